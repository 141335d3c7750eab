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
#include "hydraulics/phs_params.h"

namespace phs::hydraulics {

/// How the memory of a VolumeLaw moves: dm/dt = rate(p, m).
struct MemoryRate {
  double rate = 0;         ///< [1/s]
  double rate_slope = 0;   ///< d(rate)/dm [1/s], <= 0
  double rate_rise = 0;    ///< d(rate)/dp [1/(s Pa)]
  double volume_rise = 0;  ///< dV/dm at constant pressure [m3]
};

/// Volume taken up above the static state at pressure p: Volume(p0) = 0, rising with p (passive).
/// A law may have a memory m, one number that follows the pressure with a lag (creep, dissolving
/// gas): 0 in the static state, of the order of one.
class VolumeLaw {
 public:
  virtual ~VolumeLaw() = default;
  /// `volume` [m3] and `slope` dV/dp [m3/Pa] >= 0 at constant memory are added to.
  virtual void Add(double pressure, double memory, double* volume,
                   double* slope) const noexcept = 0;
  /// Integral of p dV from the static state, less what was lost on the way [J].
  virtual double Energy(double pressure, double memory) const noexcept = 0;
  /// Name of the memory among the states, "creep"; empty = none.
  virtual std::string MemoryName() const { return {}; }
  virtual MemoryRate Memory(double /*pressure*/, double /*memory*/) const noexcept { return {}; }
  /// Available power lost by the memory's moving [W], >= 0.
  virtual double Loss(double /*pressure*/, double /*memory*/) const noexcept { return 0; }
};

/// Flow through an opening or pipe: rises with the pressure difference, Flow(0) = 0 (passive).
class FlowLaw {
 public:
  virtual ~FlowLaw() = default;
  /// Volume flow [m3/s] from the high to the low side at p_from - p_to = `dp` [Pa]; `slope` =
  /// d/d(dp).
  virtual double Flow(double time, double dp, double* slope) const noexcept = 0;
  /// Inverse: pressure drop [Pa] at `flow`, and its slope. Needed only with an inertance.
  virtual double Drop(double time, double flow, double* slope) const noexcept = 0;
  /// rho l / A [kg/m4]; 0 = the flow follows the pressure at once.
  virtual double Inertance() const noexcept { return 0; }
  /// True where the drop is the smoother of the two sides (turbulent flow: q ~ sqrt(dp), steep at
  /// zero), so that a step is solved for the flow: Newton on dp = Drop(q) does not circle about
  /// zero.
  virtual bool SolvedByDrop() const noexcept { return false; }
};

/// Where a flow law begins and ends.
enum class Port { kBore, kRod, kLine, kAtmosphere };

/// What a further force of a cylinder (or of a part on a bench) may depend on.
struct ForcePlace {
  double time = 0;         ///< [s]
  double piston = 0;       ///< y [m]
  double speed = 0;        ///< [m/s]
  double direction = 0;    ///< friction's own, -1 … 1: turns over its presliding or ramp
  double bore_rise = 0;    ///< p_bore above static [Pa]; element bench: the pressure itself
  double rod_rise = 0;     ///< p_rod above static [Pa]
  double temperature = 0;  ///< above the model's [K]
};

/// A force beside friction, F > 0 tension.
class ForceLaw {
 public:
  virtual ~ForceLaw() = default;
  virtual double Force(const ForcePlace& place) const noexcept = 0;
};

/// What a sensor shows beyond the truth, in the unit of its channel; of `place` time, piston and
/// pressures are set.
class ReadingLaw {
 public:
  virtual ~ReadingLaw() = default;
  virtual double Error(const ForcePlace& place) const noexcept = 0;
};

/// A part on a bench, beyond its declared ElementParams.
///   o--[ m ]--+--[ k ]--+--[ m_f ]     m_f part of the mass behind a spring and a damper:
///      x      +--[ c ]--+      y       m_f y" = k (x - y) + c (x' - y'),  f² = k/m_f/(2 pi)²
struct ElementTerms {
  double pressure_area_m2 = 0;
  double mass_kg = 0;
  double flexible_mass_kg = 0;
  double flexible_Hz = 0;       ///< natural frequency f with the drive held
  double flexible_damping = 0;  ///< c / (2 sqrt(k m_f))
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

/// Elements in series between mounting and piston: play, spring, spring with Maxwell branches.
/// Spring force k e (1 + b e²), times `tension_ratio` for e > 0.
struct MountTerms {
  static constexpr int kBranches = 2;
  bool present = false;
  double gap_m = 0;                ///< total free play
  double gap_tension_share = 0.5;  ///< of it that is crossed before tension, from rest, 0 … 1
  double stiffness_N_per_m = 0;    ///< series spring; 0 = the contact stiffness below only
  double hardening_1_per_m2 = 0;   ///< b >= 0
  double tension_ratio = 1;        ///< stiffness in tension over that in compression, > 0
  /// Parallel branches of a bush.
  double maxwell_stiffness_N_per_m[kBranches] = {0, 0};
  double maxwell_damping_Ns_per_m[kBranches] = {0, 0};
  bool HasBranch(int k) const { return maxwell_stiffness_N_per_m[k] > 0; }
  /// e: what of actuator minus piston `u` is beyond the play [m].
  double PlayFree(double u) const {
    const double tension = gap_tension_share * gap_m, compression = gap_m - tension;
    return u > tension ? u - tension : (u < -compression ? u + compression : 0);
  }
  /// Force of the spring [N], tension > 0, and its slope, where `e` is beyond the play.
  double SpringForce(double e, double* slope) const {
    const double k = stiffness_N_per_m * (e > 0 ? tension_ratio : 1);
    const double harder = hardening_1_per_m2 * e * e;
    *slope = k * (1 + 3 * harder);
    return k * e * (1 + harder);
  }
};
/// Stiffness used for a mounting that only has play [N/m].
inline constexpr double kContactStiffness = 2e9;

/// Error of the instruments of one cylinder: shown = gain * true(t - delay) + offset + drift * t,
/// or drift T (1 - exp(-t/T)) for a drift that settles with the time T, its t counted from
/// `start_s` on; plus a slow wave wave_sine sin(2 pi t/P) + wave_cosine (cos(2 pi t/P) - 1).
struct InstrumentTerms {
  struct Channel {
    double gain = 1, offset = 0, drift_per_s = 0, delay_s = 0;
    double wave_sine = 0, wave_cosine = 0;
    std::shared_ptr<const ReadingLaw> further;  ///< none if empty
  };
  Channel load, p_bore, p_rod, piston;
  double start_s = 0;     ///< no drift before
  double settling_s = 0;  ///< T; 0 = never settles
  double period_s = 100;  ///< P
  bool present = false;
};

/// Temperature of surroundings and oil: static + ramp up to `limit` + amplitude sin(2 pi t/period);
/// ramp: rate t, or rate T_s (1 - exp(-t/T_s)) for one that settles with the time T_s; its t is
/// counted from `start_s` on.
struct TemperatureTerms {
  bool present = false;
  double rate_K_per_s = 0;
  double start_s = 0;     ///< no ramp before
  double settling_s = 0;  ///< T_s; 0 = never settles
  double amplitude_K = 0, period_s = 86400;
  double limit_K = 40;           ///< |rate t| stays below this
  double expansion_1_per_K = 0;  ///< of the oil against its housing
  double softening_1_per_K = 0;  ///< relative fall of the oil's bulk modulus
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
  virtual MountTerms& mount(int cylinder) = 0;
  virtual InstrumentTerms& instrument(int cylinder) = 0;
  virtual TemperatureTerms& temperature() = 0;
  virtual ElementTerms& element() = 0;
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
