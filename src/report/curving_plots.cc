// Plots of the curving report.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/curving_parts.h"
#include "report/decimation.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr char kGroup[] = "distance";
constexpr char kDistance[] = "distance [m]";

std::vector<double> Scaled(const std::vector<double>& values, double factor) {
  std::vector<double> scaled(values);
  for (double& value : scaled) value *= factor;
  return scaled;
}

std::string SectionLabel(const Section& section) {
  return section.kind == "curve"        ? fmt::format("R {:.0f} m", section.radius)
         : section.kind == "transition" ? "transition"
                                        : "";
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
};

void AddChannelPlot(const CurvingResults& results, const ChannelPlot& what, ReportPage* page) {
  SeriesPlot plot{.title = what.title,
                  .x_label = kDistance,
                  .y_label = what.y_label,
                  .bands = TrackBands(results),
                  .levels = what.levels,
                  .group = kGroup,
                  .least_span = what.least_span,
                  .from_zero = what.from_zero,
                  .steps = what.steps,
                  .max_points = 1600};
  for (const BogieRun& run : results.runs) {
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

void AddAxlePlots(const CurvingResults& results, const std::string& prefix, ReportPage* page) {
  const double limit = PrudHomme(StaticWheelLoad(results.reference(), prefix));
  page->BeginGrid(2);
  for (const auto& [axle, word] : {std::pair{"lead", "leading"}, std::pair{"trail", "trailing"}}) {
    const std::string name = BogieWords(prefix) + word + " axle";
    AddChannelPlot(results,
                   {.title = "Angle of attack, " + name,
                    .channel = prefix + axle + "_angle_of_attack_rad",
                    .y_label = "angle of attack [mrad]",
                    .factor = 1e3,
                    .least_span = 0.5},
                   page);
  }
  for (const auto& [axle, word] : {std::pair{"lead", "leading"}, std::pair{"trail", "trailing"}}) {
    const std::string name = BogieWords(prefix) + word + " axle";
    AddChannelPlot(results,
                   {.title = "Lateral position, " + name,
                    .channel = prefix + axle + "_lateral_m",
                    .y_label = "lateral position [mm]",
                    .factor = 1e3,
                    .least_span = 1},
                   page);
  }
  for (const auto& [axle, word] : {std::pair{"lead", "leading"}, std::pair{"trail", "trailing"}}) {
    const std::string name = BogieWords(prefix) + word + " axle";
    ChannelPlot plot{.title = "Track-shifting force ΣY, " + name,
                     .channel = prefix + axle + "_sum_Y_N",
                     .y_label = "ΣY [kN]",
                     .factor = 1e-3,
                     .least_span = 1};
    if (std::isfinite(limit)) {
      const std::string words = fmt::format("Prud'homme {:.0f} kN", limit);
      plot.levels = {{limit, words}, {-limit, words}};
    }
    AddChannelPlot(results, plot, page);
  }
  page->EndGrid();
}

/// Greatest magnitude of a packed-size series over all rows; 0 if there is none.
double Greatest(const std::vector<double>& values) {
  double greatest = 0;
  for (double value : values) {
    if (std::isfinite(value)) greatest = std::max(greatest, std::abs(value));
  }
  return greatest;
}

/// The largest of 1, 2, 3, 4, 5, 10, 20 … that does not exceed `most`.
double RoundFactor(double most) {
  if (!(most > 1)) return 1;
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  return power * std::min(5.0, std::floor(most / power));
}

json Packed(const std::vector<double>& values) {
  const PackedValues packed = Pack(values);
  return {{"least", packed.least}, {"greatest", packed.greatest}, {"packed", packed.base64}};
}

double Wheelbase(const BogieRun& run, const std::string& prefix) {
  const auto* x1 = run.Channel(prefix + "lead_x_m");
  const auto* y1 = run.Channel(prefix + "lead_y_m");
  const auto* x2 = run.Channel(prefix + "trail_x_m");
  const auto* y2 = run.Channel(prefix + "trail_y_m");
  if (x1 == nullptr || y1 == nullptr || x2 == nullptr || y2 == nullptr || x1->empty()) return kNone;
  return std::hypot(x1->front() - x2->front(), y1->front() - y2->front());
}

json TrackMap(const CurvingResults& results) {
  const json line = results.all.value(json::json_pointer("/track/centre_line"), json::object());
  if (!line.contains("s_m") || line["s_m"].size() < 2) return nullptr;
  json sections = json::array();
  for (const Section& section : results.sections) {
    sections.push_back({{"kind", section.kind},
                        {"begin", section.begin},
                        {"end", section.end},
                        {"label", SectionLabel(section)}});
  }
  // At most about a thousand points: enough for a map.
  json map = {{"name", results.track_name}, {"sections", sections}};
  const std::size_t step = line["s_m"].size() / 1000 + 1;
  for (const auto& [to, from] :
       {std::pair{"s", "s_m"}, std::pair{"x", "x_m"}, std::pair{"y", "y_m"}}) {
    map[to] = json::array();
    const json& values = line.value(from, json::array());
    for (std::size_t i = 0; i < values.size(); i += step) map[to].push_back(values[i]);
  }
  return map;
}

/// Poses of the bogies along the track and the factors they are magnified by.
json PlanSpec(const CurvingResults& results, const std::string& prefix) {
  const std::vector<double>& s0 = *results.reference().Channel("s_m");
  const Grid grid{.begin = s0.front(), .end = s0.back(), .points = 600};
  json spec = {{"grid", {{"begin", grid.begin}, {"end", grid.end}, {"points", grid.points}}},
               {"bogies", json::array()}};
  double attack = 1e-4;
  double lateral = 1e-4;
  double curvature = 1e-6;
  for (const BogieRun& run : results.runs) {
    json bogie = {{"label", run.label}, {"colour", run.colour}};
    const std::vector<double>* s = run.Channel("s_m");
    for (const char* axle : {"lead", "trail"}) {
      for (const auto& [key, suffix] :
           {std::pair{"lateral", "_lateral_m"}, std::pair{"attack", "_angle_of_attack_rad"},
            std::pair{"yaw", "_yaw_rad"}}) {
        const std::vector<double>* y = run.Channel(prefix + axle + suffix);
        if (s == nullptr || y == nullptr) return nullptr;
        bogie[axle][key] = Packed(PutOnGrid(*s, *y, grid));
        if (std::string(key) == "attack") attack = std::max(attack, Greatest(*y));
        if (std::string(key) == "lateral") lateral = std::max(lateral, Greatest(*y));
      }
    }
    spec["bogies"].push_back(std::move(bogie));
  }
  const std::vector<double>* k = results.reference().Channel("curvature_1_m");
  if (k == nullptr) return nullptr;
  curvature = std::max(curvature, Greatest(*k));
  const double wheelbase = Wheelbase(results.reference(), prefix);
  if (!std::isfinite(wheelbase)) return nullptr;
  spec["curvature"] = Packed(PutOnGrid(s0, *k, grid));
  spec["wheelbase"] = wheelbase;
  const json track = results.all.value("track", json::object());
  spec["gauge"] = track.value("gauge_m", 1.067);
  spec["wheel_radius"] = 0.625;  // only how large the wheels are drawn
  // At most 8 degrees of track heading and 17 degrees of attack in the drawing.
  spec["magnification"] = RoundFactor(std::min(0.14 / (curvature * wheelbase / 2), 0.3 / attack));
  spec["lateral_magnification"] = RoundFactor(std::min(12.0, 0.12 / lateral));
  spec["start"] = results.radius > 0 ? (results.steady_begin + results.steady_end) / 2
                                     : (grid.begin + grid.end) / 2;
  spec["track"] = TrackMap(results);
  return spec;
}

MomentBudget FromParts(double creep, double pressure, double friction, double primary, int sign) {
  MomentBudget budget;
  budget.known = std::isfinite(creep) && std::isfinite(primary);
  const auto counted = [sign](double value) { return std::isfinite(value) ? sign * value : 0.0; };
  budget.creep = counted(creep);
  budget.phs_pressure = counted(pressure);
  budget.phs_friction = counted(friction);
  budget.primary = counted(primary);
  budget.rest = -(budget.creep + budget.phs_pressure + budget.phs_friction + budget.primary);
  return budget;
}

}  // namespace

MomentBudget CalcBudget(const BogieRun& run, const CurvingResults& results,
                        const std::string& axle) {
  // A left curve asks the leading axle to turn left (+) in its bogie and the trailing one right
  // (-).
  const int sign = results.hand * (axle.ends_with("lead") ? 1 : -1);
  if (sign == 0) return {};
  const std::string at = "/budget/" + axle + "/";
  MomentBudget saved =
      FromParts(run.Number(at + "creep_Nm"), run.Number(at + "phs_pressure_Nm"),
                run.Number(at + "phs_friction_Nm"), run.Number(at + "primary_Nm"), sign);
  if (saved.known) return saved;
  const auto mean = [&](const char* suffix) {
    return run.Mean(axle + suffix, results.steady_begin, results.steady_end);
  };
  return FromParts(mean("_steering_moment_Nm"), mean("_phs_pressure_moment_Nm"),
                   mean("_phs_friction_moment_Nm"), mean("_primary_moment_Nm"), sign);
}

void AddPlanView(const CurvingResults& results, ReportPage* page) {
  for (const std::string& prefix : results.prefixes) {
    if (!HasSeries(results)) break;
    const json spec = PlanSpec(results, prefix);
    if (spec.is_null()) continue;
    page->AddFigure(
        "plan",
        fmt::format(
            "{}all angles magnified {:.0f} times (as if the radius were that much smaller), "
            "lateral positions {:.0f} times; dashed: radial direction under each axle",
            prefix.empty()       ? "Axles on the track: "
            : prefix == "front_" ? "Front bogie: "
                                 : "Rear bogie: ",
            spec["magnification"].get<double>(), spec["lateral_magnification"].get<double>()),
        spec.dump(-1, ' ', false, json::error_handler_t::replace));
    return;  // the front bogie stands for both
  }
  page->Note("No poses of the axles were recorded.");
}

void AddMomentBudget(const CurvingResults& results, ReportPage* page) {
  if (results.hand == 0) {
    page->Note("The track has no circular arc: there is no steering moment to balance.");
    return;
  }
  page->Paragraph(
      "Yaw moments on each axle in the steady curve. Positive: turns the axle towards the radial "
      "direction (steers). Negative: turns it away from it (holds back). In a steady state they "
      "add "
      "up to zero.");
  page->BeginGrid(2);
  for (const std::string& prefix : results.prefixes) {
    for (const auto& [axle, word] :
         {std::pair{"lead", "leading"}, std::pair{"trail", "trailing"}}) {
      BarChart chart{.title = "Yaw moments, " + BogieWords(prefix) + word + " axle",
                     .unit = "kN m",
                     .categories = {"Creep forces", "Oil pressure", "Seal friction",
                                    "Primary suspension", "Rest"}};
      for (const BogieRun& run : results.runs) {
        const MomentBudget budget = CalcBudget(run, results, prefix + axle);
        if (!budget.known) continue;
        chart.bars.push_back({run.label, run.colour,
                              Scaled({budget.creep, budget.phs_pressure, budget.phs_friction,
                                      budget.primary, budget.rest},
                                     1e-3)});
      }
      if (!chart.bars.empty()) page->Add(chart);
    }
  }
  page->EndGrid();
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
    page->Heading("Derailment quotient Y/Q");
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
    AddChannelPlot(results,
                   {.title = BogieWords(prefix) + "Bending: opposite yaw of the axles (steering)",
                    .channel = prefix + "bending_rad",
                    .y_label = "bending [mrad]",
                    .factor = 1e3,
                    .least_span = 0.2},
                   page);
    AddChannelPlot(results,
                   {.title = BogieWords(prefix) + "Shear: same-sense yaw of the axles",
                    .channel = prefix + "shear_rad",
                    .y_label = "shear [mrad]",
                    .factor = 1e3,
                    .least_span = 0.2},
                   page);
    for (const BogieRun& run : results.runs) {
      if (run.Channel(prefix + "cylinder_1_force_N") == nullptr) continue;
      std::vector<std::pair<std::string, std::string>> force;
      std::vector<std::pair<std::string, std::string>> piston;
      std::vector<std::pair<std::string, std::string>> friction;
      std::vector<std::pair<std::string, std::string>> pressure;
      for (int i = 1; run.Channel(fmt::format("{}cylinder_{}_force_N", prefix, i)) != nullptr;
           ++i) {
        const std::string name = fmt::format("{}cylinder_{}", prefix, i);
        const std::string label = fmt::format("cylinder {}", i);
        force.emplace_back(label, name + "_force_N");
        piston.emplace_back(label, name + "_piston_m");
        friction.emplace_back(label, name + "_friction_N");
      }
      for (int i = 1; run.Channel(fmt::format("{}line_L{}_pressure_Pa", prefix, i)) != nullptr;
           ++i) {
        pressure.emplace_back(fmt::format("line L{}", i),
                              fmt::format("{}line_L{}_pressure_Pa", prefix, i));
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
