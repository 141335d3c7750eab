// Parameters of a Passive Hydraulic Steering as plain data: cylinders, lines, friction, effects.
// Read from files, written and changed by name in src/phs_model.
//
// Signs: piston displacement x > 0 = extension from the static position; tension force > 0; oil
// flow into a chamber > 0. Pressures absolute. SI throughout.
//
//        bore side (1)        rod side (2)
//      +--------------+==+---------------+
//   o--|   p_bore     |  |   p_rod  =====|=====--o      F = p_rod A_rod - p_bore A_bore + friction
//      +--------------+==+---------------+              x > 0: the two eyes move apart
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "hydraulics/gas_law.h"

namespace phs::hydraulics {

/// Elastic end stop with a soft start: F = k s²/(2 d) for penetration s < d, k (s - d/2) beyond,
/// and damping c min(s/d, 1) v, never pulling.
struct EndStopParams {
  double clearance_m = 0.03;       ///< free stroke to each side, (0, 1]
  double stiffness_N_per_m = 1e8;  ///< > 0
  double damping_Ns_per_m = 1e5;   ///< >= 0
  double transition_m = 1e-3;      ///< d, > 0
  bool operator==(const EndStopParams&) const = default;
};

struct CylinderParams {
  std::string name;
  std::string bore_line;  ///< line of the bore chamber; empty: open to atmosphere
  std::string rod_line;   ///< line of the rod chamber; empty: open to atmosphere
  double bore_m = 0.100;  ///< bore diameter
  double rod_m = 0.032;   ///< rod diameter, < bore_m
  EndStopParams end_stop;

