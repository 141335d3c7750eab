#include "view/camera.h"

#include <algorithm>
#include <cmath>

#include "view/shapes.h"

namespace phs::view {

using Eigen::Vector3d;

const std::vector<View>& Views() {
  static const std::vector<View> kViews = {
      {"bogie", "from the front, outer side", Target::kVehicle, 0.62, 138, -17, 6.6},
      {"side", "square to the track, from the outer side", Target::kVehicle, 0.70, 90, -5, 6.6},
      {"top", "from above", Target::kVehicle, 0.60, 90, -89.9, 6.8},
      {"plan", "from above, the way it runs upwards", Target::kVehicle, 0.60, 0, -89.9, 7.6},
      {"front", "along the track, from the front", Target::kVehicle, 0.75, 180, -8, 6.5},
      {"chase", "from behind and above", Target::kVehicle, 0.5, 14, -14, 9.5},
      {"wheel", "leading outer wheel", Target::kWheel, 0.45, 130, -10, 2.6},
      {"contact", "leading outer wheel on its rail, along the rail", Target::kContact, 0.02, 178,
       -3, 0.36},
  };
  return kViews;
}

const View* FindView(const std::string& name) {
  for (const View& view : Views()) {
    if (name == view.name) return &view;
  }
  return nullptr;
}

std::vector<std::string> ViewNames() {
  std::vector<std::string> names;
  for (const View& view : Views()) names.emplace_back(view.name);
  return names;
}

namespace {

/// A long vehicle is looked at from farther away: by how much, against a bogie of two axles.
double LengthShare(const Picture& picture) {
  const plugin::Binding& binding = picture.model->binding();
  Vector3d least = picture.BodyAt(binding.wheelsets()[0].body);
  Vector3d most = least;
  for (const plugin::WheelsetBinding& w : binding.wheelsets()) {
    least = least.cwiseMin(picture.BodyAt(w.body));
    most = most.cwiseMax(picture.BodyAt(w.body));
  }
  return std::max(1.0, ((most - least).norm() + 1.6) / 4.8);
}

}  // namespace

mjvCamera CameraOf(const View& view, const Picture& picture, rail::Side outer) {
  const plugin::Binding& binding = picture.model->binding();
  const rail::TrackFrame frame = binding.track().FrameAt(picture.s);
  Vector3d at = ToEigen(frame.origin) - picture.origin;
  if (view.target != Target::kVehicle) {
    const plugin::WheelsetBinding& lead = binding.wheelsets()[0];
    const double hand = outer == rail::Side::kLeft ? 1 : -1;
    const double radius = binding.wheel_rail().params().wheel_radius;
    const Vector3d wheel = picture.BodyAxes(lead.body).col(1) * hand;
    at = picture.BodyAt(lead.body) + wheel * WheelPosition(binding.wheel_rail()) -
         radius * Vector3d::UnitZ();
    if (view.target == Target::kContact) ContactPoint(picture, 0, outer, &at);
  }
  mjvCamera camera;
  mjv_defaultCamera(&camera);
  camera.type = mjCAMERA_FREE;
  for (int i = 0; i < 3; ++i) camera.lookat[i] = at[i] + (i == 2 ? view.height_m : 0);
  // The views are those from the right; mirrored where the outer rail is the left one.
  const double azimuth = outer == rail::Side::kRight ? view.azimuth_deg : -view.azimuth_deg;
  camera.azimuth = frame.heading * 180 / M_PI + azimuth;
  camera.elevation = view.elevation_deg;
  camera.distance = view.distance_m * (view.target == Target::kVehicle ? LengthShare(picture) : 1);
  return camera;
}

}  // namespace phs::view
