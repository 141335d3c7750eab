// Wheel and rail profiles: read, thinned, splined.
//
// Profile axes are those of a right wheel or rail: y outward (field side), z down, origin at the
// tape circle (wheel) or at the top of the rail. A profile is used as a function z(y): what is
// steeper than atan 6 (80 deg) is cut off.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "base/result.h"

namespace phs::rail {

/// z(y) as a cubic spline on equidistant knots: position, slope and curvature are consistent, slope
/// is continuously differentiable.
class Profile {
 public:
  /// Value and derivatives at y. Beyond the ends: straight continuation of the end slope.
  struct Sample {
    double z = 0;
    double slope = 0;   ///< dz/dy
    double second = 0;  ///< d2z/dy2 [1/m]
  };
  Sample At(double y) const noexcept;
  double min_y() const { return begin_; }
  double max_y() const { return begin_ + step_ * static_cast<double>(piece_.size()); }
  const std::string& name() const { return name_; }

  /// Turns the section about its origin: > 0 inclines a rail towards the track (top moves inward).
  void Incline(double angle);
  /// Takes `depth(y)` [m] off the surface: z becomes z - depth.
  void Lower(const std::function<double(double)>& depth);
  /// Moves the section so that its highest point (smallest z) has z = 0.
  void PutTopAtZero();
  /// y of the inner side at depth z below the top. NaN if the profile does not reach so deep.
  double InnerSideAtDepth(double z) const;

  /// From points with strictly growing y [m].
  static Result<Profile> FromPoints(const std::string& name, std::vector<double> y,
                                    std::vector<double> z);

 private:
  struct Piece {
    double c0 = 0, c1 = 0, c2 = 0, c3 = 0;
  };
  std::string name_;
  std::vector<double> outline_y_, outline_z_;  ///< all points given, also the steep ones
  double begin_ = 0;
  double step_ = 0;
  double per_step_ = 0;
  std::vector<Piece> piece_;
};

inline Profile::Sample Profile::At(double y) const noexcept {
  const int last = static_cast<int>(piece_.size()) - 1;
  const double place = (y - begin_) * per_step_;
  const int i = static_cast<int>(std::clamp(place, 0.0, static_cast<double>(last)));
  const double t = y - (begin_ + step_ * i);
  const Piece& p = piece_[static_cast<size_t>(i)];
  const double inside = std::clamp(t, 0.0, step_);
  const double over = t - inside;  // 0 but beyond the ends
  const double slope = p.c1 + inside * (2 * p.c2 + 3 * p.c3 * inside);
  return {p.c0 + inside * (p.c1 + inside * (p.c2 + p.c3 * inside)) + slope * over, slope,
          over == 0 ? 2 * p.c2 + 6 * p.c3 * inside : 0};
}

enum class ProfileKind { kWheel, kRail };

/// Reads a file (.prw, .prr, two-column table) or generates `cone:LAMBDA`, `arc:RADIUS_M`.
Result<Profile> LoadProfile(const std::string& path, ProfileKind kind);
/// The reader of files alone, from their text (fuzzed).
Result<Profile> ParseProfile(const std::string& text, const std::string& name, ProfileKind kind);

}  // namespace phs::rail
