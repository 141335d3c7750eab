#include "sweep/optimisation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/disk.h"
#include "base/words.h"
#include "sweep/axis_key.h"

namespace phs::sweep {
namespace {

/// The key of a choice or parameter: known, and given once.
std::string ReadKey(const Subject& subject, YamlMap* entry, std::set<std::string>* keys) {
  std::string key = entry->Text("key");
  if (Status s = CheckAxisKey(subject, key); !s.ok()) {
    entry->Fail("key", s.error().what, s.error().allowed, s.error().mend);
  }
  if (!keys->insert(key).second) {
    entry->Fail("key", fmt::format("'{}' is varied twice", key), "each key once",
                "remove one of the two");
  }
  return key;
}

DesignParameter ReadParameter(const Subject& subject, YamlMap* entry, std::set<std::string>* keys) {
  DesignParameter p;
  p.key = ReadKey(subject, entry, keys);
  p.logarithmic = entry->Bool("logarithmic", false);
  p.min =
      p.logarithmic ? entry->Number("min", {.min = 0, .open_min = true}) : entry->Number("min", {});
  p.max = entry->Number("max", {.min = p.min, .open_min = true});
  p.start = entry->Number("start", {.min = p.min, .max = p.max}, p.AtShare(0.5));
  return p;
}

StudyCase ReadCase(const Subject& subject, YamlMap* entry, const std::string& base) {
  StudyCase c;
  c.name = entry->Text("name");
  if (!IsFileName(c.name)) entry->Fail("name", Quoted(c.name) + " is no file name", kFileNames);
  c.subject = &subject;
  c.analysis = ReadAnalysis(entry, subject.key);
  c.base = entry->Text(subject.key, base);
  if (c.base.empty()) {
    entry->Fail(subject.key, "is missing",
                std::string("a ") + subject.key + " here or in the study");
  }
  if (entry->Has("set")) {
    YamlMap set = entry->Map("set");
    for (const std::string& key : set.Keys()) {
      if (Status s = CheckAxisKey(subject, key); !s.ok()) {
        set.Fail(key, s.error().what, s.error().allowed, s.error().mend);
      }
      c.set.emplace_back(key, set.Text(key));
    }
  }
  return c;
}

CaseNumber ReadNumber(YamlMap* entry, std::vector<StudyCase>* cases) {
  CaseNumber number;
  std::vector<std::string> names;
  for (const StudyCase& c : *cases) names.push_back(c.name);
  const std::string name = entry->Text("case");
  number.result = entry->Text("result");
  number.magnitude = entry->Bool("magnitude", false);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    entry->Fail("case", Quoted(name) + " is no case", JoinWords(names), DidYouMean(name, names));
    return number;
  }
  number.of_case = static_cast<int>(found - names.begin());
  auto& outputs = (*cases)[static_cast<std::size_t>(number.of_case)].outputs;
  if (std::find(outputs.begin(), outputs.end(), number.result) == outputs.end()) {
    outputs.push_back(number.result);
  }
  return number;
}

void ReadConstraint(YamlMap* entry, std::vector<StudyCase>* cases,
                    std::vector<DesignConstraint>* constraints) {
  const CaseNumber number = ReadNumber(entry, cases);
  const std::string of =
      entry->Text("case") + ": " + (number.magnitude ? "magnitude of " : "") + number.result;
  for (const char* key : {"at_most", "at_least"}) {
    if (!entry->Has(key)) continue;
    const double bound = entry->Number(key, {});
    const bool at_most = std::string(key) == "at_most";
    constraints->push_back(
        {number, bound, at_most, fmt::format("{} {} {:g}", of, at_most ? "<=" : ">=", bound)});
  }
  if (!entry->Has("at_most") && !entry->Has("at_least")) {
    entry->Fail("at_most", "is missing", "at_most, at_least or both", "add one");
  }
}

void ReadCases(const Subject& subject, YamlMap* map, const std::string& base,
               std::vector<StudyCase>* cases) {
  std::set<std::string> names;
  for (YamlMap& entry : map->Maps("cases")) {
    cases->push_back(ReadCase(subject, &entry, base));
    if (!names.insert(cases->back().name).second) {
      entry.Fail("name", Quoted(cases->back().name) + " is given twice", "each name once", "");
    }
  }
  if (cases->empty()) map->Fail("cases", "is empty or missing", "a list of cases", "add one");
}

}  // namespace

double DesignConstraint::Violation(double value) const {
  if (!std::isfinite(value)) return 1;
  const double scale = bound == 0 ? 1 : std::abs(bound);
  return (at_most ? value - bound : bound - value) / scale;
}

double DesignParameter::AtShare(double u) const {
  return logarithmic ? min * std::pow(max / min, u) : min + u * (max - min);
}

double DesignParameter::ShareOf(double value) const {
  return logarithmic ? std::log(value / min) / std::log(max / min) : (value - min) / (max - min);
}

int Optimisation::NumCombinations() const {
  int count = 1;
  for (const DesignChoice& choice : choices) count *= static_cast<int>(choice.values.size());
  return count;
}

std::vector<std::string> Optimisation::Combination(int i) const {
  std::vector<std::string> values(choices.size());
  for (std::size_t at = choices.size(); at-- > 0;) {
    const int size = static_cast<int>(choices[at].values.size());
    values[at] = choices[at].values[static_cast<std::size_t>(i % size)];
    i /= size;
  }
  return values;
}

OptimisationBlock ReadOptimisation(const Subject& subject, YamlMap map, const std::string& base) {
  OptimisationBlock block;
  Optimisation& o = block.optimisation;
  const std::string method = map.Word("method", {"cobyla", "direct", "isres"}, "cobyla");
  o.method = method == "direct"  ? Optimisation::Method::kDirect
             : method == "isres" ? Optimisation::Method::kIsres
                                 : Optimisation::Method::kCobyla;
  o.evaluations = map.Integer("evaluations", 1, 100000, o.evaluations);
  o.tolerance = map.Number("tolerance", {.min = 1e-6, .max = 0.5}, o.tolerance);
  std::set<std::string> keys;
  for (YamlMap& entry : map.Maps("choices")) {
    DesignChoice choice{ReadKey(subject, &entry, &keys), entry.Texts("values")};
    if (choice.values.empty()) entry.Fail("values", "is empty", "at least one value");
    o.choices.push_back(std::move(choice));
  }
  for (YamlMap& entry : map.Maps("parameters"))
    o.parameters.push_back(ReadParameter(subject, &entry, &keys));
  if (o.choices.empty() && o.parameters.empty()) {
    map.Fail("parameters", "is empty or missing", "parameters, choices or both", "add one");
  }
  ReadCases(subject, &map, base, &block.cases);
  for (YamlMap& entry : map.Maps("objective")) {
    o.objective.push_back({ReadNumber(&entry, &block.cases), entry.Number("weight", {}, 1)});
  }
  if (o.objective.empty())
    map.Fail("objective", "is empty or missing", "a list of terms", "add one");
  for (YamlMap& entry : map.Maps("constraints")) {
    ReadConstraint(&entry, &block.cases, &o.constraints);
  }
  return block;
}

}  // namespace phs::sweep
