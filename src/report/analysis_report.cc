#include "report/analysis_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/numbers.h"
#include "report/json_fields.h"
#include "report/moving_shape.h"
#include "report/report_page.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

struct Mode {
  const char* key;
  const char* title;
  const char* meaning;
  bool rotation;
};
constexpr Mode kModes[] = {
    {"bending", "Bending", "opposite yaw of the axles: steering; should be soft", true},
    {"shear", "Shear", "same-sense yaw of the axles: keeps the bogie stable; should be stiff",
     true},
    {"traction", "Traction", "both axles along the track; carries traction and braking", false},
    {"antiphase", "Anti-phase", "axles along the track against each other", false}};

std::string Key(const Mode& mode, bool stiffness) {
  return std::string(stiffness ? "stiffness" : "damping") +
         (mode.rotation ? (stiffness ? "_Nm_per_rad" : "_Nms_per_rad")
                        : (stiffness ? "_N_per_m" : "_Ns_per_m"));
}

std::string Unit(const Mode& mode, bool stiffness) {
  if (mode.rotation) return stiffness ? "kN m/rad" : "kN m s/rad";
  return stiffness ? "kN/m" : "kN s/m";
}

/// One mode from above, motion drawn large: both axles move as one sine, greatest at phase zero.
/// Yaw turns an axle, x moves it; the frame stands still. A cylinder goes with its axle's box.
MovingShape ModeShape(const json& bogie, const Mode& mode, int lead_sign, int trail_sign) {
  constexpr double kHalfAxle = 0.9;  // [m]
  MovingShape shape{.title = std::string(mode.title) + ": " + mode.meaning,
                    .keys = {{"axles", 0}, {"at rest", 6, 2}, {"frame, held", 7}},
                    .period_s = PlayedPeriod(NumberOf(bogie, "frequency_Hz"))};
  const json plan = bogie.value("plan", json::object());
  double reach = 0;
  const json axles = plan.value("axles", json::array());
  for (const json& axle : axles) reach = std::max(reach, std::abs(NumberOf(axle, "x_m")));
  const auto fixed = [&shape](const char* name, int key, double x0, double y0, double x1, double y1,
                              double width) {
    shape.lines.push_back(
        {.name = name, .key = key, .from = {x0, y0}, .to = {x1, y1}, .width_px = width});
  };
  for (const double side : {-0.75, 0.75}) {
    fixed("frame", 2, -0.75 * reach, side, 0.75 * reach, side, 2);
  }
  fixed("frame", 2, 0, -0.75, 0, 0.75, 2);
  const auto moved = [&](double x, double y) {  // a point of the axle that is nearest to x
    const double sign = x > 0 ? lead_sign : trail_sign;
    const double centre = x > 0 ? reach : -reach;
    return PointOfBody(centre, x - centre, y, mode.rotation ? 0 : sign, 0,
                       mode.rotation ? sign : 0);
  };
  for (const json& axle : axles) {
    const double x = NumberOf(axle, "x_m");
    fixed("at rest", 1, x, -kHalfAxle, x, kHalfAxle, 1);
    shape.lines.push_back({.name = axle.value("name", ""),
                           .from = moved(x, -kHalfAxle),
                           .to = moved(x, kHalfAxle),
                           .width_px = 4});
  }
  const json at =
      bogie.value(mode.key, json::object()).value("at_greatest_displacement", json::object());
  std::map<std::string, double> strokes;
  for (const json& cylinder : at.value("cylinders", json::array())) {
    strokes[cylinder.value("name", "")] = NumberOf(cylinder, "stroke_m");
  }
  for (const json& cylinder : plan.value("cylinders", json::array())) {
    const json from = cylinder.value("from_m", json::array());
    const json to = cylinder.value("to_m", json::array());
    if (from.size() != 2 || to.size() != 2) continue;
    if (shape.keys.size() == 3) {
      shape.keys.push_back({"cylinder longer than at rest", 2});
      shape.keys.push_back({"cylinder shorter", 1});
    }
    const std::string name = cylinder.value("name", "");
    shape.lines.push_back({.name = "cylinder " + name,
                           .key = 3,
                           .from = {from[0].get<double>(), from[1].get<double>()},
                           .to = moved(to[0].get<double>(), to[1].get<double>()),
                           .width_px = 5,
                           .stroke = strokes[name]});
  }
  Enlarge(0.25, &shape.lines);
  return shape;
}

std::vector<double> ClosedLoop(const json& values, double factor) {
  std::vector<double> out;
  for (const json& value : values)
    out.push_back(value.is_number() ? factor * value.get<double>() : kNoNumber);
  if (!out.empty()) out.push_back(out.front());
  return out;
}

/// Force against displacement over one cycle, every bogie.
XyPlot ModeLoop(const std::vector<json>& bogies, const Mode& mode) {
  XyPlot plot{.title = std::string(mode.title) + ", large motion: resistance over displacement",
              .x_label = mode.rotation ? "yaw of each axle [mrad]" : "travel of each axle [mm]",
              .y_label = mode.rotation ? "moment [kN m]" : "force [kN]",
              .height_px = 260};
  for (const json& bogie : bogies) {
    const json loop = bogie.value(mode.key, json::object()).value("loop", json::object());
    const int number = static_cast<int>(plot.curves.size());
    plot.curves.push_back(Curve{
        .label = bogie.value("bogie", "bogie"),
        .colour = number % 8,
        .dash = number % 4,
        .x = ClosedLoop(
            loop.value(mode.rotation ? "displacement_rad" : "displacement_m", json::array()), 1e3),
        .y = ClosedLoop(loop.value(mode.rotation ? "moment_Nm" : "force_N", json::array()), 1e-3)});
  }
  return plot;
}

