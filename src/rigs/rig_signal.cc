#include "rigs/rig_signal.h"

#include <algorithm>
#include <cmath>

namespace phs::rigs {
namespace {

const std::vector<std::string> kKinds = {"sine", "triangle", "step", "ramp", "multisine"};

SignalParams ReadSignal(YamlMap map) {
  const Range positive{.min = 0, .open_min = true};
  SignalParams s;
  const std::string kind = map.Word("kind", kKinds);
  for (size_t i = 0; i < kKinds.size(); ++i) {
    if (kKinds[i] == kind) s.kind = static_cast<SignalKind>(i);
  }
  s.start_s = map.Number("start_s", {.min = 0}, 0.0);
  if (s.kind == SignalKind::kStep) {
    s.levels_m = map.Numbers("levels_m", {});
    s.rise_s = map.Number("rise_s", positive, s.rise_s);
    s.hold_s = map.Number("hold_s", positive, s.hold_s);
    return s;
  }
  s.amplitude_m = map.Number("amplitude_m", positive);
  if (s.kind == SignalKind::kRamp) {
    s.speed_m_s = map.Number("speed_m_s", {});
    if (s.speed_m_s == 0) map.Fail("speed_m_s", "is zero", "a speed other than 0");
    return s;
  }
  s.frequency_Hz = map.Number("frequency_Hz", positive);
  if (s.kind == SignalKind::kMultisine) {
    s.high_frequency_Hz = map.Number("high_frequency_Hz", {.min = s.frequency_Hz});
    s.tones = map.Integer("tones", 1, 200, 12);
  }
  return s;
}

double Triangle(double turns) {
  const double u = turns - std::floor(turns);
  return u < 0.25 ? 4 * u : (u < 0.75 ? 2 - 4 * u : 4 * u - 4);
}

double Steps(const SignalParams& s, double t) {
  double from = 0;
  for (const double to : s.levels_m) {
    if (t < s.rise_s) return from + (to - from) * t / s.rise_s;
    if (t < s.rise_s + s.hold_s) return to;
    t -= s.rise_s + s.hold_s;
    from = to;
  }
  return from;
}

double Multisine(const SignalParams& s, double t) {
  double sum = 0;
  for (int k = 1; k <= s.tones; ++k) {
    const double part = s.tones == 1 ? 0 : (k - 1.0) / (s.tones - 1.0);
    const double f = s.frequency_Hz + part * (s.high_frequency_Hz - s.frequency_Hz);
    sum += std::sin(2 * M_PI * f * t - M_PI * k * (k - 1.0) / s.tones);
  }
  return sum;
}

}  // namespace

int RigSignals::num_samples() const {
  return sample_s > 0 ? static_cast<int>(std::floor(duration_s / sample_s + 0.5)) + 1 : 0;
}

RigSignals ReadRigSignals(YamlMap map) {
  RigSignals out;
  out.duration_s = map.Number("duration_s", {.min = 0, .max = 1e5, .open_min = true});
  out.sample_s = map.Number("sample_s", {.min = 1e-5, .max = 1}, 0.005);
  for (const std::string& key : map.Keys()) {
    if (key == "duration_s" || key == "sample_s") continue;
    out.channels.push_back(key);
    out.signals.push_back(ReadSignal(map.Map(key)));
  }
  if (out.channels.empty()) {
    map.Fail("actuator_m", "no channel has a signal", "a map of the driven channel, e.g.",
             "actuator_m: {kind: sine, amplitude_m: 0.0015, frequency_Hz: 0.1}");
  }
  if (out.num_samples() > 5'000'000 || out.num_samples() < 3) {
    map.Fail("duration_s", "gives " + std::to_string(out.num_samples()) + " samples",
             "3 to 5 million samples of sample_s");
  }
  return out;
}

std::vector<double> GenerateSignal(const SignalParams& s, int num_samples, double step_s) {
  std::vector<double> x(static_cast<size_t>(num_samples), 0.0);
  double peak = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    const double t = static_cast<double>(i) * step_s - s.start_s;
    if (t <= 0) continue;
    switch (s.kind) {
      case SignalKind::kSine:
        x[i] = s.amplitude_m * std::sin(2 * M_PI * s.frequency_Hz * t);
        break;
      case SignalKind::kTriangle:
        x[i] = s.amplitude_m * Triangle(s.frequency_Hz * t);
        break;
      case SignalKind::kStep:
        x[i] = Steps(s, t);
        break;
      case SignalKind::kRamp:
        x[i] = std::clamp(s.speed_m_s * t, -s.amplitude_m, s.amplitude_m);
        break;
      case SignalKind::kMultisine:
        x[i] = Multisine(s, t) - Multisine(s, 0);
        break;
    }
    peak = std::max(peak, std::abs(x[i]));
  }
  if (s.kind == SignalKind::kMultisine && peak > 0) {
    for (double& value : x) value *= s.amplitude_m / peak;
  }
  return x;
}

}  // namespace phs::rigs
