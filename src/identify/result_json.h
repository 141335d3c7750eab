// result.json of an identification, part by part (docs/program.md names the fields).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "identify/identification.h"
#include "identify/motion_share.h"
#include "identify/verdict.h"
#include "measurement/fit_data.h"

namespace phs::identify::search {

using Json = nlohmann::ordered_json;

/// Errors of one predicted set of channels over a window, by name of channel.
Json ScoreChannels(const measurement::FitData& data, const Channels& predicted,
                   const std::array<double, 2>& window);
/// "before" and "after" of each channel.
Json ScoreBoth(const measurement::FitData& data, const Channels& before, const Channels& after,
               const std::array<double, 2>& window);
/// Where the residual of the declared model lives: channel and variables it depends on.
Json Localise(const measurement::FitData& data, const Channels& predicted, const FitResult& fit);
/// What the corrected model leaves in the validation window. `left`: by channel, there.
Json Unexplained(const measurement::FitData& data, const Channels& after,
                 const std::vector<LeftOver>& left, const Identification& found);
/// Values and intervals of the free numbers [begin, end).
Json Parameters(const FreeModel& model, const FitResult& fit, size_t begin, size_t end,
                bool whole_name);
Json EffectList(const Identification& found);
Json CandidateList(const Identification& found);
/// The accepted effects and what explains as much.
std::vector<NamedEffect> NamedEffects(const Identification& found);
/// The declared numbers after the last fit.
std::vector<FittedNumber> FittedNumbers(const Identification& found);
/// "verdict", "verdict_text" and "reasons".
void PutVerdict(const VerdictFacts& facts, Json* result);
/// The same for the terminal.
std::string VerdictLines(const Json& result);

/// Noise of each channel.
Json NoiseLevels(const measurement::FitData& data);
Json FindingList(const std::vector<measurement::DataFinding>& findings);

/// What to measure next, for the terminal.
std::string NextTestLines(const Json& result);
/// The ten lines for the terminal.
std::string Summary(const Json& result);

}  // namespace phs::identify::search
