#include "measurement/data_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "measurement/channel_noise.h"
#include "measurement/series.h"
#include "measurement/units.h"

namespace phs::measurement {
namespace {

/// Correlation of measured and predicted, and the ratio of their swings.
struct Likeness {
  double correlation = 0;
  double ratio = 1;  ///< measured over predicted standard deviation
  double mean = 0;   ///< of the measured
};

Likeness Compare(const std::vector<double>& measured, const std::vector<double>& predicted) {
  Likeness out;
  double n = 0, mb = 0, aa = 0, bb = 0, ab = 0;
  for (size_t i = 0; i < measured.size(); ++i) {
    if (std::isfinite(measured[i])) ++n, out.mean += measured[i], mb += predicted[i];
  }
  if (n < 2) return out;
  out.mean /= n, mb /= n;
  for (size_t i = 0; i < measured.size(); ++i) {
    if (!std::isfinite(measured[i])) continue;
    const double a = measured[i] - out.mean, b = predicted[i] - mb;
    aa += a * a, bb += b * b, ab += a * b;
  }
  if (!(aa > 0 && bb > 0)) return out;
  out.ratio = std::sqrt(aa / bb);
  out.correlation = ab / std::sqrt(aa * bb);
  return out;
}

constexpr double kLike = 0.6;  ///< correlation beyond which a channel follows, or runs against
/// Swing over the model's, either way: beyond what a declared model is wrong by, to be asked about,
/// and another unit.
constexpr double kFar = 3, kOtherUnit = 32;

bool IsBeyond(double ratio, double factor) { return std::abs(std::log(ratio)) >= std::log(factor); }

std::string Quantity(const std::string& name) { return name.substr(name.rfind('_')); }

/// Of one quantity, by their shapes.
bool AreSwapped(const FitData& data, const std::vector<std::vector<double>>& predicted, size_t a,
                size_t b) {
  const auto &ya = data.outputs[a].values, &yb = data.outputs[b].values;
  const Likeness own_a = Compare(ya, predicted[a]), own_b = Compare(yb, predicted[b]);
  const Likeness cross_a = Compare(ya, predicted[b]), cross_b = Compare(yb, predicted[a]);
  if (Quantity(data.outputs[a].name) != Quantity(data.outputs[b].name)) {
    // Of two quantities, by their sizes too.
    const auto follows = [](const Likeness& l) {
      return l.correlation > 0.7 && !IsBeyond(l.ratio, kFar);
    };
    return IsBeyond(own_a.ratio, 3 * kFar) && IsBeyond(own_b.ratio, 3 * kFar) && follows(cross_a) &&
           follows(cross_b);
  }
  // Pressures of the wrong sign would be negative; under the wrong name they stay positive.
  const bool pressure = Quantity(data.outputs[a].name) == "_Pa";
  if (pressure && (own_a.mean < 0 || own_b.mean < 0)) return false;
  return cross_a.correlation > 0.7 && cross_b.correlation > 0.7 && own_a.correlation < 0.5 &&
         own_b.correlation < 0.5;
}

/// The first and the last three samples have neighbours on one side alone: each is foretold by a
/// parabola through the three next to it, and by a straight line through two. Returns how many were
/// no measurement; they are put on the line.
int MarkEnds(double noise, Channel* channel) {
  constexpr std::ptrdiff_t kEnd = 3;
  constexpr double kAmplified = 4.4;  // sqrt(1 + 9 + 9 + 1) of a sample less its parabola
  std::vector<double>& y = channel->y;
  const auto n = static_cast<std::ptrdiff_t>(y.size());
  int marked = 0;
  for (const std::ptrdiff_t inward : {1, -1}) {
    for (std::ptrdiff_t k = kEnd - 1; k >= 0 && n > 4 * kEnd; --k) {
      const std::ptrdiff_t i = inward > 0 ? k : n - 1 - k;
      const auto next = [&](std::ptrdiff_t steps) {
        return y[static_cast<size_t>(i + steps * inward)];
      };
      const double parabola = 3 * next(1) - 3 * next(2) + next(3), line = 2 * next(1) - next(2);
      const double off = std::min(std::abs(next(0) - parabola), std::abs(next(0) - line));
      if (!(off > 12 * kAmplified * noise + 8 * std::abs(parabola - line))) continue;
      y[static_cast<size_t>(i)] = line, channel->bad[static_cast<size_t>(i)] = 1, ++marked;
    }
  }
  return marked;
}

/// Samples [begin, end) that show one value.
struct Stretch {
  size_t begin = 0, end = 0;
};

std::vector<Stretch> EqualStretches(const Channel& channel) {
  const std::vector<double>& y = channel.y;
  std::vector<Stretch> out;
  for (size_t i = 0; i < y.size(); i = out.back().end) {
    size_t end = i + 1;
    while (end < y.size() && y[end] == y[i] && !channel.bad[end]) ++end;
    out.push_back({i, end});
  }
  return out;
}

/// The motion that drives the rig repeats itself to the last digit there, too: a record without noise.
bool DriveStandsExactly(const RigRun& run, const Channel& channel, const Stretch& stretch) {
  return !run.inputs.empty() &&
         std::all_of(run.inputs.begin(), run.inputs.end(), [&](const Channel& input) {
           if (&input == &channel || input.y.size() < stretch.end) return false;
           const auto begin = input.y.begin() + static_cast<long>(stretch.begin);
           const auto end = input.y.begin() + static_cast<long>(stretch.end);
           return !input.bad[stretch.begin] &&
                  std::all_of(begin, end, [&](double x) { return x == *begin; });
         });
}

/// Samples of one value that noise does not make (MarkStuck).
size_t LeastStuck(const ChannelNoise& noise, const std::vector<Stretch>& stretches,
                  size_t samples) {
  constexpr double kWanted = 1e-3;       // of channels of noise alone
  constexpr double kLeastRepeat = 1e-3;  // p: below, a record may hold doubled rows
  std::vector<double> lengths;
  lengths.reserve(stretches.size());
  for (const Stretch& s : stretches) lengths.push_back(static_cast<double>(s.end - s.begin));
  const double clock = Quantile(lengths, 0.5);
  const double p = std::max(std::erf(noise.quantum / (std::sqrt(8.0) * noise.white)), kLeastRepeat);
  const double repeats = std::log(static_cast<double>(samples) / kWanted) / -std::log(p);
  return static_cast<size_t>(std::ceil(clock * (1 + repeats)));
}

}  // namespace

void MarkSpikes(Channel* channel, std::vector<DataFinding>* findings) {
  std::vector<double>& y = channel->y;
  const double noise = std::max(WhiteNoise(y, channel->bad), Quantum(y) / 3.46);
  int removed = MarkEnds(noise, channel);
  std::vector<size_t> spikes;
  for (size_t i = 2; i + 2 < y.size(); ++i) {
    const double around = (4 * (y[i - 1] + y[i + 1]) - (y[i - 2] + y[i + 2])) / 6;
    const double spread = std::abs(y[i + 1] - y[i - 1]) + std::abs(y[i + 2] - y[i + 1]) +
                          std::abs(y[i - 1] - y[i - 2]);
    if (std::abs(y[i] - around) > 12 * noise + 4 * spread) spikes.push_back(i), ++removed;
  }
  for (size_t i : spikes) y[i] = 0.5 * (y[i - 1] + y[i + 1]), channel->bad[i] = 1;
  if (removed > 0) {
    findings->push_back({channel->name, fmt::format("{} spikes: left out", removed)});
  }
}

void MarkMotionSpikes(Channel* channel, std::vector<DataFinding>* findings) {
  std::vector<double>& y = channel->y;
  const double noise = std::max(WhiteNoise(y, channel->bad), Quantum(y) / 3.46);
  const size_t ends = MarkEnds(noise, channel);
  std::vector<size_t> spikes;
  for (size_t i = 3; i + 3 < y.size(); ++i) {
    const double inner = (4 * (y[i - 1] + y[i + 1]) - (y[i - 2] + y[i + 2])) / 6;
    const double outer = 0.9 * (y[i - 2] + y[i + 2]) - 0.4 * (y[i - 3] + y[i + 3]);
    const auto [low, high] = std::minmax({y[i - 2], y[i - 1], y[i + 1], y[i + 2]});
    const double beyond = std::max(y[i] - high, low - y[i]);
    const double off = std::min(beyond, std::abs(y[i] - inner));  // at a turn the first alone
    if (off > 12 * noise + 4 * std::abs(inner - outer)) spikes.push_back(i);
  }
  for (const size_t i : spikes) y[i] = 0.5 * (y[i - 1] + y[i + 1]), channel->bad[i] = 1;
  if (spikes.empty() && ends == 0) return;
  findings->push_back({channel->name, fmt::format("{} spikes: left out", spikes.size() + ends)});
}

void MarkStuck(Channel* channel, const RigRun& run, std::vector<DataFinding>* findings) {
  const std::vector<double>& y = channel->y;
  // Of coarse steps, or without noise, repeats are natural.
  if (!(channel->noise.white > std::max(0.8 * channel->noise.quantum, LeastNoise(y)))) return;
  const std::vector<Stretch> stretches = EqualStretches(*channel);
  const size_t least = LeastStuck(channel->noise, stretches, y.size());
  const auto [low, high] = std::minmax_element(y.begin(), y.end());
  size_t saturated = 0, stuck = 0, times = 0;
  double from = 0, to = 0;
  std::vector<double> ends;  // values at which the channel was saturated, rising
  for (const auto& [begin, end] : stretches) {
    if (end - begin < least || channel->bad[begin]) continue;
    if (DriveStandsExactly(run, *channel, {begin, end})) continue;
    const double at = y[begin];
    const bool edge = at == *low || at == *high;
    (edge ? saturated : stuck) += end - begin;
    if (edge) {
      ends.insert(std::upper_bound(ends.begin(), ends.end(), at), at);
    } else {
      if (times++ == 0) from = run.Time(static_cast<int>(begin));
      to = run.Time(static_cast<int>(end - 1));
    }
    std::fill(channel->bad.begin() + static_cast<long>(begin),
              channel->bad.begin() + static_cast<long>(end), 1);
  }
  if (saturated > 0) {  // one end is proved: its shorter stays are no measurement either
    for (size_t i = 0; i < y.size(); ++i) {
      if (channel->bad[i] || !std::binary_search(ends.begin(), ends.end(), y[i])) continue;
      channel->bad[i] = 1, ++saturated;
    }
    const std::string other =
        ends.front() == ends.back() ? "" : fmt::format(" and {:.4g}", ends.back());
    findings->push_back({channel->name, fmt::format("saturated at {:.4g}{}: {} samples left out",
                                                    ends.front(), other, saturated)});
  }
  if (stuck > 0) {
    const std::string often = times > 1 ? fmt::format(" {} times", times) : "";
    findings->push_back(
        {channel->name, fmt::format("stuck{} between {:.4g} and {:.4g} s: {} samples left out",
                                    often, from, to, stuck)});
  }
}

double MendInputScale(const hydraulics::PhsParams& params, Channel* input,
                      std::vector<DataFinding>* findings) {
  double stroke = 0.03;
  for (const auto& cylinder : params.cylinders)
    stroke = std::max(stroke, 2 * cylinder.end_stop.clearance_m);
  const double reach = Quantile(input->y, 0.99) - Quantile(input->y, 0.01);
  double factor = 1;
  while (reach * factor > 20 * stroke && factor > 1e-9) factor *= 1e-3;
  if (factor == 1) return factor;
  for (double& x : input->y) x *= factor;
  findings->push_back(
      {input->name, fmt::format("swings {:.3g} m, far beyond the stroke: taken in units of {:g} m",
                                reach, factor)});
  return factor;
}

double SwingsOff(const FitData& data, const std::vector<std::vector<double>>& predicted) {
  constexpr double kLost = 1e3;
  std::vector<double> off;
  for (size_t c = 0; c < data.outputs.size(); ++c) {
    const Likeness like = Compare(data.outputs[c].values, predicted[c]);
    const bool follows = std::abs(like.correlation) >= kLike;
    off.push_back(follows ? std::abs(std::log(like.ratio)) : std::log(kLost));
  }
  return Quantile(off, 0.5);
}

void ScaleInputs(double factor, FitData* data) {
  for (MeasuredChannel& input : data->inputs) {
    for (double& x : input.values) x *= factor;
    input.noise *= std::abs(factor);
  }
  for (SmoothMotion& motion : data->motion) {
    for (auto* row : {&motion.position, &motion.speed, &motion.acceleration}) {
      for (double& x : *row) x *= factor;
    }
    for (auto* row : {&motion.position_deviation, &motion.speed_deviation}) {
      for (double& x : *row) x *= std::abs(factor);
    }
  }
}

bool InputIsSwapped(const FitData& data, const std::vector<std::vector<double>>& predicted) {
  int with = 0, against = 0;
  for (size_t c = 0; c < data.outputs.size(); ++c) {
    const double r = Compare(data.outputs[c].values, predicted[c]).correlation;
    with += r > 0.5, against += r < -0.5;
  }
  return with == 0 && against >= 2 &&
         !(data.outputs.size() == 2 && AreSwapped(data, predicted, 0, 1));
}

void MendOutputs(const std::vector<std::vector<double>>& predicted, FitData* data) {
  auto& outputs = data->outputs;
  for (size_t a = 0; a < outputs.size(); ++a) {
    for (size_t b = a + 1; b < outputs.size(); ++b) {
      if (!AreSwapped(*data, predicted, a, b)) continue;
      std::swap(outputs[a].values, outputs[b].values);
      std::swap(outputs[a].noise, outputs[b].noise);
      data->findings.push_back(
          {outputs[a].name, "and " + outputs[b].name + " follow each other's prediction: swapped"});
    }
  }
  for (size_t c = 0; c < outputs.size(); ++c) {
    MeasuredChannel& out = outputs[c];
    const Likeness like = Compare(out.values, predicted[c]);
    if (std::abs(like.correlation) < kLike) continue;
    double factor = 1;
    if (like.correlation < 0) {
      factor = -1;
      data->findings.push_back(
          {out.name, fmt::format("runs against the model (correlation {:.2f}): sign swapped; "
                                 "tension and extension > 0, pressures absolute",
                                 like.correlation)});
    }
    const std::optional<Unit> unit = UnitThatReads(out.name, like.ratio);
    if (IsBeyond(like.ratio, kOtherUnit) && unit) {
      factor *= unit->factor;
      data->findings.push_back({out.name, fmt::format("swings {:.3g} times as much as the model: "
                                                      "taken in {}",
                                                      like.ratio, unit->name())});
    } else if (IsBeyond(like.ratio, kFar)) {
      const std::string asked = fmt::format(
          "swings {:.3g} times as much as the declared model: is it in {}? (columns, "
          "factors)",
          like.ratio, unit ? unit->name() : "another unit");
      data->findings.push_back({out.name, asked});
      data->questions.push_back(out.name + " " + asked);
    }
    if (factor == 1) continue;
    for (double& y : out.values) y *= factor;
    out.noise *= std::abs(factor);
  }
}

std::vector<std::string> FindContradictions(const std::vector<std::vector<double>>& predicted,
                                            const FitData& data) {
  std::vector<std::string> out;
  const auto& outputs = data.outputs;
  std::vector<char> swapped(outputs.size(), 0);
  for (size_t a = 0; a < outputs.size(); ++a) {
    for (size_t b = a + 1; b < outputs.size(); ++b) {
      if (!AreSwapped(data, predicted, a, b)) continue;
      swapped[a] = swapped[b] = 1;
      out.push_back(outputs[a].name + " and " + outputs[b].name +
                    " follow each other's prediction: are the columns swapped?");
    }
  }
  for (size_t c = 0; c < outputs.size(); ++c) {
    const Likeness like = Compare(outputs[c].values, predicted[c]);
    if (swapped[c] || std::abs(like.correlation) < kLike) continue;
    if (like.correlation < 0) {
      out.push_back(
          fmt::format("{} runs against the fitted model (correlation {:.2f}): is its "
                      "sign turned? (factors: {{{}: -1}})",
                      outputs[c].name, like.correlation, outputs[c].name));
    }
    if (IsBeyond(like.ratio, kFar)) {
      const std::optional<Unit> unit = UnitThatReads(outputs[c].name, like.ratio);
      out.push_back(
          fmt::format("{} swings {:.3g} times as much as the fitted model: is it in {}? "
                      "(columns, factors)",
                      outputs[c].name, like.ratio, unit ? unit->name() : "another unit"));
    }
  }
  return out;
}

namespace {

/// Marks in `out` the samples about where a pressure reads below vacuum.
void MarkBelowVacuum(const MeasuredChannel& channel, const FitData& data, std::vector<char>* out,
                     std::vector<DataFinding>* findings) {
  constexpr double kBelow_Pa = -1.2e5, kAbout_s = 0.01;
  const auto about = static_cast<size_t>(std::ceil(kAbout_s / data.step_s));
  const std::vector<double>& y = channel.values;
  for (size_t begin = 0; begin < y.size(); ++begin) {
    if (!(y[begin] < 0)) continue;
    size_t end = begin;
    double least = 0;
    for (; end < y.size() && y[end] < 0; ++end) least = std::min(least, y[end]);
    if (least < kBelow_Pa - 5 * channel.noise) {
      const size_t after = std::max(about, end - begin);
      const size_t first = begin - std::min(begin, about), last = std::min(end + after, y.size());
      std::fill(out->begin() + static_cast<long>(first), out->begin() + static_cast<long>(last), 1);
      findings->push_back(
          {channel.name,
           fmt::format("reads {:.3g} Pa, below absolute vacuum: every output left out "
                       "from {:.5g} to {:.5g} s",
                       least, data.time_s[first], data.time_s[last - 1])});
    }
    begin = end;
  }
}

}  // namespace

void LeaveOutBelowVacuum(FitData* data) {
  constexpr double kMostOfRecord = 0.05;
  std::vector<char> out(data->time_s.size(), 0);
  std::vector<DataFinding> findings;
  for (const MeasuredChannel& channel : data->outputs) {
    if (channel.name.ends_with("_Pa")) MarkBelowVacuum(channel, *data, &out, &findings);
  }
  const auto count = static_cast<double>(std::count(out.begin(), out.end(), 1));
  if (count > kMostOfRecord * static_cast<double>(out.size())) return;
  data->findings.insert(data->findings.end(), findings.begin(), findings.end());
  for (MeasuredChannel& channel : data->outputs) {
    for (size_t i = 0; i < out.size(); ++i) {
      if (out[i] != 0) channel.values[i] = std::numeric_limits<double>::quiet_NaN();
    }
  }
}

}  // namespace phs::measurement
