// From where a vehicle is looked at. A view is fixed to the track under the vehicle, so that it
// follows through the curve.
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "view/picture.h"

namespace phs::view {

/// What a view looks at.
enum class Target { kVehicle, kWheel, kContact };

struct View {
  const char* name;
  const char* text;  ///< one line of help
  Target target;
  double height_m;       ///< of the point looked at: above the rails, or above the wheel's contact
  double azimuth_deg;    ///< of the line of sight against the track, anticlockwise; 180: backwards
  double elevation_deg;  ///< of the line of sight, < 0 downwards
  double distance_m;
};

/// The table.
const std::vector<View>& Views();
/// By name, or null.
const View* FindView(const std::string& name);
std::vector<std::string> ViewNames();

/// The camera of a view at one moment; wheel and contact are those of the leading wheelset on the
/// outer rail of the track's first curve (`outer`).
mjvCamera CameraOf(const View& view, const Picture& picture, rail::Side outer);

}  // namespace phs::view
