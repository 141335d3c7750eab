// A run: one vehicle on one track. Read from models/scenarios/*.yaml (format: docs/scenarios.md).
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "phs_model/phs_model.h"
#include "plugin/running_forces.h"
#include "rail/creep_conditions.h"
#include "rail/track.h"
#include "rail/tread_wear.h"

namespace phs::vehicle {

/// Step of a vehicle where neither scenario nor bogie file says one [s].
inline constexpr double kDefaultStep_s = 0.001;

struct Scenario {
  std::string name;               ///< file name without extension
  std::string track;              ///< name or path
  std::string bogie = "phs";      ///< name or path
  std::string vehicle = "bogie";  ///< bogie | locomotive
  std::string wheel;              ///< profile; empty = as in the bogie file
  std::string rail;
  std::string creep;                ///< creep law; empty = as in the bogie file
  int contact_fineness = 1;         ///< of the normal contact's grid (contact_search.h)
  std::string phs;                  ///< PHS model; empty = as in the bogie file
  double speed_m_s = 0;             ///< held by the drives, > 0
  rail::FrictionSettings friction;  ///< nothing set: the track's
  double timestep_s = 0;            ///< 0: the bogie file's <option timestep>, else kDefaultStep_s
  double duration_s = 0;            ///< 0: until the vehicle reaches the end of the track
  double start_s_m = 1;             ///< arc length of the rearmost wheelset at the start
  double record_interval_s = 0.01;
  plugin::RunningForces running;      ///< traction and braking; inactive: the drives hold the speed
  phs_model::PhsChanges phs_changes;  ///< parameters, effects and failures of the PHS
  rail::TrackErrors track_errors;     ///< on top of the track file
  rail::TreadWear wear;               ///< of every wheel
  /// As written; what they do is already in the fields above (running_effects.h).
  std::vector<hydraulics::EffectParams> effects;
  /// Springs and dampers of single joints of the vehicle, instead of the file's.
  struct JointChange {
    std::string joint;
    double stiffness = -1;  ///< [N/m, N m/rad]; < 0: as in the file
    double damping = -1;    ///< [N s/m, N m s/rad]; < 0: as in the file
  };
  std::vector<JointChange> joints;
  /// Springs of one axle box over those of the rest (box_springs.h).
  struct BoxSpring {
    std::string box;  ///< "lead_left"; empty: every one
    double factor = 1;
  };
  std::vector<BoxSpring> box_springs;
};

/// Puts a bogie into a scenario: "phs", a path, or "phs@out/model.yaml" for one with another PHS
/// model than its own.
void UseBogie(const std::string& asked, Scenario* scenario);
/// What such a bogie is called in tables and results: files by their name without folder and
/// ending ("phs@model").
std::string BogieLabel(const std::string& asked);

}  // namespace phs::vehicle
