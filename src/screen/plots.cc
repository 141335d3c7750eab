#include "screen/plots.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "view/pose.h"

namespace phs::screen {
namespace {

constexpr int kSpans = 180;  ///< of a curve, its least and greatest value each
constexpr int kMaxCurves = 6;
constexpr float kColours[kMaxCurves][3] = {{0.12f, 0.35f, 0.80f}, {0.90f, 0.40f, 0.05f},
                                           {0.10f, 0.60f, 0.25f}, {0.75f, 0.10f, 0.20f},
                                           {0.50f, 0.25f, 0.70f}, {0.35f, 0.35f, 0.35f}};

template <size_t N>
void Copy(const std::string& text, char (&to)[N]) {
  std::snprintf(to, N, "%s", text.c_str());
}

/// Least and greatest value of each span of rows, in their order, so that no peak is lost.
int FillLine(const std::vector<double>& time, const std::vector<double>& values, double scale,
             float* line) {
  const size_t spans = std::min<size_t>(kSpans, values.size());
  int count = 0;
  for (size_t i = 0; i < spans; ++i) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(i * values.size() / spans);
    const auto end = values.begin() + static_cast<std::ptrdiff_t>((i + 1) * values.size() / spans);
    const auto [least, most] = std::minmax_element(begin, end);
    for (const auto at : {std::min(least, most), std::max(least, most)}) {
      line[2 * count] = static_cast<float>(time[static_cast<size_t>(at - values.begin())]);
      line[2 * count + 1] = static_cast<float>(scale * *at);
      ++count;
    }
  }
  return count;
}

/// Four steps of 1, 2 or 5 times a power of ten that hold both.
void SetRange(double low, double high, float* range) {
  const double span = std::max(high - low, 1e-9);
  for (double power = std::pow(10, std::floor(std::log10(span / 4)));; power *= 10) {
    for (const double step : {power, 2 * power, 2.5 * power, 5 * power}) {
      const double begin = step * std::floor(low / step + 1e-9);
      if (begin + 4 * step < high * (1 - 1e-9)) continue;
      range[0] = static_cast<float>(begin);
      range[1] = static_cast<float>(begin + 4 * step);
      return;
    }
  }
}

}  // namespace

void Plots::Add(const view::Recording& recording, const char* title, double scale,
                const std::vector<Curve>& curves) {
  auto figure = std::make_unique<mjvFigure>();
  mjv_defaultFigure(figure.get());
  Copy(title, figure->title);
  Copy("%.0f", figure->xformat);
  Copy("%.3g", figure->yformat);
  figure->flg_legend = 0;
  figure->gridsize[0] = figure->gridsize[1] = 5;
  figure->linewidth = 2;
  const float pane[4] = {1, 1, 1, 0.92f};
  const float around[4] = {0.95f, 0.96f, 0.97f, 0.92f};
  std::copy_n(pane, 4, figure->panergba);
  std::copy_n(around, 4, figure->figurergba);
  for (float& c : figure->textrgb) c = 0.1f;
  for (float& c : figure->gridrgb) c = 0.80f;
  int line = 0;
  double low = 0;
  double high = 0;
  const auto& time = recording.columns[static_cast<size_t>(recording.time_column)];
  for (const Curve& curve : curves) {
    const int column = recording.Find(curve.channel);
    if (column < 0 || line >= kMaxCurves) continue;
    const auto& values = recording.columns[static_cast<size_t>(column)];
    figure->linepnt[line] = FillLine(time, values, scale, figure->linedata[line]);
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    low = std::min(low, scale * *least);
    high = std::max(high, scale * *most);
    std::copy_n(kColours[line], 3, figure->linergb[line]);
    Copy(curve.name, figure->linename[line]);
    ++line;
  }
  if (line == 0) return;
  SetRange(low, high, figure->range[1]);
  figure->range[0][0] = static_cast<float>(time.front());
  figure->range[0][1] = static_cast<float>(time.back());
  figures_.push_back(std::move(figure));
}

Plots::Plots(const view::Stage& stage) {
  const view::Recording& recording = stage.recording();
  const plugin::Binding& binding = stage.picture().model->binding();
  std::vector<Curve> attack, guiding, lines, forces;
  const std::string outer = stage.outer() == rail::Side::kLeft ? "_left_" : "_right_";
  for (const plugin::WheelsetBinding& w : binding.wheelsets()) {
    attack.push_back({w.name + "_angle_of_attack_rad", w.name});
    guiding.push_back({w.name + outer + "Y_N", w.name + " outer"});
  }
  for (size_t p = 0; p < binding.phs().size(); ++p) {
    for (const std::string& name : binding.phs()[p].system->line_names()) {
      lines.push_back({view::PhsChannel(binding, p, "line_" + name + "_pressure_Pa"), name});
    }
    for (const std::string& name : binding.phs()[p].system->cylinder_names()) {
      forces.push_back({view::PhsChannel(binding, p, "cylinder_" + name + "_force_N"), name});
    }
  }
  Add(recording, "angle of attack [mrad]", 1e3, attack);
  Add(recording, "guiding force Y [kN]", 1e-3, guiding);
  Add(recording, "line pressure [MPa]", 1e-6, lines);
  Add(recording, "cylinder force [kN]", 1e-3, forces);
}

void Plots::Draw(double time, const mjrRect& viewport, const mjrContext& context) {
  const int count = static_cast<int>(figures_.size());
  for (int i = 0; i < count; ++i) {
    const int height = viewport.height / std::max(3, count);
    const mjrRect place{viewport.left, viewport.bottom + viewport.height - (i + 1) * height,
                        viewport.width, height};
    mjvFigure* figure = figures_[static_cast<size_t>(i)].get();
    mjr_figure(place, figure, &context);
    // Output of the engine: where the axes lie in the figure.
    const double share =
        (time - figure->xaxisdata[0]) / (figure->xaxisdata[1] - figure->xaxisdata[0]);
    const int x = figure->xaxispixel[0] +
                  static_cast<int>(share * (figure->xaxispixel[1] - figure->xaxispixel[0]));
    const int y = std::min(figure->yaxispixel[0], figure->yaxispixel[1]);
    const int tall = std::abs(figure->yaxispixel[1] - figure->yaxispixel[0]);
    mjr_rectangle({place.left + x, place.bottom + y, 2, tall}, 0.1f, 0.1f, 0.1f, 0.8f);
    int right = place.left + place.width - 8;
    for (int line = kMaxCurves - 1; line >= 0; --line) {
      if (figure->linepnt[line] == 0) continue;
      const std::string name = figure->linename[line];
      int width = 10;
      for (const char c : name) width += context.charWidth[static_cast<unsigned char>(c) % 127];
      right -= width;
      const float* c = kColours[line];
      mjr_label({right, place.bottom + 1, width, context.charHeight + 2}, mjFONT_NORMAL,
                name.c_str(), 0, 0, 0, 0, c[0], c[1], c[2], &context);
    }
  }
}

}  // namespace phs::screen
