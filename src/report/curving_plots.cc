// Plots of axles and wheels along the track.
#include <fmt/format.h>

#include <cmath>

#include "base/numbers.h"
#include "report/curving_channel_plots.h"
#include "report/curving_parts.h"

namespace phs::report {
namespace {

std::vector<Curve> BogieNames(const CurvingResults& results) {
  std::vector<Curve> names;
  for (const BogieRun& run : results.runs) {
    names.push_back({.label = run.label, .colour = run.colour, .dash = run.dash});
  }
  return names;
}

/// "Y, leading left wheel (inner)".
std::string WheelTitle(const CurvingResults& results, const std::string& quantity,
                       const std::string& prefix, const std::string& axle,
                       const std::string& side) {
  std::string rail;
  if (results.hand != 0) rail = side == results.Side(true) ? " (outer)" : " (inner)";
  return fmt::format("{}, {}{} {} wheel{}", quantity, BogieWords(prefix), axle, side, rail);
}

void AddWheelPlots(const CurvingResults& results, const std::string& prefix,
                   const std::string& quantity, const std::string& suffix, ChannelPlot plot,
                   ReportPage* page) {
  std::vector<std::string> channels;
  for (const AxleName& axle : results.Axles(prefix)) {
    channels.push_back(prefix + axle.name + "_left" + suffix);
    channels.push_back(prefix + axle.name + "_right" + suffix);
  }
  ShareOrdinate(results, channels, &plot);
  page->BeginGrid(2);
  for (const AxleName& axle : results.Axles(prefix)) {
    for (const char* side : {"left", "right"}) {
      plot.title = WheelTitle(results, quantity, prefix, axle.word, side);
      plot.channel = prefix + axle.name + "_" + side + suffix;
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
  if (s == nullptr || s->empty()) return kNoNumber;
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
  std::vector<std::string> channels;
  for (const AxleName& axle : results.Axles(prefix)) {
    channels.push_back(prefix + axle.name + suffix);
  }
  ShareOrdinate(results, channels, &plot);
  for (const AxleName& axle : results.Axles(prefix)) {
    plot.title = quantity + ", " + BogieWords(prefix) + axle.word + " axle";
    plot.channel = prefix + axle.name + suffix;
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
  page->SharedLegend(kDistanceGroup, BogieNames(results));
  page->ZoomButtons(kDistanceGroup, [&] {
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

}  // namespace phs::report
