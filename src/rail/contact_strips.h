// Pressure between wheel and rail by strips of the wheel's surface that share one half-space.
//
// A strip i of width w lies along the rolling direction; g is its undeformed normal overlap [m],
// its load per width is pi E* x, E* = G/(1 - nu). What the loads press in at strip i is
//   u_i = l x_i + sum_j w_j x_j c(r_ij, p_ij) cos_ij,   c(r, p) = (r + p)/(r^2 + r p + p^2)
// r the distance along the surface, cos_ij between the normals. c is 1/r far away (Boussinesq's
// half-space) and levels off at p = k_i + k_j, a share of both strips' half-lengths in contact,
// k = s sqrt(g/A), A half the curvature along. Contact is
//   x >= 0,  u >= g,  x (u - g) = 0
// which makes x the maximum of a concave function: there is one answer, it is continuous, and
//   U = pi E* sum w (x g - x u/2)
// is an energy. The strips' forces are its exact derivatives by g, f_i = dU/dg_i, with what k
// changes by g. So the wrench comes from an energy, and U grows with the power 5/2 of the size of
// g, as Hertz's 2/5 N delta does.
//
// l and s make load, width and peak of an ellipse Hertz's: l = 0.2 and s = 0.083 (b + 0.15)/(b +
// 0.23) with b = B/A give load and approach within 2 %, the width within 5 % for B/A of 0.02 … 50.
#pragma once

#include <vector>

#include "rail/profile.h"

namespace phs::rail {

inline constexpr int kStripsPerHump = 9;
inline constexpr int kMaxStrips = 3 * kStripsPerHump;

/// Strips in growing order of the wheel's profile.
struct StripLoads {
  int count = 0;
  double place[kMaxStrips];    ///< wheel y [m]
  double width[kMaxStrips];    ///< arc length [m]
  double cosine[kMaxStrips];   ///< of the wheel's slope
  double sine[kMaxStrips];     ///< < 0 where the wheel falls inwards
  double along[kMaxStrips];    ///< A [1/m]
  double overlap[kMaxStrips];  ///< g [m]
  double x[kMaxStrips];        ///< of the point of contact, from the wheelset's centre [m]
  double y[kMaxStrips];        ///< from the rail's origin [m]
  double z[kMaxStrips];
  double slope[kMaxStrips];   ///< dz/dy of the placed wheel there
  double force[kMaxStrips];   ///< f >= 0 [N]
  double energy[kMaxStrips];  ///< the strip's part of U [J]
};

class ContactStrips {
 public:
  /// @param modulus E* [Pa]
  ContactStrips(const Profile& wheel, const Profile& rail, double radius, double modulus);
  /// Forces and energies of the overlaps given.
  void Press(StripLoads* loads) const noexcept;

 private:
  /// Of the strips that overlap, lower halves of symmetric matrices.
  struct Compliance {
    double level[kMaxStrips];             ///< k [m]
    double give[kMaxStrips][kMaxStrips];  ///< displacement per load w x [1/m]
    double fall[kMaxStrips][kMaxStrips];  ///< -d give/dp; of the own strip -d give/dk [1/m^2]
  };
  void Give(const StripLoads& loads, Compliance* compliance) const noexcept;

  double modulus_;  ///< pi E* [Pa]
  double begin_, per_step_, last_;
  struct Place {
    double arc, own, share;  ///< arc length [m], l, s
  };
  std::vector<Place> table_;  ///< over wheel y
};

}  // namespace phs::rail
