// Output channels that belong to a run in time: the energy book and the drives. One row each; the
// channels of an instant stand in plugin/channels.h.
#pragma once

#include <mujoco/mujoco.h>

#include <span>

#include "plugin/binding.h"
#include "vehicle/energy_book.h"

namespace phs::vehicle {

struct EnergyRow {
  const char* name;  ///< with its unit
  const char* unit;
  const char* text;
  double (*value)(const EnergyBook& book, const mjData* d, const plugin::Binding& binding);
};

/// In the order of the columns, after those of the instant.
std::span<const EnergyRow> EnergyChannels();

}  // namespace phs::vehicle
