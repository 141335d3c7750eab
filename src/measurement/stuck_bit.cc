#include "measurement/stuck_bit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "measurement/channel_noise.h"
#include "measurement/series.h"

namespace phs::measurement {
namespace {

using Complex = std::complex<double>;

constexpr size_t kLeastJumps = 10;
constexpr double kMargin = 4, kLeastJump = 8;  // noise levels

/// White part of the noise, from second differences: the lower quarter of them knows nothing of the
/// jumps.
double NoiseBesideJumps(const std::vector<double>& y) {
  constexpr double kQuarter = 0.3186;  // of |N(0, 1)|
  std::vector<double> bends;
  for (size_t i = 2; i < y.size(); ++i) bends.push_back(std::abs(y[i] - 2 * y[i - 1] + y[i - 2]));
  return std::max(Quantile(std::move(bends), 0.25) / (kQuarter * std::sqrt(6.0)),
                  Quantum(y) / std::sqrt(12.0));
}

/// Readings that have moved on from the one before by more than the margin: values where the
/// channel rests count no more than those that it passes.
std::vector<double> Passed(const std::vector<double>& y, double noise) {
  constexpr size_t kMost = 4000;
  std::vector<double> out = {y.front()};
  for (const double value : y) {
    if (std::abs(value - out.back()) > kMargin * noise) out.push_back(value);
  }
  const size_t stride = out.size() / kMost + 1;
  for (size_t i = 0; i * stride < out.size(); ++i) out[i] = out[i * stride];
  out.resize((out.size() + stride - 1) / stride);
  return out;
}

/// Mean of exp(2 pi i y/period): of values that fill half of each period its size is 2/pi, of those
/// that fill it 0. Its angle is that of the middle of what they fill.
Complex Gather(const std::vector<double>& y, size_t from, double period) {
  Complex sum = 0;
  for (size_t i = from; i < y.size(); ++i) sum += std::polar(1.0, 2 * M_PI * y[i] / period);
  return sum / static_cast<double>(y.size() - from);
}

/// Periods [unit of y] in which the values gather most, the best first.
std::vector<double> Periods(const std::vector<double>& y, double span, double noise) {
  constexpr double kGathered = 0.3, kFewest = 4, kMostPeriods = 1000, kLeastWeight = 8;
  constexpr size_t kMost = 10;
  const double first = kFewest / span, step = 0.125 / span;
  const double last = std::min(kMostPeriods / span, 1 / (2 * kLeastWeight * noise));
  std::vector<Complex> now, turn;
  for (const double value : y) {
    now.push_back(std::polar(1.0, 2 * M_PI * value * first));
    turn.push_back(std::polar(1.0, 2 * M_PI * value * step));
  }
  std::vector<double> gathered;
  for (double at = first; at < last; at += step) {
    Complex sum = 0;
    for (size_t i = 0; i < y.size(); ++i) sum += now[i], now[i] *= turn[i];
    gathered.push_back(std::abs(sum) / static_cast<double>(y.size()));
  }
  std::vector<size_t> peaks;
  for (size_t i = 1; i + 1 < gathered.size(); ++i) {
    const bool peak = gathered[i] >= gathered[i - 1] && gathered[i] >= gathered[i + 1];
    if (peak && gathered[i] > kGathered) peaks.push_back(i);
  }
  std::stable_sort(peaks.begin(), peaks.end(),
                   [&](size_t a, size_t b) { return gathered[a] > gathered[b]; });
  peaks.resize(std::min(peaks.size(), kMost));
  std::vector<double> periods;
  for (const size_t i : peaks) {
    double best = first + static_cast<double>(i) * step;
    for (double fine = 0.5 * step; fine > 0.01 * step; fine *= 0.5) {
      for (const double at : {best - fine, best + fine}) {
        if (std::abs(Gather(y, 0, 1 / at)) > std::abs(Gather(y, 0, 1 / best))) best = at;
      }
    }
    periods.push_back(1 / best);
  }
  return periods;
}

/// Sizes of jumps that come while the channel hardly moves; 0 at other samples.
std::vector<double> FlatJumps(const std::vector<double>& y, double noise) {
  std::vector<double> out(y.size(), 0.0);
  for (size_t i = 1; i + 2 < y.size(); ++i) {
    const double jump = y[i + 1] - y[i], before = y[i] - y[i - 1], after = y[i + 2] - y[i + 1];
    const double flat = 0.25 * std::abs(jump);
    if (std::abs(jump) < kLeastJump * noise) continue;
    if (std::abs(before) < flat && std::abs(after) < flat) {
      out[i] = std::abs(jump - 0.5 * (before + after));
    }
  }
  return out;
}

size_t CountAbout(const std::vector<double>& jumps, size_t from, double weight) {
  constexpr double kAbout = 0.2;
  return static_cast<size_t>(
      std::count_if(jumps.begin() + static_cast<long>(from), jumps.end(),
                    [&](double jump) { return std::abs(jump - weight) < kAbout * weight; }));
}

/// First sample from which on no two in a row lie in the bands left out.
size_t KeepsOutFrom(const std::vector<double>& y, const std::vector<double>& passed, double period,
                    double noise) {
  Complex gathered = Gather(passed, 0, period);
  size_t from = 0;
  for (int round = 0; round < 3 && from + kLeastJumps < y.size(); ++round) {
    const double middle = std::arg(gathered) / (2 * M_PI) * period;
    from = 0;
    bool before = false;
    for (size_t i = 0; i < y.size(); ++i) {
      const double away = std::abs(std::remainder(y[i] - middle, period));
      const bool out = away > 0.25 * period + kMargin * noise;
      if (out && before) from = i + 1;
      before = out;
    }
    if (from < y.size()) gathered = Gather(y, from, period);
  }
  return from;
}

/// Over the states of the bit, right or wrong, at a sample and (times two) the one before.
using Row = std::array<double, 4>;

/// What it costs that y - shift where the bit is wrong bends at sample i, as |second difference|; a
/// jump that stays counts no more than one weight. `state`: now, before and earlier, a bit each.
double Bend(const std::vector<double>& y, size_t i, double shift, size_t state) {
  const auto value = [&](size_t back) {
    return y[i - back] - shift * static_cast<double>((state >> back) & 1);
  };
  return std::min(std::abs(value(0) - 2 * value(1) + value(2)), std::abs(shift));
}

constexpr Row kNever = {INFINITY, INFINITY, INFINITY, INFINITY};

/// Where the bit is wrong so that the channel read back bends least (the least cost of all ways
/// through each state of each sample, forwards and backwards). Returns that cost.
double ReadBack(const std::vector<double>& y, size_t from, double shift, StuckBit* bit) {
  const size_t n = y.size();
  std::vector<Row> before(n, kNever), after(n, kNever);
  before[1] = from < 2 ? Row{} : Row{0, INFINITY, INFINITY, INFINITY};
  for (size_t i = 2; i < n; ++i) {
    for (size_t state = 0; state < 8; ++state) {
      if (i < from && (state & 1) != 0) continue;
      double& best = before[i][state & 3];
      best = std::min(best, before[i - 1][state >> 1] + Bend(y, i, shift, state));
    }
  }
  after[n - 1] = {};
  for (size_t i = n - 1; i > 1; --i) {
    for (size_t state = 0; state < 8; ++state) {
      double& best = after[i - 1][state >> 1];
      best = std::min(best, after[i][state & 3] + Bend(y, i, shift, state));
    }
  }
  constexpr double kTold = 1;  // weights by which the other state costs more
  bit->wrong.assign(n, 0), bit->told.assign(n, 1);
  double least = INFINITY;
  for (size_t i = 1; i < n; ++i) {
    const auto through = [&](size_t state) { return before[i][state] + after[i][state]; };
    const double right = std::min(through(0), through(2)), wrong = std::min(through(1), through(3));
    bit->wrong[i] = wrong < right;
    bit->told[i] = std::abs(wrong - right) > kTold * std::abs(shift);
    least = std::min(right, wrong);
  }
  return least;
}

}  // namespace

std::optional<StuckBit> FindStuckBit(const std::vector<double>& y) {
  constexpr double kGathered = 0.5;
  constexpr size_t kLeastSamples = 100;
  if (y.size() < kLeastSamples) return {};
  const double noise = NoiseBesideJumps(y);
  if (!(noise > 0)) return {};
  const std::vector<double> jumps = FlatJumps(y, noise);
  const auto flat = std::count_if(jumps.begin(), jumps.end(), [](double j) { return j > 0; });
  if (static_cast<size_t>(flat) < kLeastJumps) return {};
  const auto [low, high] = std::minmax_element(y.begin(), y.end());
  const std::vector<double> passed = Passed(y, noise);
  for (const double period : Periods(passed, *high - *low, noise)) {
    StuckBit bit;
    bit.weight = 0.5 * period;
    bit.from = KeepsOutFrom(y, passed, period, noise);
    if (bit.from + kLeastSamples > y.size()) continue;
    if (CountAbout(jumps, bit.from, bit.weight) < kLeastJumps) continue;
    if (std::abs(Gather(y, bit.from, period)) < kGathered) continue;
    StuckBit zero = bit;
    zero.at_one = false;
    const double one_costs = ReadBack(y, bit.from, bit.weight, &bit);
    const double zero_costs = ReadBack(y, bit.from, -bit.weight, &zero);
    return one_costs <= zero_costs ? bit : zero;
  }
  return {};
}

void ReadBackStuckBit(const RigRun& run, Channel* channel, std::vector<DataFinding>* findings) {
  const std::optional<StuckBit> bit = FindStuckBit(channel->y);
  if (!bit) return;
  const double shift = bit->at_one ? bit->weight : -bit->weight;
  size_t untold = 0;
  for (size_t i = 0; i < channel->y.size(); ++i) {
    if (bit->wrong[i] != 0) channel->y[i] -= shift;
    if (bit->told[i] == 0) channel->bad[i] = 1, ++untold;
  }
  const std::string when =
      bit->from > 0
          ? fmt::format("at {} from {:.4g} s on", bit->at_one ? 1 : 0,
                        run.Time(static_cast<int>(bit->from)))
          : fmt::format("throughout (taken as at 1; at 0 all would be {:.4g} more)", bit->weight);
  findings->push_back(
      {channel->name, fmt::format("a bit of its converter, worth {:.4g}, is stuck {}: read back; "
                                  "{} samples of which it is not told are left out",
                                  bit->weight, when, untold)});
}

}  // namespace phs::measurement
