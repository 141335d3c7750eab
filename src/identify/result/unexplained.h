// What is known of a residual, on its way from the numbers to result.json and to the next test.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "identify/discrepancy/formula_search.h"
#include "measurement/channel_scores.h"

namespace phs::identify {

/// Errors of a channel: declared model as fitted, corrected model.
struct BeforeAfter {
  std::string channel;
  measurement::ChannelScore before, after;
};

/// Where a residual lives.
struct Localised {
  std::string channel;
  std::vector<std::string> depends_on;  ///< variables, the strongest first
  std::vector<VariableShare> shares;    ///< of all variables
  /// Rms over noise and the model's own uncertainty, by channel.
  std::vector<std::pair<std::string, double>> over_noise;
};

/// What the corrected model leaves in the validation window, in its worst channel.
struct Unexplained {
  std::string channel;
  double nrmse = 0;
  double whiteness_p = 1;           ///< Ljung–Box
  double over_noise = 0;            ///< rms over noise and the model's own uncertainty
  double following_over_noise = 0;  ///< of the part that follows what the rig did
  std::optional<double> estimation_over_noise = {};  ///< the same rms in the estimation window
  std::vector<std::string> depends_on = {};
  std::string formula = {};  ///< that was accepted; empty: none
};

}  // namespace phs::identify
