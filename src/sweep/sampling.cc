#include "sweep/sampling.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_qrng.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

#include "base/check.h"

namespace phs::sweep {
namespace {

using Generator = std::unique_ptr<gsl_rng, decltype(&gsl_rng_free)>;

Generator MakeGenerator(std::uint64_t seed) {
  Generator generator(gsl_rng_alloc(gsl_rng_mt19937), &gsl_rng_free);
  gsl_rng_set(generator.get(), static_cast<unsigned long>(seed));
  return generator;
}

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

double NormalQuantile(const Distribution& d, double u) {
  const double s = d.standard_deviation;
  const double low = gsl_cdf_gaussian_P(d.min - d.mean, s);
  const double high = gsl_cdf_gaussian_P(d.max - d.mean, s);
  return d.mean + gsl_cdf_gaussian_Pinv(low + u * (high - low), s);
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
  const Generator generator = MakeGenerator(seed);
  std::vector<std::vector<double>> points(
      static_cast<std::size_t>(samples), std::vector<double>(static_cast<std::size_t>(dimensions)));
  std::vector<int> cells(static_cast<std::size_t>(samples));
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
    std::iota(cells.begin(), cells.end(), 0);
    gsl_ran_shuffle(generator.get(), cells.data(), cells.size(), sizeof(int));
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i][axis] = (cells[i] + gsl_rng_uniform_pos(generator.get())) / samples;
    }
  }
  return points;
}

std::vector<std::vector<double>> SobolPoints(int samples, int dimensions, std::uint64_t seed) {
  PHS_CHECK(samples > 0 && dimensions > 0 && dimensions <= kMostSobolDimensions);
  const auto size = static_cast<std::size_t>(dimensions);
  std::vector<double> shift(size, 0.0);
  if (seed != 0) {
    const Generator generator = MakeGenerator(seed);
    for (double& s : shift) s = gsl_rng_uniform_pos(generator.get());
  }
  const std::unique_ptr<gsl_qrng, decltype(&gsl_qrng_free)> sequence(
      gsl_qrng_alloc(gsl_qrng_sobol, static_cast<unsigned>(dimensions)), &gsl_qrng_free);
  std::vector<std::vector<double>> points(static_cast<std::size_t>(samples),
                                          std::vector<double>(size));
  for (auto& point : points) {
    gsl_qrng_get(sequence.get(), point.data());
    for (std::size_t axis = 0; axis < size; ++axis) {
      point[axis] += shift[axis];
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
