#include "identify/rig_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/table.h"
#include "base/words.h"
#include "identify/bogie_run.h"
#include "identify/element_run.h"
#include "identify/steps_run.h"
#include "measurement/channel_scores.h"
#include "measurement/rig_motion.h"
#include "phs_model/phs_model.h"

namespace phs::identify {

using measurement::CheckStroke;
using measurement::ReadRigCase;
using measurement::RigCase;
namespace {

using json = nlohmann::ordered_json;
using measurement::Manifest;
using measurement::Window;
using rigs::RigModel;
using rigs::RigPrediction;

Status CheckFinite(const RigModel& model, const RigCase& c, const RigPrediction& predicted) {
  for (size_t k = 0; k < predicted.channels.size(); ++k) {
    for (size_t i = 0; i < predicted.channels[k].size(); ++i) {
      if (std::isfinite(predicted.channels[k][i])) continue;
      const double t = c.motion.t0_s + static_cast<double>(i) * c.motion.step_s;
      return Error{model.output_names()[k],
                   fmt::format("the model has no finite value at {:.6g} s", t), "",
                   "check the model's parameters; raise `substeps` in the manifest"};
    }
  }
  return {};
}

std::vector<double> Times(const RigCase& c) {
  std::vector<double> t;
  for (int i = 0; i < c.motion.num_samples(); ++i) t.push_back(c.motion.t0_s + i * c.motion.step_s);
  return t;
}

/// The measured channels as used: uniform clock, SI, NaN where a sample takes no part.
Status WriteMeasured(const RigCase& c, const std::string& path) {
  std::vector<std::string> names = {"t_s"};
  std::vector<std::vector<double>> columns = {Times(c)};
  for (const auto* list : {&c.run.inputs, &c.run.outputs}) {
    for (const measurement::Channel& channel : *list) {
      if (!channel.present()) continue;
      names.push_back(channel.name);
      columns.push_back(channel.y);
    }
  }
  return WriteCsv(path, names, columns);
}

Status WritePredicted(const RigModel& model, const RigCase& c, const RigPrediction& predicted,
                      const std::string& path) {
  std::vector<std::string> names = {"t_s"};
  std::vector<std::vector<double>> columns = {Times(c)};
  for (size_t k = 0; k < model.input_names().size(); ++k) {
    names.push_back(model.input_names()[k]);
    columns.push_back(c.motion.position_m[k]);
  }
  for (size_t k = 0; k < model.output_names().size(); ++k) {
    names.push_back(model.output_names()[k]);
    columns.push_back(predicted.channels[k]);
  }
  return WriteCsv(path, names, columns);
}

json ScoreWindow(const RigCase& c, const RigPrediction& predicted, const Window& window) {
  const std::vector<double> t = Times(c);
  const std::array<double, 2> span =
      window.empty() ? std::array<double, 2>{t.front(), t.back() + c.motion.step_s}
                     : std::array<double, 2>{window.begin, window.end};
  json out = json::object();
  for (size_t k = 0; k < c.run.outputs.size(); ++k) {
    const measurement::Channel& channel = c.run.outputs[k];
    if (!channel.present()) continue;
    std::vector<double> y = channel.y;
    for (size_t i = 0; i < y.size(); ++i) {
      if (channel.bad[i]) y[i] = std::numeric_limits<double>::quiet_NaN();
    }
    out[channel.name] = ToJson(measurement::Score(t, y, predicted.channels[k], span));
  }
  return out;
}

void AddComparison(const RigCase& c, const RigPrediction& predicted, RigOutcome* outcome) {
  json noise = json::object(), findings = json::array();
  for (const auto* list : {&c.run.inputs, &c.run.outputs}) {
    for (const measurement::Channel& channel : *list) {
      if (channel.present()) noise[channel.name] = channel.noise.level;
    }
  }
  for (const measurement::DataFinding& f : c.run.findings) {
    findings.push_back({{"channel", f.channel}, {"text", f.text}});
    outcome->summary += "data: " + f.channel + " " + f.text + "\n";
  }
  json& result = outcome->result;
  result["noise"] = noise;
  result["data_findings"] = findings;
  if (!c.run.estimation.empty()) {
    result["estimation"] = {c.run.estimation.begin, c.run.estimation.end};
    result["channels_estimation"] = ScoreWindow(c, predicted, c.run.estimation);
  }
  if (!c.run.validation.empty()) {
    result["validation"] = {c.run.validation.begin, c.run.validation.end};
  }
  result["channels"] = ScoreWindow(c, predicted, c.run.validation);
  outcome->summary += fmt::format("{:14} {:>10} {:>8} {:>10} {:>10} {:>8} {:>12}\n",
                                  c.run.validation.empty() ? "whole record" : "validation", "RMSE",
                                  "NRMSE", "bias", "largest", "m%RE", "below 12 %");
  for (const auto& [name, s] : result["channels"].items()) {
    outcome->summary +=
        fmt::format("{:14} {:>10.4g} {:>8.4f} {:>10.3g} {:>10.4g} {:>8.2f} {:>10.1f} %\n", name,
                    s["rmse"].get<double>(), s["nrmse"].get<double>(), s["bias"].get<double>(),
                    s["max"].get<double>(), s["m_re_percent"].get<double>(),
                    100 * s["share_below_12_percent"].get<double>());
  }
}

void AddExtremes(const RigModel& model, const RigPrediction& predicted, bool print,
                 RigOutcome* outcome) {
  json extremes = json::object();
  if (print) outcome->summary += fmt::format("{:14} {:>12} {:>12}\n", "predicted", "least", "most");
  for (size_t k = 0; k < model.output_names().size(); ++k) {
    const auto [low, high] =
        std::minmax_element(predicted.channels[k].begin(), predicted.channels[k].end());
    extremes[model.output_names()[k]] = {{"least", *low}, {"most", *high}};
    if (print) {
      outcome->summary +=
          fmt::format("{:14} {:>12.5g} {:>12.5g}\n", model.output_names()[k], *low, *high);
    }
  }
  outcome->result["extremes"] = extremes;
}

/// A bench whose force was measured, too.
bool IsMeasuredBench(const Manifest& manifest) {
  if (manifest.rig != "element" || manifest.signal) return false;
  const auto run = measurement::ReadRigRun(manifest.runs.front(), manifest, {"x_m"}, {"force_N"},
                                           measurement::OutputNeed::kNone);
  return !run.ok() || run.value().outputs.front().present();
}

}  // namespace

Result<RigOutcome> RunRig(const Manifest& manifest, const ResultDir& dir) {
  if (manifest.rig == "steps") return RunSteps(manifest, dir);
  if (manifest.rig == "bogie") {
    if (manifest.signal) {
      return Error{manifest.path + ": signal", "a bogie runs on its track, not by signals",
                   "data:", "without a measurement: phs simulate"};
    }
    Result<search::IdentifyOutcome> run = search::RunBogieRig(manifest, dir);
    if (!run.ok()) return run.error();
    return RigOutcome{run.value().result, run.value().summary, dir.File("measured.csv")};
  }
  if (IsMeasuredBench(manifest)) {  // several records, band limit: its own rows
    Result<search::IdentifyOutcome> run = element::RunElementRig(manifest, dir);
    if (!run.ok()) return run.error();
    return RigOutcome{run.value().result, run.value().summary, dir.File("measured.csv")};
  }
  Result<rigs::RigKind> kind = rigs::ParseRigKind(manifest.rig);
  if (!kind.ok()) return kind.error();
  Result<hydraulics::PhsParams> params = measurement::DeclaredModel(manifest);
  if (!params.ok()) return params.error();
  Result<RigModel> made = RigModel::Create(kind.value(), params.value(), manifest.options);
  if (!made.ok()) return made.error();
  Result<RigCase> loaded = ReadRigCase(manifest, made.value());
  if (!loaded.ok()) return loaded.error();
  const RigCase& c = loaded.value();
  if (c.run.extra) {
    rigs::RigOptions options = manifest.options;
    options.extra = c.run.extra;
    made = RigModel::Create(kind.value(), params.value(), options);
    if (!made.ok()) return made.error();
  }
  const RigModel& model = made.value();
  RigPrediction predicted;
  if (Status s = model.Run(c.motion, &predicted); !s.ok()) return s.error();
  if (Status s = CheckFinite(model, c, predicted); !s.ok()) return s.error();
  if (Status s = CheckStroke(model, c.motion, predicted.channels); !s.ok()) {
    Error error = s.error();
    error.where = (c.measured() ? c.run.source : manifest.path) + ": " + error.where;
    return error;
  }
  RigOutcome outcome;
  outcome.result = {{"rig", manifest.rig}, {"declared", manifest.model}};
  outcome.result["data"] = c.measured() ? json(c.run.source) : json("generated signals");
  if (c.measured() && !c.compared()) {
    outcome.summary += "no output was measured: the model alone, driven by " +
                       JoinWords(model.input_names()) + "\n";
  }
  if (c.compared()) {
    AddComparison(c, predicted, &outcome);
    outcome.measured = dir.File("measured.csv");
    if (Status s = WriteMeasured(c, outcome.measured); !s.ok()) return s.error();
  }
  AddExtremes(model, predicted, !c.compared(), &outcome);
  for (const Status& s :
       {WritePredicted(model, c, predicted, dir.File("predicted.csv")),
        WriteFileAtomically(dir.File("result.json"), outcome.result.dump(1) + "\n")}) {
    if (!s.ok()) return s.error();
  }
  return outcome;
}

}  // namespace phs::identify
