#include "measurement/held_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace phs::measurement {

namespace {

/// What a model moves within three samples of `at`: a jump of its own may come a little apart.
double RangeAbout(const std::vector<double>& predicted, size_t at) {
  constexpr size_t kApart = 3;
  const auto [low, high] = std::minmax_element(
      predicted.begin() + static_cast<long>(at - std::min(at, kApart)),
      predicted.begin() + static_cast<long>(std::min(at + kApart, predicted.size())));
  return *high - *low;
}

}  // namespace

std::vector<HeldStretch> FindHeld(const MeasuredChannel& channel,
                                  const std::vector<double>& predicted) {
  constexpr size_t kLeast = 4;
  constexpr double kFlat = 8, kStill = 1.6, kMoved = 10;  // noise levels
  constexpr double kHalf = 0.5, kTwice = 2, kAtOnce = 3;  // of the jump over the model's motion
  const std::vector<double>& y = channel.values;
  std::vector<HeldStretch> out;
  for (size_t begin = 0; begin < y.size();) {
    double low = y[begin], high = low, sum = 0, square = 0;
    size_t end = begin;
    for (; end < y.size() && std::isfinite(y[end]); ++end) {
      const double least = std::min(low, y[end]), most = std::max(high, y[end]);
      if (most - least > kFlat * channel.noise) break;
      low = least, high = most;
      sum += y[end] - y[begin], square += (y[end] - y[begin]) * (y[end] - y[begin]);
    }
    if (end == y.size() || !std::isfinite(y[end]) || end < begin + kLeast) {
      begin = std::max(end, begin + 1);
      continue;
    }
    const double count = static_cast<double>(end - begin), mean = sum / count;
    const double deviation = std::sqrt(std::max(0.0, square / count - mean * mean));
    const double jump = y[end] - y[begin] - mean;
    const double moved = predicted[end] - predicted[begin];
    const double at_once = RangeAbout(predicted, end);
    const double caught_up = jump / moved;
    const bool held = deviation < kStill * channel.noise &&
                      std::min(std::abs(jump), std::abs(moved)) > kMoved * channel.noise &&
                      caught_up > kHalf && caught_up < kTwice && std::abs(jump) > kAtOnce * at_once;
    if (held) out.push_back({begin, end});
    begin = end;
  }
  return out;
}

void LeaveOutHeld(const std::vector<std::vector<double>>& predicted, FitData* data) {
  constexpr size_t kOften = 3;
  for (size_t c = 0; c < data->outputs.size(); ++c) {
    MeasuredChannel& channel = data->outputs[c];
    const std::vector<HeldStretch> held = FindHeld(channel, predicted[c]);
    if (held.size() < kOften) continue;
    size_t count = 0, longest = 0;
    for (const auto& [begin, end] : held) {
      count += end - begin - 1, longest = std::max(longest, end - begin - 1);
      for (size_t i = begin + 1; i < end; ++i) {  // the first is the one that is held
        channel.values[i] = std::numeric_limits<double>::quiet_NaN();
      }
    }
    data->findings.push_back(
        {channel.name,
         fmt::format("holds its last value {} times, {:.3g} s at the longest, and jumps then to "
                     "where the model is, as a link that loses frames: {} samples left out",
                     held.size(), static_cast<double>(longest) * data->step_s, count)});
  }
}

}  // namespace phs::measurement
