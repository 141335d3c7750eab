#include "measurement/redrawn_motion.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace phs::measurement {

const std::vector<std::vector<SmoothMotion>>& RedrawnMotion::Draws() {
  std::call_once(drawn_, [this] {
    std::mt19937 generator(20260101);
    std::normal_distribution<double> normal;
    std::vector<std::vector<SmoothMotion>> draws;
    for (int k = 0; k < kDraws; ++k) {
      std::vector<SmoothMotion> motions;
      for (size_t a = 0; a < data_.motion.size(); ++a) {
        const double noise = data_.inputs[a].noise;
        std::vector<double> samples = data_.motion[a].position;
        for (double& x : samples) x += noise * normal(generator);
        SmoothMotion drawn =
            noise > 0 ? SmoothPosition(samples, {}, data_.step_s, noise) : data_.motion[a];
        motions.push_back({std::move(drawn.position), std::move(drawn.speed), {}, {}, {}});
      }
      draws.push_back(std::move(motions));
    }
    draws_ = std::move(draws);
  });
  return draws_;
}

std::vector<double> DeviationOfDraws(const std::vector<std::vector<double>>& with,
                                     const std::vector<double>& without, double step_s,
                                     double reach_s) {
  const size_t n = without.size();
  std::vector<double> sum(n + 1, 0.0);  // of squares, of all samples before
  for (size_t i = 0; i < n; ++i) {
    double square = 0;
    for (const auto& draw : with) square += std::pow(draw[i] - without[i], 2);
    sum[i + 1] = sum[i] + square / static_cast<double>(with.size());
  }
  const auto reach = static_cast<size_t>(std::max(1.0, std::round(reach_s / step_s)));
  std::vector<double> out(n);
  for (size_t i = 0; i < n; ++i) {
    const size_t from = i - std::min(i, reach), to = std::min(n, i + reach + 1);
    out[i] = std::sqrt(std::max(0.0, sum[to] - sum[from]) / static_cast<double>(to - from));
  }
  return out;
}

}  // namespace phs::measurement
