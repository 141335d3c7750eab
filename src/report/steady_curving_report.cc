// The report of curving.json: steady curving over radius, one curve per bogie.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/axle_words.h"
#include "report/analysis_report.h"
#include "report/conicity.h"
#include "report/curving_results.h"
#include "report/json_fields.h"
#include "report/report_page.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

struct CurvingQuantity {
  const char* key;
  const char* title;
  const char* unit;
  double scale;
  bool attack = false;  ///< drawn positive where the axle points to the outer rail
};
constexpr CurvingQuantity kCurvingQuantities[] = {
    {"angle_of_attack_lead_rad", "Angle of attack, leading axle", "mrad", 1e3, true},
    {"largest_Y_N", "Largest guiding force Y of a wheel", "kN", 1e-3},
    {"sum_Y_lead_N", "Sum of Y, leading axle", "kN", 1e-3},
    {"T_gamma_N", "T-gamma, all wheels", "N", 1}};

/// Of a row; results of former programs name none: their curves were left-hand.
int HandOfCurve(const json& row) { return HandOf(row.value("hand", "left")); }

std::string CellText(const json& row, const CurvingQuantity& q) {
  const double value = q.scale * NumberOf(row, q.key);
  if (!q.attack || !std::isfinite(value)) return FormatNumber(value);
  return FormatNumber(std::abs(value)) + " " + RailPointedTo(value, HandOfCurve(row));
}

XyPlot OverRadius(const json& bogies, const CurvingQuantity& quantity) {
  XyPlot plot{
      .title = quantity.title,
      .x_label = "radius [m]",
      .y_label = fmt::format("{}[{}]", quantity.attack ? "to the outer rail " : "", quantity.unit)};
  for (const auto& [name, rows] : bogies.items()) {
    const int number = static_cast<int>(plot.curves.size());
    Curve curve{.label = BogieLabel(name), .colour = number % 8, .dash = number / 8 % 4};
    for (const json& row : rows) {
      curve.x.push_back(NumberOf(row, "radius_m"));
      const int sign = quantity.attack ? -HandOfCurve(row) : 1;
      curve.y.push_back(sign * quantity.scale * NumberOf(row, quantity.key));
    }
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

DataTable Numbers(const json& bogies, const CurvingQuantity& quantity) {
  DataTable table{.caption = fmt::format("{} [{}]", quantity.title, quantity.unit),
                  .head = {"Radius [m]"}};
  std::vector<std::vector<TableCell>> rows;
  for (const auto& [name, entries] : bogies.items()) {
    table.head.push_back(BogieLabel(name));
    for (size_t i = 0; i < entries.size(); ++i) {
      if (rows.size() <= i) {
        rows.push_back({TableCell(fmt::format("{:g}", NumberOf(entries[i], "radius_m")))});
      }
      rows[i].emplace_back(CellText(entries[i], quantity));
    }
  }
  table.rows = std::move(rows);
  return table;
}

}  // namespace

Status WriteSteadyCurvingReport(const std::string& curving_file, const std::string& path) {
  const Result<json> read = ReadJsonObject(curving_file);
  if (!read.ok()) return read.error();
  const json& result = read.value();
  const json bogies = result.value("bogies", json::object());
  ReportPage page("Curving over radius", "Steady state in the arc, found directly");
  page.Paragraph(
      "Each point is the steady state in an arc, with the seals as the way through the transition "
      "left them. Speed and cant follow the radius by one rule (docs/curving.md).");
  page.Section("Over radius");
  page.BeginGrid(2);
  for (const CurvingQuantity& quantity : kCurvingQuantities) page.Add(OverRadius(bogies, quantity));
  page.EndGrid();
  std::vector<std::string> names;
  for (const auto& [name, rows] : bogies.items()) names.push_back(name);
  AddConicity(ConicityOfBogies(result.value("conicity", json::object()), names), &page);
  page.Section("Numbers");
  for (const CurvingQuantity& quantity : kCurvingQuantities) page.Add(Numbers(bogies, quantity));
  return page.Write(path);
}

}  // namespace phs::report
