// Plots of the curving report.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "report/curving_parts.h"

namespace phs::report {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr char kGroup[] = "distance";
constexpr char kDistance[] = "distance [m]";

std::vector<double> Scaled(const std::vector<double>& values, double factor) {
  std::vector<double> scaled(values);
  for (double& value : scaled) value *= factor;
  return scaled;
}

std::vector<Band> TrackBands(const CurvingResults& results) {
  std::vector<Band> bands;
  for (const Section& section : results.sections) {
    if (section.kind == "tangent") continue;
    bands.push_back(
        {section.begin, section.end, SectionLabel(section), section.kind == "curve" ? 2 : 1});
  }
  return bands;
}

/// A plot over distance with one curve per bogie that recorded `channel`.
struct ChannelPlot {
  std::string title = {};
  std::string channel = {};
  std::string y_label = {};
  double factor = 1;
  double least_span = 0;
  bool from_zero = false;
  bool steps = false;
  std::vector<Level> levels = {};
  double ordinate_least = 0;
  double ordinate_greatest = 0;
};

/// Gives a plot the ordinate that covers these channels of all bogies, so that plots compare.
void ShareOrdinate(const CurvingResults& results, const std::vector<std::string>& channels,
                   ChannelPlot* plot) {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  for (const BogieRun& run : results.runs) {
    for (const std::string& channel : channels) {
      const std::vector<double>* values = run.Channel(channel);
      if (values == nullptr) continue;
      for (double value : *values) {
        if (!std::isfinite(value)) continue;
        least = std::min(least, value);
        greatest = std::max(greatest, value);
      }
    }
  }
  if (least > greatest) return;
  plot->ordinate_least = plot->factor * least;
  plot->ordinate_greatest = plot->factor * greatest;
}

void AddChannelPlot(const CurvingResults& results, const ChannelPlot& what, ReportPage* page) {
  SeriesPlot plot{.title = what.title,
                  .x_label = kDistance,
                  .y_label = what.y_label,
                  .bands = TrackBands(results),
                  .levels = what.levels,
                  .group = kGroup,
                  .ordinate_least = what.ordinate_least,
                  .ordinate_greatest = what.ordinate_greatest,
                  .least_span = what.least_span,
                  .from_zero = what.from_zero,
                  .steps = what.steps,
                  .max_points = 1600};
  // The reference is drawn last, on top of the others.
  for (std::size_t i = results.runs.size(); i-- > 0;) {
    const BogieRun& run = results.runs[i];
    const std::vector<double>* s = run.Channel("s_m");
    const std::vector<double>* y = run.Channel(what.channel);
    if (s == nullptr || y == nullptr) continue;
    plot.curves.push_back({.label = run.label,
                           .colour = run.colour,
                           .dash = run.dash,
                           .x = *s,
                           .y = Scaled(*y, what.factor)});
  }
  if (!plot.curves.empty()) page->Add(plot);
}

/// Several channels of one bogie in one plot.
void AddBogiePlot(const CurvingResults& results, const BogieRun& run, const std::string& title,
                  const std::string& y_label, double factor,
                  const std::vector<std::pair<std::string, std::string>>& channels,
                  ReportPage* page, double least_span = 0) {
  SeriesPlot plot{.title = title,
                  .x_label = kDistance,
                  .y_label = y_label,
                  .bands = TrackBands(results),
                  .group = kGroup,
                  .least_span = least_span,
                  .max_points = 1600};
  const std::vector<double>* s = run.Channel("s_m");
  if (s == nullptr) return;
  int colour = 3;
  for (const auto& [label, channel] : channels) {
    const std::vector<double>* y = run.Channel(channel);
    ++colour;
    if (y == nullptr) continue;
    plot.curves.push_back({.label = label,
                           .colour = colour % 8,
                           .dash = colour % 4,
                           .x = *s,
                           .y = Scaled(*y, factor)});
  }
  if (!plot.curves.empty()) page->Add(plot);
}

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

std::vector<Curve> BogieNames(const CurvingResults& results) {
  std::vector<Curve> names;
  for (const BogieRun& run : results.runs) {
    names.push_back({.label = run.label, .colour = run.colour, .dash = run.dash});
  }
  return names;
}

bool HasSeries(const CurvingResults& results) {
  for (const BogieRun& run : results.runs) {
    if (run.Channel("s_m") != nullptr) return true;
  }
  return false;
}

/// "Y, leading left wheel (inner)".
std::string WheelTitle(const CurvingResults& results, const std::string& quantity,
                       const std::string& prefix, const char* axle, const std::string& side) {
  std::string rail;
  if (results.hand != 0) rail = side == results.Side(true) ? " (outer)" : " (inner)";
  return fmt::format("{}, {}{} {} wheel{}", quantity, BogieWords(prefix),
                     std::string(axle) == "lead" ? "leading" : "trailing", side, rail);
}

void AddWheelPlots(const CurvingResults& results, const std::string& prefix,
                   const std::string& quantity, const std::string& suffix, ChannelPlot plot,
                   ReportPage* page) {
  std::vector<std::string> channels;
  for (const char* wheel : {"lead_left", "lead_right", "trail_left", "trail_right"}) {
    channels.push_back(prefix + wheel + suffix);
  }
  ShareOrdinate(results, channels, &plot);
  page->BeginGrid(2);
  for (const char* axle : {"lead", "trail"}) {
    for (const char* side : {"left", "right"}) {
      plot.title = WheelTitle(results, quantity, prefix, axle, side);
      plot.channel = prefix + axle + "_" + side + suffix;
      AddChannelPlot(results, plot, page);
    }
  }
  page->EndGrid();
}

/// Prud'homme limit of the track-shifting force from the static wheel load Q0, both in kN.
double PrudHomme(double q0_kN) { return 10 + 2 * q0_kN / 3; }

/// Static wheel load from the mean of Q at the start of the run [kN]; NaN if not recorded.
double StaticWheelLoad(const BogieRun& run, const std::string& prefix) {
  const std::vector<double>* s = run.Channel("s_m");
  if (s == nullptr || s->empty()) return kNone;
  double sum = 0;
  for (const char* wheel : {"lead_left", "lead_right", "trail_left", "trail_right"}) {
    sum += run.Mean(prefix + wheel + "_Q_N", s->front(), s->front() + 20);
  }
  return 1e-3 * sum / 4;
}

/// One plot for each axle, with equal ordinates.
void AddAxlePair(const CurvingResults& results, const std::string& prefix,
                 const std::string& quantity, const std::string& suffix, ChannelPlot plot,
                 ReportPage* page) {
  ShareOrdinate(results, {prefix + "lead" + suffix, prefix + "trail" + suffix}, &plot);
  for (const auto& [axle, word] : {std::pair{"lead", "leading"}, std::pair{"trail", "trailing"}}) {
    plot.title = quantity + ", " + BogieWords(prefix) + word + " axle";
    plot.channel = prefix + axle + suffix;
    AddChannelPlot(results, plot, page);
  }
}

void AddAxlePlots(const CurvingResults& results, const std::string& prefix, ReportPage* page) {
  page->BeginGrid(2);
  AddAxlePair(results, prefix, "Angle of attack", "_angle_of_attack_rad",
              {.y_label = "angle of attack [mrad]", .factor = 1e3, .least_span = 0.5}, page);
  AddAxlePair(results, prefix, "Lateral position", "_lateral_m",
              {.y_label = "lateral position [mm]", .factor = 1e3, .least_span = 1}, page);
  ChannelPlot force{.y_label = "ΣY [kN]", .factor = 1e-3, .least_span = 1};
  const double limit = PrudHomme(StaticWheelLoad(results.reference(), prefix));
  if (std::isfinite(limit)) {
    const std::string words = fmt::format("Prud'homme {:.0f} kN", limit);
    force.levels = {{limit, words}, {-limit, words}};
  }
  AddAxlePair(results, prefix, "Track-shifting force ΣY", "_sum_Y_N", force, page);
  page->EndGrid();
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
            {"primary suspension", name + "_primary_moment_Nm"}};
        if (run.Channel(HydraulicPrefix(run, prefix) + "cylinder_1_force_N") != nullptr) {
          parts.emplace_back("oil pressure", name + "_phs_pressure_moment_Nm");
          parts.emplace_back("seal friction", name + "_phs_friction_moment_Nm");
        }
        AddBogiePlot(results, run,
                     "Yaw moments, " + BogieWords(prefix) + word + " axle, " + run.label,
                     "yaw moment [kN m]", 1e-3 * sign, parts, page, 0.5);
      }
    }
  }
  page->EndGrid();
  page->EndDetails();
}