/// What the cylinders and lines of the first bogie see at the greatest displacement.
void AddCylinderTable(const json& bogie, ReportPage* page) {
  DataTable table{.caption = "At the greatest displacement of the large motion", .head = {"Mode"}};
  for (const Mode& mode : kModes) {
    const json at =
        bogie.value(mode.key, json::object()).value("at_greatest_displacement", json::object());
    if (!at.contains("cylinders")) return;
    std::vector<TableCell> row = {TableCell(mode.title)};
    const bool first = table.head.size() == 1;
    for (const json& cylinder : at["cylinders"]) {
      if (first) table.head.push_back("cylinder " + cylinder.value("name", "") + " [mm, kN]");
      row.emplace_back(fmt::format("{}, {}", FormatNumber(1e3 * NumberOf(cylinder, "stroke_m")),
                                   FormatNumber(1e-3 * NumberOf(cylinder, "force_N"))));
    }
    for (const json& line : at.value("lines", json::array())) {
      if (first) table.head.push_back(line.value("name", "") + " [MPa absolute]");
      row.emplace_back(FormatNumber(1e-6 * NumberOf(line, "pressure_Pa")));
    }
    table.rows.push_back(std::move(row));
  }
  page->Add(table);
}

void AddModeTable(const std::vector<json>& bogies, ReportPage* page) {
  DataTable table{.caption = "Axle modes, totals over both axles", .head = {"Quantity"}};
  for (const json& bogie : bogies) table.head.push_back(bogie.value("bogie", "bogie"));
  for (const Mode& mode : kModes) {
    table.rows.push_back({TableCell(std::string(mode.title) + ": " + mode.meaning)});
    for (bool stiffness : {true, false}) {
      for (bool small : {false, true}) {
        std::vector<TableCell> row = {TableCell(
            fmt::format("{}{} [{}]", stiffness ? "stiffness" : "damping",
                        small ? ", small amplitude (seals stick)" : "", Unit(mode, stiffness)))};
        bool any = false;
        for (const json& bogie : bogies) {
          json entry = bogie.value(mode.key, json::object());
          if (small) entry = entry.value("small_amplitude", json::object());
          const double value = 1e-3 * NumberOf(entry, Key(mode, stiffness));
          any = any || std::isfinite(value);
          row.emplace_back(FormatNumber(value));
        }
        if (any) table.rows.push_back(std::move(row));
      }
    }
    std::vector<TableCell> row = {
        TableCell(fmt::format("stiffness by closed form, small [{}]", Unit(mode, true)))};
    for (const json& bogie : bogies) {
      const json form = bogie.value(mode.key, json::object()).value("closed_form", json::object());
      row.emplace_back(FormatNumber(1e-3 * NumberOf(form, Key(mode, true))));
    }
    table.rows.push_back(std::move(row));
  }
  page->Add(table);
}

}  // namespace

Status WriteModesReport(const std::vector<std::string>& modes_files, const std::string& path) {
  std::vector<json> bogies;
  for (const std::string& file : modes_files) {
    Result<json> read = ReadJsonObject(file);
    if (!read.ok()) return read.status();
    bogies.push_back(std::move(read.value()));
  }
  ReportPage page("Axle modes", "Stiffness and damping measured on the multibody model");
  page.Section("Stiffness");
  page.BeginGrid(2);
  for (const Mode& mode : kModes) {
    BarChart chart{.title = std::string(mode.title) + " stiffness",
                   .unit = Unit(mode, true),
                   .categories = {""}};
    for (const json& bogie : bogies) {
      const double value = 1e-3 * NumberOf(bogie.value(mode.key, json::object()), Key(mode, true));
      chart.bars.push_back(
          {bogie.value("bogie", "bogie"), static_cast<int>(chart.bars.size()) % 8, {value}});
    }
    page.Add(chart);
  }
  page.EndGrid();
  page.Section("Numbers");
  AddModeTable(bogies, &page);
  page.Note(
      "Closed form: springs, seals that stick and lines of oil and gas with their compliance at "
      "the "
      "static pressure; it holds for small motion. Large motion breaks the seals loose (friction "
      "goes into the damping) and compresses the gas.");
  page.Section("How the axles move");
  page.Paragraph("Motion enlarged, greatest at 0°. " +
                 PlayedWords(NumberOf(bogies[0], "frequency_Hz")) +
                 " The axles are driven as a sine, so nothing grows or dies out.");
  constexpr int kTrailSign[] = {-1, 1, 1, -1};
  page.BeginGrid(2);
  for (size_t i = 0; i < std::size(kModes); ++i) {
    AddMovingShape(ModeShape(bogies[0], kModes[i], 1, kTrailSign[i]), &page);
    page.Add(ModeLoop(bogies, kModes[i]));
  }
  page.EndGrid();
  AddCylinderTable(bogies[0], &page);
  return page.Write(path);
}

}  // namespace phs::report
