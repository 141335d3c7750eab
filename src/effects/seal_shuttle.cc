#include "effects/seal_shuttle.h"

#include <memory>

#include "effects/snap_flow.h"
#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Port;

Status InstallSealShuttle(const EffectParams& effect, Extension* extension) {
  if (!(effect.values.at("volume_m3") > 0)) return {};
  for (int i : TargetCylinders(effect, extension->params())) {
    const auto& cylinder = extension->params().cylinders[static_cast<size_t>(i)];
    const double rest = StaticPressure(cylinder.bore_line, *extension) -
                        StaticPressure(cylinder.rod_line, *extension);
    extension->AddFlow(Port::kBore, Port::kRod, i, -1, "seal_shuttle",
                       std::make_unique<SnapFlow>(SnapParams{
                           .volume_m3 = effect.values.at("volume_m3"),
                           .width_Pa = effect.values.at("width_Pa"),
                           .centre_Pa = effect.values.at("centre_Pa"),
                           .friction_Pa = effect.values.at("friction_Pa"),
                           .time_s = effect.values.at("slide_s"),
                           .rest_Pa = rest,
                       }));
  }
  return {};
}

}  // namespace

const EffectInfo& SealShuttleInfo() {
  static const EffectInfo info = {
      "seal_shuttle",
      "hydraulic",
      "cylinders",
      "V/2 tanh((d -+ P_h - d_c)/P) from bore to rod, d = p_bore - p_rod, with the seal's ring",
      {
          {"volume_m3", "m3", 5e-7, 0, 1e-2, 1e-9, 1e-4, "V: clearance of the groove, ring area"},
          {"width_Pa", "Pa", 5e5, 1e3, 1e8, 1e4, 1e7,
           "P: half the difference that moves it across"},
          {"centre_Pa", "Pa", 0, -1e8, 1e8, -1e7, 1e7, "d_c: where it stands in the middle"},
          {"friction_Pa", "Pa", 0, 0, 1e7, 1e4, 3e6, "P_h: difference at which it comes loose"},
          {"slide_s", "s", 2e-3, 1e-4, 1e3, 2e-3, 1, "tau"},
      },
      InstallSealShuttle,
      {
          .rig =
              {
                  {.free = {{"volume_m3", 3e-7}, {"width_Pa", 2e5, 3e6, 3}}},
                  {.free = {{"volume_m3", 1e-5}}, .held = {{"width_Pa", 3e7}}},
              },
          .options =
              {
                  {.free = {{"friction_Pa", 2e5, 1e6, 2}}},
                  {.free = {{"slide_s", 0.02, 0.1, 2}}},
                  {.free = {{"centre_Pa", -2e6, 2e6, 3}}},
              },
          .over = {"m3", "pq"},
      }};
  return info;
}

}  // namespace phs::effects
