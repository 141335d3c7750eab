// The section of a wheel or rail: height z (down) over y (to the field side) as a function, sampled
// evenly from the points of a file in SIMPACK's form (.prw, .prr). A wheel's origin is its tape
// circle, a rail's the top of its head.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace bogie_curve {

class Section {
 public:
  struct Place {
    double z = 0, slope = 0;
  };
  // Throws std::runtime_error with the path where the file cannot be read.
  static Section Read(const std::string& path, bool top_at_zero);
  // A cone without flange; a head of one arc, 35 mm to either side.
  static Section Cone(double conicity);
  static Section Arc(double radius);
  // From points with growing y [m].
  static Section Of(std::vector<double> y, std::vector<double> z);

  double first() const { return first_; }
  double last() const { return first_ + step_ * static_cast<double>(z_.size() - 1); }
  bool Has(double y) const { return y >= first_ && y <= last(); }
  // Within first … last.
  Place At(double y) const;
  // The y < 0 at which the flank has gone down to `depth`; the end where it does not.
  double InnerFlank(double depth) const;

 private:
  static constexpr double step_ = 1e-4;  // [m]
  double first_ = 0;
  std::vector<double> z_;
  std::vector<std::pair<double, double>> outline_;  // all points of the file, the steep ones too
};

}  // namespace bogie_curve
