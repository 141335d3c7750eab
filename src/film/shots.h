// One instant of a scene as shapes in the vehicle's frame L (report/replay.h), and the courses of
// many instants made of them: what a body carries is told once, whatever it carries.
#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "report/replay.h"
#include "view/stage.h"

namespace phs::film {

/// A shape at one instant.
struct Shot {
  std::string kind;
  int mesh = -1;  ///< id in the model
  bool mirrored = false;
  bool visible = true;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  std::array<double, 4> colour{};  ///< red, green, blue, alpha
  Eigen::Vector3d a, b;            ///< of a bar; a is the origin of a solid
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

struct Pose {
  Eigen::Vector3d origin;
  Eigen::Matrix3d axes;
};

/// What a camera could see at one instant.
struct Instant {
  std::vector<Shot> shots;
  std::vector<Pose> bodies;  ///< all bodies of the model
};

/// Takes the scene of the stage's last SetMoment apart (Look::parts_only).
Instant TakeApart(view::Stage* stage);

/// Colours that parts share.
class Colours {
 public:
  /// The number of this course of colours; a new one if there is none like it.
  int Add(const std::array<report::Course, 3>& course);
  std::vector<std::array<report::Course, 3>> Take() { return std::move(courses_); }

 private:
  std::vector<std::array<report::Course, 3>> courses_;
};

/// Bodies and parts of a bogie from its instants, [look][instant]; a part's mesh is its id in the
/// model still.
void AddParts(const std::vector<std::vector<Instant>>& instants, Colours* colours,
              report::ReplayBogie* bogie);

}  // namespace phs::film
