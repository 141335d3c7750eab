// Result files of an identification of a bench part: scores, maps, parameters as JSON; series.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result_dir.h"
#include "identify/discrepancy/formula_search.h"
#include "identify/models/bench_forward.h"
#include "identify/result/motion_share.h"
#include "identify/select/identification.h"
#include "measurement/channel_scores.h"

namespace phs::identify::element {

/// Scores of the predicted rows over the estimation or the validation windows.
struct RowScore {
  measurement::ChannelScore score;
  double relative_percent = 0;  ///< 100 |y - ŷ| / |y| (norms over all rows)
};
RowScore ScoreRows(const ElementData& data, const Rows& predicted, bool fitted);
nlohmann::ordered_json ToJson(const RowScore& score);

/// On what the rows' residual depends; `uncertain`: BenchForward::Uncertain.
struct RowMap {
  std::string channel;                  ///< that is compared
  std::vector<std::string> depends_on;  ///< variables, the strongest first
  std::vector<VariableShare> shares;    ///< of all variables
  double over_noise = 0;                ///< rms over the noise of the force
  double whiteness_p = 1;               ///< Ljung–Box
};
RowMap MapRows(const ElementData& data, const Rows& predicted, const Rows& uncertain, bool fitted);
nlohmann::ordered_json ToJson(const RowMap& map);

/// What the rows of the estimation (`fitted`) or of the validation windows leave, over the noise.
LeftOver LeftOfRows(const ElementData& data, const Rows& predicted, const Rows& uncertain,
                    bool fitted);
/// The formula with its fitted coefficients; empty without.
std::string FormulaText(const search::Identification& found);

/// t_s, x_m, force_N (and p_Pa, temperature_K) on the compared rows; several runs one after the
/// other with a column `run`. `predicted` of what is compared; null: as measured.
Status WriteRows(const std::string& path, const ElementData& data, const Rows* predicted);

}  // namespace phs::identify::element
