#include "report/analysis_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "report/json_fields.h"
#include "report/report_page.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

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

/// Picture of one mode from above: at rest dashed, at its greatest displacement solid; motion drawn
/// large. Yaw turns the axle, x moves it; the frame stands still.
XyPlot ModePicture(const json& bogie, const Mode& mode, int lead_sign, int trail_sign) {
  constexpr double kHalfAxle = 0.9;  // [m]
  constexpr double kYaw = 0.22;      // drawn [rad]
  constexpr double kMove = 0.25;     // drawn [m]
  XyPlot plot{.title = std::string(mode.title) + ": " + mode.meaning,
              .x_label = "along the bogie [m], motion enlarged",
              .y_label = "to the left [m]",
              .height_px = 260};
  Curve frame{.label = "frame", .colour = 7, .x = {}, .y = {}};
  Curve rest{.label = "axles at rest", .colour = 7, .dash = 2};
  Curve moved{.label = "axles moved", .colour = 0};
  Curve longer{.label = "cylinder extends", .colour = 2};
  Curve shorter{.label = "cylinder shortens", .colour = 1};
  const auto line = [](Curve* curve, double x0, double y0, double x1, double y1) {
    for (const auto& [x, y] : {std::pair{x0, y0}, {x1, y1}, {kNone, kNone}}) {
      curve->x.push_back(x);
      curve->y.push_back(y);
    }
  };
  const json plan = bogie.value("plan", json::object());
  double reach = 0;
  const json axles = plan.value("axles", json::array());
  for (const json& axle : axles) reach = std::max(reach, std::abs(NumberOf(axle, "x_m")));
  for (const double side : {-0.75, 0.75}) line(&frame, -0.75 * reach, side, 0.75 * reach, side);
  line(&frame, 0, -0.75, 0, 0.75);
  const auto place = [&](double x, double y) {  // of a point of the axle nearest to x
    const int sign = x > 0 ? lead_sign : trail_sign;
    const double centre = x > 0 ? reach : -reach;
    const double yaw = mode.rotation ? kYaw * sign : 0;
    return std::pair{x - yaw * y + (mode.rotation ? 0 : kMove * sign), y + yaw * (x - centre)};
  };
  for (const json& axle : axles) {
    const double x = NumberOf(axle, "x_m");
    line(&rest, x, -kHalfAxle, x, kHalfAxle);
    const auto [x0, y0] = place(x, -kHalfAxle);
    const auto [x1, y1] = place(x, kHalfAxle);
    line(&moved, x0, y0, x1, y1);
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
    const auto [x, y] = place(to[0].get<double>(), to[1].get<double>());
    line(strokes[cylinder.value("name", "")] >= 0 ? &longer : &shorter, from[0].get<double>(),
         from[1].get<double>(), x, y);
  }
  plot.curves = {frame, rest, moved};
  if (!longer.x.empty()) plot.curves.push_back(longer);
  if (!shorter.x.empty()) plot.curves.push_back(shorter);
  return plot;
}

std::vector<double> Scaled(const json& values, double factor) {
  std::vector<double> out;
  for (const json& value : values)
    out.push_back(value.is_number() ? factor * value.get<double>() : kNone);
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
        .x = Scaled(
            loop.value(mode.rotation ? "displacement_rad" : "displacement_m", json::array()), 1e3),
        .y = Scaled(loop.value(mode.rotation ? "moment_Nm" : "force_N", json::array()), 1e-3)});
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
      if (first) table.head.push_back(line.value("name", "") + " [MPa]");
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
  constexpr int kTrailSign[] = {-1, 1, 1, -1};
  page.BeginGrid(2);
  for (size_t i = 0; i < std::size(kModes); ++i) {
    page.Add(ModePicture(bogies[0], kModes[i], 1, kTrailSign[i]));
    page.Add(ModeLoop(bogies, kModes[i]));
  }
  page.EndGrid();
  AddCylinderTable(bogies[0], &page);
  return page.Write(path);
}

}  // namespace phs::report
