#include "effects/snap_through.h"

#include <memory>

#include "effects/snap_flow.h"
#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::kAtmosphere;
using hydraulics::Places;
using hydraulics::Port;

Status InstallSnapThrough(const EffectParams& effect, Extension* extension) {
  const auto value = [&effect](const char* key) { return effect.values.at(key); };
  if (!(value("volume_m3") > 0)) return {};
  for (int i : TargetLines(effect, extension->params())) {
    const auto& line = extension->params().lines[static_cast<size_t>(i)];
    extension->AddFlow(Port::kLine, Port::kAtmosphere, -1, i, "snap_through",
                       std::make_unique<SnapFlow>(SnapParams{
                           .volume_m3 = value("volume_m3"),
                           .width_Pa = value("width_Pa"),
                           .centre_Pa = value("centre_Pa") - kAtmosphere,
                           .snap_Pa = value("snap_Pa"),
                           .time_s = value("time_s"),
                           .rest_Pa = line.static_pressure_Pa - kAtmosphere,
                       }));
  }
  return {};
}

}  // namespace

const EffectInfo& SnapThroughInfo() {
  static const EffectInfo info = {
      "snap_through",
      "hydraulic",
      "lines",
      "V/2 tanh((p - p_c + P_s u)/P) out of the line, u = -1 … 1: a wall that snaps over",
      {
          {"volume_m3", "m3", 3e-7, 0, 1e-3, 1e-9, 1e-5, "V: between its two shapes"},
          {"centre_Pa", "Pa", 2.5e6, 0, 1e8, 2e5, 2e7,
           "p_c: midway between out and back, absolute"},
          {"snap_Pa", "Pa", 3e5, 0, 1e8, 1e4, 8e6, "P_s: half between out and back"},
          {"width_Pa", "Pa", 1e5, 1e3, 1e8, 1e4, 3e6, "P: how much it gives; small: it snaps"},
          {"time_s", "s", 0.02, 1e-4, 1e3, 2e-3, 1, "tau"},
      },
      InstallSnapThrough,
      {
          .rig =
              {
                  {.free = {{"volume_m3", 3e-7},
                            {"centre_Pa", 8e5, 1e7, 6},
                            {"snap_Pa", 3e5, 1.2e6, 2},
                            {"width_Pa", 3e5}},
                   .places = Places::kAlone},
              },
          .options =
              {
                  {.free = {{"time_s", 0.1}}},
              },
      }};
  return info;
}

}  // namespace phs::effects
