#include "effects/sensor_gain.h"

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
    t.load.gain *= effect.values.at("load");
    t.p_bore.gain *= effect.values.at("p_bore");
    t.p_rod.gain *= effect.values.at("p_rod");
    t.piston.gain *= effect.values.at("piston");
  }
  return {};
}

}  // namespace

const EffectInfo& SensorGainInfo() {
  static const EffectInfo info = {"sensor_gain",
                                  "instrument",
                                  "cylinders",
                                  "shown = gain true",
                                  {
                                      {"load", "-", 1, -100, 100, 0.8, 1.2, "load cell"},
                                      {"p_bore", "-", 1, -100, 100, 0.8, 1.2, "bore pressure"},
                                      {"p_rod", "-", 1, -100, 100, 0.8, 1.2, "rod pressure"},
                                      {"piston", "-", 1, -100, 100, 0.8, 1.2, "piston"},
                                  },
                                  Install};
  return info;
}

}  // namespace phs::effects
