// Plots of the identification report.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "report/decimation.h"
#include "report/identify_parts.h"

namespace phs::report {
namespace {

constexpr char kGroup[] = "time";

std::string BeforeName() { return "declared, fitted"; }
std::string AfterName(const IdentifyResults& results) {
  return results.has_before ? "corrected" : "model";
}

SeriesPlot TimePlot(const IdentifyResults& results, const std::string& title,
                    const std::string& y_label) {
  return {.title = title,
          .x_label = "time [s]",
          .y_label = y_label,
          .bands = results.windows,
          .group = kGroup,
          .max_points = 4000};
}

/// Edges of `count` equal cells over the values' central 99 %; empty if they do not vary.
std::vector<double> Edges(std::vector<double> values, int count) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.size() < 100) return {};
  std::sort(values.begin(), values.end());
  const double least = values[values.size() / 200];
  const double greatest = values[values.size() - 1 - values.size() / 200];
  if (!(greatest > least)) return {};
  std::vector<double> edges;
  for (int i = 0; i <= count; ++i) edges.push_back(least + (greatest - least) * i / count);
  return edges;
}

/// Cell of `value`; -1 outside.
int CellOf(const std::vector<double>& edges, double value) {
  if (!(value >= edges.front() && value <= edges.back())) return -1;
  const double part = (value - edges.front()) / (edges.back() - edges.front());
  const int cells = static_cast<int>(edges.size()) - 1;
  return std::min(cells - 1, static_cast<int>(part * cells));
}

std::vector<double> Picked(const std::vector<double>& values,
                           const std::vector<std::size_t>& rows) {
  std::vector<double> picked;
  picked.reserve(rows.size());
  for (std::size_t row : rows) picked.push_back(values[row]);
  return picked;
}

/// Mean of the residual in cells of displacement and speed; cells with less than 3 samples empty.
HeatMap MapOf(const IdentifyResults& results, const ChannelData& channel, bool after) {
  const ReadableName name = Readable(channel.name);
  const std::vector<std::size_t> rows = results.ScoredRows();
  HeatMap map{.title = "Mean residual of " + name.words + ", " +
                       (after ? AfterName(results) : BeforeName()),
              .x_label = "displacement [mm]",
              .y_label = "speed [mm/s]",
              .value_label = "residual [" + name.unit + "]"};
  map.x_edges = Edges(Scaled(Picked(results.displacement, rows), 1e3), 24);
  map.y_edges = Edges(Scaled(Picked(results.speed, rows), 1e3), 16);
  const std::vector<double> residual = ResidualOf(channel, after);
  if (map.x_edges.empty() || map.y_edges.empty() || residual.empty()) return map;
  std::vector<std::vector<int>> count(16, std::vector<int>(24, 0));
  map.values.assign(16, std::vector<double>(24, 0.0));
  for (std::size_t row : rows) {
    const int i = CellOf(map.x_edges, 1e3 * results.displacement[row]);
    const int j = CellOf(map.y_edges, 1e3 * results.speed[row]);
    if (i < 0 || j < 0 || !std::isfinite(residual[row])) continue;
    map.values[j][i] += name.factor * residual[row];
    ++count[j][i];
  }
  for (int j = 0; j < 16; ++j) {
    for (int i = 0; i < 24; ++i) {
      map.values[j][i] = count[j][i] < 3 ? kNoNumber : map.values[j][i] / count[j][i];
    }
  }
  return map;
}

double LargestIn(const HeatMap& map) {
  double largest = 0;
  for (const std::vector<double>& row : map.values) {
    for (double value : row) {
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    }
  }
  return largest;
}

/// Mean of the residual over cells of one variable.
Curve MeanOver(const IdentifyResults& results, const ChannelData& channel, bool after,
               const std::vector<double>& variable, double factor) {
  const ReadableName name = Readable(channel.name);
  Curve curve{.label = after ? AfterName(results) : BeforeName(),
              .colour = after ? kAfterColour : kBeforeColour,
              .dash = after ? 0 : 1};
  const std::vector<std::size_t> rows = results.ScoredRows();
  const std::vector<double> residual = ResidualOf(channel, after);
  const std::vector<double> edges = Edges(Scaled(Picked(variable, rows), factor), 40);
  if (edges.empty() || residual.empty()) return curve;
  std::vector<double> sum(40, 0.0);
  std::vector<int> count(40, 0);
  for (std::size_t row : rows) {
    const int i = CellOf(edges, factor * variable[row]);
    if (i < 0 || !std::isfinite(residual[row])) continue;
    sum[i] += name.factor * residual[row];
    ++count[i];
  }
  for (int i = 0; i < 40; ++i) {
    if (count[i] < 3) continue;
    curve.x.push_back(0.5 * (edges[i] + edges[i + 1]));
    curve.y.push_back(sum[i] / count[i]);
  }
  return curve;
}

void AddMeanPlot(const IdentifyResults& results, const ChannelData& channel,
                 const std::string& variable_label, const std::vector<double>& variable,
                 double factor, ReportPage* page) {
  const ReadableName name = Readable(channel.name);
  XyPlot plot{.title = "Mean residual of " + name.words + " over " + variable_label,
              .x_label = variable_label,
              .y_label = "residual [" + name.unit + "]",
              .height_px = 260};
  for (bool after : {false, true}) {
    Curve curve = MeanOver(results, channel, after, variable, factor);
    if (!curve.x.empty()) plot.curves.push_back(std::move(curve));
  }
  if (!plot.curves.empty()) page->Add(plot);
}

