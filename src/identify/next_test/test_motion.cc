#include "identify/next_test/test_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace phs::identify::search {
namespace {

using rigs::SignalKind;
using rigs::SignalParams;

constexpr double kRest = 0.05;  // of the test, at both ends
constexpr double kFade_s = 1;   // in and out of a wave

double Half(const MotionLimits& l) { return 0.5 * (l.high_m - l.low_m); }

SignalParams Signal(SignalKind kind, double amplitude_m, double frequency_Hz = 0) {
  SignalParams signal;
  signal.kind = kind, signal.amplitude = amplitude_m, signal.frequency_Hz = frequency_Hz;
  return signal;
}

/// 10 u³ - 15 u⁴ + 6 u⁵: at rest at both ends, at most 1.875 times as fast as a ramp.
double Fade(double u) {
  const double v = std::clamp(u, 0.0, 1.0);
  return v * v * v * (10 + v * (6 * v - 15));
}

void AddSines(const MotionLimits& l, double fastest_Hz, std::vector<TestMotion>* out) {
  for (double f = 3 / l.duration_s; f <= fastest_Hz; f *= 3) {
    const double most = std::min(Half(l), l.speed_m_s / (2 * M_PI * f));
    for (const double share : {1.0, 0.25, 0.0625}) {
      const SignalParams s = Signal(SignalKind::kSine, share * most, f);
      out->push_back({fmt::format("sine of {:.3g} mm at {:.3g} Hz", 1e3 * s.amplitude, f), {s}});
    }
  }
}

void AddTriangles(const MotionLimits& l, std::vector<TestMotion>* out) {
  const double slowest = 4 * Half(l) / (l.duration_s * (1 - 4 * kRest));
  for (double v = l.speed_m_s; v > slowest; v *= 0.25) {
    for (const double share : {1.0, 0.1}) {
      const double a = share * Half(l), f = std::min(v / (4 * a), 1 / (2 * kFade_s));
      const SignalParams s = Signal(SignalKind::kTriangle, a, f);
      out->push_back(
          {fmt::format("triangle of {:.3g} mm at {:.3g} mm/s", 1e3 * a, 4e3 * a * f), {s}});
    }
  }
  const SignalParams once =
      Signal(SignalKind::kTriangle, Half(l), 1 / (l.duration_s * (1 - 4 * kRest)));
  out->push_back(
      {fmt::format("one slow way over the full stroke of {:.3g} mm", 2e3 * Half(l)), {once}});
}

/// To levels that come in no order and reach both ends: multiples of the golden section.
void AddSteps(const MotionLimits& l, std::vector<TestMotion>* out) {
  for (const double holds : {0.02, 0.06, 0.18}) {
    for (const double share : {1.0, 0.25}) {
      SignalParams s = Signal(SignalKind::kStep, share * Half(l));
      s.hold_s = holds * l.duration_s;
      s.rise_s = 4 * s.amplitude / l.speed_m_s;
      double place = 0;
      for (double t = 0; t < l.duration_s; t += s.hold_s + s.rise_s) {
        place = std::fmod(place + 0.6180339887, 1.0);
        s.levels.push_back(s.amplitude * std::clamp(2.4 * place - 1.2, -1.0, 1.0));
      }
      out->push_back(
          {fmt::format("steps within {:.3g} mm, held {:.3g} s", 2e3 * s.amplitude, s.hold_s), {s}});
    }
  }
}

void AddMultisines(const MotionLimits& l, double fastest_Hz, std::vector<TestMotion>* out) {
  for (double high = 30 / l.duration_s; high <= fastest_Hz; high *= 4) {
    for (const double share : {1.0, 0.25}) {
      SignalParams s = Signal(SignalKind::kMultisine, share * Half(l), 3 / l.duration_s);
      s.high_frequency_Hz = high, s.tones = 20;
      out->push_back(
          {fmt::format("multisine within {:.3g} mm up to {:.3g} Hz", 2e3 * s.amplitude, high),
           {s}});
    }
  }
}

/// A wave about the middle, of `count` samples, faded in and out, no faster than allowed.
std::vector<double> Wave(const SignalParams& signal, double speed_m_s, int count, double step_s) {
  std::vector<double> x = rigs::GenerateSignal(signal, count, step_s);
  double top = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    const double t = static_cast<double>(i) * step_s;
    x[i] *= Fade(t / kFade_s) * Fade((count * step_s - t) / kFade_s);
    if (i > 0) top = std::max(top, std::abs(x[i] - x[i - 1]) / step_s);
  }
  if (top > speed_m_s) {
    for (double& v : x) v *= speed_m_s / top;
  }
  return x;
}

}  // namespace

std::vector<TestMotion> ListTestMotions(const MotionLimits& limits, double fastest_Hz) {
  std::vector<TestMotion> out;
  AddSines(limits, fastest_Hz, &out);
  AddTriangles(limits, &out);
  AddSteps(limits, &out);
  AddMultisines(limits, fastest_Hz, &out);
  return out;
}

TestMotion Joined(const TestMotion& first, const TestMotion& second) {
  TestMotion both = first;
  both.text += ", then " + second.text;
  both.signal.insert(both.signal.end(), second.signal.begin(), second.signal.end());
  return both;
}

rigs::RigMotion Sampled(const TestMotion& motion, const MotionLimits& limits, double step_s,
                        int channels) {
  const auto samples = [&](double seconds) { return static_cast<int>(seconds / step_s + 0.5); };
  const int all = samples(limits.duration_s), rest = samples(kRest * limits.duration_s);
  const double middle = 0.5 * (limits.low_m + limits.high_m);
  const double way = std::max(kFade_s, 1.875 * std::abs(middle) / limits.speed_m_s);
  const int move = samples(way);
  const auto parts = static_cast<int>(motion.signal.size());
  std::vector<double> x(static_cast<size_t>(all), 0.0);
  const int begin = rest + move, end = std::max(begin, all - begin);
  for (int i = 0; i < all; ++i) {
    const double up = Fade((i - rest) * step_s / way), down = Fade((all - rest - i) * step_s / way);
    x[static_cast<size_t>(i)] = middle * std::min(up, down);
  }
  for (int p = 0; p < parts; ++p) {
    const int from = begin + (end - begin) * p / parts,
              to = begin + (end - begin) * (p + 1) / parts;
    const auto wave =
        Wave(motion.signal[static_cast<size_t>(p)], limits.speed_m_s, to - from, step_s);
    for (int i = from; i < to; ++i) {
      x[static_cast<size_t>(i)] += wave[static_cast<size_t>(i - from)];
    }
  }
  rigs::RigMotion out;
  out.step_s = step_s;
  for (int c = 0; c < channels; ++c) {
    std::vector<double> position = x;
    if (c > 0 && motion.opposed) {
      for (double& v : position) v = std::clamp(-v, limits.low_m, limits.high_m);
    }
    out.speed_m_s.push_back(rigs::DifferentiateMotion(position, step_s));
    out.acceleration_m_s2.push_back(rigs::DifferentiateMotion(out.speed_m_s.back(), step_s));
    out.position_m.push_back(std::move(position));
  }
  return out;
}

}  // namespace phs::identify::search
