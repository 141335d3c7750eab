// Gas of a reservoir or accumulator: one interface for all gas laws: V(p, T), its slopes, and the
// energy and the heat balance that belong to it. The laws are the rows of gas_laws.cc.
//
// A law without a temperature of its own takes the temperature T_s of the surroundings. One with it
// has the state T:
//   dT/dt = (T_s - T)/tau - T (dp/dT)_V (dV/dt)/(m c_v)
// With a wall that takes up heat, T_w stands for T_s above, and
//   dT_w/dt = r (c_v/c_v0) (T - T_w)/tau + (T_s - T_w)/tau_w,   r = m c_v0/C_w
// (heat balance of a wall of heat capacity C_w; r = 0: it stays at T_s).
// Denser gas gives its heat off faster by free convection: tau = tau_0 (rho_0/rho)^m, m = 0 a
// constant, 1/2 laminar, 2/3 turbulent (Nu ~ Gr^(m/2), Gr ~ rho²; measured by A. Pourmovahed and
// D. R. Otis, J. Dyn. Syst. Meas. Control 112 (1990) 116).
// p absolute [Pa], V [m3], T [K], tau thermal time constant at constant volume [s].
// Source: T. P. Löwe, M.Eng. thesis, University of Pretoria, eqs. 12-19, constants corrected (see
// bwr_nitrogen.h); D. R. Otis and P. E. Pourmovahed, J. Dyn. Syst. Meas. Control 107 (1985) 116.
#pragma once

#include <string>
#include <vector>

namespace phs::hydraulics {

/// Nitrogen as an ideal gas.
inline constexpr double kNitrogenR = 296.797;    ///< specific gas constant [J/(kg K)]
inline constexpr double kNitrogenCv = 742.2;     ///< isochoric heat capacity at 300 K [J/(kg K)]
inline constexpr double kAtmosphere = 101325.0;  ///< [Pa]

struct GasVolume;

/// V(p, T) with its slopes. `stopped`: the diaphragm rests on a stop, V does not change with p, T.
struct GasState {
  double volume = 0;  ///< [m3]
  double dV_dp = 0;   ///< [m3/Pa], <= 0
  double dV_dT = 0;   ///< [m3/K], >= 0
  bool stopped = false;
};

/// What the heat balance needs of a gas at V and T.
struct GasCapacity {
  double cv = 0;     ///< isochoric heat capacity [J/(kg K)]
  double dp_dT = 0;  ///< at constant volume [Pa/K]
};

/// Pressure where it is explicit in the density.
struct GasPressure {
  double p = 0;        ///< [Pa]
  double dp_drho = 0;  ///< [Pa m3/kg]
};

/// One gas law: its formulas. V > 0, p > 0, T as CalcGas and its like give it.
struct GasLaw {
  const char* name;
  const char* text;  ///< what it is, for the docs
  /// p V = p0 V0 T/T0: the balance of a node has a closed form.
  bool follows_boyle;
  /// Density at the reference state [kg/m3].
  double (*density)(double pressure, double T);
  /// Volume without stops, with its slopes. `solved_volume`: the volume where it is known already,
  /// so that its root need not be sought again; 0 = not known.
  GasState (*volume)(const GasVolume& gas, double pressure, double T, double solved_volume);
  double (*pressure)(const GasVolume& gas, double volume, double T);  ///< [Pa]
  /// CalcGasEnergy without what a filler stores.
  double (*energy)(const GasVolume& gas, double volume, double T, double ambient);
  /// Null: no temperature of its own.
  GasCapacity (*capacity)(const GasVolume& gas, double volume, double T) = nullptr;
  /// Null: the volume is explicit in the pressure. Otherwise V(p, T) is a root, and a node with one
  /// such reservoir is solved for the density.
  GasPressure (*of_density)(double density, double T) = nullptr;
};

/// All of them. Names, messages and the docs follow from these rows.
const std::vector<const GasLaw*>& GasLaws();
std::vector<std::string> GasLawNames();
/// @pre a name of GasLawNames().
const GasLaw* FindGasLaw(const std::string& name);
extern const GasLaw kIsothermalGas;  ///< (perfect_gas.h) where nothing else is asked for

/// A closed amount of gas, fixed by its volume at a reference pressure and temperature.
/// Volumes are clamped to [min_volume, max_volume]: the diaphragm or bladder at its stop.
struct GasVolume {
  const GasLaw* law = &kIsothermalGas;
  double reference_volume = 0;       ///< V0 [m3], > 0
  double reference_pressure = 0;     ///< p0 [Pa], > 0
  double reference_temperature = 0;  ///< T0 [K]
  double exponent = 1.4;             ///< n of the polytropic law, 1 … 1.7
  double thermal_time = 5;           ///< tau [s], > 0
  double heat_capacity_ratio = 1;    ///< (gas + filler that stores heat with it) / nitrogen, >= 0.5
  double wall_heat_ratio = 0;        ///< r: heat capacity of the gas over its wall's; 0 = no wall
  double wall_time = 0;              ///< tau_w [s], > 0 with a wall
  double density_exponent = 0;       ///< m
  double min_volume = 0;             ///< [m3]
  double max_volume = 0;             ///< [m3]
  double mass = 0;                   ///< [kg]; set by SetMass

  /// Fills `mass` from the reference state by the volume's own law.
  void SetMass();
  bool HasTemperatureState() const { return law->capacity != nullptr; }
  bool HasWallState() const { return HasTemperatureState() && wall_heat_ratio > 0; }
};

/// `temperature`: of the gas for the laws with a state, of the surroundings for the others.
/// `solved_volume`: the real gas's volume where it is known already; 0 = not known.
GasState CalcGas(const GasVolume& gas, double pressure, double temperature,
                 double solved_volume = 0);

/// Unclamped p(V, T) of the same law [Pa].
double CalcGasPressure(const GasVolume& gas, double volume, double temperature);

/// Energy stored above the reference state that can be won back against surroundings of
/// temperature `ambient` [J]: -∫p dV for the laws without a state, the exergy
/// U - U0 - T_s (S - S0) for those with one. Its rate is -p dV/dt - CalcGasLoss.
double CalcGasEnergy(const GasVolume& gas, double volume, double temperature, double ambient);

/// Heat balance of a law with a state: dT/dt = relax - kappa dV/dt.
struct GasHeat {
  double relax = 0;  ///< (T_w - T)/tau [K/s]
  double time = 0;   ///< tau at this density [s]
  double kappa = 0;  ///< T (dp/dT)_v / (m c_v) [K/m3], > 0
  /// Available power destroyed by the heat flows, T_s Q (1/T_w - 1/T) + C_w (T_w-T_s)^2/(tau_w T_w)
  /// [W].
  double loss = 0;
  double wall_rate = 0;   ///< dT_w/dt [K/s]
  double wall_slope = 0;  ///< its derivative over T_w [1/s], <= 0
  double wall_taken = 0;  ///< and over T [1/s], >= 0
};
/// `wall`: T_w; `ambient` where there is no wall [K].
GasHeat CalcGasHeat(const GasVolume& gas, double volume, double temperature, double wall,
                    double ambient);
/// Exergy of the wall's heat above the reference temperature [J].
double CalcWallEnergy(const GasVolume& gas, double wall, double ambient);

}  // namespace phs::hydraulics
