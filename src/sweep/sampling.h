// Points of a study in the unit cube and in the units of its axes, the same on every machine. Boost
// gives Sobol's sequence (direction numbers of Joe and Kuo, SIAM J. Sci. Comput. 30 (2008) 2635)
// and the normal distribution, the standard library the generator.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/yaml.h"

namespace phs::sweep {

/// Distribution of one axis: u in (0, 1) -> value by the inverse distribution function.
struct Distribution {
  enum class Kind { kUniform, kLogUniform, kTriangular, kNormal };
  Kind kind = Kind::kUniform;
  double min = 0;   ///< uniform, log_uniform (> 0), triangular; normal: cut off below (or -inf)
  double max = 0;   ///< > min; normal: cut off above (or +inf)
  double mode = 0;  ///< triangular, between min and max
  double mean = 0;  ///< normal
  double standard_deviation = 0;  ///< normal, > 0

  double Quantile(double u) const;
};

/// Reads `distribution: uniform|log_uniform|triangular|normal` and its numbers from an axis.
Distribution ReadDistribution(YamlMap* axis);

/// `samples` points of a Latin hypercube in (0, 1)^dimensions: each axis cut into `samples` cells
/// of equal probability, each cell used once, the place within it random. [point][axis].
std::vector<std::vector<double>> LatinHypercube(int samples, int dimensions, std::uint64_t seed);

/// The first `samples` points of Sobol's sequence after the origin, shifted modulo 1 by a random
/// vector drawn from `seed` (seed 0: not shifted). At most kMostSobolDimensions.
std::vector<std::vector<double>> SobolPoints(int samples, int dimensions, std::uint64_t seed);
constexpr int kMostSobolDimensions = 40;

/// A seed for run `index` of a study: SplitMix64 of both, below 2^31 (Steele, Lea, Flood, Fast
/// splittable pseudorandom number generators, OOPSLA 2014).
std::uint32_t RunSeed(std::uint64_t study_seed, std::uint64_t index);

}  // namespace phs::sweep
