#include "report/radius_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/axle_words.h"
#include "base/numbers.h"
#include "base/result_dir.h"
#include "report/conicity.h"
#include "report/curving_results.h"
#include "report/json_fields.h"
#include "report/report_page.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

/// A quantity of a row as it is shown.
struct RadiusQuantity {
  const char* title;
  const char* axis;
  const char* key;
  double factor;
  bool attack = false;  ///< drawn positive where the axle points to the outer rail
};

/// +1 left-hand, -1 right-hand, 0 unknown.
int HandOfRow(const json& row) { return HandOf(row.value("hand", "")); }

/// "4.61 outer".
std::string AttackOf(const json& row, const char* key) {
  const double angle = NumberOf(row, key);
  if (!std::isfinite(angle)) return FormatNumber(angle);
  return FormatNumber(1e3 * std::abs(angle)) + " " + RailPointedTo(angle, HandOfRow(row));
}

constexpr RadiusQuantity kRadiusQuantities[] = {
    {"Angle of attack of the leading axle", "to the outer rail [mrad]", "angle_of_attack_lead_rad",
     1e3, true},
    {"Wear: conventional bogie over own, Tγ over the run", "conventional / own [–]",
     "wear_yardstick_over_own_run", 1},
    {"Wear number Tγ of all wheels, steady", "Tγ [N]", "T_gamma_N", 1},
    {"Track-shifting force ΣY of the leading axle, steady", "ΣY [kN]", "sum_Y_lead_N", 1e-3}};

/// Value of a row; NaN for a run that did not end well, since its means do not hold.
double ValueOf(const json& row, const RadiusQuantity& q) {
  if (row.value("status", "") != "ok") return kNoNumber;
  const double value = q.factor * NumberOf(row, q.key);
  return q.attack ? -HandOfRow(row) * value : value;
}

std::vector<std::string> BogiesOf(const json& rows) {
  std::vector<std::string> names;
  for (const json& row : rows) {
    const std::string name = row.value("bogie", "");
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

void AddTable(const json& rows, ReportPage* page) {
  DataTable table{.caption = "Every run",
                  .head = {"Bogie", "Angle of attack, leading [mrad]", "trailing [mrad]",
                           "Tγ, steady [N]", "Tγ, run [kJ]", "Wear, conventional / own",
                           "ΣY, leading [kN]", "Greatest ΣY [kN]", "Greatest Y/Q"}};
  std::string curve;
  for (const json& row : rows) {
    const std::string own = fmt::format("R = {:.0f} m, {:.0f} km/h", NumberOf(row, "radius_m"),
                                        3.6 * NumberOf(row, "speed_m_s"));
    if (own != curve) table.rows.push_back({TableCell(own)});
    curve = own;
    if (row.value("status", "") != "ok") {
      table.rows.push_back({TableCell(BogieLabel(row.value("bogie", ""))),
                            TableCell(row.value("status", "?") + ": " + row.value("reason", ""))});
      continue;
    }
    std::vector<TableCell> cells = {TableCell(BogieLabel(row.value("bogie", "")))};
    cells.emplace_back(AttackOf(row, "angle_of_attack_lead_rad"));
    cells.emplace_back(AttackOf(row, "angle_of_attack_trail_rad"));
    for (const auto& [key, factor] : {std::pair{"T_gamma_N", 1.0},
                                      {"T_gamma_total_J", 1e-3},
                                      {"wear_yardstick_over_own_run", 1.0},
                                      {"sum_Y_lead_N", 1e-3},
                                      {"max_sum_Y_N", 1e-3},
                                      {"max_Y_over_Q", 1.0}}) {
      cells.emplace_back(FormatNumber(factor * NumberOf(row, key)));
    }
    table.rows.push_back(std::move(cells));
  }
  page->Add(table);
}

void AddPlots(const json& rows, ReportPage* page) {
  page->BeginGrid(2);
  for (const RadiusQuantity& q : kRadiusQuantities) {
    XyPlot plot{.title = q.title, .x_label = "radius [m]", .y_label = q.axis};
    int colour = 0;
    for (const std::string& bogie : BogiesOf(rows)) {
      Curve curve{.label = BogieLabel(bogie), .colour = colour % 8, .dash = colour / 8};
      ++colour;
      for (const json& row : rows) {
        if (row.value("bogie", "") != bogie) continue;
        curve.x.push_back(NumberOf(row, "radius_m"));
        curve.y.push_back(ValueOf(row, q));
      }
      plot.curves.push_back(std::move(curve));
    }
    page->Add(plot);
  }
  page->EndGrid();
}

void AddCriticalSpeeds(const json& all, ReportPage* page) {
  if (!all.contains("critical_speeds")) return;
  BarChart chart{.title = "Critical speed on straight track", .unit = "km/h"};
  BarChart::Bars linear{.label = "linear"};
  BarChart::Bars nonlinear{.label = "non-linear", .colour = 1};
  for (const auto& [bogie, speeds] : all["critical_speeds"].items()) {
    chart.categories.push_back(BogieLabel(bogie));
    linear.values.push_back(3.6 * NumberOf(speeds, "linear_m_s"));
    nonlinear.values.push_back(3.6 * NumberOf(speeds, "nonlinear_m_s"));
  }
  chart.bars = {linear, nonlinear};
  page->Section("Running straight");
  page->Paragraph(
      "Linear: speed above which infinitely small motions grow, by the eigenvalues of the bogie "
      "linearised about running on straight track; seals of a PHS stick there and hold like "
      "links. Non-linear: the lowest speed at which hunting, once a disturbance has "
      "started it, does not die, by runs in time with the true seals and profiles. Between both "
      "speeds it depends on the disturbance. No bar: none found in the range looked at.");
  page->Add(chart);
}

Status WriteRadiusPage(const std::string& bogies_file, const std::string& path) {
  Result<std::string> text = ReadFile(bogies_file);
  if (!text.ok()) return text.error();
  const json all = json::parse(text.value(), nullptr, false);
  if (!all.is_object() || !all.contains("rows") || !all["rows"].is_array() || all["rows"].empty()) {
    return Error{.where = bogies_file,
                 .what = "holds no rows of bogies and curves",
                 .allowed = "bogies.json of phs compare --radii",
                 .mend = ""};
  }
  const json scenario = all.value("scenario", json::object());
  ReportPage page(
      "Bogies over the radius of the curve",
      fmt::format("{} on {}, friction {}", scenario.value("wheel", "?"),
                  scenario.value("rail", "?"), FormatNumber(NumberOf(scenario, "friction"))));
  page.Section("Over the radius");
  page.Paragraph(
      "Steady values: means over the last third of the arc. Wear: Tγ = |Tx ξ| + |Ty η| without "
      "spin, "
      "added up over the run, of the conventional bogie with the same number of axles, divided by "
      "that of the bogie itself. A run that derailed has no point.");
  AddPlots(all["rows"], &page);
  AddCriticalSpeeds(all, &page);
  AddConicity(ConicityOfBogies(all.value("conicity", json::object()), BogiesOf(all["rows"])),
              &page);
  page.Section("Numbers");
  AddTable(all["rows"], &page);
  page.BeginDetails("Scenario that the curves share");
  page.Preformatted(scenario.dump(2));
  page.EndDetails();
  return page.Write(path);
}

}  // namespace

Status WriteRadiusReport(const std::string& bogies_file, const std::string& path) {
  return MakeGuarded(bogies_file, [&] { return WriteRadiusPage(bogies_file, path); });
}

}  // namespace phs::report
