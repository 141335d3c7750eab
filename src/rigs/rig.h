// What all rigs have in common: kinds, options, driving motion, predicted channels. Signs:
// extension > 0, tension > 0; pressures absolute.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "hydraulics/extra_series.h"

namespace phs::rigs {

enum class RigKind { kCylinder, kQuarter, kFull, kElement };
Result<RigKind> ParseRigKind(const std::string& word);

/// The hinged beam that carries cylinders 3 and 4 of the full rig: y = ±lever * angle.
struct BeamParams {
  double lever_m = 1.0;               ///< hinge to cylinder, > 0
  double inertia_kg_m2 = 60;          ///< about the hinge, > 0
  double damping_Nms_per_rad = 2000;  ///< >= 0
  double hinge_friction_Nm = 0;       ///< >= 0, regularised over 1e-4 rad/s
};

/// What is given of the driven cylinder, or of a part on a bench (position or force). Of rigs with
/// one cylinder force and pressure are for phs rig.
enum class Drive { kPosition, kForce, kPressure };

struct RigOptions {
  Drive driven_by = Drive::kPosition;
  double moving_mass_kg = 30;  ///< that a force drives, > 0: a piston with its rod and eye
  int actuators = 2;           ///< of the full rig: 2 and a beam, or 4
  int substeps = 1;  ///< integration steps per sample (1 … 1000); more where a line rings
  /// Of a ringing line, unless more are asked for; none for one that needs three times as many.
  int most_substeps = 8;
  BeamParams beam = {};  ///< full rig only
  /// Further measured channels of the record; null: none.
  std::shared_ptr<const hydraulics::ExtraSeries> extra = {};
};

/// What drives the rig: one row per driven actuator, samples at t0 + i step.
struct RigMotion {
  double t0_s = 0;
  double step_s = 0;  ///< > 0
  /// [input][sample], as RigModel::input_names(): positions [m]; a driving force [N]; behind the
  /// position given pressures [Pa].
  std::vector<std::vector<double>> position_m = {};
  std::vector<std::vector<double>> speed_m_s = {};  ///< same shape; empty: central differences
  /// Same shape [m/s2]; empty: central differences of the speed, which take sin(w T)/(w T) of it.
  std::vector<std::vector<double>> acceleration_m_s2 = {};
  std::vector<double> pressure_Pa = {};    ///< element rig: side channel; else empty
  std::vector<double> temperature_K = {};  ///< element rig: side channel; else empty
  int num_samples() const {
    return position_m.empty() ? 0 : static_cast<int>(position_m[0].size());
  }
};

/// Predicted channels; [channel][sample]. Reused between runs without reallocation.
struct RigPrediction {
  std::vector<std::vector<double>> channels;
};

/// What runs of models that differ in the rest alone have in common; see KeptOf.
struct KeptRun {
  /// Chamber pressures of a cylinder on rigid mountings [Pa], at the start of every step of its
  /// integration: they follow from motion and oil alone.
  std::vector<double> bore, rod;
  /// Where friction acts back on the pressures: all channels as they are before the instruments.
  std::vector<std::vector<double>> channels;
  size_t num_numbers() const {
    return bore.size() + rod.size() + (channels.empty() ? 0 : channels.size() * channels[0].size());
  }
};

/// Speeds by central differences (one-sided at the ends).
std::vector<double> DifferentiateMotion(const std::vector<double>& position, double step_s);
/// Of the first actuator; `speed` counts where the motion has no acceleration of its own.
std::vector<double> AccelerationOf(const RigMotion& motion, const std::vector<double>& speed);

}  // namespace phs::rigs
