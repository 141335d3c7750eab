#include "effects/sensor_drift.h"

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
    t.start_s = effect.values.at("start_s");
    t.settling_s = effect.values.at("settling_s");
    t.period_s = effect.values.at("period_s");
    t.load.wave_sine += effect.values.at("load_sine_N");
    t.load.wave_cosine += effect.values.at("load_cosine_N");
    t.p_bore.wave_sine += effect.values.at("p_bore_sine_Pa");
    t.p_bore.wave_cosine += effect.values.at("p_bore_cosine_Pa");
    t.p_rod.wave_sine += effect.values.at("p_rod_sine_Pa");
    t.p_rod.wave_cosine += effect.values.at("p_rod_cosine_Pa");
    t.load.drift_per_s += effect.values.at("load_N_per_s");
    t.p_bore.drift_per_s += effect.values.at("p_bore_Pa_per_s");
    t.p_rod.drift_per_s += effect.values.at("p_rod_Pa_per_s");
    t.piston.drift_per_s += effect.values.at("piston_m_per_s");
  }
  return {};
}

}  // namespace

const EffectInfo& SensorDriftInfo() {
  static const EffectInfo info = {
      "sensor_drift",
      "instrument",
      "cylinders",
      "shown = true + drift t from start_s on; settling: drift T (1 - exp(-t/T)); and a slow wave",
      {
          {"load_N_per_s", "N/s", 0, -1e6, 1e6, -300, 300, "load cell"},
          {"p_bore_Pa_per_s", "Pa/s", 0, -1e7, 1e7, -5e4, 5e4, "bore pressure"},
          {"p_rod_Pa_per_s", "Pa/s", 0, -1e7, 1e7, -5e4, 5e4, "rod pressure"},
          {"piston_m_per_s", "m/s", 0, -1, 1, -1e-5, 1e-5, "piston"},
          {"load_sine_N", "N", 0, -1e7, 1e7, -3000, 3000, "wave of the load cell"},
          {"load_cosine_N", "N", 0, -1e7, 1e7, -3000, 3000, "wave of the load cell"},
          {"p_bore_sine_Pa", "Pa", 0, -1e8, 1e8, -5e5, 5e5, "wave of the bore pressure"},
          {"p_bore_cosine_Pa", "Pa", 0, -1e8, 1e8, -5e5, 5e5, "wave of the bore pressure"},
          {"p_rod_sine_Pa", "Pa", 0, -1e8, 1e8, -5e5, 5e5, "wave of the rod pressure"},
          {"p_rod_cosine_Pa", "Pa", 0, -1e8, 1e8, -5e5, 5e5, "wave of the rod pressure"},
          {"period_s", "s", 100, 1, 1e9, 15, 1e4, "period of the wave"},
          {"settling_s", "s", 0, 0, 1e9, 0.3, 1e4, "T; 0 = never settles"},
          {"start_s", "s", 0, -1e12, 1e12, 0, 1e6, "the drift begins at this time"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
