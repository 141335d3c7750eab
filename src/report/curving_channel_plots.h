// Plots of recorded channels over distance, the common tool of the curving report.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "report/curving_results.h"
#include "report/report_page.h"

namespace phs::report {

inline constexpr char kDistanceGroup[] = "distance";  ///< plots that are zoomed together

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
                   ChannelPlot* plot);
/// Adds nothing if no bogie recorded the channel.
void AddChannelPlot(const CurvingResults& results, const ChannelPlot& what, ReportPage* page);

/// Several channels of one bogie in one plot: pairs of label and channel.
struct BogiePlot {
  std::string title = {};
  std::string y_label = {};
  double factor = 1;
  double least_span = 0;
  std::vector<std::pair<std::string, std::string>> channels = {};
};
void AddBogiePlot(const CurvingResults& results, const BogieRun& run, const BogiePlot& what,
                  ReportPage* page);

/// Transitions and arcs as shaded bands.
std::vector<Band> TrackBands(const CurvingResults& results);
bool HasSeries(const CurvingResults& results);

}  // namespace phs::report
