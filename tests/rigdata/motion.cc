#include "motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace rigdata {
namespace {

double RoundedTriangle(double phase, double roundness) {
  return std::asin(roundness * std::sin(phase)) / std::asin(roundness);
}

double BlockValue(const OscillationBlock& block, double t) {
  if (t <= block.start || t >= block.end) return 0;
  const double window =
      SmoothStep((t - block.start) / block.taper) * SmoothStep((block.end - t) / block.taper);
  double sum = 0;
  for (const SineTerm& s : block.terms) {
    const double phase = kTwoPi * s.frequency * (t - block.start) + s.phase;
    sum += s.amplitude *
           (block.roundness > 0 ? RoundedTriangle(phase, block.roundness) : std::sin(phase));
  }
  return window * sum;
}

enum class Kind {
  kSlowSine,
  kFastSine,
  kTriangle,
  kSteps,
  kMultisine,
  kRandom,
  kRest,
  kSmallReversals,
  kCreep,
  kBlowOff,
};

// Appends blocks one after another and keeps the time and the level reached.
class Composer {
 public:
  Composer(const MotionRange& range, RandomSource random) : range_(range), random_(random) {}

  void Add(Kind kind, double length);
  double time() const { return time_; }
  Motion Finish() { return Motion(std::move(ramps_), std::move(blocks_)); }

 private:
  // Moves to a level with a ramp whose speed stays below about 40 mm/s.
  void MoveTo(double level, double ramp) {
    const double needed = 1.9 * std::abs(level - level_) / 0.04;
    ramp = std::max(ramp, needed);
    time_ += ramp;
    ramps_.push_back({time_, ramp, level});
    level_ = level;
  }
  void Hold(double seconds) { time_ += seconds; }
  double Span() const { return range_.high - range_.low; }
  // A centre such that +-amplitude fits.
  double DrawCentre(double amplitude) {
    return random_.Uniform(range_.low + amplitude, range_.high - amplitude);
  }
  void Oscillate(double length, double amplitude, double roundness, std::vector<SineTerm> terms);
  void AddSteps(double length);
  void AddCreep(double length);
  void AddBlowOff(double length);
  std::vector<SineTerm> DrawBand(int count, double low_Hz, double high_Hz, double amplitude,
                                 double slope);

  MotionRange range_;
  RandomSource random_;
  double time_ = 0, level_ = 0;
  std::vector<RampPoint> ramps_;
  std::vector<OscillationBlock> blocks_;
};

void Composer::Oscillate(double length, double amplitude, double roundness,
                         std::vector<SineTerm> terms) {
  const double end = time_ + length;
  MoveTo(DrawCentre(amplitude), random_.Uniform(0.3, 0.8));
  Hold(random_.Uniform(0.1, 0.6));
  OscillationBlock block;
  block.start = time_;
  block.end = std::max(end, time_ + 2.0);
  block.taper = 0.5;
  block.roundness = roundness;
  block.terms = std::move(terms);
  time_ = block.end;
  blocks_.push_back(std::move(block));
}

std::vector<SineTerm> Composer::DrawBand(int count, double low_Hz, double high_Hz, double amplitude,
                                         double slope) {
  std::vector<SineTerm> terms(count);
  double energy = 0;
  for (SineTerm& s : terms) {
    s.frequency = random_.LogUniform(low_Hz, high_Hz);
    s.phase = random_.Uniform(0, kTwoPi);
    s.amplitude = std::pow(s.frequency / low_Hz, -slope);
    energy += s.amplitude * s.amplitude;
  }
  // A sum of many sines rarely exceeds 2.6 times its own standard deviation √(energy/2).
  const double scale = amplitude / (2.6 * std::sqrt(0.5 * energy));
  for (SineTerm& s : terms) s.amplitude *= scale;
  return terms;
}

void Composer::AddSteps(double length) {
  const double end = time_ + length;
  while (time_ < end - 0.8) {
    const double level = random_.Uniform(range_.low, range_.high);
    MoveTo(level, random_.LogUniform(0.04, 0.25));
    Hold(random_.Uniform(0.7, 2.6));
  }
}

void Composer::AddCreep(double length) {
  const double end = time_ + length;
  while (time_ < end - 0.5) {
    const double distance = random_.Sign() * random_.Uniform(0.1, 0.45) * Span();
    const double level = std::clamp(level_ + distance, range_.low, range_.high);
    const double speed = random_.LogUniform(0.15e-3, 3e-3);
    const double ramp = std::abs(level - level_) / speed;
    MoveTo(level, std::clamp(ramp, 0.4, 5.0));
    Hold(random_.Uniform(0.1, 1.2));
  }
}

void Composer::AddBlowOff(double length) {
  const double share = random_.Uniform(0.3, 0.4);
  MoveTo(range_.deep, share * length);
  Hold(random_.Uniform(0.5, 1.5));
  const double back = random_.Uniform(range_.low, 0.3 * range_.high);
  MoveTo(range_.high - 0.1 * Span(), 0.15 * length);
  MoveTo(range_.high, random_.Uniform(0.2, 0.6));
  Hold(random_.Uniform(0.3, 0.8));
  MoveTo(back, 0.15 * length);
}

void Composer::Add(Kind kind, double length) {
  switch (kind) {
    case Kind::kSlowSine: {
      const double a = random_.Uniform(0.3, 0.49) * Span();
      Oscillate(length, a, 0, {{a, random_.Uniform(0.15, 0.4), random_.Uniform(0, kTwoPi)}});
      break;
    }
    case Kind::kFastSine: {
      const double f = random_.Uniform(1.2, 4.5);
      const double a = std::min(random_.Uniform(0.1, 0.2) * Span(), 0.03 / (kTwoPi * f));
      Oscillate(0.7 * length, a, 0, {{a, f, 0}});
      break;
    }
    case Kind::kTriangle: {
      const double a = random_.Uniform(0.2, 0.48) * Span();
      Oscillate(length, a, 0.997, {{a, random_.Uniform(0.2, 0.6), 0}});
      break;
    }
    case Kind::kSteps:
      AddSteps(length);
      break;
    case Kind::kMultisine: {
      const double a = random_.Uniform(0.2, 0.35) * Span();
      Oscillate(length, a, 0, DrawBand(12, 0.2, 6.0, a, 0.7));
      break;
    }
    case Kind::kRandom: {
      const double a = random_.Uniform(0.25, 0.45) * Span();
      Oscillate(length, a, 0, DrawBand(40, 0.1, 2.5, a, 0.4));
      break;
    }
    case Kind::kRest:
      MoveTo(random_.Uniform(range_.low, range_.high), random_.Uniform(0.2, 0.6));
      Hold(0.8 * length);
      break;
    case Kind::kSmallReversals: {
      const double a = random_.LogUniform(0.03e-3, 0.3e-3);
      Oscillate(0.7 * length, a, random_.Coin() ? 0.99 : 0,
                {{a, random_.Uniform(0.3, 1.0), random_.Uniform(0, kTwoPi)}});
      break;
    }
    case Kind::kCreep:
      AddCreep(length);
      break;
    case Kind::kBlowOff:
      AddBlowOff(length);
      break;
  }
}

// One of each kind in random order; the mean length fills the part.
void ComposePart(Composer& composer, RandomSource& random, double until) {
  std::array<Kind, 10> kinds = {
      Kind::kSlowSine, Kind::kFastSine, Kind::kTriangle,       Kind::kSteps, Kind::kMultisine,
      Kind::kRandom,   Kind::kRest,     Kind::kSmallReversals, Kind::kCreep, Kind::kBlowOff};
  for (int i = static_cast<int>(kinds.size()) - 1; i > 0; --i) {
    std::swap(kinds[i], kinds[random.Integer(i + 1)]);
  }
  for (size_t i = 0; i < kinds.size(); ++i) {
    const double remaining = until - composer.time();
    const double mean = remaining / static_cast<double>(kinds.size() - i);
    if (mean < 1.5) break;
    composer.Add(kinds[i], mean * random.Uniform(0.75, 1.15));
  }
}

}  // namespace

