// What the identification found, what is left and what to measure next, in words.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "report/identify_parts.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

std::string JoinedNames(const json& names) {
  std::string text;
  if (!names.is_array()) return text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!names[i].is_string()) continue;
    text += i == 0 ? "" : i + 1 == names.size() ? " and " : ", ";
    text += Spaced(names[i].get<std::string>());
  }
  return text;
}

/// "x_m" → "position": the variables on which a residual may depend.
std::string VariableWords(const std::string& variable) {
  if (variable == "x_m") return "position";
  if (variable == "v_m_s") return "speed";
  if (variable == "t_s") return "time";
  const ReadableName name = Readable(variable);
  return name.words;
}

std::string JoinedVariables(const json& variables) {
  json words = json::array();
  for (const json& variable : variables) {
    if (variable.is_string()) words.push_back(VariableWords(variable.get<std::string>()));
  }
  return JoinedNames(words);
}

/// Variables of a "depends_on" list that call for a certain excitation.
std::string TestFor(const std::string& variable) {
  if (variable == "reversal" || variable == "history") {
    return "slow triangles of several amplitudes with rests of different length at the ends: they "
           "separate play, presliding and dwell";
  }
  if (variable.starts_with("v") || variable == "speed") {
    return "constant speeds in both directions, from 0.1 mm/s up: they separate friction that "
           "depends on speed from flow resistance";
  }
  if (variable.starts_with("x") || variable == "position") {
    return "the same small motion about several mean positions: it separates what depends on "
           "position from what depends on pressure";
  }
  if (variable.starts_with("p") || variable == "pressure") {
    return "the same motion at several precharges: it separates what depends on pressure";
  }
  if (variable == "t_s" || variable == "time" || variable == "temperature") {
    return "a hold of some minutes after a step, and the same run cold and warm: they separate "
           "leakage, gas temperature and sensor drift";
  }
  if (variable == "frequency" || variable == "acceleration") {
    return "a sine sweep at constant amplitude: it separates inertia and delay from stiffness";
  }
  return "";
}

void AddTestOnce(const std::string& test, std::vector<std::string>* tests) {
  if (test.empty()) return;
  const std::string sentence = "Run " + test + ".";
  if (std::find(tests->begin(), tests->end(), sentence) == tests->end()) {
    tests->push_back(sentence);
  }
}

/// What a formula stands for, by the unit of its first number: c1_N, c1_Pa …
std::string OnNoList(const json& effect) {
  static const std::map<std::string, const char*> kinds = {
      {"N", "a force on no list"},
      {"m3", "a volume on no list"},
      {"m3_per_s", "a flow on no list"},
      {"m", "an error of the piston reading on no list"},
      {"Pa", "an error of the pressure reading on no list"}};
  const json numbers = effect.value("parameters", json::object());
  if (numbers.empty()) return "an effect on no list";
  if (effect.value("formula", std::string()).find('F') != std::string::npos &&
      numbers.begin().key().ends_with("_N")) {
    return "an error of the load cell on no list";
  }
  const std::string first = numbers.begin().key();
  const auto kind = kinds.find(first.substr(first.find('_') + 1));
  return kind == kinds.end() ? "an effect on no list" : kind->second;
}

}  // namespace

