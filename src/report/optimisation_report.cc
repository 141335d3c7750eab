#include "report/optimisation_report.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "base/result_dir.h"
#include "base/table.h"
#include "report/readable_name.h"
#include "report/report_page.h"

namespace phs::report {
namespace {

using Json = nlohmann::ordered_json;

std::string ValueText(const std::string& key, const Json& value) {
  if (!value.is_number()) return value.is_string() ? value.get<std::string>() : "none";
  const ReadableName name = Readable(key.substr(key.rfind('.') + 1));
  const std::string number = FormatNumber(name.factor * value.get<double>(), 4);
  return name.unit.empty() || name.unit == "-" ? number : number + " " + name.unit;
}

std::string Words(const std::string& key) { return Readable(key.substr(key.rfind('.') + 1)).words; }

std::string Objective(const Json& json) {
  std::string text;
  for (const Json& term : json["objective"]) {
    text +=
        fmt::format("{}{:g} x {}{} of {}", text.empty() ? "" : " + ", term["weight"].get<double>(),
                    term["magnitude"].get<bool>() ? "|" : "",
                    term["result"].get<std::string>() + (term["magnitude"].get<bool>() ? "|" : ""),
                    term["case"].get<std::string>());
  }
  return text;
}

void AddBest(const Json& json, ReportPage* page) {
  const Json& best = json["best"];
  if (best.is_null()) {
    page->Warning("No candidate was calculated to the end: candidates.csv and sweep.csv say why.");
    return;
  }
  if (!best["keeps_constraints"].get<bool>()) {
    page->Warning("No candidate keeps all constraints; shown is the one that misses them least.");
  }
  std::vector<KeyFigure> figures = {
      {FormatNumber(best["objective"].get<double>(), 4), "", "objective", ""}};
  for (const auto& [key, value] : best["design"].items()) {
    figures.push_back({ValueText(key, value), "", Words(key), ""});
  }
  page->KeyFigures(figures);
}

void AddCombinations(const Json& json, ReportPage* page) {
  DataTable table{.caption = "Best candidate of each combination", .head = {"Choice", "objective"}};

  for (const Json& one : json["combinations"]) {
    std::string name;
    const Json choice = one.value("choice", Json::object());
    for (const auto& [key, value] : choice.items()) {
      name += (name.empty() ? "" : ", ") + value.get<std::string>();
    }
    std::vector<TableCell> row = {TableCell(name.empty() ? "all" : name)};
    const Json& best = one["best"];
    if (best.is_null()) {
      row.emplace_back("none was calculated to the end");
      table.rows.push_back(row);
      continue;
    }
    row.emplace_back(FormatNumber(best["objective"].get<double>(), 4));
    for (const auto& [key, value] : best["design"].items()) {
      if (choice.contains(key)) continue;
      if (table.rows.empty()) table.head.push_back(Words(key));
      row.emplace_back(ValueText(key, value));
    }
    for (const Json& c : best["constraints"]) {
      if (table.rows.empty()) table.head.push_back(c["name"].get<std::string>());
      const bool kept = c["kept"].get<bool>();
      const std::string value =
          c["value"].is_number() ? FormatNumber(c["value"].get<double>(), 4) : "none";
      row.emplace_back(kept ? value : value + " missed", !kept);
    }
    table.rows.push_back(std::move(row));
  }

  page->Add(table);
}

/// Combination of choices of each row, and which columns are parameters.
struct Candidates {
  Table table;
  std::vector<int> parameters;
  std::vector<std::string> combination;
};

Candidates Sort(Table table) {
  Candidates c{std::move(table), {}, {}};
  const int status = c.table.Find("status");
  c.combination.resize(static_cast<std::size_t>(c.table.num_rows()));
  for (int i = 1; i < status; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (c.table.num_rows() > 0 && std::isfinite(c.table.columns[at][0])) {
      c.parameters.push_back(i);
      continue;
    }
    for (std::size_t row = 0; row < c.combination.size(); ++row) {
      c.combination[row] += (c.combination[row].empty() ? "" : ", ") + c.table.text[at][row];
    }
  }
  return c;
}

void AddCandidateScatter(const Candidates& c, int parameter, ReportPage* page) {
  const ReadableName name = parameter < 0
                                ? ReadableName{"candidate", "", 1}
                                : Readable(c.table.names[static_cast<std::size_t>(parameter)]);
  const auto column = static_cast<std::size_t>(std::max(parameter, 0));
  const auto status = static_cast<std::size_t>(c.table.Find("status"));
  const auto objective = static_cast<std::size_t>(c.table.Find("objective"));
  std::map<std::string, Curve> curves;
  Curve misses{.label = "misses a constraint", .colour = 7, .points = true};
  for (std::size_t row = 0; row < c.combination.size(); ++row) {
    const double y = c.table.columns[objective][row];
    if (!std::isfinite(y)) continue;
    const double x = name.factor * c.table.columns[column][row];
    const std::string label = c.combination[row].empty() ? "all" : c.combination[row];
    Curve& curve = c.table.text[status][row] == "ok" ? curves[label] : misses;
    curve.x.push_back(x);
    curve.y.push_back(y);
  }
  XyPlot plot{.title = "Objective over " + name.words,
              .x_label = name.words + (name.unit.empty() ? "" : " [" + name.unit + "]"),
              .y_label = "objective",
              .height_px = 300};
  for (auto& [label, curve] : curves) {
    curve.label = label;
    curve.colour = static_cast<int>(plot.curves.size()) % 7;
    curve.points = true;
    plot.curves.push_back(curve);
  }
  if (!misses.x.empty()) plot.curves.push_back(misses);
  if (!plot.curves.empty()) page->Add(plot);
}

}  // namespace

Status WriteOptimisationReport(const std::string& folder, const std::string& path) {
  const auto text = ReadFile(folder + "/optimum.json");
  if (!text.ok()) return text.error();
  const Json json = Json::parse(text.value(), nullptr, false);
  if (json.is_discarded()) return Error{folder + "/optimum.json", "is no JSON", "", ""};
  auto table = ReadCsv(folder + "/candidates.csv");
  if (!table.ok()) return table.error();
  const Candidates candidates = Sort(std::move(table).value());
  ReportPage page("Best design: " + json["study"].get<std::string>(),
                  fmt::format("{} candidates", json["candidates"].get<int>()));
  page.Section("Result");
  AddBest(json, &page);
  page.Paragraph(Objective(json), "Least: ");
  AddCombinations(json, &page);
  page.Section("Search");
  page.BeginGrid(2);
  AddCandidateScatter(candidates, -1, &page);
  for (int parameter : candidates.parameters) AddCandidateScatter(candidates, parameter, &page);
  page.EndGrid();
  page.Paragraph(
      "best/CASE/scenario.yaml repeats a case of the best candidate: phs simulate "
      "best/CASE/scenario.yaml; candidates.csv lists every candidate, sweep.csv every run.",
      "Files: ");
  return page.Write(path);
}

}  // namespace phs::report
