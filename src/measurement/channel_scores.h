// Error measures of a predicted channel (docs/identify.md). m%RE after Kat and Els (2012): relative
// error 100 |p - m|/|m| of each sample, capped at 100, averaged.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <vector>

namespace phs::measurement {

struct ChannelScore {
  double rmse = 0;
  double nrmse = 0;  ///< RMSE / standard deviation of what was measured; NaN if that is one value
  double bias = 0;   ///< mean of predicted - measured
  double max = 0;    ///< largest |predicted - measured|
  double m_re_percent = 0;
  double share_at_or_below_mean = 0;  ///< 0 … 1
  double share_below_12_percent = 0;  ///< share (0 … 1) of samples with relative error < 12 %
  int samples = 0;
};

/// Over the samples with time in `window`; measured NaN are left out.
ChannelScore Score(const std::vector<double>& time, const std::vector<double>& measured,
                   const std::vector<double>& predicted, const std::array<double, 2>& window);

/// All measures but the count, by the names of result.json.
nlohmann::ordered_json ToJson(const ChannelScore& score);

}  // namespace phs::measurement
