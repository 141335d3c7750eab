// A URDF file as plain data. The only part of the product that sees urdfdom (urdf_file.cc).
//
// URDF: a tree of rigid links; each joint ties a child link to its parent at an origin given in the
// parent's frame, and the child's frame lies at the joint. SI units, radians.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/result.h"

namespace phs::vehicle {

struct UrdfPose {
  std::array<double, 3> position = {0, 0, 0};       ///< [m]
  std::array<double, 4> quaternion = {1, 0, 0, 0};  ///< w, x, y, z
};

struct UrdfLink {
  std::string name = {};
  bool has_inertial = false;
  double mass = 0;                         ///< [kg]
  UrdfPose inertial = {};                  ///< of the inertia axes in the link
  std::array<double, 6> inertia = {};      ///< xx, yy, zz, xy, xz, yz about that origin [kg m^2]
  std::string parent = {};                 ///< "" for the root
  std::string joint = {};                  ///< to the parent
  std::string joint_type = {};             ///< fixed, continuous, revolute, prismatic, floating …
  UrdfPose origin = {};                    ///< of the joint in the parent
  std::array<double, 3> axis = {1, 0, 0};  ///< in the joint's frame
};

struct UrdfModel {
  std::string path = {};
  std::string name = {};
  std::vector<UrdfLink> links = {};  ///< parents before children
  const UrdfLink* Find(const std::string& link) const;
};

/// Errors carry the file and, where the parser tells, the element.
Result<UrdfModel> ReadUrdf(const std::string& path);

}  // namespace phs::vehicle
