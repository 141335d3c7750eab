// Errors of the measuring chain that are on the list.
#include "hidden_effect.h"

namespace rigdata {
namespace {

Channel DrawChannel(RandomSource& random) {
  constexpr Channel kChoice[] = {kLoad, kPBore, kPRod};
  return kChoice[random.Integer(3)];
}

double Unit(Channel channel) { return channel == kLoad ? 150.0 : 30.0e3; }

HiddenEffect Offset(RandomSource& random) {
  const Channel channel = DrawChannel(random);
  const double sign = random.Sign();
  HiddenEffect effect;
  effect.form = kChannelNames[channel];
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    r->sensors[channel].offset = sign * size * Unit(channel);
    return {{"offset", r->sensors[channel].offset}};
  };
  return effect;
}

HiddenEffect Drift(RandomSource& random) {
  constexpr DriftForm kForms[] = {DriftForm::kLinear, DriftForm::kSettling, DriftForm::kWave,
                                  DriftForm::kWander};
  constexpr const char* kNames[] = {"linear", "settling", "wave", "wander"};
  const int form = random.Integer(4);
  const Channel channel = DrawChannel(random);
  const double sign = random.Sign(), tau = random.Uniform(20, 70);
  std::array<double, 4> wander{};
  for (double& phase : wander) phase = random.Uniform(0, 6.283);
  HiddenEffect effect;
  effect.form = std::string(kNames[form]) + "_" + kChannelNames[channel];
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    SensorParams& s = r->sensors[channel];
    s.drift = kForms[form];
    s.drift_amount = sign * size * Unit(channel);
    s.drift_tau = tau;
    s.wander = wander;
    return {{"amount", s.drift_amount}, {"tau_s", tau}};
  };
  return effect;
}

HiddenEffect Delay(RandomSource& random) {
  const bool lag = random.Coin(), both = random.Uniform() < 0.3;
  const Channel channel = DrawChannel(random);
  HiddenEffect effect;
  effect.form = std::string(lag ? "lag_" : "pure_") + (both ? "pressures" : kChannelNames[channel]);
  effect.smallest = 0.03;
  effect.largest = 15;
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    const double time = 4e-3 * size;
    for (const Channel c : {kLoad, kPBore, kPRod}) {
      if (both ? c == kLoad : c != channel) continue;
      (lag ? r->sensors[c].lag : r->sensors[c].delay) = time;
    }
    return {{"time_s", time}};
  };
  return effect;
}

HiddenEffect Gain(RandomSource& random) {
  const Channel channel = DrawChannel(random);
  const double sign = random.Sign();
  HiddenEffect effect;
  effect.form = kChannelNames[channel];
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    r->sensors[channel].gain = sign * 0.01 * size;
    return {{"relative_error", r->sensors[channel].gain}};
  };
  return effect;
}

}  // namespace

HiddenEffect DrawInstrument(const std::string& name, RandomSource& random) {
  if (name == "sensor_offset") return Offset(random);
  if (name == "sensor_drift") return Drift(random);
  if (name == "sensor_delay") return Delay(random);
  if (name == "sensor_gain") return Gain(random);
  return {};
}

}  // namespace rigdata
