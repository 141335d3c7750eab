#include "measurement/band_limit.h"

#include <algorithm>
#include <cmath>

namespace phs::measurement {
namespace {

constexpr int kOrder = 8;
constexpr double kRipple_dB = 0.05;

}  // namespace

BandLimit::BandLimit(double step_s, double band_Hz) {
  const double nyquist = 0.5 / step_s;
  if (!(band_Hz > 0) || band_Hz >= 0.8 * nyquist) return;
  stride_ = std::max(1, static_cast<int>(0.8 * nyquist / band_Hz + 1e-9));
  spread_ = static_cast<int>(std::ceil(0.5 / (band_Hz * step_s)));
  // Poles of the analogue prototype, then the bilinear transform with s = (1 - 1/z)/(1 + 1/z) / w.
  const double w = std::tan(M_PI * band_Hz * step_s);
  const double e = std::sqrt(std::pow(10.0, kRipple_dB / 10) - 1);
  const double a = std::asinh(1 / e) / kOrder;
  double gain = 1 / std::sqrt(1 + e * e);  // of an even order at zero frequency
  for (int k = 0; k < kOrder / 2; ++k) {
    const double angle = M_PI * (2 * k + 1) / (2 * kOrder);
    const double real = -std::sinh(a) * std::sin(angle), imag = std::cosh(a) * std::cos(angle);
    const double q0 = (real * real + imag * imag) * w * w, q1 = -2 * real * w;
    const double norm = 1 / (1 + q1 + q0);
    sections_.push_back({gain * q0 * norm, 2 * gain * q0 * norm, gain * q0 * norm,
                         2 * (q0 - 1) * norm, (1 - q1 + q0) * norm});
    gain = 1;
  }
}

void BandLimit::RunOnce(std::vector<double>* y) const {
  for (const Section& s : sections_) {
    // Started as if the first value had always been there.
    const double rest = (*y)[0], out = rest * (s.b0 + s.b1 + s.b2) / (1 + s.a1 + s.a2);
    double x1 = rest, x2 = rest, y1 = out, y2 = out;
    for (double& value : *y) {
      const double now = s.b0 * value + s.b1 * x1 + s.b2 * x2 - s.a1 * y1 - s.a2 * y2;
      x2 = x1, x1 = value, y2 = y1, y1 = now;
      value = now;
    }
  }
}

std::vector<double> BandLimit::Filter(const std::vector<double>& y) const {
  const size_t n = y.size();
  if (sections_.empty() || n < 2) return y;
  const size_t pad = std::min(n - 1, static_cast<size_t>(12 * spread_));
  std::vector<double> padded;
  padded.reserve(n + 2 * pad);
  for (size_t i = pad; i > 0; --i) padded.push_back(2 * y[0] - y[i]);
  padded.insert(padded.end(), y.begin(), y.end());
  for (size_t i = 1; i <= pad; ++i) padded.push_back(2 * y[n - 1] - y[n - 1 - i]);
  for (int pass = 0; pass < 2; ++pass) {
    RunOnce(&padded);
    std::reverse(padded.begin(), padded.end());
  }
  return {padded.begin() + static_cast<long>(pad), padded.begin() + static_cast<long>(pad + n)};
}

std::vector<double> BandLimit::Apply(const std::vector<double>& y) const {
  std::vector<double> filtered = Filter(y);
  if (stride_ == 1) return filtered;
  std::vector<double> out;
  for (size_t i = 0; i < y.size(); i += static_cast<size_t>(stride_)) out.push_back(filtered[i]);
  return out;
}

}  // namespace phs::measurement