  double BoreArea() const { return M_PI / 4 * bore_m * bore_m; }                   ///< [m2]
  double RodArea() const { return M_PI / 4 * (bore_m * bore_m - rod_m * rod_m); }  ///< [m2]
  bool operator==(const CylinderParams&) const = default;
};

/// A diaphragm reservoir (or a bladder accumulator): one gas volume behind a separator.
struct GasChargeParams {
  const GasLaw* law = &kIsothermalGas;
  double volume_m3 = 0;  ///< shell volume: gas volume when empty of oil; 0 = absent
  double polytropic_exponent = 1.4;
  double thermal_time_s = 5.0;  ///< tau of the energy equation
  /// (gas + filler) / gas, >= 1: set by the effect gas_thermal.
  double heat_capacity_ratio = 1.0;
  double wall_heat_ratio = 0;    ///< of the gas over its wall; set by gas_thermal
  double density_exponent = 0;   ///< of the time constant; set by gas_thermal
  double wall_time_s = 60.0;     ///< of the wall with its surroundings; set by gas_thermal
  double min_gas_volume_m3 = 0;  ///< diaphragm on its stop
  /// Diaphragm on its oil port; 0: at the shell's volume; set by diaphragm_stop.
  double port_gas_volume_m3 = 0;
  /// Standard deviation of both over the parts of a diaphragm that come to rest one after the
  /// other, relative to their mean; set by diaphragm_stop.
  double stop_spread = 0;
  double stop_share = 1;  ///< of the gas that the stop holds; set by diaphragm_stop
  bool operator==(const GasChargeParams&) const = default;
};

/// All oil and gas that share one pressure.
struct LineParams {
  std::string name;
  double static_pressure_Pa = 2.0e6;  ///< p0
  double oil_volume_m3 = 1.1e-3;      ///< V_oil, > 0
  double bulk_modulus_Pa = 1.4e9;     ///< beta at static pressure, > 0
  double bulk_modulus_slope = 0;      ///< d(beta)/dp [-], 0 … 20
  /// beta rises by R over P and then no more (oil_compression.h) [Pa]: of an effect alone.
  double bulk_modulus_rise_Pa = 0, bulk_modulus_over_Pa = 0;
  double free_air_m3 = 0;    ///< undissolved air, as a volume at 101325 Pa
  double gas_volume_m3 = 0;  ///< V_g0 of the reservoir at static pressure; 0 = no gas
  GasChargeParams reservoir;
  GasChargeParams accumulator;  ///< blow-off accumulator; volume_m3 = 0: none
  double accumulator_precharge_Pa = 15e6;
  /// Standard deviation of the precharge over the parts of an accumulator that lift off one after
  /// the other; set by accumulator_precharge.
  double accumulator_spread_Pa = 0;
  double expansion_1_per_K = 0;  ///< of its oil against the housing; set by temperature_drift
  double temperature_K = 0;      ///< of its oil and gas at the start; 0: the model's
  double softening_1_per_K = 0;  ///< relative fall of its bulk modulus; set by temperature_drift
  bool operator==(const LineParams&) const = default;
};

enum class FrictionModel { kNone, kStatic, kPresliding };
enum class FrictionCurve { kTable, kCoulomb };

/// Friction of one cylinder: a curve of level over speed and a model of how the level is reached.
/// Levels resist motion; extension (v > 0) and retraction have their own.
struct FrictionParams {
  FrictionModel model = FrictionModel::kPresliding;
  FrictionCurve curve = FrictionCurve::kTable;
  double scale = 1.0;  ///< multiplies every level, >= 0
  /// Table: speed [m/s], rising, with one point (0, 0); force [N] with the sign of the speed.
  /// Linear between points, last segment continued.
  std::vector<double> speed_m_s = {-0.05, -0.01, -0.001, -0.0002, 0, 0.0002, 0.001, 0.01, 0.05};
  std::vector<double> force_N = {-1900, -1700, -1600, -1500, 0, 1700, 1850, 1950, 2150};
  /// Coulomb + Stribeck + viscous: level = coulomb + (breakaway - coulomb) exp(-|v|/v_s) + c |v|.
  double coulomb_extension_N = 1850, coulomb_retraction_N = 1600;
  double breakaway_extension_N = 1850, breakaway_retraction_N = 1600;
  double stribeck_speed_m_s = 1e-3;
  double viscous_extension_Ns_per_m = 4000, viscous_retraction_Ns_per_m = 4000;
  double ramp_speed_m_s = 2e-4;  ///< static model: level reached at this speed, > 0
  /// Presliding (elasto-plastic, friction.h).
  double stiffness_N_per_m = 3.6e7;  ///< sigma0, > 0
  double damping_Ns_per_m = 2e3;     ///< sigma1, >= 0
  double breakaway_ratio = 0.7;      ///< purely elastic below this share of the level, [0, 0.99]
  bool operator==(const FrictionParams&) const = default;
};

/// A part on a bench moved by prescribed motion (equation: rigs/element_bench.h).
struct ElementParams {
  double mass_kg = 0;
  double stiffness_N_per_m = 0;
  double hardening_N_per_m3 = 0;
  double damping_Ns_per_m = 0;
  double quadratic_damping_Ns2_per_m2 = 0;
  double gas_force_N = 0;       ///< absolute pressure at x = 0 times its area; 0: none
  double gas_length_m = 0.1;    ///< volume at x = 0 over area, not 0; > 0: x > 0 compresses
  double gas_exponent = 1;      ///< 1 isothermal … 1.4 adiabatic
  double pressure_area_m2 = 0;  ///< on which the bench's pressure channel acts
  double offset_N = 0;
  bool operator==(const ElementParams&) const = default;
};

/// One effect of the catalogue (src/effects) with its parameters by name. `targets`: names of
/// cylinders or lines it acts on; empty = all.
struct EffectParams {
  std::string name;
  std::vector<std::string> targets;
  std::map<std::string, double> values;
  std::string formula = {};  ///< effect `unlisted` only: its law (effects/formula.h)
  bool operator==(const EffectParams&) const = default;
};

/// How line pressures follow from volumes.
enum class BalanceMethod {
  kUnified,     ///< all elements share the pressure (physics of one line); the default
  kSequential,  ///< the thesis's procedure (its Figs 6-7, 7-4): reservoir until full, then oil,
                ///< then accumulator
};

struct PhsParams {
  std::string name;
  std::string description;
  std::string source;
  double temperature_K = 293.15;  ///< static temperature of oil, gas and surroundings
  double filled_at_K = 0;         ///< temperature at which the lines were filled; 0: temperature_K
  double oil_expansion_1_per_K = 6.65e-4;  ///< of the oil against its housing, after filling
  BalanceMethod balance = BalanceMethod::kUnified;
  std::vector<CylinderParams> cylinders;
  std::vector<LineParams> lines;
  FrictionParams friction;
  ElementParams element;
  std::vector<EffectParams> effects;
  /// Several measured runs fitted as one: what each has for itself, "run2.L1.gas_volume_m3".
  std::map<std::string, double> of_runs;

  double FilledAt() const { return filled_at_K > 0 ? filled_at_K : temperature_K; }
  int FindLine(const std::string& line) const;          ///< -1 if absent
  int FindCylinder(const std::string& cylinder) const;  ///< -1 if absent
  bool operator==(const PhsParams&) const = default;
};

}  // namespace phs::hydraulics
