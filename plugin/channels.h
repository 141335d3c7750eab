// Output channels: every quantity that a run records and the C API offers is one row of a table.
//
// There is a table for each kind of thing that has results, in the file channels_KIND.cc. A channel
// is called PREFIX_NAME with the name of its row, e.g. lead_left_Y_N:
//
//   kind       prefix                     channels
//   run        none                       once in a run
//   wheelset   lead, rear_trail …         of each wheelset
//   wheel      lead_left …                of both wheels of a wheelset
//   bogie      none, or front …           of each pair of wheelsets in one frame
//   cylinder   cylinder_1, PHS_cylinder_1 of each cylinder
//   line       line_L1, PHS_line_L1       of each line
//   element    damper_yaw_left …          of each element between bodies that is no joint or tendon
//
// A value is a pure function of the model at one instant.
#pragma once

#include <mujoco/mujoco.h>

#include <span>
#include <string>
#include <vector>

#include "plugin/bogie_pairs.h"

namespace phs::plugin {

/// A bound model at the instant that MuJoCo last worked out, after mj_forward or mj_step, when qpos,
/// qvel and time of `d` have gone on: what values are read from.
struct Instant {
  const mjModel* m = nullptr;
  const mjData* d = nullptr;
  const Binding* binding = nullptr;
  const std::vector<BogiePair>* bogies = nullptr;
  int car_body = 0;                           ///< the heaviest body
  std::vector<WheelsetState> wheelsets = {};  ///< as in the binding
  std::vector<PhsState> phs = {};             ///< as in the binding
  const WheelsetState* leading = nullptr;     ///< the foremost on the track, or none

  /// Position of a joint [m or rad]; 0 for joint -1.
  double Joint(int joint) const {
    return joint < 0 ? 0.0 : binding->Joints(m, d).position[m->jnt_qposadr[joint]];
  }
};

/// Which thing of its kind a channel belongs to.
struct ChannelPlace {
  int index = 0;  ///< wheelset, bogie (Instant::bogies), PHS, elements of one kind
  int part = 0;   ///< wheel of the wheelset (rail::Side), cylinder or line of the PHS, element
};

struct ChannelRow {
  const char* name;  ///< with its unit, e.g. "Y_N"
  const char* unit;
  const char* text;
  double (*value)(const Instant& at, ChannelPlace place);
};

/// The rows of each kind, in the order of the columns.
std::span<const ChannelRow> RunChannels();
std::span<const ChannelRow> WheelsetChannels();
std::span<const ChannelRow> WheelChannels();
std::span<const ChannelRow> BogieChannels();
std::span<const ChannelRow> CylinderChannels();
std::span<const ChannelRow> LineChannels();
std::span<const ChannelRow> ElementChannels();

/// All tables, for the reference page.
struct ChannelKind {
  const char* name;
  const char* prefix;  ///< of its channels, as a reader sees it
  std::span<const ChannelRow> rows;
};
std::vector<ChannelKind> ChannelKinds();

}  // namespace phs::plugin
