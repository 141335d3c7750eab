#include "effects/sensor_delay.h"

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
    t.load.delay_s += effect.values.at("load_s");
    t.p_bore.delay_s += effect.values.at("p_bore_s");
    t.p_rod.delay_s += effect.values.at("p_rod_s");
    t.piston.delay_s += effect.values.at("piston_s");
  }
  return {};
}

}  // namespace

const EffectInfo& SensorDelayInfo() {
  static const EffectInfo info = {"sensor_delay",
                                  "instrument",
                                  "cylinders",
                                  "shown(t) = true(t - delay)",
                                  {
                                      {"load_s", "s", 0, 0, 100, 0, 0.2, "load cell"},
                                      {"p_bore_s", "s", 0, 0, 100, 0, 0.2, "bore pressure"},
                                      {"p_rod_s", "s", 0, 0, 100, 0, 0.2, "rod pressure"},
                                      {"piston_s", "s", 0, 0, 100, 0, 0.2, "piston"},
                                  },
                                  Install};
  return info;
}

}  // namespace phs::effects
