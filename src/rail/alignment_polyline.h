// A line of straight pieces with parabolic corners: cant, gauge widening and height of a track.
//
// Between its vertices f(s) is linear; a vertex with a change of slope from m1 to m2 and half
// length d is replaced by the parabola that touches both straights:
//
//     f(s) = f_v + m1 (s - s_v) + (m2 - m1)/(4 d) (s - s_v + d)^2      for |s - s_v| <= d
//
// so f is continuous to its slope and its second derivative is bounded by |m2 - m1|/(2 d). For the
// height this is the vertical curve of radius R = 2 d/|m2 - m1|.
#pragma once

#include <vector>

namespace phs::rail {

/// f(s0 + u) = value + slope u + half_second u^2.
struct Quadratic {
  double value = 0;
  double slope = 0;
  double half_second = 0;  ///< f''/2

  double At(double u) const { return value + u * (slope + u * half_second); }
  double SlopeAt(double u) const { return slope + 2 * half_second * u; }
};

class RoundedPolyline {
 public:
  struct Vertex {
    double s = 0;
    double value = 0;
    double half_length = 0;  ///< d of the parabola; 0 keeps the corner [m]
  };

  /// @pre at least two vertices with increasing s, parabolas do not overlap, the first and the last
  /// vertex have no parabola. Outside the vertices the end straights go on.
  explicit RoundedPolyline(const std::vector<Vertex>& vertices);

  /// The quadratic in force at s (from s on), expanded about s.
  Quadratic ExpandAt(double s) const;
  /// Where the quadratic changes.
  std::vector<double> Breaks() const;

 private:
  struct Piece {
    double s = 0;
    Quadratic f;
  };
  std::vector<Piece> pieces_;
};

}  // namespace phs::rail