/// At most `most` of the rows, evenly thinned out.
std::vector<std::size_t> Thinned(const std::vector<std::size_t>& rows, std::size_t most) {
  if (rows.size() <= most) return rows;
  std::vector<std::size_t> thin;
  for (std::size_t i = 0; i < most; ++i) thin.push_back(rows[i * rows.size() / most]);
  return thin;
}

}  // namespace

void AddTimePlots(const IdentifyResults& results, ReportPage* page) {
  page->Paragraph(
      "Drag across a plot to zoom all of them, double click for the whole record, click a name to "
      "hide its curves.");
  std::vector<Curve> names = {{.label = "measured", .colour = kMeasuredColour}};
  if (results.has_before)
    names.push_back({.label = BeforeName(), .colour = kBeforeColour, .dash = 1});
  names.push_back({.label = AfterName(results), .colour = kAfterColour});
  page->SharedLegend(kGroup, names);
  page->ZoomButtons(kGroup, results.windows);
  if (!results.displacement.empty()) {
    SeriesPlot motion = TimePlot(results, "Motion that drives rig and model", "displacement [mm]");
    motion.curves = {{.label = "displacement",
                      .colour = 4,
                      .x = results.time,
                      .y = Scaled(results.displacement, 1e3)}};
    motion.height_px = 180;
    page->Add(motion);
  }
  for (const ChannelData& channel : results.channels) {
    const ReadableName name = Readable(channel.name);
    SeriesPlot plot = TimePlot(results, "Measured and predicted: " + name.words, channel.label);
    SeriesPlot residual = TimePlot(results, "Residual (measured − predicted): " + name.words,
                                   "residual [" + name.unit + "]");
    plot.curves.push_back({.label = "measured",
                           .colour = kMeasuredColour,
                           .x = results.time,
                           .y = Scaled(channel.measured, name.factor)});
    for (bool after : {false, true}) {
      const std::vector<double>& predicted = after ? channel.after : channel.before;
      if (predicted.size() != results.time.size()) continue;
      const Curve curve{.label = after ? AfterName(results) : BeforeName(),
                        .colour = after ? kAfterColour : kBeforeColour,
                        .dash = after ? 0 : 1,
                        .x = results.time,
                        .y = Scaled(predicted, name.factor)};
      plot.curves.push_back(curve);
      residual.curves.push_back(curve);
      residual.curves.back().y = Scaled(ResidualOf(channel, after), name.factor);
    }
    page->BeginGrid(2);
    page->Add(plot);
    page->Add(residual);
    page->EndGrid();
  }
}

void AddLoops(const IdentifyResults& results, ReportPage* page) {
  constexpr std::size_t kMost = 6000;
  bool any = false;
  const std::size_t scored = results.ScoredRows().size();
  if (scored > kMost) {
    page->Note(fmt::format("Loops show {} of {} rows, evenly thinned out.", kMost, scored));
  }
  page->BeginGrid(2);
  for (const ChannelData& channel : results.channels) {
    if (!channel.is_force || results.displacement.empty()) continue;
    const ReadableName name = Readable(channel.name);
    const std::vector<std::size_t> rows = Thinned(results.ScoredRows(), kMost);
    const std::vector<double> x = Scaled(Picked(results.displacement, rows), 1e3);
    for (bool after : {false, true}) {
      const std::vector<double>& predicted = after ? channel.after : channel.before;
      if (predicted.size() != results.time.size()) continue;
      const std::string model = after ? AfterName(results) : BeforeName();
      XyPlot plot{.title = name.words + " over displacement: measured and " + model,
                  .x_label = "displacement [mm]",
                  .y_label = channel.label};
      plot.curves = {{.label = "measured",
                      .colour = kMeasuredColour,
                      .x = x,
                      .y = Scaled(Picked(channel.measured, rows), name.factor)},
                     {.label = model,
                      .colour = after ? kAfterColour : kBeforeColour,
                      .x = x,
                      .y = Scaled(Picked(predicted, rows), name.factor)}};
      page->Add(plot);
      any = true;
    }
  }
  page->EndGrid();
  if (!any) page->Note("No force was measured together with a displacement.");
}

void AddResidualMaps(const IdentifyResults& results, ReportPage* page) {
  bool any = false;
  if (!results.place.empty()) {
    page->BeginGrid(2);
    for (const ChannelData& channel : results.channels) {
      AddMeanPlot(results, channel, "distance [m]", results.place, 1, page);
    }
    page->EndGrid();
    return;
  }
  for (const ChannelData& channel : results.channels) {
    if (results.displacement.empty()) break;
    HeatMap before = MapOf(results, channel, false);
    HeatMap after = MapOf(results, channel, true);
    before.full_scale = after.full_scale = std::max(LargestIn(before), LargestIn(after));
    page->BeginGrid(2);
    for (const HeatMap* map : {&before, &after}) {
      if (map->values.empty()) continue;
      page->Add(*map);
      any = true;
    }
    AddMeanPlot(results, channel, "speed [mm/s]", results.speed, 1e3, page);
    AddMeanPlot(results, channel, "displacement [mm]", results.displacement, 1e3, page);
    page->EndGrid();
  }
  page->Note(
      any ? "Maps and means cover the middle 99 % of displacement and speed; cells with fewer "
            "than 3 samples stay empty."
          : "The motion does not cover enough places and speeds for a map.");
}

}  // namespace phs::report
