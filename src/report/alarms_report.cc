#include "report/alarms_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "report/json_fields.h"
#include "report/report_page.h"

namespace phs::report {
namespace {

using Json = nlohmann::ordered_json;

/// Of a signal: what its numbers are multiplied with and the unit then.
std::pair<double, std::string> UnitShown(const Json& hose) {
  if (hose.at("unit") == "Pa") return {1e-6, "MPa"};
  return {1, ""};
}

std::string PairText(const Json& hose) {
  const std::string a = hose.at("first"), b = hose.at("second"), form = hose.at("form");
  const std::string text = form == "sum"                 ? a + " + " + b
                           : form == "ratio"             ? "ln(" + a + "/" + b + ")"
                           : form == "product"           ? "ln(" + a + " " + b + "/MPa²)"
                           : form == "product over rest" ? "ln(" + a + " " + b + "/rest²)"
                                                         : a + " - " + b;
  return hose.value("against_mean", false) ? text + " less its mean" : text;
}

std::string ThresholdText(const Json& hose) {
  const auto [factor, unit] = UnitShown(hose);
  return hose.at("alarm").get<std::string>() + " " +
         FormatNumber(factor * NumberOf(hose, "threshold")) + (unit.empty() ? "" : " " + unit);
}

std::string SafetyText(const Json& safety) {
  // A wheel that lifts has no Y/Q.
  const bool lifts = NumberOf(safety, "unloading") >= 1;
  return fmt::format("{}, {} kN, {} %", lifts ? "–" : FormatNumber(NumberOf(safety, "Y_over_Q"), 2),
                     FormatNumber(1e-3 * NumberOf(safety, "sum_Y_N")),
                     FormatNumber(100 * NumberOf(safety, "unloading"), 2));
}

void AddHoses(const Json& all, ReportPage* page) {
  DataTable table{.caption = "Each hose burst at speed",
                  .head = {"hose", "signal", "alarm", "seconds to the alarm: mean, slowest",
                           "margin", "alarms", "lowest line names it", "false alarms",
                           "until the alarm: Y/Q, sum of Y, unloading", "before the burst"}};
  for (const Json& hose : all.at("hoses")) {
    const int runs = hose.at("runs"), alarmed = hose.at("alarmed");
    table.rows.push_back(
        {hose.at("name").get<std::string>(), PairText(hose), ThresholdText(hose),
         FormatNumber(NumberOf(hose, "mean_seconds_to_alarm")) + ", " +
             FormatNumber(NumberOf(hose, "largest_seconds_to_alarm")),
         FormatNumber(NumberOf(hose, "margin")), fmt::format("{} of {}", alarmed, runs),
         fmt::format("{} of {}", hose.at("named_by_lowest_pressure").get<int>(), runs),
         fmt::format("{}", hose.at("false_alarms").get<int>()), SafetyText(hose.at("until_alarm")),
         SafetyText(hose.at("before_burst"))});
    table.rows.back()[5].bad = alarmed != runs;
  }
  page->Add(table);
  page->Paragraph(
      "Margin: how far the signal stays beyond its threshold, over how far the threshold lies "
      "beyond "
      "a usual block. Pressures are absolute. Y/Q and the sum of Y are means over 2 m, all behind "
      "20 Hz; "
      "unloading "
      "is the share of its mean load that a wheel has lost. Largest of all runs.");
}

void AddFalseAlarms(const Json& all, ReportPage* page) {
  const Json& found = all.at("false_alarms");
  DataTable table{
      .caption = "Without any failure, on tracks that nothing was learned from",
      .head = {"service", "distance [km]", "false alarms", "at most, in 1000 km (Poisson, 95 %)"}};
  const auto add = [&](const std::string& name, const Json& row) {
    table.rows.push_back({name, FormatNumber(NumberOf(row, "distance_km"), 4),
                          fmt::format("{}", row.at("count").get<int>()),
                          FormatNumber(NumberOf(row, "upper_per_1000_km"))});
  };
  for (const Json& service : found.at("services")) add(service.at("name"), service);
  add("all", found);
  page->Add(table);
}

std::vector<double> ScaledNumbers(const Json& list, double factor) {
  std::vector<double> out;
  for (const Json& value : list) out.push_back(factor * AsNumber(value));
  return out;
}

void AddBurst(const Json& hose, ReportPage* page) {
  const Json& drawn = hose.at("drawn");
  const std::vector<double> t = ScaledNumbers(drawn.at("t_s"), 1);
  SeriesPlot lines{.title = hose.at("name").get<std::string>() + " bursts, " +
                            drawn.at("service").get<std::string>() + ": pressures",
                   .x_label = "time since the burst [s]",
                   .y_label = "pressure, absolute [MPa]",
                   .group = "burst",
                   .from_zero = true};
  for (const auto& [name, values] : drawn.at("pressure_Pa").items()) {
    const int n = static_cast<int>(lines.curves.size());
    lines.curves.push_back(
        {.label = name, .colour = n, .dash = n % 4, .x = t, .y = ScaledNumbers(values, 1e-6)});
  }
  const auto [factor, unit] = UnitShown(hose);
  SeriesPlot signal{.title = hose.at("name").get<std::string>() + " bursts: " + PairText(hose),
                    .x_label = "time since the burst [s]",
                    .y_label = "signal" + (unit.empty() ? "" : " [" + unit + "]"),
                    .levels = {{factor * NumberOf(hose, "threshold"), "threshold"}},
                    .group = "burst"};
  signal.curves.push_back({.label = PairText(hose),
                           .colour = 0,
                           .x = t,
                           .y = ScaledNumbers(drawn.at("signal"), factor)});
  page->Add(lines);
  page->Add(signal);
}

/// Largest values of the blocks in order against what their law says of that order.
void AddLearned(const Json& hose, ReportPage* page) {
  const auto [factor, unit] = UnitShown(hose);
  XyPlot plot{.title = hose.at("name").get<std::string>() + ": " + PairText(hose),
              .x_label = "reduced variate of Gumbel's law",
              .y_label = "extreme of a block" + (unit.empty() ? "" : " [" + unit + "]"),
              .levels = {{factor * NumberOf(hose, "threshold"), "threshold"}},
              .height_px = 260};
  const double sign = hose.at("alarm") == "above" ? 1 : -1;
  for (const Json& learned : hose.at("learned")) {
    std::vector<double> extremes = ScaledNumbers(learned.at("maxima"), factor);
    std::sort(extremes.begin(), extremes.end(),
              [sign](double a, double b) { return sign * a < sign * b; });
    const int colour = static_cast<int>(plot.curves.size()) / 2;
    const std::string service = learned.at("service");
    Curve points{.label = service, .colour = colour, .points = true};
    Curve law{.label = service + ", law", .colour = colour, .dash = 1};
    for (size_t i = 0; i < extremes.size(); ++i) {
      const double p = (static_cast<double>(i) + 0.5) / static_cast<double>(extremes.size());
      points.x.push_back(-std::log(-std::log(p)));
      points.y.push_back(extremes[i]);
    }
    const double shape = NumberOf(learned, "shape");
    for (double y = -2; y <= 14; y += 0.5) {
      const double reach = shape == 0 ? y : -std::expm1(-shape * y) / shape;
      law.x.push_back(y);
      law.y.push_back(factor *
                      (NumberOf(learned, "location") + sign * NumberOf(learned, "scale") * reach));
    }
    plot.curves.push_back(std::move(points));
    plot.curves.push_back(std::move(law));
  }
  page->Add(plot);
}

}  // namespace

Status WriteAlarmsReport(const std::string& alarms_file, const std::string& path) {
  const Result<Json> read = ReadJsonObject(alarms_file);
  if (!read.ok()) return read.error();
  return MakeGuarded(alarms_file, [&]() -> Status {
    const Json& all = read.value();
    const Json& found = all.at("false_alarms");
    ReportPage page("Alarms for lost hoses",
                    fmt::format("pairs of line pressures; wanted: {:g} false alarms in 1000 km",
                                NumberOf(all, "wanted_per_1000_km")));
    page.Section("Result");
    if (all.at("status") != "ok") page.Warning("Not every burst gave an alarm.");
    AddHoses(all, &page);
    AddFalseAlarms(all, &page);
    page.Paragraph(fmt::format(
        "Threshold: extremes of blocks of {:g} m without failure follow a law of extremes; it lies "
        "where "
        "the wanted rate, shared by the hoses, is exceeded, at the upper end of its 95 % interval, "
        "for the worst service. Signals stand behind a lag of {:g} s. Tested on {} km.",
        NumberOf(all, "block_m"), NumberOf(all, "lag_s"),
        FormatNumber(NumberOf(found, "distance_km"), 4)));
    page.Section("A burst of each hose");
    page.BeginGrid(2);
    for (const Json& hose : all.at("hoses")) AddBurst(hose, &page);
    page.EndGrid();
    page.Section("What the thresholds were learned from");
    page.BeginGrid(2);
    for (const Json& hose : all.at("hoses")) AddLearned(hose, &page);
    page.EndGrid();
    return page.Write(path);
  });
}

}  // namespace phs::report
