#include "identify/bench_checks.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "identify/bench_forward.h"

namespace phs::identify::element {
namespace {

using hydraulics::PhsParams;
using measurement::Manifest;

/// Work over its own size: 1 for a part that only rubs, 0 for a spring.
double WorkShare(const ElementData& data) {
  double work = 0, size = 0;
  for (const ElementRecord& r : data.records) {
    double mean = 0, count = 0;
    for (size_t k = 0; k < r.fitted.size(); ++k) {
      if (r.fitted[k]) mean += r.row_force_N[k], ++count;
    }
    mean /= std::max(count, 1.0);
    for (size_t k = 0; k < r.fitted.size(); ++k) {
      if (!r.fitted[k]) continue;
      const double v = r.motion.speed_m_s[0][static_cast<size_t>(r.row_sample[k])];
      work += (r.row_force_N[k] - mean) * v, size += std::abs((r.row_force_N[k] - mean) * v);
    }
  }
  return size > 0 ? work / size : 0;
}

struct Likeness {
  double correlation = 0;
  double ratio = 1;  ///< swing of the measured over that of the declared
};

std::optional<Likeness> Compared(const ElementData& data, const PhsParams& declared) {
  const auto bench = BenchForward::Create(data, declared, {});
  if (!bench.ok()) return std::nullopt;
  const Result<Rows> rows = bench.value()->Predict(declared);
  if (!rows.ok()) return std::nullopt;
  double n = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;
  for (size_t r = 0; r < data.records.size(); ++r) {
    const ElementRecord& record = data.records[r];
    for (size_t k = 0; k < record.fitted.size(); ++k) {
      if (!record.fitted[k]) continue;
      const double y = record.row_value[k], p = rows.value()[r][k];
      ++n, a += y, b += p, aa += y * y, bb += p * p, ab += y * p;
    }
  }
  const double va = aa - a * a / n, vb = bb - b * b / n;
  if (!(n > 1 && va > 0 && vb > 0)) return std::nullopt;
  return Likeness{(ab - a * b / n) / std::sqrt(va * vb), std::sqrt(va / vb)};
}

/// The record read with position and force under each other's name.
std::optional<Likeness> ComparedSwapped(const Manifest& manifest, const PhsParams& declared) {
  const auto name = [&](const char* channel) {
    const auto named = manifest.columns.find(channel);
    return named == manifest.columns.end() ? std::string(channel) : named->second;
  };
  Manifest swapped = manifest;
  swapped.columns["x_m"] = name("force_N"), swapped.columns["force_N"] = name("x_m");
  const Result<ElementData> data = ReadElementData(swapped);
  if (!data.ok()) return std::nullopt;
  return Compared(data.value(), declared);
}

}  // namespace

std::vector<std::string> FindFaults(const Manifest& manifest, const ElementData& data,
                                    const PhsParams& declared) {
  constexpr double kGivesOut = -0.1, kFollows = 0.7, kDoesNot = 0.5, kPowers = 2;
  // A position follows a force in a way of its own: what is compared is judged by its sign alone.
  const std::optional<Likeness> own = data.by_force ? std::nullopt : Compared(data, declared);
  if (own && own->correlation < kDoesNot) {
    const std::optional<Likeness> other = ComparedSwapped(manifest, declared);
    if (other && other->correlation > kFollows) {
      return {
          fmt::format("x_m and force_N are under each other's name: the force follows the "
                      "declared model with the columns swapped (correlation {:.2f}), not as "
                      "they are ({:.2f})",
                      other->correlation, own->correlation)};
    }
  }
  if (const double work = WorkShare(data); work < kGivesOut) {
    return {
        fmt::format("a turned sign: the part gives out work ({:.0f} % of all that passes "
                    "through it), which no passive part does; turn force_N or x_m (factors: "
                    "{{force_N: -1}})",
                    -100 * work)};
  }
  if (own && std::abs(own->correlation) > kFollows) {
    const double powers = std::round(std::log10(own->ratio));
    if (std::abs(powers) >= kPowers) {
      return {
          fmt::format("another unit: force_N swings {:.3g} times as much as the declared model "
                      "(factors: {{force_N: 1e{:.0f}}}), or is not the force but another column",
                      own->ratio, -powers)};
    }
  }
  return {};
}

}  // namespace phs::identify::element
