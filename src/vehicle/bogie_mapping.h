// What a URDF does not say about a bogie: which link is what, where springs and cylinders sit
// (docs/import.md). Read from a small YAML file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "phs_model/phs_model.h"

namespace phs::vehicle {

/// One direction in which a link may move against its parent.
struct SpringDirection {
  std::string direction;  ///< x, y, z, roll, pitch, yaw
  double stiffness = 0;   ///< [N/m] or [N m/rad]
  double damping = 0;     ///< [N s/m] or [N m s/rad]
  double preload_N = 0;   ///< of the spring on the link at rest, > 0 up; z only
};

struct AxleMapping {
  std::string name;          ///< lead, trail, mid
  std::string boxes;         ///< link
  std::string wheelset;      ///< link
  double rotor_inertia = 0;  ///< of the motor seen at the axle [kg m^2]
  bool driven = true;
  std::vector<SpringDirection> suspension;  ///< in the order of the file
};

struct SprungMapping {
  std::string link;
  std::vector<SpringDirection> suspension;
};

struct CylinderMapping {
  std::string name;
  std::string from_link, to_link;
  double from_m[3] = {0, 0, 0};
  double to_m[3] = {0, 0, 0};
};

struct BogieMapping {
  std::string path;
  std::string name;
  std::string frame;
  double coupler_m[3] = {0, 0, 0};  ///< where the train acts, in the frame
  std::vector<AxleMapping> axles;
  std::vector<SprungMapping> sprung;  ///< bodies on springs: half the car body
  std::vector<CylinderMapping> cylinders;
  std::string phs = phs_model::kDefaultModel;
  std::string yardstick;
  double wheel_radius_m = 0.625;
  double flange_back_m = 0;  ///< between the flange backs; 0: gauge less 75 mm
  double timestep_s = 0.001;
  std::string track, wheel, rail, creep;
  double speed_m_s = 0;
};

/// Errors name file:line and key.
Result<BogieMapping> LoadBogieMapping(const std::string& path);

}  // namespace phs::vehicle
