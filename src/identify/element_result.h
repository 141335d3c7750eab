// Result files of an identification of a bench part: scores, maps, parameters as JSON; series.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result_dir.h"
#include "identify/bench_forward.h"
#include "identify/identification.h"
#include "identify/motion_share.h"
#include "measurement/channel_scores.h"

namespace phs::identify::element {

/// Scores of the predicted rows over the estimation or the validation windows, with
/// `relative_percent` = 100 |y - ŷ| / |y| (norms over all rows).
nlohmann::ordered_json ScoreRows(const ElementData& data, const Rows& predicted, bool fitted);
/// On what the rows' residual depends: channel, depends_on, explained_share, p_values, whiteness_p.
nlohmann::ordered_json MapRows(const ElementData& data, const Rows& predicted, bool fitted);
/// What the scored rows leave, over the noise.
LeftOver LeftOfRows(const ElementData& data, const Rows& predicted);
/// The formula with its fitted coefficients, as text; null without.
nlohmann::ordered_json FormulaJson(const search::Identification& found);

/// t_s, x_m, force_N (and p_Pa, temperature_K) on the compared rows; several runs one after the
/// other with a column `run`. `force` null: as measured.
Status WriteRows(const std::string& path, const ElementData& data, const Rows* force);

}  // namespace phs::identify::element
