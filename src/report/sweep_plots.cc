#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "report/readable_name.h"
#include "report/sweep_parts.h"

namespace phs::report::sweep_page {
namespace {

constexpr int kMostCurves = 8;

/// What tells one curve from another: texts and all parameters but the first.
std::string CurveName(const Sweep& sweep, int row) {
  std::string name = TextsOf(sweep, row);
  for (std::size_t i = 1; i < sweep.parameters.size(); ++i) {
    const int column = sweep.parameters[i];
    const ReadableName words = Readable(sweep.table.names[column]);
    name += fmt::format("{}{} {} {}", name.empty() ? "" : ", ", words.words,
                        FormatNumber(Value(sweep.table, column, row)), words.unit);
  }
  return name.empty() ? "all runs" : name;
}

/// Edges of cells around sorted values: midway between neighbours.
std::vector<double> EdgesAround(const std::set<double>& values) {
  const std::vector<double> v(values.begin(), values.end());
  std::vector<double> edges = {v[0] - (v[1] - v[0]) / 2};
  for (std::size_t i = 1; i < v.size(); ++i) edges.push_back((v[i - 1] + v[i]) / 2);
  edges.push_back(v.back() + (v.back() - v[v.size() - 2]) / 2);
  return edges;
}

/// Ranks 0 … n - 1 of the values; equal ones share their mean rank.
std::vector<double> Ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i;
    while (end < order.size() && values[order[end]] == values[order[i]]) ++end;
    const double shared = 0.5 * static_cast<double>(i + end - 1);
    for (; i < end; ++i) ranks[order[i]] = shared;
  }
  return ranks;
}

}  // namespace

std::string Label(const Table& table, int column) {
  const ReadableName name = Readable(table.names[column]);
  return name.words + " [" + name.unit + "]";
}

double Value(const Table& table, int column, int row) {
  return Readable(table.names[column]).factor * table.columns[column][row];
}

std::string TextsOf(const Sweep& sweep, int row) {
  std::string name;
  for (int column : sweep.texts) {
    name += (name.empty() ? "" : ", ") + sweep.table.text[column][row];
  }
  return name;
}

void AddCurves(const Sweep& sweep, int output, ReportPage* page) {
  std::map<std::string, std::vector<std::pair<double, double>>> curves;
  for (int row : sweep.good) {
    curves[CurveName(sweep, row)].emplace_back(Value(sweep.table, sweep.parameters[0], row),
                                               Value(sweep.table, output, row));
  }
  const std::string title = Readable(sweep.table.names[output]).words;
  XyPlot plot{.title = title,
              .x_label = Label(sweep.table, sweep.parameters[0]),
              .y_label = Label(sweep.table, output),
              .height_px = 300};
  for (auto& [name, points] : curves) {
    const int number = static_cast<int>(plot.curves.size());
    if (number == kMostCurves) {
      plot.title += fmt::format(" (the first {} of {} series)", kMostCurves, curves.size());
      break;
    }
    std::sort(points.begin(), points.end());
    Curve curve{.label = name, .colour = number, .dash = number % 4};
    for (const auto& [x, y] : points) {
      curve.x.push_back(x);
      curve.y.push_back(y);
    }
    plot.curves.push_back(std::move(curve));
  }
  if (!plot.curves.empty()) page->Add(plot);
}

/// One map per text combination, for sweeps of two parameters with at least three values each.
void AddMaps(const Sweep& sweep, int output, ReportPage* page) {
  if (sweep.parameters.size() != 2) return;
  std::set<double> xs;
  std::set<double> ys;
  std::map<std::string, std::map<std::pair<double, double>, double>> maps;
  for (int row : sweep.good) {
    const double x = Value(sweep.table, sweep.parameters[0], row);
    const double y = Value(sweep.table, sweep.parameters[1], row);
    xs.insert(x);
    ys.insert(y);
    maps[TextsOf(sweep, row)][{x, y}] = Value(sweep.table, output, row);
  }
  if (xs.size() < 3 || ys.size() < 3) return;
  for (const auto& [name, cells] : maps) {
    HeatMap map{
        .title = Readable(sweep.table.names[output]).words + (name.empty() ? "" : ", ") + name,
        .x_label = Label(sweep.table, sweep.parameters[0]),
        .y_label = Label(sweep.table, sweep.parameters[1]),
        .value_label = Label(sweep.table, output),
        .x_edges = EdgesAround(xs),
        .y_edges = EdgesAround(ys),
        .diverging = false};
    for (double y : ys) {
      std::vector<double> row;
      for (double x : xs) {
        const auto found = cells.find({x, y});
        row.push_back(found == cells.end() ? std::numeric_limits<double>::quiet_NaN()
                                           : found->second);
      }
      map.values.push_back(std::move(row));
    }
    page->Add(map);
  }
}

double RankCorrelation(const Sweep& sweep, int a, int b) {
  std::vector<double> x, y;
  for (int row : sweep.good) {
    const double u = sweep.table.columns[a][row], v = sweep.table.columns[b][row];
    if (!std::isfinite(u) || !std::isfinite(v)) continue;
    x.push_back(u);
    y.push_back(v);
  }
  x = Ranks(x);
  y = Ranks(y);
  const double mean = 0.5 * (static_cast<double>(x.size()) - 1);
  double xy = 0, xx = 0, yy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - mean) * (y[i] - mean);
    xx += (x[i] - mean) * (x[i] - mean);
    yy += (y[i] - mean) * (y[i] - mean);
  }
  return xx > 0 && yy > 0 ? xy / std::sqrt(xx * yy) : 0;
}

void AddScatter(const Sweep& sweep, int output, ReportPage* page) {
  int most = sweep.parameters[0];
  for (int parameter : sweep.parameters) {
    if (std::abs(RankCorrelation(sweep, parameter, output)) >
        std::abs(RankCorrelation(sweep, most, output))) {
      most = parameter;
    }
  }
  std::map<std::string, Curve> clouds;
  for (int row : sweep.good) {
    Curve& cloud = clouds[TextsOf(sweep, row)];
    cloud.x.push_back(Value(sweep.table, most, row));
    cloud.y.push_back(Value(sweep.table, output, row));
  }
  XyPlot plot{.title = Readable(sweep.table.names[output]).words,
              .x_label = Label(sweep.table, most),
              .y_label = Label(sweep.table, output),
              .height_px = 300};
  for (auto& [name, cloud] : clouds) {
    if (static_cast<int>(plot.curves.size()) == kMostCurves) {
      plot.title += fmt::format(" (the first {} of {} series)", kMostCurves, clouds.size());
      break;
    }
    cloud.label = name.empty() ? "all runs" : name;
    cloud.colour = static_cast<int>(plot.curves.size());
    cloud.points = true;
    plot.curves.push_back(std::move(cloud));
  }
  if (!plot.curves.empty()) page->Add(plot);
}

}  // namespace phs::report::sweep_page
