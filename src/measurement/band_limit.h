// What two signals have in common below a frequency: both pass the same filter, without lag, and
// are taken at a lower rate. So a model that runs at the full rate is compared with a measurement
// only where the measurement is believed ("parallel filtering and decimation" of robot
// identification, Gautier 1997).
//
// Chebyshev low-pass of the first kind, eighth order, 0.05 dB ripple, run forwards and backwards
// (phase zero, ripple 0.1 dB), odd continuation at the ends; then every r-th sample,
// r = floor(0.8 Nyquist / band), at least 1.
#pragma once

#include <vector>

namespace phs::measurement {

class BandLimit {
 public:
  /// `band_Hz` = 0 or above 0.8 of the Nyquist frequency: everything passes.
  BandLimit(double step_s, double band_Hz);
  /// Samples kept of a series of n: 0, r, 2 r, …
  int stride() const { return stride_; }
  bool passes_all() const { return sections_.empty(); }
  /// Filtered at the full rate.
  std::vector<double> Filter(const std::vector<double>& y) const;
  /// Filtered and thinned.
  std::vector<double> Apply(const std::vector<double>& y) const;
  /// Samples over which a bad sample spreads, to each side.
  int spread() const { return spread_; }

 private:
  struct Section {
    double b0, b1, b2, a1, a2;
  };
  void RunOnce(std::vector<double>* y) const;

  std::vector<Section> sections_;
  int stride_ = 1, spread_ = 0;
};

}  // namespace phs::measurement
