// A residual taken apart into octaves of frequency, each with its place in time.
//
// Orthonormal wavelets (Daubechies 1988, Comm. Pure Appl. Math. 41, 909: eight taps, four vanishing
// moments): the first band holds what lies between a quarter and half of the sampling rate, each
// next one the octave below, the last what is slower than all. White noise of variance 1 gives
// coefficients of variance 1 in every band, so the mean square of a band is the power of the
// residual there over that of its noise. A coloured residual has coefficients that are nearly
// independent though its samples are not (Wornell 1993, Proc. IEEE 81, 1428): this is what makes a
// likelihood of coloured residuals as simple as one of white ones (likelihood.h).
//
// Mean and slope are taken off first and stand in the last band, so that the record may be closed to
// a ring without a jump: the transform stays orthonormal up to its ends. (A mirrored end doubles
// samples, and every octave doubles them again.)
#pragma once

#include <Eigen/Core>
#include <vector>

namespace phs::identify {

/// Where the coefficients of one residual of `samples` stand.
class OctaveBands {
 public:
  /// `samples` >= 1. No band is made of fewer than sixteen samples.
  explicit OctaveBands(int samples);

  int samples() const { return samples_; }
  /// Coefficients in all (a few more than samples: each octave is rounded up).
  int size() const { return begin_.back(); }
  int num_bands() const { return static_cast<int>(begin_.size()) - 1; }
  int begin(int band) const { return begin_[static_cast<size_t>(band)]; }
  int end(int band) const { return begin_[static_cast<size_t>(band) + 1]; }
  /// Where in the record a coefficient lies: 0 … 1.
  double Place(int band, int coefficient) const {
    return (coefficient - begin(band) + 0.5) / (end(band) - begin(band));
  }
  /// Samples -> coefficients.
  Eigen::VectorXd Transform(const Eigen::Ref<const Eigen::VectorXd>& y) const;

 private:
  int samples_;
  std::vector<int> begin_;  ///< of each band, and one more
};

}  // namespace phs::identify
