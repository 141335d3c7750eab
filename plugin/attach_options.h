// What a program may say of a model beside its <custom> section.
#pragma once

#include <string>

#include "phs_model/phs_model.h"
#include "plugin/running_forces.h"
#include "rail/creep_conditions.h"
#include "rail/track_frame.h"
#include "rail/tread_wear.h"

namespace phs::plugin {

/// Overrides of what the model says in its <custom> section; empty or NaN = as in the model.
struct AttachOptions {
  std::string track;
  std::string wheel_profile;
  std::string rail_profile;
  std::string creep_law;
  /// So many times more samples and nodes of the normal contact: 1 … 4.
  int contact_fineness = 1;
  std::string phs_model;              ///< replaces the model of every PHS system
  rail::FrictionSettings friction;    ///< of wheel on rail
  double speed_m_s = kUnset;          ///< target of the speed hold
  double start_s_m = kUnset;          ///< arc length of the rearmost wheelset at the start
  phs_model::PhsChanges phs_changes;  ///< parameters and failures of every PHS
  RunningForces running;              ///< traction and braking
  rail::TrackErrors track_errors;     ///< on top of the track file
  rail::TreadWear wear;               ///< of every wheel
  static constexpr double kUnset = -1;
};

}  // namespace phs::plugin
