// Plots of the bogie as a whole: bending and shear, hydraulics, yaw moments on the axles.
#include <fmt/format.h>

#include <string_view>

#include "report/curving_channel_plots.h"
#include "report/curving_parts.h"

namespace phs::report {
namespace {

/// ", front bogie"; empty for a single bogie.
std::string WhichBogie(const std::string& prefix) {
  return prefix.empty() ? "" : ", " + prefix.substr(0, prefix.size() - 1) + " bogie";
}

/// Prefix of the channels of the hydraulics that belong to a bogie: "" or e.g. "front_bogie_".
std::string HydraulicPrefix(const BogieRun& run, const std::string& bogie) {
  static constexpr std::string_view kFirst = "cylinder_1_force_N";
  for (const Channel& channel : run.series.channels) {
    if (!channel.name.ends_with(kFirst) || !channel.name.starts_with(bogie)) continue;
    return channel.name.substr(0, channel.name.size() - kFirst.size());
  }
  return bogie;
}

/// Forces, friction, strokes and pressures of one bogie's hydraulics; nothing if it has none.
void AddCylinderPlots(const CurvingResults& results, const BogieRun& run, const std::string& bogie,
                      ReportPage* page) {
  const std::string whose = ", " + BogieWords(bogie) + run.label;
  BogiePlot force{.title = "Cylinder forces" + whose + " (tension positive)",
                  .y_label = "force [kN]",
                  .factor = 1e-3,
                  .least_span = 0.5};
  BogiePlot friction{.title = "Seal friction in the cylinders" + whose,
                     .y_label = "friction [kN]",
                     .factor = 1e-3,
                     .least_span = 0.5};
  BogiePlot piston{.title = "Piston displacements" + whose + " (extension positive)",
                   .y_label = "piston [mm]",
                   .factor = 1e3,
                   .least_span = 0.5};
  BogiePlot pressure{.title = "Line pressures" + whose + " (absolute)",
                     .y_label = "pressure [MPa]",
                     .factor = 1e-6,
                     .least_span = 0.05};
  const std::string system = HydraulicPrefix(run, bogie);
  for (int i = 1;; ++i) {
    const std::string cylinder = fmt::format("{}cylinder_{}", system, i);
    if (run.Channel(cylinder + "_force_N") == nullptr) break;
    const std::string label = fmt::format("cylinder {}", i);
    force.channels.emplace_back(label, cylinder + "_force_N");
    friction.channels.emplace_back(label, cylinder + "_friction_N");
    piston.channels.emplace_back(label, cylinder + "_piston_m");
  }
  for (int i = 1;; ++i) {
    const std::string line = fmt::format("{}line_L{}_pressure_Pa", system, i);
    if (run.Channel(line) == nullptr) break;
    pressure.channels.emplace_back(fmt::format("line L{}", i), line);
  }
  for (const BogiePlot* plot : {&force, &friction, &piston, &pressure}) {
    AddBogiePlot(results, run, *plot, page);
  }
}

}  // namespace

void AddMomentPlots(const CurvingResults& results, ReportPage* page) {
  if (!HasSeries(results) || results.hand == 0) return;
  page->BeginDetails("The same moments along the track");
  page->Paragraph(
      "Positive: towards the direction that the first arc asks for, so that the arc reads like the "
      "bars above.");
  page->BeginGrid(2);
  for (const std::string& prefix : results.prefixes) {
    for (const auto& [axle, word] :
         {std::pair{"lead", "leading"}, std::pair{"trail", "trailing"}}) {
      const double sign = results.hand * (std::string(axle) == "lead" ? 1 : -1);
      for (const BogieRun& run : results.runs) {
        const std::string name = prefix + axle;
        std::vector<std::pair<std::string, std::string>> parts = {
            {"creep forces", name + "_steering_moment_Nm"},
            {"primary suspension with its links", name + "_primary_moment_Nm"}};
        if (run.Channel(HydraulicPrefix(run, prefix) + "cylinder_1_force_N") != nullptr) {
          parts.emplace_back("oil pressure", name + "_phs_pressure_moment_Nm");
          parts.emplace_back("seal friction", name + "_phs_friction_moment_Nm");
        }
        AddBogiePlot(results, run,
                     {.title = "Yaw moments, " + BogieWords(prefix) + word + " axle, " + run.label,
                      .y_label = "yaw moment [kN m]",
                      .factor = 1e-3 * sign,
                      .least_span = 0.5,
                      .channels = parts},
                     page);
      }
    }
  }
  page->EndGrid();
  page->EndDetails();
}

void AddHydraulicPlots(const CurvingResults& results, ReportPage* page) {
  if (!HasSeries(results)) {
    page->Note("No time series was saved with this result.");
    return;
  }
  for (const std::string& prefix : results.prefixes) {
    page->BeginGrid(2);
    AddChannelPlot(
        results,
        {.title = "Bending" + WhichBogie(prefix) + ": opposite yaw of the axles (steering)",
         .channel = prefix + "bending_rad",
         .y_label = "bending [mrad]",
         .factor = 1e3,
         .least_span = 0.2},
        page);
    AddChannelPlot(results,
                   {.title = "Shear" + WhichBogie(prefix) + ": same-sense yaw of the axles",
                    .channel = prefix + "shear_rad",
                    .y_label = "shear [mrad]",
                    .factor = 1e3,
                    .least_span = 0.2},
                   page);
    for (const BogieRun& run : results.runs) AddCylinderPlots(results, run, prefix, page);
    page->EndGrid();
    for (const BogieRun& run : results.runs) {
      AddHydraulicTable(results, run, prefix, HydraulicPrefix(run, prefix), page);
    }
  }
}

}  // namespace phs::report
