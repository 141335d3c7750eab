// Triangle meshes that the product makes itself: turned bodies (wheels), swept ones (rails, bed,
// coils). Vertices carry their normals, so that an edge is sharp where it is given twice.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

namespace phs::view {

struct Mesh {
  std::vector<Eigen::Vector3f> vertex;
  std::vector<Eigen::Vector3f> normal;   ///< unit, outward
  std::vector<std::array<int, 3>> face;  ///< anticlockwise seen from outside
  void Append(const Mesh& other);
};

/// A closed outline in a plane: corners in anticlockwise order, each with the outward normals of
/// the edge before and after it (equal where the outline is smooth).
struct Section {
  std::vector<Eigen::Vector2d> point;
  /// Bends by more than this are edges [rad].
  double edge_angle = 0.5;
};

/// Where a section stands: its origin and the directions of its two axes.
struct Station {
  Eigen::Vector3d origin, first, second;
};

/// The section carried through the stations, closed by flat ends. `first` x `second` points along
/// the order of the stations. The number of vertices and the faces depend on
/// the numbers of points and stations alone, so that a swept mesh can be filled anew.
Mesh Sweep(const Section& section, const std::vector<Station>& stations);

/// The section (axial place, radius) turned about the axis y; anticlockwise with y to the right
/// and the radius up.
Mesh Revolve(const Section& section, int segments);

/// A round wire wound about the line from a to b: `radius` of the coil, `wire` of the wire [m].
Mesh Coil(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius, double wire,
          double turns);

}  // namespace phs::view
