#include "view/pen.h"

#include <algorithm>
#include <cstring>

namespace phs::view {

using Eigen::Matrix3d;
using Eigen::Vector3d;

mjvGeom* Pen::Add(int type, const Vector3d& size, const Vector3d& at, const Matrix3d& axes,
                  const Colour& colour, const Finish& finish) {
  if (scene_->ngeom >= scene_->maxgeom) return nullptr;
  mjvGeom* geom = scene_->geoms + scene_->ngeom;
  *geom = mjvGeom{};  // mjv_initGeom leaves some fields as they were
  geom->category = mjCAT_DECOR;
  geom->segid = scene_->ngeom++;
  const float rgba[4] = {colour.r, colour.g, colour.b, colour.a * alpha_};
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = axes;
  mjv_initGeom(geom, type, size.data(), at.data(), rows.data(), rgba);
  geom->specular = finish.specular;
  geom->shininess = finish.shininess;
  geom->emission = finish.emission;
  geom->transparent = geom->rgba[3] < 0.999f ? 1 : 0;
  return geom;
}

mjvGeom* Pen::Connect(int type, const Vector3d& a, const Vector3d& b, double width,
                      const Colour& colour, const Finish& finish) {
  if ((b - a).norm() < 1e-5) {
    Skip();
    return nullptr;
  }
  mjvGeom* geom = Add(type, Vector3d::Ones(), a, Matrix3d::Identity(), colour, finish);
  if (geom == nullptr) return nullptr;
  mjv_makeConnector(geom, type, width, a.x(), a.y(), a.z(), b.x(), b.y(), b.z());
  return geom;
}

void Pen::Skip(int count) {
  for (int i = 0; keeps_places_ && i < count; ++i) {
    Add(mjGEOM_NONE, Vector3d::Ones(), Vector3d::Zero(), Matrix3d::Identity(), {0, 0, 0, 0}, kMatt);
  }
}

void Pen::Box(const Vector3d& centre, const Matrix3d& axes, const Vector3d& half,
              const Colour& colour, const Finish& finish) {
  Add(mjGEOM_BOX, half, centre, axes, colour, finish);
}

void Pen::Cylinder(const Vector3d& a, const Vector3d& b, double radius, const Colour& colour,
                   const Finish& finish) {
  Connect(mjGEOM_CYLINDER, a, b, radius, colour, finish);
}

void Pen::Capsule(const Vector3d& a, const Vector3d& b, double radius, const Colour& colour,
                  const Finish& finish) {
  Connect(mjGEOM_CAPSULE, a, b, radius, colour, finish);
}

void Pen::Ball(const Vector3d& centre, const Matrix3d& axes, const Vector3d& half,
               const Colour& colour, const Finish& finish) {
  Add(mjGEOM_ELLIPSOID, half, centre, axes, colour, finish);
}

void Pen::Arrow(const Vector3d& from, const Vector3d& to, double width, const Colour& colour) {
  Connect(mjGEOM_ARROW, from, to, width, colour, kGlow);
}

void Pen::Mesh(int id, const Vector3d& origin, const Matrix3d& axes, const Colour& colour,
               const Finish& finish) {
  mjvGeom* geom = Add(mjGEOM_MESH, Vector3d::Ones(), origin, axes, colour, finish);
  if (geom != nullptr) geom->dataid = 2 * id;  // odd numbers are convex hulls
}

void Pen::Label(const Vector3d& at, const std::string& text) {
  mjvGeom* geom =
      Add(mjGEOM_LABEL, Vector3d::Constant(0.01), at, Matrix3d::Identity(), {1, 1, 1, 1}, kMatt);
  if (geom == nullptr) return;
  const size_t length = std::min(text.size(), sizeof geom->label - 1);
  std::memcpy(geom->label, text.data(), length);
  geom->label[length] = 0;
}

}  // namespace phs::view
