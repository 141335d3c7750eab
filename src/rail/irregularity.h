// Irregularities of a track: deviations of both rails from their designed place.
//
// Four channels over arc length s, as track recording cars give them:
//
//   alignment   mean lateral deviation of both rails, > 0 to the left            [m]
//   level       mean vertical deviation of both rails, > 0 upwards               [m]
//   cross level right rail above left rail (the sense of cant > 0)               [m]
//   gauge       widening, > 0 wider than nominal                                 [m]
//
//   y_left = alignment + gauge/2      z_left  = level - cross_level/2
//   y_right = alignment - gauge/2     z_right = level + cross_level/2
//
// Between the samples each channel is a cubic spline, continuous to its second derivative. At both
// ends of the range the samples are multiplied with the smooth step 6t^5 - 15t^4 + 10t^3 over the
// fade length, so a run enters and leaves without a kick; outside the range all channels are zero.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "rail/frames.h"
#include "rail/track_frame.h"

namespace phs::rail {

enum IrregularityChannel { kAlignment = 0, kLevel = 1, kCrossLevel = 2, kGauge = 3 };
inline constexpr int kNumIrregularityChannels = 4;

/// Samples of the four channels at increasing arc lengths.
struct IrregularitySamples {
  std::vector<double> s;                                              ///< strictly increasing [m]
  std::array<std::vector<double>, kNumIrregularityChannels> channel;  ///< [m]

  /// Swaps left and right: alignment and cross level change sign.
  void Mirror();
};

/// Reads columns s_m, alignment_m, level_m, cross_level_m, gauge_m; a missing channel is zero, s_m
/// must be there. Errors name file and line.
Result<IrregularitySamples> ReadIrregularity(const std::string& path);

/// Immutable; queries are const, allocation-free and thread-safe.
class Irregularity {
 public:
  /// No irregularity: all zero.
  Irregularity() = default;
  /// @pre samples.s strictly increasing with at least four samples; fade >= 0 [m].
  Irregularity(const IrregularitySamples& samples, double fade);

  bool empty() const { return knots_.empty(); }
  double begin_s() const { return empty() ? 0 : knots_.front().s; }
  double end_s() const { return empty() ? 0 : knots_.back().s; }
  /// Offset of one rail; zero outside [begin_s, end_s].
  RailOffset At(Side side, double s) const noexcept;

 private:
  struct Knot {
    double s = 0;
    std::array<double, kNumIrregularityChannels> value{};
    std::array<double, kNumIrregularityChannels> second{};  ///< d2/ds2
  };
  void Fade(double length);
  void Spline();
  void BuildBuckets();

  std::vector<Knot> knots_;
  std::vector<std::int32_t> bucket_;
  double buckets_per_metre_ = 0;
};

}  // namespace phs::rail