void AddTrackPlots(const CurvingResults& results, ReportPage* page) {
  if (!HasSeries(results)) {
    page->Note("No time series was saved with this result.");
    return;
  }
  page->Paragraph(
      "Drag across a plot to zoom all of them, double click for the whole run, click a name to "
      "hide "
      "its curves. Shaded: transitions and circular arcs. Angles and lateral positions are "
      "positive "
      "to the left.");
  page->SharedLegend(kGroup, BogieNames(results));
  page->ZoomButtons(kGroup, [&] {
    std::vector<Band> ranges;
    for (const Band& band : TrackBands(results)) {
      ranges.push_back(band);
      if (ranges.size() == 6) break;
    }
    return ranges;
  }());
  for (const std::string& prefix : results.prefixes) {
    if (!prefix.empty()) page->Heading(prefix == "front_" ? "Front bogie" : "Rear bogie");
    AddAxlePlots(results, prefix, page);
    page->Heading("Guiding force Y");
    AddWheelPlots(results, prefix, "Guiding force Y", "_Y_N",
                  {.y_label = "Y [kN]", .factor = 1e-3, .least_span = 1}, page);
    page->Heading("Wheel load Q");
    AddWheelPlots(results, prefix, "Wheel load Q", "_Q_N",
                  {.y_label = "Q [kN]", .factor = 1e-3, .least_span = 5}, page);
    page->Heading("Derailment quotient Y/Q (usual limit 0.8 as a mean over 2 m)");
    AddWheelPlots(results, prefix, "Y/Q", "_Y_over_Q",
                  {.y_label = "Y/Q [–]", .least_span = 0.1, .levels = {{0.8, "limit 0.8"}}}, page);
    page->Heading("Wear number Tγ (without spin)");
    AddWheelPlots(results, prefix, "Wear number Tγ", "_T_gamma_N",
                  {.y_label = "Tγ [N]", .least_span = 5, .from_zero = true}, page);
    page->BeginDetails("Number of contact points per wheel");
    AddWheelPlots(
        results, prefix, "Contact points", "_contacts",
        {.y_label = "contact points [–]", .least_span = 2, .from_zero = true, .steps = true}, page);
    page->EndDetails();
  }
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
    for (const BogieRun& run : results.runs) {
      const std::string system = HydraulicPrefix(run, prefix);
      if (run.Channel(system + "cylinder_1_force_N") == nullptr) continue;
      std::vector<std::pair<std::string, std::string>> force;
      std::vector<std::pair<std::string, std::string>> piston;
      std::vector<std::pair<std::string, std::string>> friction;
      std::vector<std::pair<std::string, std::string>> pressure;
      for (int i = 1; run.Channel(fmt::format("{}cylinder_{}_force_N", system, i)) != nullptr;
           ++i) {
        const std::string name = fmt::format("{}cylinder_{}", system, i);
        const std::string label = fmt::format("cylinder {}", i);
        force.emplace_back(label, name + "_force_N");
        piston.emplace_back(label, name + "_piston_m");
        friction.emplace_back(label, name + "_friction_N");
      }
      for (int i = 1; run.Channel(fmt::format("{}line_L{}_pressure_Pa", system, i)) != nullptr;
           ++i) {
        pressure.emplace_back(fmt::format("line L{}", i),
                              fmt::format("{}line_L{}_pressure_Pa", system, i));
      }
      const std::string whose = ", " + BogieWords(prefix) + run.label;
      AddBogiePlot(results, run, "Cylinder forces" + whose + " (tension positive)", "force [kN]",
                   1e-3, force, page, 0.5);
      AddBogiePlot(results, run, "Seal friction in the cylinders" + whose, "friction [kN]", 1e-3,
                   friction, page, 0.5);
      AddBogiePlot(results, run, "Piston displacements" + whose + " (extension positive)",
                   "piston [mm]", 1e3, piston, page, 0.5);
      AddBogiePlot(results, run, "Line pressures" + whose + " (absolute)", "pressure [MPa]", 1e-6,
                   pressure, page, 0.05);
    }
    page->EndGrid();
  }
}

}  // namespace phs::report
