// result.json of an identification, part by part (docs/program.md names the fields).
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "identify/result/motion_share.h"
#include "identify/result/unexplained.h"
#include "identify/select/identification.h"
#include "identify/select/verdict.h"
#include "measurement/fit_data.h"

namespace phs::identify::search {

using Json = nlohmann::ordered_json;

/// Errors of one predicted set of channels over a window, by name of channel.
Json ScoreChannels(const measurement::FitData& data, const Channels& predicted,
                   const std::array<double, 2>& window);
std::vector<BeforeAfter> ScoreBoth(const measurement::FitData& data, const Channels& before,
                                   const Channels& after, const std::array<double, 2>& window);
/// What a fit leaves of each channel of `data`, all runs together: weighted mean square.
std::vector<double> MeanSquares(const measurement::FitData& data, const FitProblem& problem,
                                const FitResult& fit);
/// Of the declared model as fitted, which leaves `mean_squares`.
Localised Localise(const measurement::FitData& data, const Channels& predicted,
                   const std::vector<double>& mean_squares);
/// `left`: by channel, in the validation window; `mean_squares`: in estimation.
Unexplained FindUnexplained(const measurement::FitData& data, const Channels& after,
                            const std::vector<LeftOver>& left,
                            const std::vector<double>& mean_squares, const Identification& found);
/// Null where empty.
Json OrNull(const std::string& text);
Json ScoresJson(const std::vector<BeforeAfter>& scores);
Json LocalisedJson(const Localised& found);
Json UnexplainedJson(const Unexplained& left);
/// Values and intervals of the free numbers [begin, end).
Json Parameters(const FreeModel& model, const FitResult& fit, size_t begin, size_t end,
                bool whole_name);
Json EffectList(const Identification& found);
Json CandidateList(const Identification& found);
/// The accepted effects and what explains as much.
std::vector<NamedEffect> NamedEffects(const Identification& found);
/// Of what was tried last and refused for amounts at the end of what is plausible alone: the one
/// that explains most.
std::optional<BeyondRange> WouldExplain(const Identification& found);
/// The declared numbers after the last fit.
std::vector<FittedNumber> FittedNumbers(const Identification& found);
/// "verdict", "verdict_text" and "reasons".
void PutVerdict(const VerdictFacts& facts, Json* result);
/// The same for the terminal.
std::string VerdictLines(const Json& result);

/// "rule" where it is another than the product's own: what was changed, what was left out.
void PutRule(const SearchRule& rule, Json* result);

/// Noise of each channel.
Json NoiseLevels(const measurement::FitData& data);
Json FindingList(const std::vector<measurement::DataFinding>& findings);

/// What to measure next, for the terminal.
/// "data: …", a line for each of the first findings.
/// An effect of a result: its name, where it is, formula, numbers with their 95 % intervals, gain.
std::string EffectLine(const Json& effect);
std::string FindingLines(const Json& result);
std::string NextTestLines(const Json& result);
/// The ten lines for the terminal.
std::string Summary(const Json& result);

}  // namespace phs::identify::search
