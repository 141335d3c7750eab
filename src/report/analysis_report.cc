#include "report/analysis_report.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/result_dir.h"
#include "report/report_page.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Result<json> ReadJson(const std::string& path) {
  Result<std::string> text = ReadFile(path);
  if (!text.ok()) return text.error();
  json parsed = json::parse(text.value(), nullptr, false);
  if (!parsed.is_object()) {
    return Error{.where = path, .what = "is not a JSON object", .allowed = "", .mend = ""};
  }
  return parsed;
}

double NumberOf(const json& object, const std::string& key) {
  if (!object.is_object() || !object.contains(key) || !object[key].is_number()) return kNone;
  return object[key].get<double>();
}

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
  }
  page->Add(table);
}

}  // namespace

Status WriteModesReport(const std::vector<std::string>& modes_files, const std::string& path) {
  std::vector<json> bogies;
  for (const std::string& file : modes_files) {
    Result<json> read = ReadJson(file);
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
  return page.Write(path);
}

}  // namespace phs::report
