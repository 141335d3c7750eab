#include "identify/result/result_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "identify/discrepancy/residual_map.h"
#include "identify/select/own_form.h"
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

/// At most three variables that explain more than a twentieth.
std::vector<std::string> Strongest(const std::vector<VariableShare>& shares) {
  std::vector<std::string> out;
  for (const VariableShare& v : shares) {
    if (v.share > 0.05 && out.size() < 3) out.push_back(v.variable);
  }
  return out;
}

Json EvidenceJson(const Evidence& e) {
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

std::vector<BeforeAfter> ScoreBoth(const FitData& data, const Channels& before,
                                   const Channels& after, const std::array<double, 2>& window) {
  std::vector<BeforeAfter> out;
  for (size_t c = 0; c < data.outputs.size(); ++c) {
    const auto& measured = data.outputs[c].values;
    out.push_back({data.outputs[c].name, Score(data.time_s, measured, before[c], window),
                   Score(data.time_s, measured, after[c], window)});
  }
  return out;
}

Json OrNull(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json ScoresJson(const std::vector<BeforeAfter>& scores) {
  Json out = Json::object();
  for (const BeforeAfter& s : scores) {
    out[s.channel] = {{"before", ToJson(s.before)}, {"after", ToJson(s.after)}};
  }
  return out;
}

std::vector<double> MeanSquares(const FitData& data, const FitProblem& problem,
                                const FitResult& fit) {
  std::vector<double> out;
  for (const MeasuredChannel& channel : data.outputs) {
    double sum = 0, count = 0;
    for (size_t b = 0; b < fit.channel_ms.size(); ++b) {
      if (problem.block_name(b) != channel.name) continue;
      const double rows = problem.block(b).count * problem.block(b).present;
      sum += rows * fit.channel_ms[b], count += rows;
    }
    out.push_back(sum / std::max(count, 1.0));
  }
  return out;
}

Localised Localise(const FitData& data, const Channels& predicted,
                   const std::vector<double>& mean_squares) {
  const auto c = static_cast<size_t>(std::max_element(mean_squares.begin(), mean_squares.end()) -
                                     mean_squares.begin());
  Localised out{data.outputs[c].name, {}, {}, {}};
  const std::vector<double> r = Residual(data, predicted, c, data.estimation);
  for (const Dependence& d : MapResidual(data, r, data.estimation)) {
    out.shares.push_back({d.variable, d.share});
  }
  out.depends_on = Strongest(out.shares);
  for (size_t k = 0; k < data.outputs.size(); ++k) {
    out.over_noise.emplace_back(data.outputs[k].name, std::sqrt(mean_squares[k]));
  }
  return out;
}

Json LocalisedJson(const Localised& found) {
  Json share = Json::object(), over = Json::object();
  for (const VariableShare& v : found.shares) share[v.variable] = v.share;
  for (const auto& [name, value] : found.over_noise) over[name] = value;
  return {{"channel", found.channel},
          {"depends_on", found.depends_on},
          {"explained_share", share},
          {"residual_over_noise", over}};
}

Unexplained FindUnexplained(const FitData& data, const Channels& after,
                            const std::vector<LeftOver>& left,
                            const std::vector<double>& mean_squares, const Identification& found) {
  const auto more = [](const LeftOver& a, const LeftOver& b) {
    return a.over_noise < b.over_noise;
  };
  const auto c =
      static_cast<size_t>(std::max_element(left.begin(), left.end(), more) - left.begin());
  const std::vector<double> r = Residual(data, after, c, data.validation);
  const ChannelScore score = Score(data.time_s, data.outputs[c].values, after[c], data.validation);
  std::vector<VariableShare> shares;
  for (const Dependence& d : MapResidual(data, r, data.validation)) {
    shares.push_back({d.variable, d.share});
  }
  return {.channel = data.outputs[c].name,
          .nrmse = score.nrmse,
          .whiteness_p = WhitenessP(Finite(r)),
          .over_noise = left[c].over_noise,
          .following_over_noise = std::sqrt(left[c].following),
          .estimation_over_noise = std::sqrt(mean_squares[c]),
          .depends_on = Strongest(shares),
          .formula = found.formula.empty() ? "" : found.formula.text};
}

Json UnexplainedJson(const Unexplained& left) {
  Json out = {{"channel", left.channel},
              {"nrmse", left.nrmse},
              {"whiteness_p", left.whiteness_p},
              {"residual_over_noise", left.over_noise},
              {"following_over_noise", left.following_over_noise}};
  if (left.estimation_over_noise) out["estimation_over_noise"] = *left.estimation_over_noise;
  out["depends_on"] = left.depends_on;
  out["formula"] = OrNull(left.formula);
  return out;
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

namespace {

Json EffectJson(const Identification& found, const AcceptedEffect& effect) {
  const std::string prefix = "effects." + effect.candidate.effect + ".";
  size_t begin = 0;
  while (!found.corrected.free[begin].name.starts_with(prefix)) ++begin;
  Json entry = {{"name", effect.candidate.effect},
                {"parameters", Parameters(found.corrected, found.after, begin,
                                          begin + effect.candidate.free.size(), false)},
                {"evidence", EvidenceJson(effect.evidence)},
                {"confusable_with", effect.confusable_with}};
  if (const auto held = HeldNumbers(effect.candidate); !held.empty()) entry["held"] = held;
  if (IsFormula(effect)) entry["formula"] = found.formula.text;
  if (!effect.candidate.params.targets.empty()) entry["on"] = effect.candidate.params.targets;
  return entry;
}

}  // namespace

Json EffectList(const Identification& found) {
  const std::optional<size_t> formed = HasOwnForm(found);
  Json out = Json::array(), form;
  size_t host = 0;
  for (size_t i = 0; i < found.effects.size(); ++i) {
    Json entry = EffectJson(found, found.effects[i]);
    if (formed == i) host = out.size();
    if (formed && IsFormula(found.effects[i])) {
      entry.erase("name"), entry.erase("confusable_with");
      form = std::move(entry);
    } else {
      out.push_back(std::move(entry));
    }
  }
  if (formed) out[host]["form"] = std::move(form);
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

void PutRule(const SearchRule& rule, Json* result) {
  const SearchRule own;
  Json changed = Json::object(), without = Json::array();
  for (const AcceptanceNumber& n : AcceptanceNumbers()) {
    if (rule.accept.*n.value != own.accept.*n.value) changed[n.name] = rule.accept.*n.value;
  }
  for (const RulePart& part : RuleParts()) {
    if (!(rule.*part.holds)) without.push_back(part.name);
  }
  if (changed.empty() && without.empty()) return;
  (*result)["rule"] = {{"changed", changed}, {"without", without}};
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
