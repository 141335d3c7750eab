#include "rail/irregularity.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/table.h"
#include "base/tridiagonal.h"

namespace phs::rail {

Result<IrregularitySamples> ReadIrregularity(const std::string& path) {
  Result<Table> read = ReadCsv(path);
  if (!read.ok()) return read.error();
  const Table& table = read.value();
  static const char* const kNames[] = {"alignment_m", "level_m", "cross_level_m", "gauge_m"};
  const std::string allowed = "columns s_m, alignment_m, level_m, cross_level_m, gauge_m";
  for (const std::string& name : table.names) {
    if (name != "s_m" &&
        std::find(std::begin(kNames), std::end(kNames), name) == std::end(kNames)) {
      return Error{path, "unknown column " + name, allowed, "rename or remove the column"};
    }
  }
  Result<std::vector<double>> s = table.Column("s_m");
  if (!s.ok()) return s.error();
  if (table.num_rows() < 4) {
    return Error{path, "only " + std::to_string(table.num_rows()) + " samples", "4 or more rows",
                 "give a longer record"};
  }
  IrregularitySamples samples;
  samples.s = s.value();
  for (int c = 0; c < kNumIrregularityChannels; ++c) {
    const int column = table.Find(kNames[c]);
    samples.channel[c] = column < 0 ? std::vector<double>(samples.s.size(), 0.0)
                                    : table.columns[static_cast<size_t>(column)];
  }
  for (size_t i = 0; i < samples.s.size(); ++i) {
    const std::string where = path + ":" + std::to_string(table.line[i]);
    if (!std::isfinite(samples.s[i]) || (i > 0 && samples.s[i] <= samples.s[i - 1])) {
      return Error{where, "s_m does not increase", "strictly increasing arc lengths",
                   "sort the rows and remove repeated ones"};
    }
    for (const auto& channel : samples.channel) {
      if (!(std::abs(channel[i]) <= 0.1)) {
        return Error{where, "an irregularity is no number or larger than 0.1 m",
                     "-0.1 <= x <= 0.1 m", "give metres, not millimetres"};
      }
    }
  }
  return samples;
}

void IrregularitySamples::Mirror() {
  for (IrregularityChannel c : {kAlignment, kCrossLevel}) {
    for (double& value : channel[c]) value = -value;
  }
}

Irregularity::Irregularity(const IrregularitySamples& samples, double fade) {
  PHS_CHECK(samples.s.size() >= 4 && fade >= 0);
  knots_.resize(samples.s.size());
  for (size_t i = 0; i < knots_.size(); ++i) {
    knots_[i].s = samples.s[i];
    PHS_CHECK(i == 0 || knots_[i].s > knots_[i - 1].s);
    for (int c = 0; c < kNumIrregularityChannels; ++c) knots_[i].value[c] = samples.channel[c][i];
  }
  Fade(fade);
  Spline();
  BuildBuckets();
}

void Irregularity::Fade(double length) {
  for (Knot& knot : knots_) {
    const double from_end = std::min(knot.s - begin_s(), end_s() - knot.s);
    const double t = length > 0 ? std::min(1.0, from_end / length) : (from_end > 0 ? 1.0 : 0.0);
    const double window = t * t * t * (t * (6 * t - 15) + 10);
    for (double& value : knot.value) value *= window;
  }
}

// Second derivatives M of the cubic spline with zero slope at both ends.
void Irregularity::Spline() {
  const size_t n = knots_.size();
  std::vector<TridiagonalRow> rows(n);
  std::vector<double> second(n);
  for (int c = 0; c < kNumIrregularityChannels; ++c) {
    auto step = [&](size_t i) { return knots_[i + 1].s - knots_[i].s; };
    auto slope = [&](size_t i) { return (knots_[i + 1].value[c] - knots_[i].value[c]) / step(i); };
    for (size_t i = 0; i < n; ++i) {
      const double below = i > 0 ? step(i - 1) : 0.0, above = i + 1 < n ? step(i) : 0.0;
      const double kink = (i + 1 < n ? slope(i) : 0.0) - (i > 0 ? slope(i - 1) : 0.0);
      rows[i] = {below, 2 * (below + above), above, 6 * kink};
    }
    SolveTridiagonal(rows, second);
    for (size_t i = 0; i < n; ++i) knots_[i].second[c] = second[i];
  }
}

void Irregularity::BuildBuckets() {
  const double length = end_s() - begin_s();
  buckets_per_metre_ = static_cast<double>(knots_.size() - 1) / length;
  const size_t count = static_cast<size_t>(length * buckets_per_metre_) + 2;
  bucket_.resize(count);
  std::int32_t knot = 0;
  for (size_t i = 0; i < count; ++i) {
    const double begin = begin_s() + static_cast<double>(i) / buckets_per_metre_;
    while (knot + 2 < static_cast<std::int32_t>(knots_.size()) &&
           knots_[static_cast<size_t>(knot) + 1].s <= begin) {
      ++knot;
    }
    bucket_[i] = std::max(0, knot - 1);  // one back, against rounding of the bucket's begin
  }
}

RailOffset Irregularity::At(Side side, double s) const noexcept {
  RailOffset offset;
  if (knots_.empty() || !(s >= begin_s() && s < end_s())) return offset;
  size_t i =
      static_cast<size_t>(bucket_[static_cast<size_t>((s - begin_s()) * buckets_per_metre_)]);
  while (knots_[i + 1].s <= s) ++i;
  const Knot& k0 = knots_[i];
  const Knot& k1 = knots_[i + 1];
  const double h = k1.s - k0.s;
  const double b = (s - k0.s) / h;
  const double a = 1 - b;
  double value[kNumIrregularityChannels];
  double slope[kNumIrregularityChannels];
  for (int c = 0; c < kNumIrregularityChannels; ++c) {
    value[c] = a * k0.value[c] + b * k1.value[c] +
               h * h / 6 * ((a * a * a - a) * k0.second[c] + (b * b * b - b) * k1.second[c]);
    slope[c] = (k1.value[c] - k0.value[c]) / h +
               h / 6 * ((3 * b * b - 1) * k1.second[c] - (3 * a * a - 1) * k0.second[c]);
  }
  const double half = side == Side::kLeft ? 0.5 : -0.5;
  offset.lateral = value[kAlignment] + half * value[kGauge];
  offset.vertical = value[kLevel] - half * value[kCrossLevel];
  offset.lateral_slope = slope[kAlignment] + half * slope[kGauge];
  offset.vertical_slope = slope[kLevel] - half * slope[kCrossLevel];
  return offset;
}

}  // namespace phs::rail
