// What a search leaves: optimum.json, candidates.csv, best/CASE/.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/json_path.h"
#include "base/numbers.h"
#include "base/result_dir.h"
#include "sweep/case_files.h"
#include "sweep/optimiser.h"

namespace phs::sweep {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A value of a choice is a word, that of a parameter a number.
Json ValueJson(const std::string& text) {
  const auto number = ParseNumber(text);
  return number ? Json(*number) : Json(text);
}

Json CandidateJson(const Study& study, const SearchResult& result, int number) {
  if (number < 0) return nullptr;
  const Candidate& c = result.candidates[static_cast<std::size_t>(number)];
  const auto& constraints = study.optimisation->constraints;
  Json json = {{"candidate", number},
               {"keeps_constraints", c.Kept()},
               {"objective", NumberOrNull(c.objective)}};
  for (std::size_t i = 0; i < c.values.size(); ++i) {
    json["design"][study.axes[i].key] = ValueJson(c.values[i]);
  }
  json["constraints"] = Json::array();
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    json["constraints"].push_back({{"name", constraints[i].name},
                                   {"value", NumberOrNull(c.constrained[i])},
                                   {"kept", constraints[i].Violation(c.constrained[i]) <= 1e-6}});
  }
  return json;
}

std::string Cell(const std::string& text) {
  return text.find(',') == std::string::npos ? text : "\"" + text + "\"";
}

Status WriteCandidates(const Study& study, const SearchResult& result, const ResultDir& dir) {
  std::string text = "candidate";
  for (std::size_t i = 0; i + 1 < study.axes.size(); ++i) text += "," + study.axes[i].column;
  text += ",status,objective,largest_violation";
  for (const auto& constraint : study.optimisation->constraints) {
    text += "," + Cell(constraint.name);
  }
  text += "\n";
  int number = 0;
  for (const Candidate& c : result.candidates) {
    text += fmt::format("{}", number++);
    for (const std::string& value : c.values) text += "," + Cell(value);
    const auto cell = [](double value) { return std::isfinite(value) ? Shortest(value) : ""; };
    text += fmt::format(",{},{},{}",
                        c.broken   ? "broken"
                        : c.Kept() ? "ok"
                                   : "misses",
                        cell(c.objective), cell(c.violation));
    for (double value : c.constrained) text += "," + cell(value);
    text += "\n";
  }
  return WriteFileAtomically(dir.File("candidates.csv"), text);
}

Status WriteBest(const Study& study, int best, const ResultDir& dir) {
  for (std::size_t k = 0; k < study.cases.size(); ++k) {
    const std::string at = "best/" + study.cases[k].name;
    std::error_code fault;
    fs::create_directories(dir.File(at), fault);
    if (fault) return WriteFault(dir.File(at), fault.value());
    const int run = best * static_cast<int>(study.cases.size()) + static_cast<int>(k);
    if (Status s = LayOutRun(study, run, dir.File(at), dir.final_path() + "/" + at); !s.ok()) {
      return s;
    }
  }
  return {};
}

}  // namespace

Status WriteOptimum(const Study& study, const SearchResult& result, const ResultDir& dir) {
  Json json = {{"study", study.name}, {"candidates", result.candidates.size()}};
  for (const ObjectiveTerm& term : study.optimisation->objective) {
    const std::string& of = study.cases[static_cast<std::size_t>(term.number.of_case)].name;
    json["objective"].push_back({{"case", of},
                                 {"result", term.number.result},
                                 {"magnitude", term.number.magnitude},
                                 {"weight", term.weight}});
  }
  json["best"] = CandidateJson(study, result, result.best);
  json["combinations"] = Json::array();
  for (std::size_t i = 0; i < result.best_of.size(); ++i) {
    Json one;
    const auto values = study.optimisation->Combination(static_cast<int>(i));
    for (std::size_t k = 0; k < values.size(); ++k) one["choice"][study.axes[k].key] = values[k];
    one["best"] = CandidateJson(study, result, result.best_of[i]);
    json["combinations"].push_back(one);
  }
  if (Status s = WriteFileAtomically(dir.File("optimum.json"), json.dump(2) + "\n"); !s.ok()) {
    return s;
  }
  if (Status s = WriteCandidates(study, result, dir); !s.ok()) return s;
  return result.best < 0 ? Status() : WriteBest(study, result.best, dir);
}

}  // namespace phs::sweep
