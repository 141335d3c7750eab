#include "identify/result_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "effects/unlisted.h"
#include "identify/residual_map.h"
#include "measurement/channel_scores.h"

namespace phs::identify::search {

using measurement::ChannelScore;
using measurement::DataFinding;
using measurement::FitData;
using measurement::MeasuredChannel;
using measurement::Score;
namespace {

std::vector<double> Residual(const FitData& data, const Channels& predicted, size_t c,
                             const std::array<double, 2>& window) {
  std::vector<double> out(data.time_s.size(), std::numeric_limits<double>::quiet_NaN());
  for (size_t i = 0; i < out.size(); ++i) {
    if (data.time_s[i] < window[0] || data.time_s[i] >= window[1]) continue;
    out[i] = data.outputs[c].values[i] - predicted[c][i];
  }
  return out;
}

std::vector<double> Finite(std::vector<double> y) {
  std::erase_if(y, [](double x) { return !std::isfinite(x); });
  return y;
}

/// Index of the channel whose weighted residual is largest.
size_t WorstChannel(const FitResult& fit) {
  return static_cast<size_t>(std::max_element(fit.channel_ms.begin(), fit.channel_ms.end()) -
                             fit.channel_ms.begin());
}

Json ToJson(const Evidence& e) {
  return {{"delta_bic", e.delta_bic},
          {"estimation_gain", e.estimation_gain},
          {"best_channel", e.best_channel},
          {"best_channel_gain", e.best_channel_gain},
          {"cross_validation_gain", e.cross_validation_gain},
          {"share", e.share}};
}

}  // namespace

Json ScoreChannels(const FitData& data, const Channels& predicted,
                   const std::array<double, 2>& window) {
  Json out = Json::object();
  for (size_t c = 0; c < data.outputs.size(); ++c) {
    const MeasuredChannel& m = data.outputs[c];
    out[m.name] = ToJson(Score(data.time_s, m.values, predicted[c], window));
  }
  return out;
}

Json ScoreBoth(const FitData& data, const Channels& before, const Channels& after,
               const std::array<double, 2>& window) {
  Json out = Json::object();
  for (size_t c = 0; c < data.outputs.size(); ++c) {
    const auto& measured = data.outputs[c].values;
    out[data.outputs[c].name] = {
        {"before", ToJson(Score(data.time_s, measured, before[c], window))},
        {"after", ToJson(Score(data.time_s, measured, after[c], window))}};
  }
  return out;
}

Json Localise(const FitData& data, const Channels& predicted, const FitResult& fit) {
  const size_t c = WorstChannel(fit);
  Json depends = Json::array(), strength = Json::object(), over = Json::object();
  for (const Dependence& d :
       MapResidual(data, Residual(data, predicted, c, data.estimation), data.estimation)) {
    strength[d.variable] = d.share;
    if (d.share > 0.05 && depends.size() < 3) depends.push_back(d.variable);
  }
  for (size_t k = 0; k < data.outputs.size(); ++k) {
    over[data.outputs[k].name] = std::sqrt(fit.channel_ms[k]);
  }
  return {{"channel", data.outputs[c].name},
          {"depends_on", depends},
          {"explained_share", strength},
          {"residual_over_noise", over}};
}

Json Unexplained(const FitData& data, const Channels& after, const std::vector<LeftOver>& left,
                 const Identification& found) {
  const auto more = [](const LeftOver& a, const LeftOver& b) {
    return a.over_noise < b.over_noise;
  };
  const auto c =
      static_cast<size_t>(std::max_element(left.begin(), left.end(), more) - left.begin());
  const std::vector<double> r = Residual(data, after, c, data.validation);
  const ChannelScore score = Score(data.time_s, data.outputs[c].values, after[c], data.validation);
  Json depends = Json::array();
  for (const Dependence& d : MapResidual(data, r, data.validation)) {
    if (d.share > 0.05 && depends.size() < 3) depends.push_back(d.variable);
  }
  return {{"channel", data.outputs[c].name},
          {"nrmse", score.nrmse},
          {"whiteness_p", WhitenessP(Finite(r))},
          {"residual_over_noise", left[c].over_noise},
          {"following_over_noise", std::sqrt(left[c].following)},
          {"estimation_over_noise", std::sqrt(found.after.channel_ms[c])},
          {"depends_on", depends},
          {"formula", found.formula.empty() ? Json(nullptr) : Json(found.formula.text)}};
}

Json Parameters(const FreeModel& model, const FitResult& fit, size_t begin, size_t end,
                bool whole_name) {
  Json out = Json::object();
  for (size_t i = begin; i < end; ++i) {
    const FreeParameter& p = model.free[i];
    const double x = p.ToCoordinate(fit.values[i]), half = std::min(fit.half_95[i], 50.0);
    const std::string name = whole_name ? p.name : p.name.substr(p.name.rfind('.') + 1);
    out[name] = {{"value", fit.values[i]},
                 {"low", p.FromCoordinate(x - half)},
                 {"high", p.FromCoordinate(x + half)}};
  }
  return out;
}

Json EffectList(const Identification& found) {
  Json out = Json::array();
  for (const AcceptedEffect& effect : found.effects) {
    const std::string prefix = "effects." + effect.candidate.effect + ".";
    size_t begin = 0;
    while (!found.corrected.free[begin].name.starts_with(prefix)) ++begin;
    Json entry = {{"name", effect.candidate.effect},
                  {"parameters", Parameters(found.corrected, found.after, begin,
                                            begin + effect.candidate.free.size(), false)},
                  {"evidence", ToJson(effect.evidence)},
                  {"confusable_with", effect.confusable_with}};
    if (effect.candidate.effect == effects::UnlistedInfo().name)
      entry["formula"] = found.formula.text;
    if (!effect.candidate.params.targets.empty()) entry["on"] = effect.candidate.params.targets;
    out.push_back(std::move(entry));
  }
  return out;
}

Json CandidateList(const Identification& found) {
  Json out = Json::array();
  for (const CandidateRecord& r : found.candidates) {
    Json entry = {{"name", r.effect},
                  {"variant", r.variant},
                  {"round", r.round},
                  {"screening_gain", r.screening_gain},
                  {"verdict", r.verdict}};
    if (r.fitted) {
      entry["delta_bic"] = r.evidence.delta_bic;
      entry["share"] = r.evidence.share;
      entry["estimation_gain"] = r.evidence.estimation_gain;
      entry["cross_validation_gain"] = r.evidence.cross_validation_gain;
    }
    out.push_back(std::move(entry));
  }
  return out;
}

Json NoiseLevels(const FitData& data) {
  Json noise = Json::object();
  for (const auto* list : {&data.inputs, &data.outputs}) {
    for (const MeasuredChannel& channel : *list) noise[channel.name] = channel.noise;
  }
  return noise;
}

Json FindingList(const std::vector<DataFinding>& findings) {
  Json out = Json::array();
  for (const DataFinding& f : findings) out.push_back({{"channel", f.channel}, {"text", f.text}});
  return out;
}

}  // namespace phs::identify::search
