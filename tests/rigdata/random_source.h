// A seeded stream of random numbers whose bits do not depend on the standard library.
// State advance: SplitMix64 (Steele, Lea, Flood 2014). Normal deviates: Box and Muller 1958.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>

namespace rigdata {

class RandomSource {
 public:
  explicit RandomSource(uint64_t seed) : state_(seed) {}

  // A stream of its own for every use (`sensor`, `motion`, …), so that drawing one more number for
  // one use does not change the others.
  RandomSource(uint64_t seed, std::string_view use) : state_(seed) {
    for (const char c : use) state_ = Scramble(state_ ^ static_cast<unsigned char>(c)) + kStep;
  }

  uint64_t NextBits() {
    state_ += kStep;
    return Scramble(state_);
  }
  // In [0, 1).
  double Uniform() { return static_cast<double>(NextBits() >> 11) * 0x1.0p-53; }
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }
  double LogUniform(double low, double high) {
    return low * std::exp(Uniform() * std::log(high / low));
  }
  int Integer(int count) { return static_cast<int>(Uniform() * count); }
  bool Coin() { return Uniform() < 0.5; }
  double Sign() { return Coin() ? 1.0 : -1.0; }
  double Normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - Uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * Uniform());
  }

 private:
  static constexpr uint64_t kStep = 0x9E3779B97F4A7C15ULL;
  static uint64_t Scramble(uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }
  uint64_t state_;
};

}  // namespace rigdata
