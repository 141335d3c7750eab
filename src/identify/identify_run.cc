#include "identify/identify_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/table.h"
#include "effects/catalogue.h"
#include "identify/channel_scores.h"
#include "identify/residual_map.h"

namespace phs::identify::search {
namespace {

using json = nlohmann::ordered_json;
using Channels = std::vector<std::vector<double>>;
using hydraulics::PhsParams;

json ToJson(const ChannelScore& s) {
  return {{"rmse", s.rmse},
          {"nrmse", s.nrmse},
          {"bias", s.bias},
          {"max", s.max},
          {"m_re_percent", s.m_re_percent},
          {"share_at_or_below_mean", s.share_at_or_below_mean},
          {"share_below_12_percent", s.share_below_12_percent}};
}

json ScoreChannels(const FitData& data, const Channels& before, const Channels& after,
                   const std::array<double, 2>& window) {
  json out = json::object();
  for (size_t c = 0; c < data.outputs.size(); ++c) {
    const auto& measured = data.outputs[c].values;
    out[data.outputs[c].name] = {
        {"before", ToJson(Score(data.time_s, measured, before[c], window))},
        {"after", ToJson(Score(data.time_s, measured, after[c], window))}};
  }
  return out;
}

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

json Localise(const FitData& data, const Channels& predicted, const FitResult& fit) {
  const size_t c = WorstChannel(fit);
  json depends = json::array(), strength = json::object(), over = json::object();
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

json Unexplained(const FitData& data, const Channels& after, const FitResult& fit) {
  const json localised = Localise(data, after, fit);
  const size_t c = WorstChannel(fit);
  const std::vector<double> r = Finite(Residual(data, after, c, data.validation));
  const ChannelScore score = Score(data.time_s, data.outputs[c].values, after[c], data.validation);
  return {{"channel", data.outputs[c].name},
          {"nrmse", score.nrmse},
          {"whiteness_p", WhitenessP(r)},
          {"residual_over_noise", std::sqrt(fit.channel_ms[c])},
          {"depends_on", localised["depends_on"]},
          {"formula", nullptr}};
}

json Parameters(const FreeModel& model, const FitResult& fit, size_t begin, size_t end,
                bool whole_name) {
  json out = json::object();
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

json ToJson(const Evidence& e) {
  return {{"delta_bic", e.delta_bic},
          {"estimation_gain", e.estimation_gain},
          {"best_channel", e.best_channel},
          {"best_channel_gain", e.best_channel_gain},
          {"cross_validation_gain", e.cross_validation_gain}};
}

json Effects(const Identification& found) {
  json out = json::array();
  for (const AcceptedEffect& effect : found.effects) {
    const std::string prefix = "effects." + effect.candidate.effect + ".";
    size_t begin = 0;
    while (!found.corrected.free[begin].name.starts_with(prefix)) ++begin;
    json entry = {{"name", effect.candidate.effect},
                  {"parameters", Parameters(found.corrected, found.after, begin,
                                            begin + effect.candidate.free.size(), false)},
                  {"evidence", ToJson(effect.evidence)},
                  {"confusable_with", effect.confusable_with}};
    if (!effect.candidate.params.targets.empty()) entry["on"] = effect.candidate.params.targets;
    out.push_back(std::move(entry));
  }
  return out;
}

json Candidates(const Identification& found) {
  json out = json::array();
  for (const CandidateRecord& r : found.candidates) {
    json entry = {{"name", r.effect},
                  {"variant", r.variant},
                  {"round", r.round},
                  {"screening_gain", r.screening_gain},
                  {"verdict", r.verdict}};
    if (r.fitted) {
      entry["delta_bic"] = r.evidence.delta_bic;
      entry["estimation_gain"] = r.evidence.estimation_gain;
      entry["cross_validation_gain"] = r.evidence.cross_validation_gain;
    }
    out.push_back(std::move(entry));
  }
  return out;
}

/// What would separate effects that this record cannot.
std::vector<std::string> NextTests(const Identification& found) {
  std::vector<std::string> out;
  for (const AcceptedEffect& effect : found.effects) {
    if (effect.confusable_with.empty()) continue;
    const auto* info = effects::Catalogue().Find(effect.candidate.effect);
    const std::string family = info != nullptr ? info->family : "";
    std::string test = "steps with long holds at several pressures and speeds";
    if (family == "friction")
      test = "slow reversals after rests of different length, at two pressures";
    if (family == "mounting") test = "small slow reversals about zero force with the piston locked";
    if (family == "instrument") test = "a record at rest and one at a second, known load";
    out.push_back(effect.candidate.effect + " against " + JoinWords(effect.confusable_with) + ": " +
                  test);
  }
  return out;
}

Status WritePrediction(const ResultDir& dir, const std::string& file, const FitData& data,
                       const Channels& predicted) {
  std::vector<std::string> names = {"t_s"};
  Channels columns = {data.time_s};
  for (size_t a = 0; a < data.inputs.size(); ++a) {
    names.push_back(data.inputs[a].name), columns.push_back(data.motion[a].position);
  }
  for (size_t c = 0; c < data.outputs.size(); ++c) {
    names.push_back(data.outputs[c].name), columns.push_back(predicted[c]);
  }
  return WriteCsv(dir.File(file), names, columns);
}

std::string Summary(const json& result, const Identification& found) {
  std::string out;
  out += found.effects.empty()
             ? "effects: none; the declared model suffices as far as the catalogue goes\n"
             : "";
  for (const json& e : result["effects"]) {
    out += fmt::format("effect {}", e["name"].get<std::string>());
    for (const auto& [name, p] : e["parameters"].items()) {
      out += fmt::format("  {} {:.4g} [{:.4g}, {:.4g}]", name, p["value"].get<double>(),
                         p["low"].get<double>(), p["high"].get<double>());
    }
    out += fmt::format("  delta BIC {:.0f}", e["evidence"]["delta_bic"].get<double>());
    if (!e["confusable_with"].empty()) {
      out += "  not told apart from " +
             JoinWords(e["confusable_with"].get<std::vector<std::string>>());
    }
    out += "\n";
  }
  for (const auto& [name, s] : result["channels"].items()) {
    out += fmt::format("{:14} validation rmse {:.4g} -> {:.4g}  (nrmse {:.4f} -> {:.4f})\n", name,
                       s["before"]["rmse"].get<double>(), s["after"]["rmse"].get<double>(),
                       s["before"]["nrmse"].get<double>(), s["after"]["nrmse"].get<double>());
  }
  const json& left = result["unexplained"];
  out += fmt::format("unexplained: {} {:.2f} times its noise\n", left["channel"].get<std::string>(),
                     left["residual_over_noise"].get<double>());
  return out;
}

/// Data and declared model of a manifest, checked against each other.
struct Case {
  Manifest manifest;
  FitData data;
  PhsParams declared;
};

Result<Case> LoadCase(const std::string& path) {
  Result<Manifest> manifest = LoadManifest(path);
  if (!manifest.ok()) return manifest.error();
  Result<FitData> data = ReadFitData(manifest.value());
  if (!data.ok()) return data.error();
  Result<PhsParams> declared = effects::FindPhsParams(manifest.value().model);
  if (!declared.ok()) return declared.error();
  return Case{std::move(manifest.value()), std::move(data.value()), std::move(declared.value())};
}

json Head(const Case& c) {
  json noise = json::object();
  for (const auto* list : {&c.data.inputs, &c.data.outputs}) {
    for (const MeasuredChannel& channel : *list) noise[channel.name] = channel.noise;
  }
  return {{"rig", c.manifest.rig},           {"declared", c.manifest.model},
          {"data", c.data.source},           {"estimation", c.data.estimation},
          {"validation", c.data.validation}, {"noise", noise},
          {"remarks", c.data.remarks}};
}

}  // namespace

Result<IdentifyOutcome> RunIdentify(const std::string& manifest_path, const SearchOptions& options,
                                    const Progress& progress, const ResultDir& dir) {
  Result<Case> loaded = LoadCase(manifest_path);
  if (!loaded.ok()) return loaded.error();
  const Case& c = loaded.value();
  Result<FitProblem> problem = FitProblem::Create(c.data, c.declared);
  if (!problem.ok()) return problem.error();
  Result<Channels> raw = problem.value().Predict(c.declared);
  if (!raw.ok()) return raw.error();
  if (Status s = CheckChannels(c.data, raw.value()); !s.ok()) return s.error();
  Result<Identification> search = Identify(&problem.value(), c.declared, options, progress);
  if (!search.ok()) return search.error();
  const Identification& found = search.value();
  IdentifyOutcome outcome;
  outcome.cancelled = found.cancelled;
  if (found.cancelled) return outcome;
  PhsParams corrected = problem.value().Params(found.corrected, found.after.values);
  Result<Channels> before =
      problem.value().Predict(problem.value().Params(found.declared, found.before.values));
  Result<Channels> after = problem.value().Predict(corrected);
  if (!before.ok()) return before.error();
  if (!after.ok()) return after.error();
  json& result = outcome.result;
  result = Head(c);
  result["channels"] = ScoreChannels(c.data, before.value(), after.value(), c.data.validation);
  result["channels_estimation"] =
      ScoreChannels(c.data, before.value(), after.value(), c.data.estimation);
  result["effects"] = Effects(found);
  result["fitted"] = Parameters(found.corrected, found.after, 0, found.declared.free.size(), true);
  result["localised"] = Localise(c.data, before.value(), found.before);
  result["unexplained"] = Unexplained(c.data, after.value(), found.after);
  result["next_test"] = NextTests(found);
  result["candidates"] = Candidates(found);
  result["model"] = "model.yaml";
  corrected.name += "_identified";
  corrected.description = "Identified from " + c.data.source + "; declared " + c.declared.name;
  for (const Status& s :
       {WritePrediction(dir, "predicted.csv", c.data, after.value()),
        WritePrediction(dir, "baseline.csv", c.data, before.value()),
        WriteFileAtomically(dir.File("model.yaml"), hydraulics::ToYaml(corrected)),
        WriteFileAtomically(dir.File("result.json"), result.dump(1) + "\n")}) {
    if (!s.ok()) return s.error();
  }
  outcome.summary = Summary(result, found);
  return outcome;
}

Result<IdentifyOutcome> RunRig(const std::string& manifest_path, const ResultDir& dir) {
  Result<Case> loaded = LoadCase(manifest_path);
  if (!loaded.ok()) return loaded.error();
  const Case& c = loaded.value();
  Result<FitProblem> problem = FitProblem::Create(c.data, c.declared);
  if (!problem.ok()) return problem.error();
  Result<Channels> predicted = problem.value().Predict(c.declared);
  if (!predicted.ok()) return predicted.error();
  if (Status s = CheckChannels(c.data, predicted.value()); !s.ok()) return s.error();
  IdentifyOutcome outcome;
  outcome.result = Head(c);
  json channels = json::object(), estimation = json::object();
  for (size_t k = 0; k < c.data.outputs.size(); ++k) {
    const MeasuredChannel& m = c.data.outputs[k];
    const ChannelScore score =
        Score(c.data.time_s, m.values, predicted.value()[k], c.data.validation);
    channels[m.name] = ToJson(score);
    estimation[m.name] =
        ToJson(Score(c.data.time_s, m.values, predicted.value()[k], c.data.estimation));
    outcome.summary += fmt::format("{:14} validation rmse {:.4g}  nrmse {:.4f}  m%RE {:.2f}\n",
                                   m.name, score.rmse, score.nrmse, score.m_re_percent);
  }
  outcome.result["channels"] = channels;
  outcome.result["channels_estimation"] = estimation;
  for (const Status& s :
       {WritePrediction(dir, "predicted.csv", c.data, predicted.value()),
        WriteFileAtomically(dir.File("result.json"), outcome.result.dump(1) + "\n")}) {
    if (!s.ok()) return s.error();
  }
  return outcome;
}

}  // namespace phs::identify::search
