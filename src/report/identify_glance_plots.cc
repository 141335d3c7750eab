// The two pictures of the first screen.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/identify_glance.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

/// First and one past the last of the rows to show: a tenth of the scored ones, where the squares
/// of the declared model's error (of the corrected one where there is no other) sum up to most.
std::pair<size_t, size_t> WorstStretch(const IdentifyResults& results, const ChannelData& channel) {
  constexpr size_t kLeast = 100, kPart = 10;
  const std::vector<size_t> rows = results.ScoredRows();
  if (rows.empty()) return {0, 0};
  const std::vector<double> error = ResidualOf(channel, channel.before.empty());
  const size_t length = std::min(rows.size(), std::max(kLeast, rows.size() / kPart));
  if (error.empty()) return {rows.front(), rows.front() + length};
  const auto square = [&](size_t i) {
    const double e = error[rows[i]];
    return std::isfinite(e) ? e * e : 0.0;
  };
  double sum = 0;
  for (size_t i = 0; i < length; ++i) sum += square(i);
  double most = sum;
  size_t begin = 0;
  for (size_t i = length; i < rows.size(); ++i) {
    sum += square(i) - square(i - length);
    if (sum > most) most = sum, begin = i - length + 1;
  }
  return {rows[begin], rows[begin + length - 1] + 1};
}

std::vector<double> Part(const std::vector<double>& values, std::pair<size_t, size_t> rows,
                         double factor) {
  std::vector<double> part;
  for (size_t i = rows.first; i < rows.second && i < values.size(); ++i) {
    part.push_back(factor * values[i]);
  }
  return part;
}

struct Model {
  const char* label;
  int colour;
  int dash;
};

/// Predicted over measured: on the diagonal they agree.
void AddStepsPicture(const StepsData& steps, ReportPage* page) {
  XyPlot plot{.title =
                  "Settled pressures of the steps: predicted by fits without the step, over "
                  "measured",
              .x_label = "measured, gauge [MPa]",
              .y_label = "predicted, gauge [MPa]",
              .height_px = 260};
  const auto [least, most] =
      std::minmax_element(steps.measured_MPa.begin(), steps.measured_MPa.end());
  plot.curves.push_back({.label = "as measured",
                         .colour = kMeasuredColour,
                         .x = {*least, *most},
                         .y = {*least, *most}});
  const auto add = [&](const std::vector<double>& y, const Model& model) {
    if (y.size() != steps.measured_MPa.size()) return;
    plot.curves.push_back({.label = model.label,
                           .colour = model.colour,
                           .x = steps.measured_MPa,
                           .y = y,
                           .points = true});
  };
  add(steps.before_MPa, {"declared, fitted", kBeforeColour, 0});
  add(steps.after_MPa, {"corrected", kAfterColour, 0});
  page->Add(plot);
}

}  // namespace

void AddWherePicture(const IdentifyResults& results, ReportPage* page) {
  if (!results.steps.measured_MPa.empty()) return AddStepsPicture(results.steps, page);
  const std::string lead = LeadingChannel(results);
  const auto found = std::find_if(results.channels.begin(), results.channels.end(),
                                  [&](const ChannelData& c) { return c.name == lead; });
  if (found == results.channels.end()) return;
  const ChannelData& channel = *found;
  const auto rows = WorstStretch(results, channel);
  if (rows.second <= rows.first) return;
  // Where the models differ by less than a line is wide, what they leave is drawn instead.
  const double error = NumberAt(results.all, "/channels/" + lead + "/before/nrmse");
  const bool rest = std::isfinite(error) && error < 0.1 && !channel.before.empty();
  const std::string where = fmt::format("where the {} model errs most: {} to {} s of {} s",
                                        channel.before.empty() ? "corrected" : "declared",
                                        FormatNumber(results.time[rows.first]),
                                        FormatNumber(results.time[rows.second - 1]),
                                        FormatNumber(results.time.back() - results.time.front()));
  SeriesPlot plot{
      .title =
          (rest ? "What each model leaves of the " : "The ") + Readable(lead).words + ", " + where,
      .x_label = "time [s]",
      .y_label = rest ? "measured − predicted [" + Readable(lead).unit + "]" : channel.label,
      .group = "glance",
      .max_points = 2000,
      .height_px = 260};
  const auto add = [&](const std::vector<double>& values, const Model& model) {
    if (values.size() != results.time.size()) return;
    plot.curves.push_back({.label = model.label,
                           .colour = model.colour,
                           .dash = model.dash,
                           .x = Part(results.time, rows, 1),
                           .y = Part(values, rows, channel.factor)});
  };
  if (!rest) add(channel.measured, {"measured", kMeasuredColour, 0});
  add(rest ? ResidualOf(channel, false) : channel.before, {"declared, fitted", kBeforeColour, 0});
  add(rest ? ResidualOf(channel, true) : channel.after, {"corrected", kAfterColour, 0});
  page->Add(plot);
}

void AddChangePicture(const IdentifyResults& results, ReportPage* page) {
  constexpr size_t kMost = 8;
  const bool steps = results.all.value("rig", "") == "steps";
  const char* key = steps ? "m_re_percent" : "nrmse";
  struct Row {
    std::string channel;
    double before, after;
    /// One that holds nothing but noise has 100 % before and after: the error alone says little.
    double Change() const {
      return std::isfinite(before) && std::isfinite(after) ? std::abs(before - after) : 0;
    }
  };
  std::vector<Row> rows;
  const json channels = results.all.value("channels", json::object());
  for (const auto& [name, scores] : channels.items()) {
    const double factor = steps ? 1 : 100;
    const Row row{name, factor * NumberAt(scores, std::string("/before/") + key),
                  factor * NumberAt(scores, std::string("/after/") + key)};
    if (std::isfinite(row.before) || std::isfinite(row.after)) rows.push_back(row);
  }
  const size_t all = rows.size();
  if (all == 0) return;
  if (all > kMost) {
    std::stable_sort(rows.begin(), rows.end(),
                     [](const Row& a, const Row& b) { return a.Change() > b.Change(); });
    rows.resize(kMost);
  }
  BarChart chart{.title = steps ? "Mean relative error, each step left out of its fit"
                                : "Error on the validation window, of the standard deviation",
                 .unit = "%"};
  if (all > kMost) {
    chart.title += fmt::format(" ({} of {} channels, most changed first; the others under Errors)",
                               kMost, all);
  }
  chart.bars = {{.label = "declared, fitted", .colour = kBeforeColour},
                {.label = "corrected", .colour = kAfterColour}};
  for (const Row& row : rows) {
    chart.categories.push_back(Readable(row.channel).words);
    chart.bars[0].values.push_back(row.before);
    chart.bars[1].values.push_back(row.after);
  }
  page->Add(chart);
}

}  // namespace phs::report
