#include "report/curving_channel_plots.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/decimation.h"

namespace phs::report {
std::vector<Band> TrackBands(const CurvingResults& results) {
  std::vector<Band> bands;
  for (const Section& section : results.sections) {
    if (section.kind == "tangent") continue;
    bands.push_back(
        {section.begin, section.end, SectionLabel(section), section.kind == "curve" ? 2 : 1});
  }
  return bands;
}

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
                  .x_label = "distance [m]",
                  .y_label = what.y_label,
                  .bands = TrackBands(results),
                  .levels = what.levels,
                  .group = kDistanceGroup,
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

void AddBogiePlot(const CurvingResults& results, const BogieRun& run, const BogiePlot& what,
                  ReportPage* page) {
  SeriesPlot plot{.title = what.title,
                  .x_label = "distance [m]",
                  .y_label = what.y_label,
                  .bands = TrackBands(results),
                  .group = kDistanceGroup,
                  .least_span = what.least_span,
                  .max_points = 1600};
  const std::vector<double>* s = run.Channel("s_m");
  if (s == nullptr) return;
  int colour = 3;
  for (const auto& [label, channel] : what.channels) {
    const std::vector<double>* y = run.Channel(channel);
    ++colour;
    if (y == nullptr) continue;
    plot.curves.push_back({.label = label,
                           .colour = colour % 8,
                           .dash = colour % 4,
                           .x = *s,
                           .y = Scaled(*y, what.factor)});
  }
  if (!plot.curves.empty()) page->Add(plot);
}

bool HasSeries(const CurvingResults& results) {
  for (const BogieRun& run : results.runs) {
    if (run.Channel("s_m") != nullptr) return true;
  }
  return false;
}

}  // namespace phs::report
