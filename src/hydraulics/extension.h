// How effects enter a PHS without the core knowing them. An effect is a row of an EffectTable: its
// parameters and an Install function that adds laws to the places below. The core calls only laws
// that are present, so a model without effects pays nothing.
//
//   volume   VolumeLaw at a line: takes up volume as pressure rises (air, hoses)
//   flow     FlowLaw between two pressures: leakage, resistance; with inertance a state of its own
//   friction numbers of FrictionTerms: how the level depends on speed, pressure, place, rest time
//   mounting numbers of MountTerms: what lies between mounting and piston
//   instrument and environment: InstrumentTerms (predicted channels of a rig), temperature over
//   time
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "hydraulics/force_place.h"
#include "hydraulics/load_law.h"
#include "hydraulics/mount_law.h"
#include "hydraulics/oil_laws.h"
#include "hydraulics/phs_params.h"
#include "hydraulics/reading_law.h"

namespace phs::hydraulics {

/// Where a flow law begins and ends.
enum class Port { kBore, kRod, kLine, kAtmosphere };

/// A force beside friction, F > 0 tension.
class ForceLaw {
 public:
  virtual ~ForceLaw() = default;
  virtual double Force(const ForcePlace& place) const noexcept = 0;
};

/// Friction level of one cylinder beyond its curve. level(v, …) = curve(v)
///   * (1 + position_slope y + position_curvature y² + spot exp(-((y - centre)/width)²)
///        + wave_sine sin(2 pi y/wave_length) + wave_cosine (cos(2 pi y/wave_length) - 1))
///     (kept >= 0)
///   + stribeck_extra exp(-(|v|/stribeck_speed)^exponent) + dwell_extra * phi + pressure terms
///   + level_shift (extension) or - level_shift (retraction),
/// all times 1 - temperature_slope (T - T_static), kept >= 0,
/// plus viscous force c v |v/1 cm/s|^(viscous_exponent - 1) and a further force (effect
/// `unlisted`). Pressure terms: k_bore, k_rod times the chamber's rise and k_difference times the
/// rise of |p_bore - p_rod|; in retraction pressure_retraction_ratio times their sum.
/// phi: dwell state, dphi/dt = (1 - phi)/dwell_time - phi |v|/dwell_length.
struct FrictionTerms {
  double stribeck_extra_extension_N = 0, stribeck_extra_retraction_N = 0;
  double stribeck_speed_m_s = 1e-3, stribeck_exponent = 1;
  double viscous_extension_Ns_per_m = 0, viscous_retraction_Ns_per_m = 0;
  double viscous_exponent = 1;
  double pressure_bore_N_per_Pa = 0, pressure_rod_N_per_Pa = 0;  ///< times p - p0 of the chamber
  double pressure_difference_N_per_Pa = 0;
  double pressure_retraction_ratio = 1;  ///< of the pressure terms in retraction, >= 0
  double static_difference_Pa = 0;       ///< p_bore - p_rod at rest; set by the core
  double level_shift_N = 0;
  double position_slope_1_per_m = 0, position_curvature_1_per_m2 = 0;
  double spot_share = 0, spot_centre_m = 0, spot_width_m = 1e-3;
  double wave_sine = 0, wave_cosine = 0, wave_length_m = 1e-3;
  double temperature_slope_1_per_K = 0;
  std::shared_ptr<const ForceLaw> further;  ///< none if empty
  double dwell_extra_N = 0, dwell_time_s = 1, dwell_length_m = 1e-4;
  bool presliding = false;  ///< forces the presliding model with the numbers below
  double presliding_stiffness_N_per_m = 0, presliding_breakaway_ratio = 0;
  bool presliding_creeps = false;  ///< the bristle of Dahl and LuGre instead of the elasto-plastic
  double presliding_exponent = 1;  ///< i of the creeping bristle, > 0
  double presliding_share = 1;     ///< of the level that sticks; the rest slides at once
};

/// What an effect may add to while a system is being built.
class Extension {
 public:
  virtual ~Extension() = default;
  virtual const PhsParams& params() const = 0;
  virtual void AddVolume(int line, std::unique_ptr<VolumeLaw> law) = 0;
  /// Between two ports of a cylinder (kBore, kRod of `cylinder`), a line (`line`) or atmosphere.
  virtual void AddFlow(Port from, Port to, int cylinder, int line, const std::string& name,
                       std::unique_ptr<FlowLaw> law) = 0;
  /// Puts `law` between the chamber (kBore or kRod) of `cylinder` and its line. `share` of the
  /// line's oil volume moves to the chamber side (0.02 … 0.98).
  virtual void SplitChamber(Port chamber, int cylinder, double share, const std::string& name,
                            std::unique_ptr<FlowLaw> law) = 0;
  virtual FrictionTerms& friction(int cylinder) = 0;
  virtual void AddMount(int cylinder, std::unique_ptr<const MountLaw> law) = 0;
  virtual void AddReading(int cylinder, Sensor sensor, std::unique_ptr<const ReadingLaw> law) = 0;
  /// At the driven end of a bench or rig.
  virtual void AddLoad(std::unique_ptr<const LoadLaw> law) = 0;
  virtual void AddAmbient(std::unique_ptr<const AmbientLaw> law) = 0;
  /// Line parameters may still be changed (precharge, gas law): laws are compiled afterwards.
  virtual LineParams& line(int index) = 0;
};

/// One parameter of an effect.
struct EffectParameter {
  std::string name;  ///< with unit suffix, "gap_m"
  std::string unit;
  double otherwise;  ///< default
  double min, max;   ///< allowed
  double low, high;  ///< plausible
  std::string text;
};

/// One row of the catalogue.
struct EffectInfo {
  std::string name;
  std::string family;   ///< hydraulic, friction, mounting, instrument, environment
  std::string targets;  ///< "cylinders", "lines", "cylinders or lines" or "" (whole system)
  std::string text;     ///< the law in one line
  std::vector<EffectParameter> parameters;
  /// Adds the law. `value(name)` of every parameter is in `values`, defaults filled in.
  Status (*install)(const EffectParams& effect, Extension* extension);
  bool has_formula = false;  ///< needs EffectParams::formula
};

/// The catalogue as the core sees it.
class EffectTable {
 public:
  virtual ~EffectTable() = default;
  virtual const std::vector<EffectInfo>& effects() const = 0;
  const EffectInfo* Find(const std::string& name) const;
};

}  // namespace phs::hydraulics
