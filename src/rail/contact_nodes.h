// Where the integrals over an overlap are taken (contact_search.h): places that stay on the wheel.
//
// A parabola of depth d is 2 sqrt(d/B) wide along the surface, 2 B the relative curvature of wheel
// and rail. So that every hump of one depth has the same number of nodes wherever it lies, the nodes
// are at equal steps of u, du = sqrt(B) ds, with the B of the wheel's point and the rail's point of
// the same slope, evened out so that the distance of nodes changes slowly: sums over them are then
// as good as with equal distances.
//
// The nodes never move and never change with the overlap. So the sum of kappa g^4 over them is a
// smooth function of the wheelset's position, whose slope is the force to the last digit: no event of
// the grid shakes the wheelset. The price: a touch is felt when it reaches a node, up to 0.2 um of depth
// (some 20 N) late.
#pragma once

#include <vector>

#include "rail/profile.h"

namespace phs::rail {

struct ContactNodes {
  /// @param radius of the wheel at its profile's origin [m]
  /// @param fineness so many times more nodes than usual
  ContactNodes(const Profile& wheel, const Profile& rail, double radius, int fineness);
  /// In nodes from the first one.
  double PlaceOf(double wheel_y) const noexcept;

  std::vector<double> at;                     ///< [node] on the wheel [m]
  std::vector<double> radius, slope, second;  ///< [node] of the wheel [m, 1, 1/m]
  std::vector<double> across;                 ///< [node] dy/dk, width that a node stands for [m]

 private:
  double begin_, per_piece_;
  std::vector<double> density_;  ///< [end of a piece] nodes per metre across
  std::vector<double> place_;    ///< [end of a piece] in nodes from the first
};

}  // namespace phs::rail
