#include "analysis/last_seconds.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "base/json_path.h"

namespace phs::analysis {
namespace {

using Rows = std::span<const double>;

/// Rows of a channel from `first` to the end.
Rows Last(const vehicle::RunOutcome& run, const std::string& channel, size_t first) {
  const std::vector<double>& all = run.columns[static_cast<size_t>(run.Find(channel))];
  return Rows(all).subspan(first);
}

double RmsAboutMean(Rows x) {
  double sum = 0, squares = 0;
  for (const double value : x) sum += value;
  const double mean = sum / static_cast<double>(x.size());
  for (const double value : x) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(x.size()));
}

double HalfSwing(Rows x) {
  const auto [least, greatest] = std::minmax_element(x.begin(), x.end());
  return 0.5 * (*greatest - *least);
}

}  // namespace

LastSeconds CalcLastSeconds(const vehicle::Simulation& simulation, const vehicle::RunOutcome& run,
                            double window_s) {
  LastSeconds out{window_s};
  const std::vector<double>& t = run.columns[static_cast<size_t>(run.Find("t_s"))];
  if (run.status != "ok" || t.size() < 4 || t.back() - t.front() < 2 * window_s) return out;
  const auto from = std::lower_bound(t.begin(), t.end(), t.back() - window_s);
  const size_t first = static_cast<size_t>(from - t.begin());
  double largest = -1, swing = 0;
  for (const plugin::WheelsetBinding& w : simulation.binding().wheelsets()) {
    const Rows sum_Y = Last(run, w.name + "_sum_Y_N", first);
    const double rms = RmsAboutMean(sum_Y),
                 own = HalfSwing(Last(run, w.name + "_lateral_m", first));
    out.wheelsets.push_back({w.name, rms, own});
    swing = std::max(swing, own);
    if (rms <= largest) continue;
    largest = rms;
    const size_t half = sum_Y.size() / 2;
    const double before = RmsAboutMean(sum_Y.first(half));
    out.rms_grows = before > 0 ? RmsAboutMean(sum_Y.subspan(half)) / before : 1;
  }
  out.largest_rms_sum_Y_N = largest;
  out.largest_swing_m = swing;
  return out;
}

nlohmann::ordered_json LastSecondsJson(const LastSeconds& last) {
  using Json = nlohmann::ordered_json;
  Json wheelsets = Json::array();
  for (const LastSeconds::Wheelset& w : last.wheelsets) {
    wheelsets.push_back({{"name", w.name}, {"rms_sum_Y_N", w.rms_sum_Y_N}, {"swing_m", w.swing_m}});
  }
  return {{"window_s", last.window_s},
          {"wheelsets", std::move(wheelsets)},
          {"largest_rms_sum_Y_N", NumberOrNull(last.largest_rms_sum_Y_N)},
          {"largest_swing_m", NumberOrNull(last.largest_swing_m)},
          {"rms_grows", NumberOrNull(last.rms_grows)}};
}

}  // namespace phs::analysis
