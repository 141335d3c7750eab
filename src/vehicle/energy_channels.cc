#include "vehicle/energy_channels.h"

namespace phs::vehicle {
namespace {

using plugin::Binding;

double TotalDriveTorque(const EnergyBook&, const mjData* d, const Binding& binding) {
  double torque = d->userdata[plugin::UserData::kHoldMore];
  for (const auto& w : binding.wheelsets()) {
    if (w.drive_actuator >= 0) torque += d->actuator_force[w.drive_actuator];
  }
  return torque;
}

/// A number of the book.
template <double EnergyBook::*kNumber>
double Of(const EnergyBook& book, const mjData*, const Binding&) {
  return book.*kNumber;
}

constexpr char kSinceStart[] = "since the start";

constexpr EnergyRow kRows[] = {
    {"energy_kinetic_J", "J", "of the whole, not since the start", &Of<&EnergyBook::kinetic>},
    {"energy_stored_J", "J", kSinceStart, &Of<&EnergyBook::stored>},
    {"work_in_J", "J", kSinceStart, &Of<&EnergyBook::work_in>},
    {"lost_creep_J", "J", kSinceStart, &Of<&EnergyBook::lost_creep>},
    {"lost_contact_J", "J", kSinceStart, &Of<&EnergyBook::lost_contact>},
    {"lost_dampers_J", "J", kSinceStart, &Of<&EnergyBook::lost_dampers>},
    {"lost_phs_J", "J", kSinceStart, &Of<&EnergyBook::lost_phs>},
    {"lost_brakes_J", "J", kSinceStart, &Of<&EnergyBook::lost_brakes>},
    {"drive_torque_Nm", "N m", "of all driven axles together", &TotalDriveTorque},
};

}  // namespace

std::span<const EnergyRow> EnergyChannels() { return kRows; }

}  // namespace phs::vehicle
