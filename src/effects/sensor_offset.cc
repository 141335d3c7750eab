#include "effects/sensor_offset.h"

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

Status Install(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    hydraulics::InstrumentTerms& t = extension->instrument(i);
    t.present = true;
    t.load.offset += effect.values.at("load_N");
    t.p_bore.offset += effect.values.at("p_bore_Pa");
    t.p_rod.offset += effect.values.at("p_rod_Pa");
    t.piston.offset += effect.values.at("piston_m");
  }
  return {};
}

}  // namespace

const EffectInfo& SensorOffsetInfo() {
  static const EffectInfo info = {"sensor_offset",
                                  "instrument",
                                  "cylinders",
                                  "shown = true + offset",
                                  {
                                      {"load_N", "N", 0, -1e7, 1e7, -3000, 3000, "load cell"},
                                      {"p_bore_Pa", "Pa", 0, -1e8, 1e8, -5e5, 5e5, "bore pressure"},
                                      {"p_rod_Pa", "Pa", 0, -1e8, 1e8, -5e5, 5e5, "rod pressure"},
                                      {"piston_m", "m", 0, -1, 1, -1e-3, 1e-3, "piston"},
                                  },
                                  Install};
  return info;
}

}  // namespace phs::effects
