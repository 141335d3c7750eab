#include "identify/discrepancy/residual_map.h"

#include <algorithm>
#include <cmath>

#include "measurement/series.h"

namespace phs::identify::search {

using measurement::Autocorrelation;
using measurement::CorrelationTime;
using measurement::FitData;
using measurement::MeasuredChannel;
using measurement::SmoothMotion;
namespace {

constexpr int kBins = 16;

/// eta² of `r` over equally filled bins of `u`, less what chance gives.
double Share(const std::vector<double>& r, const std::vector<double>& u, double independent) {
  std::vector<double> edges = u;
  std::sort(edges.begin(), edges.end());
  if (!(edges.front() < edges.back())) return 0;
  double sum[kBins] = {}, count[kBins] = {};
  double mean = 0, square = 0;
  const double n = static_cast<double>(r.size());
  for (size_t i = 0; i < r.size(); ++i) {
    const auto rank = std::lower_bound(edges.begin(), edges.end(), u[i]) - edges.begin();
    const int bin = std::min<int>(kBins - 1, static_cast<int>(double(rank) * kBins / n));
    sum[bin] += r[i], ++count[bin];
    mean += r[i] / n, square += r[i] * r[i] / n;
  }
  double between = 0;
  for (int b = 0; b < kBins; ++b) {
    if (count[b] > 0) between += count[b] / n * std::pow(sum[b] / count[b] - mean, 2);
  }
  const double variance = square - mean * mean;
  if (!(variance > 0)) return 0;
  return std::max(0.0, between / variance - (kBins - 1) / std::max(double(kBins), independent));
}

}  // namespace

std::vector<Dependence> MapResidual(const FitData& data, const std::vector<double>& residual,
                                    const std::array<double, 2>& window) {
  std::vector<size_t> rows;
  std::vector<double> r;
  for (size_t i = 0; i < residual.size(); ++i) {
    if (data.time_s[i] < window[0] || data.time_s[i] >= window[1]) continue;
    if (!std::isfinite(residual[i])) continue;
    rows.push_back(i), r.push_back(residual[i]);
  }
  std::vector<Dependence> out;
  if (r.size() < 100) return out;
  const double independent = static_cast<double>(r.size()) / CorrelationTime(r);
  auto add = [&](const std::string& name, auto value) {
    std::vector<double> u;
    u.reserve(rows.size());
    for (size_t i : rows) u.push_back(value(i));
    if (std::all_of(u.begin(), u.end(), [](double x) { return std::isfinite(x); })) {
      out.push_back({name, Share(r, u, independent)});
    }
  };
  const SmoothMotion& motion = data.motion.front();
  std::vector<double> since(residual.size(), 0.0);  // travel since the last reversal, signed
  for (size_t i = 1; i < since.size(); ++i) {
    const double v = motion.speed[i], step = motion.position[i] - motion.position[i - 1];
    const bool turned = since[i - 1] * v < 0 && std::abs(v) > 3 * motion.speed_deviation[i];
    since[i] =
        turned ? step : since[i - 1] + (std::abs(v) > 3 * motion.speed_deviation[i] ? step : 0);
  }
  add(data.inputs.front().name, [&](size_t i) { return motion.position[i]; });
  add("speed_m_s", [&](size_t i) { return motion.speed[i]; });
  add("reversal", [&](size_t i) { return since[i]; });
  add("acceleration_m_s2", [&](size_t i) { return motion.acceleration[i]; });
  add("t_s", [&](size_t i) { return data.time_s[i]; });
  for (const MeasuredChannel& c : data.outputs) {
    if (c.name.ends_with("_Pa")) add(c.name, [&](size_t i) { return c.values[i]; });
  }
  std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.share > b.share; });
  return out;
}

double WhitenessP(const std::vector<double>& residual) {
  constexpr int kLags = 20;
  const double n = static_cast<double>(residual.size());
  if (n < 3 * kLags) return 1;
  const std::vector<double> rho = Autocorrelation(residual, kLags);
  double q = 0;
  for (int k = 1; k <= kLags; ++k)
    q += rho[static_cast<size_t>(k)] * rho[static_cast<size_t>(k)] / (n - k);
  q *= n * (n + 2);
  const double s = 2.0 / (9 * kLags);
  return 0.5 * std::erfc((std::cbrt(q / kLags) - (1 - s)) / std::sqrt(2 * s));
}

}  // namespace phs::identify::search
