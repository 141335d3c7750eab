#include "view/mesh.h"

#include <gmock/gmock.h>

#include <cmath>

namespace phs::view {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using ::testing::DoubleNear;

/// Volume by the divergence theorem: right only if the mesh is closed and every face looks outward.
double Volume(const Mesh& mesh) {
  double volume = 0;
  for (const auto& f : mesh.face) {
    const Vector3d a = mesh.vertex[static_cast<size_t>(f[0])].cast<double>();
    const Vector3d b = mesh.vertex[static_cast<size_t>(f[1])].cast<double>();
    const Vector3d c = mesh.vertex[static_cast<size_t>(f[2])].cast<double>();
    volume += a.dot(b.cross(c)) / 6;
  }
  return volume;
}

/// Least cosine between a face and the normals of its corners.
double WorstNormal(const Mesh& mesh) {
  double worst = 1;
  for (const auto& f : mesh.face) {
    const Vector3d a = mesh.vertex[static_cast<size_t>(f[0])].cast<double>();
    const Vector3d b = mesh.vertex[static_cast<size_t>(f[1])].cast<double>();
    const Vector3d c = mesh.vertex[static_cast<size_t>(f[2])].cast<double>();
    const Vector3d face = (b - a).cross(c - a);
    if (face.norm() < 1e-12) continue;
    for (const int corner : f) {
      const Vector3d normal = mesh.normal[static_cast<size_t>(corner)].cast<double>();
      EXPECT_THAT(normal.norm(), DoubleNear(1, 1e-5));
      worst = std::min(worst, normal.dot(face.normalized()));
    }
  }
  return worst;
}

TEST(Mesh, SweptSquareIsABox) {
  Section square;
  square.point = {{0, 0}, {0.2, 0}, {0.2, 0.1}, {0, 0.1}};
  const Mesh box = Sweep(square, {{{0, 0, 0}, Vector3d::UnitY(), Vector3d::UnitZ()},
                                  {{1, 0, 0}, Vector3d::UnitY(), Vector3d::UnitZ()},
                                  {{3, 0, 0}, Vector3d::UnitY(), Vector3d::UnitZ()}});
  EXPECT_THAT(Volume(box), DoubleNear(0.2 * 0.1 * 3, 1e-7));
  EXPECT_THAT(WorstNormal(box), DoubleNear(1, 1e-6)) << "edges of 90 degrees stay sharp";
}

TEST(Mesh, RevolvedSquareIsARing) {
  Section square;
  square.point = {{0, 0.3}, {0.1, 0.3}, {0.1, 0.5}, {0, 0.5}};
  const int n = 96;
  const Mesh ring = Revolve(square, n);
  // The inscribed polygon's area, not the circle's.
  const double area = 0.5 * n * std::sin(2 * M_PI / n) * (0.25 - 0.09);
  EXPECT_THAT(Volume(ring), DoubleNear(area * 0.1, 1e-7));
  EXPECT_GT(WorstNormal(ring), 0.99);
}

TEST(Mesh, CoilHasTheVolumeOfItsWire) {
  const Mesh coil = Coil({0, 0, 0}, {0, 0, 0.3}, 0.1, 0.015, 6.5);
  const double length = std::hypot(6.5 * 2 * M_PI * 0.1, 0.3);
  const double hexagon = 0.5 * 6 * std::sin(M_PI / 3) * 0.015 * 0.015;
  EXPECT_THAT(Volume(coil), DoubleNear(length * hexagon, 0.04 * length * hexagon));
  EXPECT_GT(WorstNormal(coil), 0.8);
  // A spring pressed together keeps its numbers, so that it can be drawn anew.
  const Mesh pressed = Coil({0, 0, 0}, {0, 0, 0.25}, 0.1, 0.015, 6.5);
  EXPECT_EQ(coil.vertex.size(), pressed.vertex.size());
  EXPECT_EQ(coil.face, pressed.face);
}

}  // namespace
}  // namespace phs::view
