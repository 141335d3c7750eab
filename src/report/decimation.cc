#include "report/decimation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "base/check.h"

namespace phs::report {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// Rows whose x grows strictly; the first row is kept.
void KeepGrowing(const std::vector<double>& x, const std::vector<double>& y,
                 std::vector<double>* x_kept, std::vector<double>* y_kept) {
  x_kept->reserve(x.size());
  y_kept->reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i])) continue;
    if (!x_kept->empty() && x[i] <= x_kept->back()) continue;
    x_kept->push_back(x[i]);
    y_kept->push_back(y[i]);
  }
}

/// Linear interpolation at `at`, with `*row` the last row at or before it on entry and exit.
double Interpolate(const std::vector<double>& x, const std::vector<double>& y, double at,
                   std::size_t* row) {
  if (x.empty() || at < x.front() || at > x.back()) return kNoValue;
  while (*row + 1 < x.size() && x[*row + 1] <= at) ++*row;
  if (*row + 1 == x.size()) return y[*row];
  const double part = (at - x[*row]) / (x[*row + 1] - x[*row]);
  return part == 0 ? y[*row] : y[*row] + part * (y[*row + 1] - y[*row]);
}

struct Extremes {
  std::size_t least = 0;
  std::size_t greatest = 0;
  bool turns = false;  ///< the rows go up and down
};

Extremes FindExtremes(const std::vector<double>& y, std::size_t begin, std::size_t end) {
  Extremes found{.least = begin, .greatest = begin};
  bool rises = false;
  bool falls = false;
  for (std::size_t i = begin + 1; i < end; ++i) {
    rises = rises || y[i] > y[i - 1];
    falls = falls || y[i] < y[i - 1];
    if (!(y[i] >= y[found.least])) found.least = i;
    if (!(y[i] <= y[found.greatest])) found.greatest = i;
  }
  found.turns = rises && falls;
  return found;
}

}  // namespace

std::vector<double> PutOnGrid(const std::vector<double>& x_in, const std::vector<double>& y_in,
                              const Grid& grid) {
  PHS_CHECK(x_in.size() == y_in.size());
  PHS_CHECK(grid.points >= 2 && grid.points % 2 == 0);
  std::vector<double> x;
  std::vector<double> y;
  KeepGrowing(x_in, y_in, &x, &y);
  std::vector<double> values(grid.points, kNoValue);
  const double width = 2 * (grid.end - grid.begin) / grid.points;
  std::size_t row = 0;    // for the interpolation
  std::size_t begin = 0;  // first row of the bucket
  for (int bucket = 0; bucket < grid.points / 2; ++bucket) {
    const bool last = bucket + 1 == grid.points / 2;
    const double limit = grid.begin + width * (bucket + 1);
    while (begin < x.size() && x[begin] < limit - width) ++begin;
    std::size_t end = begin;
    while (end < x.size() && (x[end] < limit || last)) ++end;
    values[2 * bucket] = Interpolate(x, y, grid.At(2 * bucket), &row);
    values[2 * bucket + 1] = Interpolate(x, y, grid.At(2 * bucket + 1), &row);
    if (end - begin >= 3) {
      const Extremes found = FindExtremes(y, begin, end);
      if (found.turns) {
        values[2 * bucket] = y[std::min(found.least, found.greatest)];
        values[2 * bucket + 1] = y[std::max(found.least, found.greatest)];
      }
    }
    begin = end;
  }
  return values;
}

std::string Base64(const std::vector<unsigned char>& bytes) {
  static constexpr char kLetters[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k) {
      text.push_back(k <= count ? kLetters[group >> (18 - 6 * k) & 63] : '=');
    }
  }
  return text;
}

PackedValues Pack(const std::vector<double>& values) {
  PackedValues packed;
  bool any = false;
  for (double value : values) {
    if (!std::isfinite(value)) continue;
    packed.least = any ? std::min(packed.least, value) : value;
    packed.greatest = any ? std::max(packed.greatest, value) : value;
    any = true;
  }
  const double span = packed.greatest - packed.least;
  std::vector<unsigned char> bytes;
  bytes.reserve(values.size() * 2);
  for (double value : values) {
    unsigned step = 65535;
    if (std::isfinite(value)) {
      step =
          span > 0 ? static_cast<unsigned>(std::lround((value - packed.least) / span * 65534)) : 0u;
    }
    bytes.push_back(static_cast<unsigned char>(step & 255));
    bytes.push_back(static_cast<unsigned char>(step >> 8));
  }
  packed.base64 = Base64(bytes);
  return packed;
}

}  // namespace phs::report
