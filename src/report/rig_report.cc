#include "report/rig_report.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/table.h"
#include "report/decimation.h"
#include "report/json_fields.h"
#include "report/readable_name.h"
#include "report/report_page.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

bool IsInput(const std::string& name) {
  return name.starts_with("actuator") || name == "x_m" || name == "force_N";
}

/// Measured beside predicted pressure, row by row.
void AddSteps(const json& result, ReportPage* page) {
  page->Section("Steps");
  page->Paragraph(
      "The piston is moved quickly and held. Pressures are gauge: just after the step, and when "
      "the "
      "gas has given off its heat. A model with isothermal gas has one pressure for both.");
  DataTable table{.caption = "Pressures [MPa gauge] and time constants [s]",
                  .head = {"Row", "chamber", "piston step [mm]", "just after, measured", "model",
                           "settled, measured", "model", "tau, measured", "model"}};
  BarChart bars{.title = "Settled pressure, gauge", .unit = "MPa"};
  bars.bars = {{.label = "measured", .colour = 0}, {.label = "model", .colour = 1}};
  const json rows = result.value("rows", json::array());
  for (const json& row : rows) {
    auto number = [&row](const char* key, const char* whose, double factor) {
      return factor * row.at(key).at(whose).get<double>();
    };
    const bool measured = row.value("measured", true);
    const std::string name = std::to_string(row.value("row", 0));
    const std::string chamber = row.value("chamber", "");
    const double step = 1e3 * row.value("piston_step_m", 0.0);
    auto shown = [&](double value) { return measured ? FormatNumber(value) : std::string("–"); };
    table.rows.push_back(
        {name, chamber, FormatNumber(step), shown(number("p_begin_Pa", "measured", 1e-6)),
         FormatNumber(number("p_begin_Pa", "predicted", 1e-6)),
         shown(number("p_end_Pa", "measured", 1e-6)),
         FormatNumber(number("p_end_Pa", "predicted", 1e-6)), shown(number("tau_s", "measured", 1)),
         FormatNumber(number("tau_s", "predicted", 1))});
    if (!measured) continue;
    bars.categories.push_back(name + ": " + chamber + ", " + FormatNumber(step) + " mm");
    bars.bars[0].values.push_back(number("p_end_Pa", "measured", 1e-6));
    bars.bars[1].values.push_back(number("p_end_Pa", "predicted", 1e-6));
  }
  page->Add(table);
  page->Add(bars);
}

void AddRigFigures(const json& result, ReportPage* page) {
  std::vector<KeyFigure> figures;
  const json channels = result.value("channels", json::object());
  for (const auto& [name, scores] : channels.items()) {
    if (!scores.contains("m_re_percent")) continue;
    figures.push_back({.value = FormatNumber(scores.at("m_re_percent").get<double>()),
                       .unit = "%",
                       .label = name == "p_end_Pa" ? "settled pressure" : "pressure just after",
                       .remark = "mean relative error, capped at 100 %"});
  }
  if (!figures.empty()) page->KeyFigures(figures);
}

void AddExtremes(const json& result, ReportPage* page) {
  DataTable table{.caption = "Least and greatest", .head = {"Channel", "least", "greatest"}};
  const json extremes = result.value("extremes", json::object());
  for (const auto& [name, extreme] : extremes.items()) {
    const ReadableName readable = Readable(name);
    table.rows.push_back({readable.words + " [" + readable.unit + "]",
                          FormatNumber(readable.factor * extreme.value("least", 0.0), 4),
                          FormatNumber(readable.factor * extreme.value("most", 0.0), 4)});
  }
  page->Add(table);
}

/// Every channel over time; forces over the driven motion.
void AddCurves(const Table& table, ReportPage* page) {
  const int t = table.Find("t_s");
  int driven = -1;
  for (int i = 0; i < table.num_columns() && driven < 0; ++i) {
    if (IsInput(table.names[i])) driven = i;
  }
  page->Section("Over time");
  page->BeginGrid(2);
  for (int i = 0; i < table.num_columns(); ++i) {
    if (i == t) continue;
    const ReadableName readable = Readable(table.names[i]);
    page->Add(SeriesPlot{.title = readable.words,
                         .x_label = "time [s]",
                         .y_label = readable.words + " [" + readable.unit + "]",
                         .curves = {{.label = "model",
                                     .colour = IsInput(table.names[i]) ? 2 : 0,
                                     .x = table.columns[t],
                                     .y = Scaled(table.columns[i], readable.factor)}},
                         .group = "time"});
  }
  page->EndGrid();
  if (driven < 0) return;
  const ReadableName motion = Readable(table.names[driven]);
  page->Section("Loops");
  page->BeginGrid(2);
  for (int i = 0; i < table.num_columns(); ++i) {
    const std::string& name = table.names[i];
    if (!name.ends_with("_N") && !name.ends_with("_Pa")) continue;
    const ReadableName readable = Readable(name);
    page->Add(XyPlot{.title = readable.words + " over " + motion.words,
                     .x_label = motion.words + " [" + motion.unit + "]",
                     .y_label = readable.words + " [" + readable.unit + "]",
                     .curves = {{.label = "model",
                                 .x = Scaled(table.columns[driven], motion.factor),
                                 .y = Scaled(table.columns[i], readable.factor)}}});
  }
  page->EndGrid();
}

}  // namespace

Status WriteRigReport(const RigReportInput& input, const std::string& path) {
  const Result<json> read = ReadJsonObject(input.result, "result.json of phs rig", "run it again");
  if (!read.ok()) return read.error();
  const json& result = read.value();
  ReportPage page("Rig", result.value("rig", "") + " rig, declared model " +
                             result.value("declared", "") + ", data " + result.value("data", ""));
  page.Section("At a glance");
  if (result.contains("rows")) {
    AddRigFigures(result, &page);
    AddSteps(result, &page);
    return page.Write(path);
  }
  page.Paragraph("No output was measured: the page shows the model alone.");
  AddExtremes(result, &page);
  Result<Table> predicted = ReadTable(input.predicted);
  if (!predicted.ok()) return predicted.error();
  AddCurves(predicted.value(), &page);
  return page.Write(path);
}

}  // namespace phs::report
