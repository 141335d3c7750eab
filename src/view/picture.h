// What every drawing function is given: one vehicle at one moment.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "plugin/scene_marks.h"
#include "view/pen.h"
#include "view/recording.h"
#include "view/view_model.h"

namespace phs::view {

/// Line pressures between which the colours run [Pa].
struct PressureScale {
  double low = 0;
  double high = 1;
  double Share(double pressure) const { return (pressure - low) / (high - low); }
};

struct Picture {
  ViewModel* model = nullptr;
  const mjData* d = nullptr;  ///< posed; the world's `origin` stands at zero
  const Recording* recording = nullptr;
  Moment at;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double s = 0;  ///< of the vehicle's middle [m]
  PressureScale pressures;

  double Value(const std::string& channel) const { return recording->Value(channel, at); }
  Eigen::Vector3d BodyAt(int body) const {
    return Eigen::Map<const Eigen::Vector3d>(d->xpos + 3 * body);
  }
  Eigen::Matrix3d BodyAxes(int body) const {
    return Eigen::Map<const Eigen::Matrix<mjtNum, 3, 3, Eigen::RowMajor>>(d->xmat + 9 * body);
  }
  Eigen::Vector3d SiteAt(int site) const {
    return Eigen::Map<const Eigen::Vector3d>(d->site_xpos + 3 * site);
  }
};

/// Rails, sleepers, bed and ground along the true alignment; fills the meshes of the model.
void DrawTrack(const Picture& picture, Pen* pen);
/// Wheels, dampers, rods and cylinders. `clear`: wheels to be looked through.
void DrawRunningGear(const Picture& picture, bool clear, Pen* pen);
/// Springs; fills the mesh of the coils.
void DrawCoils(const Picture& picture, Pen* pen);
/// A coil spring as it stands: between two points, radius of the coil and of its wire [m].
struct CoilSpan {
  Eigen::Vector3d a, b;
  double radius = 0, wire = 0;
};
std::vector<CoilSpan> CoilsOf(const Picture& picture);
/// Pipes between the cylinders' chambers with their reservoirs, coloured by pressure.
void DrawLines(const Picture& picture, Pen* pen);
/// Arrows: forces of the rails on the wheels, of the cylinders on axle boxes.
void DrawForces(const Picture& picture, Pen* pen);
/// Outlines of wheel and rail in the plane of the axle, and the places of contact.
void DrawContacts(const Picture& picture, Pen* pen);

using plugin::kCylinderScale;
using plugin::kGuidingScale;
using plugin::kLoadScale;

/// Contact point of the most loaded patch of a wheel; false if it hangs in the air.
bool ContactPoint(const Picture& picture, size_t wheelset, rail::Side side, Eigen::Vector3d* point);

}  // namespace phs::view
