#include "sweep/sampling.h"

#include <boost/math/distributions/normal.hpp>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <utility>

#include "base/check.h"

namespace phs::sweep {
namespace {

/// MT19937, whose draws the standard fixes; its distributions differ from library to library, so
/// the two that are needed stand here.
class Generator {
 public:
  explicit Generator(std::uint64_t seed)
      : engine_(static_cast<std::mt19937::result_type>(seed & 0xffffffffu)) {}

  /// In (0, 1), a multiple of 2^-32.
  double Uniform() {
    std::uint32_t draw = 0;
    while (draw == 0) draw = static_cast<std::uint32_t>(engine_());
    return draw * 0x1p-32;
  }

  /// 0 … count - 1, all equally likely: draws beyond the last full share are thrown away.
  std::size_t Index(std::size_t count) {
    const std::size_t share = 0xffffffffu / count;
    std::size_t index = count;
    while (index >= count) index = engine_() / share;
    return index;
  }

  /// Fisher and Yates, from the back.
  void Shuffle(std::vector<int>* cells) {
    for (std::size_t last = cells->size(); last-- > 1;) {
      std::swap((*cells)[last], (*cells)[Index(last + 1)]);
    }
  }

 private:
  std::mt19937 engine_;
};

std::uint64_t SplitMix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

double TriangularQuantile(const Distribution& d, double u) {
  const double width = d.max - d.min, rise = d.mode - d.min;
  const double split = rise / width;
  return u < split ? d.min + std::sqrt(u * width * rise)
                   : d.max - std::sqrt((1 - u) * width * (d.max - d.mode));
}

/// Boost's normal distribution in double precision: `long double` differs between processors.
/// The quantiles of 0 and 1 are infinite.
using Normal = boost::math::normal_distribution<
    double, boost::math::policies::policy<
                boost::math::policies::promote_double<false>,
                boost::math::policies::overflow_error<boost::math::policies::ignore_error>>>;

double NormalQuantile(const Distribution& d, double u) {
  const Normal normal(d.mean, d.standard_deviation);
  const double low = cdf(normal, d.min), high = cdf(normal, d.max);
  return quantile(normal, low + u * (high - low));
}

}  // namespace

double Distribution::Quantile(double u) const {
  switch (kind) {
    case Kind::kUniform:
      return min + u * (max - min);
    case Kind::kLogUniform:
      return min * std::pow(max / min, u);
    case Kind::kTriangular:
      return TriangularQuantile(*this, u);
    case Kind::kNormal:
      return NormalQuantile(*this, u);
  }
  return min;
}

Distribution ReadDistribution(YamlMap* axis) {
  Distribution d;
  const std::string kind =
      axis->Word("distribution", {"uniform", "log_uniform", "triangular", "normal"}, "uniform");
  if (kind == "normal") {
    d.kind = Distribution::Kind::kNormal;
    d.mean = axis->Number("mean", {});
    d.standard_deviation = axis->Number("standard_deviation", {.min = 0, .open_min = true});
    d.min = axis->Number("min", {}, -std::numeric_limits<double>::infinity());
    d.max = axis->Number("max", {.min = d.min, .open_min = true},
                         std::numeric_limits<double>::infinity());
    return d;
  }
  const bool logarithmic = kind == "log_uniform";
  d.kind = logarithmic ? Distribution::Kind::kLogUniform : Distribution::Kind::kUniform;
  d.min = logarithmic ? axis->Number("min", {.min = 0, .open_min = true}) : axis->Number("min", {});
  d.max = axis->Number("max", {.min = d.min, .open_min = true});
  if (kind == "triangular") {
    d.kind = Distribution::Kind::kTriangular;
    d.mode = axis->Number("mode", {.min = d.min, .max = d.max});
  }
  return d;
}

std::vector<std::vector<double>> LatinHypercube(int samples, int dimensions, std::uint64_t seed) {
  PHS_CHECK(samples > 0 && dimensions > 0);
  Generator generator(seed);
  std::vector<std::vector<double>> points(
      static_cast<std::size_t>(samples), std::vector<double>(static_cast<std::size_t>(dimensions)));
  std::vector<int> cells(static_cast<std::size_t>(samples));
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
    std::iota(cells.begin(), cells.end(), 0);
    generator.Shuffle(&cells);
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i][axis] = (cells[i] + generator.Uniform()) / samples;
    }
  }
  return points;
}

std::vector<std::vector<double>> SobolPoints(int samples, int dimensions, std::uint64_t seed) {
  PHS_CHECK(samples > 0 && dimensions > 0 && dimensions <= kMostSobolDimensions);
  const auto size = static_cast<std::size_t>(dimensions);
  std::vector<double> shift(size, 0.0);
  if (seed != 0) {
    Generator generator(seed);
    for (double& s : shift) s = generator.Uniform();
  }
  boost::random::sobol_engine<std::uint_least32_t, 32> sequence(size);
  std::vector<std::vector<double>> points(static_cast<std::size_t>(samples),
                                          std::vector<double>(size));
  for (auto& point : points) {
    for (std::size_t axis = 0; axis < size; ++axis) {
      point[axis] = sequence() * 0x1p-32 + shift[axis];
      point[axis] -= std::floor(point[axis]);
      // An inverse distribution function may be infinite at 0.
      if (point[axis] <= 0) point[axis] = 0x1p-53;
    }
  }
  return points;
}

std::uint32_t RunSeed(std::uint64_t study_seed, std::uint64_t index) {
  return static_cast<std::uint32_t>(SplitMix(SplitMix(study_seed) ^ index) >> 33);
}

}  // namespace phs::sweep