double SampledMotion::Position(double t) const {
  const double at = std::clamp(t / step, 0.0, static_cast<double>(position.size() - 1));
  const auto k = std::min(static_cast<size_t>(at), position.size() - 2);
  const double before = position[k > 0 ? k - 1 : 0], a = position[k], b = position[k + 1],
               after = position[std::min(k + 2, position.size() - 1)];
  const double u = at - static_cast<double>(k), u2 = u * u, u3 = u2 * u;
  return a * (2 * u3 - 3 * u2 + 1) + b * (3 * u2 - 2 * u3) +
         0.5 * ((b - before) * (u3 - 2 * u2 + u) + (after - a) * (u3 - u2));
}

double SmoothStep(double u) {
  if (u <= 0) return 0;
  if (u >= 1) return 1;
  return u * u * u * (10 + u * (-15 + 6 * u));
}

Motion::Motion(std::vector<RampPoint> ramps, std::vector<OscillationBlock> blocks)
    : ramps_(std::move(ramps)), blocks_(std::move(blocks)) {}

double Motion::Position(double t) const {
  // The last ramp that has begun and the level before it.
  const auto next = std::lower_bound(ramps_.begin(), ramps_.end(), t,
                                     [](const RampPoint& r, double time) { return r.time < time; });
  const double before = next == ramps_.begin() ? 0 : std::prev(next)->level;
  double x = before;
  if (next != ramps_.end()) {
    x += (next->level - before) * SmoothStep((t - (next->time - next->ramp)) / next->ramp);
  }
  const auto block =
      std::lower_bound(blocks_.begin(), blocks_.end(), t,
                       [](const OscillationBlock& b, double time) { return b.end < time; });
  return block == blocks_.end() ? x : x + BlockValue(*block, t);
}

DrawnMotion DrawMotion(const MotionRange& range, RandomSource random) {
  Composer composer(range, random);
  RandomSource order(random.NextBits());
  DrawnMotion drawn;
  const double split = range.estimation_share * range.duration;
  ComposePart(composer, order, split);
  drawn.split = std::max(composer.time(), split);
  ComposePart(composer, order, range.duration - 1.0);
  drawn.duration = std::max(range.duration, composer.time() + 0.5);
  drawn.split = std::round(drawn.split * 10) / 10;
  drawn.duration = std::round(drawn.duration * 10) / 10;
  drawn.motion = composer.Finish();
  return drawn;
}

}  // namespace rigdata
