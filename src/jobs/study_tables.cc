#include "jobs/study_tables.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "base/json_path.h"
#include "base/words.h"

namespace phs::jobs {
namespace {

using Json = nlohmann::ordered_json;

Result<size_t> ColumnOf(const Table& table, const std::string& name) {
  const int at = table.Find(name);
  if (at >= 0) return static_cast<size_t>(at);
  return Error{table.source, "has no column " + Quoted(name), JoinWords(table.names),
               DidYouMean(name, table.names)};
}

Result<std::vector<size_t>> ColumnsOf(const Table& table, const std::vector<std::string>& names) {
  std::vector<size_t> columns;
  for (const std::string& name : names) {
    const auto column = ColumnOf(table, name);
    if (!column.ok()) return column.error();
    columns.push_back(column.value());
  }
  return columns;
}

std::string LabelOf(const Table& table, const std::vector<size_t>& by, size_t row) {
  std::string label;
  for (const size_t column : by) {
    label += (label.empty() ? "" : ", ") + table.text[column][row];
  }
  return label;
}

bool EndedWell(const Table& table, size_t row) {
  const int status = table.Find("status");
  return status < 0 || table.text[static_cast<size_t>(status)][row] == "ok";
}

/// Least and largest of the numbers of one group.
struct Group {
  int runs = 0;
  int lacking = 0;
  double least = HUGE_VAL;
  double largest = -HUGE_VAL;
};

}  // namespace

Result<Json> PlotJson(const StudyPlot& plot, const Table& table) {
  const auto x = ColumnOf(table, plot.x), y = ColumnOf(table, plot.y);
  if (!x.ok()) return x.error();
  if (!y.ok()) return y.error();
  const auto by = ColumnsOf(table, plot.by);
  if (!by.ok()) return by.error();
  std::vector<std::string> labels;
  std::map<std::string, std::vector<std::pair<double, double>>> curves;
  for (size_t row = 0; row < static_cast<size_t>(table.num_rows()); ++row) {
    const double at = table.columns[x.value()][row], value = table.columns[y.value()][row];
    const std::string label = LabelOf(table, by.value(), row);
    if (std::find(labels.begin(), labels.end(), label) == labels.end()) labels.push_back(label);
    if (!EndedWell(table, row) || !std::isfinite(at) || !std::isfinite(value)) continue;
    curves[label].emplace_back(at, value);
  }
  Json json = {{"title", plot.title}, {"x", plot.x}, {"y", plot.y}, {"curves", Json::array()}};
  for (const std::string& label : labels) {
    std::stable_sort(curves[label].begin(), curves[label].end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    Json curve = {{"label", label}, {"x", Json::array()}, {"y", Json::array()}};
    for (const auto& [at, value] : curves[label]) {
      curve["x"].push_back(at);
      curve["y"].push_back(value);
    }
    json["curves"].push_back(std::move(curve));
  }
  return json;
}

Result<Json> SpreadJson(const StudySpread& spread, const Table& table) {
  const auto of = ColumnsOf(table, spread.of), by = ColumnsOf(table, spread.by);
  if (!of.ok()) return of.error();
  if (!by.ok()) return by.error();
  std::vector<std::string> labels;
  std::map<std::string, Group> groups;
  for (size_t row = 0; row < static_cast<size_t>(table.num_rows()); ++row) {
    const std::string label = LabelOf(table, by.value(), row);
    if (!groups.contains(label)) labels.push_back(label);
    Group& group = groups[label];
    ++group.runs;
    bool all = EndedWell(table, row);
    for (const size_t column : of.value()) {
      const double value = table.columns[column][row];
      if (!all || !std::isfinite(value)) {
        all = false;
        continue;
      }
      group.least = std::min(group.least, value);
      group.largest = std::max(group.largest, value);
    }
    group.lacking += all ? 0 : 1;
  }
  Json json = {{"title", spread.title}, {"of", spread.of}};
  json["within_factor"] = spread.within_factor > 0 ? Json(spread.within_factor) : Json(nullptr);
  json["kept"] = 0;
  json["groups"] = Json::array();
  for (const std::string& label : labels) {
    const Group& group = groups[label];
    const double factor = group.least > 0 ? group.largest / group.least : std::nan("");
    const bool kept =
        spread.within_factor > 0 && group.lacking == 0 && factor <= spread.within_factor;
    if (kept) json["kept"] = json["kept"].get<int>() + 1;
    json["groups"].push_back({{"name", label},
                              {"runs", group.runs},
                              {"lacking", group.lacking},
                              {"least", NumberOrNull(group.least)},
                              {"largest", NumberOrNull(group.largest)},
                              {"factor", NumberOrNull(factor)},
                              {"kept", kept}});
  }
  return json;
}

}  // namespace phs::jobs
