// Instrument errors on predicted channels, by the reading laws of each sensor.
#pragma once

#include "hydraulics/phs_system.h"
#include "rigs/rig.h"

namespace phs::rigs {

/// Changes the channels in place. Delays interpolate between samples; before the first sample the
/// first value holds. Not of a bench. Line pressures of the full rig take the errors of the first
/// cylinder on them.
void ApplyInstruments(RigKind kind, const hydraulics::PhsSystem& system, double t0_s, double step_s,
                      RigPrediction* prediction);

/// Of a bench (RigKind::kElement): those of the one channel that it answers.
void ApplyBenchInstruments(const hydraulics::PhsSystem& system, const RigMotion& motion,
                           Drive driven_by, RigPrediction* prediction);

}  // namespace phs::rigs