std::string Spaced(std::string words) {
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string DescribeEffect(const json& effect) {
  const bool unlisted = effect.value("name", "") == "unlisted";
  std::string text = unlisted ? OnNoList(effect) : Spaced(effect.value("name", "?"));
  const std::string places = JoinedNames(effect.value("on", json::array()));
  if (!places.empty()) text += " on " + places;
  if (effect.contains("formula") && effect["formula"].is_string()) {
    text += ", " + effect["formula"].get<std::string>();
  }
  if (effect.contains("form")) text += " in a form of its own";
  return text;
}

void AddDataFindings(const IdentifyResults& results, ReportPage* page) {
  const json findings = results.all.value("data_findings", json::array());
  if (findings.empty()) return;
  page->Section("What is wrong with the data");
  for (const json& finding : findings) {
    const std::string channel = finding.value("channel", "?");
    page->Paragraph(finding.value("text", ""), channel == "t_s" ? "Clock:" : channel + ":");
  }
}

void AddDoubt(const IdentifyResults& results, ReportPage* page) {
  for (const json& effect : results.all.value("effects", json::array())) {
    const std::string twins = JoinedNames(effect.value("confusable_with", json::array()));
    if (twins.empty()) continue;
    page->Warning(
        fmt::format("With these data {} cannot be told from {}: take the name as one of these.",
                    Spaced(effect.value("name", "?")), twins));
  }
  const json where = results.all.value("localised", json::object());
  const std::string variables = JoinedVariables(where.value("depends_on", json::array()));
  if (where.contains("channel") && where["channel"].is_string() && !variables.empty()) {
    page->Paragraph(
        fmt::format("The residual of the declared model sits in the {} and depends on {}.",
                    Readable(where["channel"].get<std::string>()).words, variables),
        "Where.");
  }
}

void AddUnexplained(const IdentifyResults& results, ReportPage* page) {
  const json left = results.all.value("unexplained", json::object());
  const double nrmse = NumberAt(left, "/nrmse");
  const double whiteness = NumberAt(left, "/whiteness_p");
  if (std::isfinite(nrmse)) {
    std::string text = fmt::format("What is left has {} % of the measured standard deviation.",
                                   FormatNumber(100 * nrmse));
    if (std::isfinite(whiteness)) {
      text += whiteness > 0.05
                  ? fmt::format(" It cannot be told from noise (whiteness p = {}).",
                                FormatNumber(whiteness, 2))
                  : fmt::format(" It is not noise (whiteness p = {}): some structure remains.",
                                FormatNumber(whiteness, 2));
    }
    page->Paragraph(text);
  }
  const std::string variables = JoinedVariables(left.value("depends_on", json::array()));
  if (!variables.empty()) page->Paragraph("It still depends on " + variables + ".");
  if (left.contains("formula") && left["formula"].is_string()) {
    page->Paragraph("A compact formula that describes it, without a physical name:");
    page->Preformatted(left["formula"].get<std::string>());
  }
  const json noise = results.all.value("noise", json::object());
  if (noise.empty()) return;
  DataTable table{.caption = "Noise of the channels, from the data",
                  .head = {"Channel", "standard deviation", "unit"}};
  for (const auto& [channel, level] : noise.items()) {
    if (!level.is_number()) continue;
    const ReadableName name = Readable(channel);
    table.rows.push_back({TableCell(name.words),
                          TableCell(FormatNumber(name.factor * level.get<double>())),
                          TableCell(name.unit)});
  }
  if (!table.rows.empty()) page->Add(table);
}

std::vector<std::string> NextTests(const IdentifyResults& results) {
  std::vector<std::string> tests;
  const json own = results.all.value("next_test", json());
  if (own.is_string()) tests.push_back(own.get<std::string>());
  if (own.is_array()) {
    for (const json& test : own) {
      if (test.is_string()) tests.push_back(test.get<std::string>());
    }
  }
  const bool designed = results.all.contains("test_design");
  const json left = results.all.value("unexplained", json::object());
  for (const json& variable : left.value("depends_on", json::array())) {
    if (designed) break;
    if (variable.is_string()) AddTestOnce(TestFor(variable.get<std::string>()), &tests);
  }
  const json where = results.all.value("localised", json::object());
  bool confusable = false;  // and no test was designed for it
  for (const json& effect : results.all.value("effects", json::array())) {
    confusable =
        confusable || (!designed && !effect.value("confusable_with", json::array()).empty());
  }
  if (confusable) {
    for (const json& variable : where.value("depends_on", json::array())) {
      if (variable.is_string()) AddTestOnce(TestFor(variable.get<std::string>()), &tests);
    }
  }
  const bool described = results.all.value("verdict", "") != "not_described";
  if (tests.empty() && !described) {
    tests.push_back(
        "Mend what the reasons name, in the record or in the declared numbers, and identify "
        "again.");
  }
  const bool found = !results.all.value("effects", json::array()).empty();
  if (tests.empty()) {
    tests.push_back(found
                        ? "Repeat the run on another day and score the corrected model on it "
                          "without any fit: an effect that is real stays."
                        : "Repeat the run on another day and score model.yaml, the declared model "
                          "with its fitted numbers, on it without any fit (phs rig): it should err "
                          "no more there.");
  }
  if (described && found) {
    tests.push_back(
        "Put model.yaml into the bogie (phs compare) to see what the found effects mean "
        "in a curve.");
  }
  return tests;
}

void AddNextTests(const IdentifyResults& results, ReportPage* page) {
  page->List(NextTests(results));
}

}  // namespace phs::report
