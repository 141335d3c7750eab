// Adds shapes to the engine's scene: what moves or is coloured by state.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Dense>
#include <string>

namespace phs::view {

struct Colour {
  float r = 0, g = 0, b = 0, a = 1;
};

/// How a surface shines.
struct Finish {
  float specular = 0.2f;
  float shininess = 0.3f;
  float emission = 0.0f;
};
inline constexpr Finish kMatt{0.04f, 0.1f, 0.0f};
inline constexpr Finish kSteel{0.5f, 0.55f, 0.0f};
inline constexpr Finish kGlow{0.1f, 0.2f, 0.45f};

class Pen {
 public:
  explicit Pen(mjvScene* scene) : scene_(scene) {}
  /// Everything drawn from now on is so transparent (1 = not at all).
  void SetAlpha(float alpha) { alpha_ = alpha; }
  /// From now on shapes that are not drawn just now leave an invisible one in their place, so that
  /// every shape keeps its number in the scene.
  void KeepPlaces(bool keep) { keeps_places_ = keep; }
  /// So many shapes are not drawn just now.
  void Skip(int count = 1);

  void Box(const Eigen::Vector3d& centre, const Eigen::Matrix3d& axes, const Eigen::Vector3d& half,
           const Colour& colour, const Finish& finish = kMatt);
  /// A round bar from a to b, flat or round at its ends.
  void Cylinder(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius,
                const Colour& colour, const Finish& finish = kSteel);
  void Capsule(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius,
               const Colour& colour, const Finish& finish = kSteel);
  void Ball(const Eigen::Vector3d& centre, const Eigen::Matrix3d& axes, const Eigen::Vector3d& half,
            const Colour& colour, const Finish& finish = kSteel);
  void Arrow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double width,
             const Colour& colour);
  /// A mesh of the model by its id.
  void Mesh(int id, const Eigen::Vector3d& origin, const Eigen::Matrix3d& axes,
            const Colour& colour, const Finish& finish = kSteel);
  void Label(const Eigen::Vector3d& at, const std::string& text);

 private:
  mjvGeom* Add(int type, const Eigen::Vector3d& size, const Eigen::Vector3d& at,
               const Eigen::Matrix3d& axes, const Colour& colour, const Finish& finish);
  mjvGeom* Connect(int type, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double width,
                   const Colour& colour, const Finish& finish);

  mjvScene* scene_;
  float alpha_ = 1;
  bool keeps_places_ = false;
};

}  // namespace phs::view
