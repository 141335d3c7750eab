#include "measurement/channel_scores.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace phs::measurement {

ChannelScore Score(const std::vector<double>& time, const std::vector<double>& measured,
                   const std::vector<double>& predicted, const std::array<double, 2>& window) {
  ChannelScore score;
  double square = 0, mean = 0, mean_square = 0;
  std::vector<double> relative;
  for (size_t i = 0; i < time.size(); ++i) {
    if (time[i] < window[0] || time[i] > window[1] || !std::isfinite(measured[i])) continue;
    const double e = predicted[i] - measured[i];
    square += e * e, score.bias += e, mean += measured[i];
    mean_square += measured[i] * measured[i];
    score.max = std::max(score.max, std::abs(e));
    const double m = std::abs(measured[i]);
    relative.push_back(m > 0 ? std::min(100.0, 100 * std::abs(e) / m) : (e == 0 ? 0.0 : 100.0));
  }
  const double n = static_cast<double>(relative.size());
  score.samples = static_cast<int>(n);
  if (n == 0) return score;
  score.rmse = std::sqrt(square / n);
  score.bias /= n, mean /= n;
  const double deviation = std::sqrt(std::max(0.0, mean_square / n - mean * mean));
  const double none = score.rmse > 0 ? std::numeric_limits<double>::quiet_NaN() : 0;
  score.nrmse = deviation > 0 ? score.rmse / deviation : none;
  for (double r : relative) score.m_re_percent += r / n;
  const auto share = [&](auto holds) {
    return static_cast<double>(std::count_if(relative.begin(), relative.end(), holds)) / n;
  };
  score.share_at_or_below_mean = share([&](double r) { return r <= score.m_re_percent; });
  score.share_below_12_percent = share([](double r) { return r < 12; });
  return score;
}

nlohmann::ordered_json ToJson(const ChannelScore& s) {
  return {{"rmse", s.rmse},
          {"nrmse", s.nrmse},
          {"bias", s.bias},
          {"max", s.max},
          {"m_re_percent", s.m_re_percent},
          {"share_at_or_below_mean", s.share_at_or_below_mean},
          {"share_below_12_percent", s.share_below_12_percent}};
}

}  // namespace phs::measurement
