#include "identify/run/bench_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "identify/models/bench_forward.h"
#include "measurement/units.h"

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

/// How far a number was driven, and how it depends on what a newton and a metre are.
struct Driven {
  double log_ratio = 0;  ///< ln(fitted / declared)
  int newtons = 0, metres = 0;
};

std::vector<Driven> DrivenNumbers(const std::vector<FittedNumber>& numbers) {
  constexpr struct {
    const char* ending;
    int newtons, metres;
  } kQuantities[] = {{"_N_per_m", 1, -1}, {"_Ns_per_m", 1, -1}, {"_N_per_m3", 1, -3},
                     {"_kg", 1, -1},      {"_N", 1, 0},         {"_m_s", 0, 1},
                     {"_m", 0, 1}};  // the longer of two first
  std::vector<Driven> out;
  for (const FittedNumber& n : numbers) {
    if (n.at_end || !(n.fitted / n.declared > 0) || !std::isfinite(n.fitted / n.declared)) continue;
    const auto quantity = std::find_if(std::begin(kQuantities), std::end(kQuantities),
                                       [&](const auto& q) { return n.name.ends_with(q.ending); });
    if (quantity == std::end(kQuantities)) continue;
    out.push_back({std::log(n.fitted / n.declared), quantity->newtons, quantity->metres});
  }
  return out;
}

}  // namespace

std::optional<std::string> FindSwallowedUnit(const std::vector<FittedNumber>& numbers) {
  constexpr size_t kMore = 3;    // numbers than channels that may be off
  constexpr double kMost = 0.2;  // of how far the numbers were driven
  const double kAlike = std::log(1.5), kDriven = std::log(3.0);
  const std::vector<Driven> driven = DrivenNumbers(numbers);
  const auto left = [&](double force,
                        double position) {  // what readings too large by so much leave
    double square = 0;
    for (const Driven& d : driven) {
      square +=
          std::pow(d.log_ratio - d.newtons * std::log(force) - d.metres * std::log(position), 2);
    }
    return std::sqrt(square / static_cast<double>(driven.size()));
  };
  if (driven.empty() || left(1, 1) < kDriven) return std::nullopt;
  std::vector<double> forces = {1}, lengths = {1};
  for (const measurement::Unit& unit : measurement::KnownUnits()) {
    if (unit.si == std::string("_N")) forces.push_back(unit.factor);
    if (unit.si == std::string("_m")) lengths.push_back(unit.factor);
  }
  double least = std::min(kAlike, kMost * left(1, 1)), force = 1, position = 1;
  for (const double newtons : forces) {
    for (const double taken : lengths) {
      for (const double metres : lengths) {
        const size_t off = (newtons != 1 ? 1 : 0) + (taken != metres ? 1 : 0);
        if (driven.size() < kMore + off) continue;
        const double now = left(1 / newtons, taken / metres);
        if (now < least) least = now, force = 1 / newtons, position = taken / metres;
      }
    }
  }
  std::vector<std::string> read, factors;
  const auto add = [&](const char* channel, double size) {
    if (size == 1) return;
    const auto unit = measurement::UnitThatReads(channel, size);
    read.push_back(fmt::format("{} read {:.4g} times its size{}", channel, size,
                               unit ? " (in " + unit->name() + "?)" : ""));
    factors.push_back(fmt::format("{}: {:.6g}", channel, 1 / size));
  };
  add("force_N", force), add("x_m", position);
  if (read.empty()) return std::nullopt;
  return fmt::format("another unit: all numbers are fitted as if {} (factors: {{{}}})",
                     fmt::join(read, " and "), fmt::join(factors, ", "));
}

std::vector<std::string> FindFaults(const Manifest& manifest, const ElementData& data,
                                    const PhsParams& declared) {
  constexpr double kGivesOut = -0.1, kFollows = 0.7, kDoesNot = 0.5, kOtherUnit = 32;
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
    if (std::abs(std::log(own->ratio)) >= std::log(kOtherUnit)) {
      const auto unit = measurement::UnitThatReads("force_N", own->ratio);
      return {fmt::format(
          "another unit: force_N swings {:.3g} times as much as the declared model{}, or is "
          "not the force but another column",
          own->ratio,
          unit ? fmt::format(" ({}? factors: {{force_N: {:.6g}}})", unit->name(), unit->factor)
               : "")};
    }
  }
  return {};
}

}  // namespace phs::identify::element
