// A curve of a railway: tangent, clothoid, arc, clothoid, tangent, with cant about the low rail.
//
// x forward, y left, z up. Curvature k(s) is linear between the ends of the parts and > 0 to the
// left; heading th' = k; plan x' = cos th, y' = sin th. Superelevation h(s) of the right rail over
// the base e follows the curvature, each corner of its ramps drawn out to a parabola (the mean of
// the ramp over `rounding`). Angle of cant a = asin(h/e); the centre line rises by h/2.
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace bogie_curve {

using Eigen::Vector3d;

struct CurveDesign {
  double tangent = 80, transition = 60, arc = 300, last_tangent = 60;  // [m]
  double radius = 550;                                                 // [m], to the left
  double cant = 0.060;                                                 // h in the arc [m]
  double base = 1.139;                                                 // e [m]
  double rounding = 6;                                                 // [m]
};

// The track frame at one arc length, world axes.
struct LinePose {
  Vector3d origin, forward, left, up;
  double heading = 0, curvature = 0;
  double twist = 0;  // da/ds [rad/m]
};

class TrackLine {
 public:
  explicit TrackLine(const CurveDesign& design);
  double Length() const { return end_[4]; }
  double Curvature(double s) const;
  double Cant(double s) const;  // h [m]
  LinePose At(double s) const;
  // Arc length of the frame whose cross-section holds `point`; `near` is where to begin.
  double Project(const Vector3d& point, double near) const;

 private:
  struct Knot {
    double s, x, y, heading;
  };
  double CantIntegral(double s) const;

  CurveDesign design_;
  double end_[5];  // ends of the five parts
  std::vector<Knot> knots_;
};

}  // namespace bogie_curve
