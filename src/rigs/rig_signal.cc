#include "rigs/rig_signal.h"

#include <algorithm>
#include <cmath>

namespace phs::rigs {
namespace {

const std::vector<std::string> kKinds = {"sine", "triangle", "step", "ramp", "multisine"};

/// The key of a displacement or a force: the file says by it which of the two it means.
std::string KeyOf(YamlMap& map, const std::string& name, const char* m, const char* n,
                  SignalParams* s) {
  s->force = map.Has(name + n);
  return name + (s->force ? n : m);
}

void ReadWave(YamlMap& map, SignalParams* s) {
  s->frequency_Hz = map.Number("frequency_Hz", {.min = 0, .open_min = true});
  if (s->kind == SignalKind::kMultisine) {
    s->high_frequency_Hz = map.Number("high_frequency_Hz", {.min = s->frequency_Hz});
    s->tones = map.Integer("tones", 1, 200, 12);
    return;
  }
  s->phase_deg = map.Number("phase_deg", {.min = -360, .max = 360}, 0.0);
  s->periods = map.Integer("periods", 0, 1000000, 0);
}

SignalParams ReadSignal(YamlMap& map) {
  const Range positive{.min = 0, .open_min = true};
  SignalParams s;
  const std::string kind = map.Word("kind", kKinds);
  for (size_t i = 0; i < kKinds.size(); ++i) {
    if (kKinds[i] == kind) s.kind = static_cast<SignalKind>(i);
  }
  s.start_s = map.Number("start_s", {.min = 0}, 0.0);
  if (s.kind == SignalKind::kStep) {
    s.levels = map.Numbers(KeyOf(map, "levels", "_m", "_N", &s), {});
    s.rise_s = map.Number("rise_s", positive, s.rise_s);
    s.hold_s = map.Number("hold_s", positive, s.hold_s);
    return s;
  }
  const std::string amplitude = KeyOf(map, "amplitude", "_m", "_N", &s);
  s.amplitude = map.Number(amplitude, {});
  if (s.kind == SignalKind::kRamp) {
    if (s.amplitude <= 0)
      map.Fail(amplitude, "of a ramp is not positive", "> 0", "its speed has the sign");
    const bool of_force = map.Has("rate_N_s");
    const char* rate = of_force ? "rate_N_s" : "speed_m_s";
    s.rate = map.Number(rate, {});
    if (of_force != s.force) map.Fail(rate, "has another unit than " + amplitude);
    if (s.rate == 0) map.Fail(rate, "is zero", "a speed other than 0");
    return s;
  }
  if (s.amplitude == 0) map.Fail(amplitude, "is zero", "a number other than 0");
  ReadWave(map, &s);
  return s;
}

/// One signal, or a list of them.
std::vector<SignalParams> ReadParts(YamlMap& map, const std::string& channel) {
  if (map.IsMap(channel)) {
    YamlMap one = map.Map(channel);
    return {ReadSignal(one)};
  }
  std::vector<YamlMap> list = map.Maps(channel);
  if (list.empty()) map.Fail(channel, "has no signal", "a map, or a list of maps");
  std::vector<SignalParams> parts;
  for (size_t i = 0; i < list.size(); ++i) {
    parts.push_back(ReadSignal(list[i]));
    if (i + 1 < list.size() && parts.back().periods == 0) {
      list[i].Fail("periods", "is missing: the next signal begins where this one ends",
                   "a number of periods of a sine or triangle");
    }
  }
  return parts;
}

double Triangle(double turns) {
  const double u = turns - std::floor(turns);
  return u < 0.25 ? 4 * u : (u < 0.75 ? 2 - 4 * u : 4 * u - 4);
}

/// The wave at `t` after start_s.
double Wave(const SignalParams& s, double t) {
  if (t <= s.Wait() || (s.periods > 0 && s.start_s + t >= s.End())) return 0;
  const double turns = s.frequency_Hz * t + s.phase_deg / 360;
  return s.amplitude * (s.kind == SignalKind::kSine ? std::sin(2 * M_PI * turns) : Triangle(turns));
}

double Steps(const SignalParams& s, double t) {
  double from = 0;
  for (const double to : s.levels) {
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

double SignalParams::Wait() const {
  const double halves = phase_deg / 180;  // a wave passes through 0 at every half turn
  return (std::ceil(halves) - halves) / (2 * frequency_Hz);
}

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
    out.signals.push_back(ReadParts(map, key));
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
      case SignalKind::kTriangle:
        x[i] = Wave(s, t);
        break;
      case SignalKind::kStep:
        x[i] = Steps(s, t);
        break;
      case SignalKind::kRamp:
        x[i] = std::clamp(s.rate * t, -s.amplitude, s.amplitude);
        break;
      case SignalKind::kMultisine:
        x[i] = Multisine(s, t) - Multisine(s, 0);
        break;
    }
    peak = std::max(peak, std::abs(x[i]));
  }
  if (s.kind == SignalKind::kMultisine && peak > 0) {
    for (double& value : x) value *= s.amplitude / peak;
  }
  return x;
}

std::vector<double> GenerateSignals(const std::vector<SignalParams>& parts, int num_samples,
                                    double step_s) {
  std::vector<double> x(static_cast<size_t>(num_samples), 0.0);
  double begin_s = 0;
  for (SignalParams part : parts) {
    part.start_s += begin_s;
    const std::vector<double> y = GenerateSignal(part, num_samples, step_s);
    for (size_t i = 0; i < x.size(); ++i) x[i] += y[i];
    if (part.periods > 0) begin_s = part.End();
  }
  return x;
}

}  // namespace phs::rigs
