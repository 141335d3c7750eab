#include "report/moving_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "report/report_page.h"

namespace phs::report {
namespace {

using SceneJson = nlohmann::json;

SceneJson Parts(std::complex<double> z) { return {z.real(), z.imag()}; }

SceneJson PointJson(const MovingPoint& p) {
  return {{"x", p.x}, {"y", p.y}, {"dx", Parts(p.dx)}, {"dy", Parts(p.dy)}};
}

/// Largest way from rest over a period: the long semi-axis of the point's ellipse.
double Reach(const MovingPoint& p) {
  const double square = std::norm(p.dx) + std::norm(p.dy);
  return std::sqrt((square + std::abs(p.dx * p.dx + p.dy * p.dy)) / 2);
}

}  // namespace

MovingPoint PointOfBody(double x, double along, double left, std::complex<double> dx,
                        std::complex<double> dy, std::complex<double> yaw) {
  return {x + along, left, dx - yaw * left, dy + yaw * along};
}

void Enlarge(double drawn, std::vector<MovingLine>* lines) {
  double reach = 0;
  for (const MovingLine& line : *lines) reach = std::max({reach, Reach(line.from), Reach(line.to)});
  if (!(reach > 0)) return;
  for (MovingLine& line : *lines) {
    for (MovingPoint* point : {&line.from, &line.to}) {
      point->dx *= drawn / reach;
      point->dy *= drawn / reach;
    }
  }
}

double PlayedPeriod(double frequency_Hz) {
  constexpr double kSeconds = 4;
  return frequency_Hz > 0 ? std::max(kSeconds, 1 / frequency_Hz) : kSeconds;
}

std::string PlayedWords(double frequency_Hz) {
  const double seconds = PlayedPeriod(frequency_Hz);
  if (!(frequency_Hz > 0)) return fmt::format("Played with one period in {:.0f} s.", seconds);
  const double slower = seconds * frequency_Hz;
  if (slower < 1.005) return "Played as fast as it is.";
  return fmt::format("Played {:.3g} times slower than it is: one period in {:.0f} s, not {:.3g} s.",
                     slower, seconds, 1 / frequency_Hz);
}

std::string GrowthWords(double growth_1_s, double frequency_Hz) {
  if (!(frequency_Hz > 0) || !std::isfinite(growth_1_s)) return "";
  const double left = std::exp(growth_1_s / frequency_Hz);
  if (std::abs(left - 1) < 5e-3) return "It neither grows nor dies out.";
  return fmt::format("Each period leaves {:.3g} times its size; the picture keeps its size.", left);
}

void AddMovingShape(const MovingShape& shape, ReportPage* page) {
  SceneJson spec = {{"keys", SceneJson::array()},
                    {"lines", SceneJson::array()},
                    {"traces_deg", shape.traces_deg},
                    {"period_s", shape.period_s}};
  for (const MovingShape::Key& key : shape.keys) {
    spec["keys"].push_back({{"label", key.label}, {"colour", key.colour}, {"dash", key.dash}});
  }
  for (const MovingLine& line : shape.lines) {
    spec["lines"].push_back({{"name", line.name},
                             {"key", line.key},
                             {"width", line.width_px},
                             {"trace", line.trace},
                             {"stroke", line.stroke ? Parts(*line.stroke) : SceneJson()},
                             {"from", PointJson(line.from)},
                             {"to", PointJson(line.to)}});
  }
  page->AddFigure("shape", shape.title,
                  spec.dump(-1, ' ', false, SceneJson::error_handler_t::replace));
}

}  // namespace phs::report
