#include "identify/run/rig_run.h"

#include <fmt/format.h>

#include "base/table.h"
#include "base/words.h"
#include "identify/run/bogie_run.h"
#include "identify/run/element_run.h"
#include "identify/run/steps_run.h"
#include "measurement/rig_numbers.h"

namespace phs::identify {
namespace {

using json = nlohmann::ordered_json;
using measurement::DrivenRig;
using measurement::Manifest;
using measurement::RigCase;

/// The measured channels as used: uniform clock, SI, NaN where a sample takes no part.
Status WriteMeasuredRig(const DrivenRig& rig, const std::string& path) {
  std::vector<std::string> names = {"t_s"};
  std::vector<std::vector<double>> columns = {rig.Times()};
  for (const auto* list : {&rig.input.run.inputs, &rig.input.run.outputs}) {
    for (const measurement::Channel& channel : *list) {
      if (!channel.present()) continue;
      names.push_back(channel.name);
      columns.push_back(channel.y);
    }
  }
  return WriteCsv(path, names, columns);
}

Status WritePredicted(const DrivenRig& rig, const std::string& path) {
  std::vector<std::string> names = {"t_s"};
  std::vector<std::vector<double>> columns = {rig.Times()};
  for (size_t k = 0; k < rig.model.input_names().size(); ++k) {
    names.push_back(rig.model.input_names()[k]);
    columns.push_back(rig.input.motion.position_m[k]);
  }
  for (size_t k = 0; k < rig.model.output_names().size(); ++k) {
    names.push_back(rig.model.output_names()[k]);
    columns.push_back(rig.predicted.channels[k]);
  }
  return WriteCsv(path, names, columns);
}

/// What the record says about itself, and the errors against it.
std::string RecordLines(const json& result, bool whole) {
  std::string text;
  for (const json& f : result["data_findings"]) {
    text += "data: " + f["channel"].get<std::string>() + " " + f["text"].get<std::string>() + "\n";
  }
  text += fmt::format("{:14} {:>10} {:>8} {:>10} {:>10} {:>8} {:>12}\n",
                      whole ? "whole record" : "validation", "RMSE", "NRMSE", "bias", "largest",
                      "m%RE", "below 12 %");
  for (const auto& [name, s] : result["channels"].items()) {
    text += fmt::format("{:14} {:>10.4g} {:>8.4f} {:>10.3g} {:>10.4g} {:>8.2f} {:>10.1f} %\n", name,
                        s["rmse"].get<double>(), s["nrmse"].get<double>(), s["bias"].get<double>(),
                        s["max"].get<double>(), s["m_re_percent"].get<double>(),
                        100 * s["share_below_12_percent"].get<double>());
  }
  return text;
}

std::string ExtremeLines(const json& result) {
  std::string text = fmt::format("{:14} {:>12} {:>12}\n", "predicted", "least", "most");
  for (const auto& [name, range] : result["extremes"].items()) {
    text += fmt::format("{:14} {:>12.5g} {:>12.5g}\n", name, range["least"].get<double>(),
                        range["most"].get<double>());
  }
  return text;
}

std::string ComparisonLines(const json& result) {
  if (!result.contains("compared_with")) return "";
  std::string text = "against " + result["compared_with"]["manifest"].get<std::string>() + "\n";
  for (const auto& [name, s] : result["compared_with"].items()) {
    if (!s.is_object()) continue;
    text += fmt::format("{:14} RMSE {:>10.4g}  m%RE {:>8.3f}\n", name, s["rmse"].get<double>(),
                        s["m_re_percent"].get<double>());
  }
  return text;
}

/// A bench of which not only what drives it was measured.
bool IsMeasuredBench(const Manifest& manifest) {
  if (manifest.rig != "element" || manifest.signal) return false;
  const bool by_force = manifest.options.driven_by == rigs::Drive::kForce;
  const auto run =
      measurement::ReadRigRun(manifest.runs.front(), manifest, {by_force ? "force_N" : "x_m"},
                              {by_force ? "x_m" : "force_N"}, measurement::OutputNeed::kNone);
  return !run.ok() || run.value().outputs.front().present();
}

}  // namespace

Result<RigOutcome> RunRig(const Manifest& manifest, const ResultDir& dir) {
  if (manifest.rig == "steps") return RunSteps(manifest, dir);
  if (manifest.runs.size() > 1 && manifest.rig != "element") {
    return Error{manifest.path + ": runs", "phs rig compares one run", "data:, or runs: of a bench",
                 "a manifest for each run; phs identify takes them as one"};
  }
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
  const Result<DrivenRig> driven = measurement::DriveRig(manifest);
  if (!driven.ok()) return driven.error();
  const DrivenRig& rig = driven.value();
  const RigCase& c = rig.input;
  Result<json> numbers = measurement::RigNumbers(manifest, rig);
  if (!numbers.ok()) return numbers.error();
  RigOutcome outcome;
  outcome.result = std::move(numbers).value();
  if (c.measured() && !c.compared()) {
    outcome.summary += "no output was measured: the model alone, driven by " +
                       JoinWords(rig.model.input_names()) + "\n";
  }
  if (c.compared()) {
    outcome.summary += RecordLines(outcome.result, c.run.validation.empty());
    outcome.measured = dir.File("measured.csv");
    if (Status s = WriteMeasuredRig(rig, outcome.measured); !s.ok()) return s.error();
  } else {
    outcome.summary += ExtremeLines(outcome.result);
  }
  outcome.summary += ComparisonLines(outcome.result);
  for (const Status& s :
       {WritePredicted(rig, dir.File("predicted.csv")),
        WriteFileAtomically(dir.File("result.json"), outcome.result.dump(1) + "\n")}) {
    if (!s.ok()) return s.error();
  }
  return outcome;
}

}  // namespace phs::identify
