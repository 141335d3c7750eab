// One pressure: the volume balance of a line (or of a part of it behind a resistance).
//
//   D = (V_oil/beta)(p - p0) + [V_g0 - V_g(p, T)] + [V_acc - V_a(p, T)] + air (1/p0 - 1/p) +
//   laws(p)
//
// D: oil volume pushed in since the static state [m3]. Every term rises with p, so p(D) is unique;
// it is found from a closed form (exact for isothermal and ideal gas on plain oil) or, from there,
// by Newton's method inside a bracket. A trace of free air is always present: it keeps p > 0
// however far the volume is pulled, which is the cavitation floor of the declared model.
#pragma once

#include <vector>

#include "hydraulics/extension.h"
#include "hydraulics/gas_law.h"

namespace phs::hydraulics {

/// Free air always assumed, as a share of the oil volume at atmospheric pressure.
inline constexpr double kTraceAir = 1e-6;

/// A compiled gas volume of a node.
struct NodeGas {
  GasVolume gas;
  double static_volume = 0;  ///< gas volume in the static state [m3]
  bool blow_off = false;     ///< an accumulator: closed below its precharge
  int state = -1;            ///< index of its temperature state, or -1
};

/// A volume law of a node and the state of its memory, if it has one.
struct NodeLaw {
  const VolumeLaw* law = nullptr;
  int state = -1;
  double Memory(const double* states) const {
    return state >= 0 && states != nullptr ? states[state] : 0;
  }
};

struct Node {
  double p0 = 0;            ///< static pressure [Pa]
  double oil_volume = 0;    ///< [m3]
  double bulk_modulus = 0;  ///< [Pa]
  double bulk_slope = 0;    ///< d(beta)/dp [-]
  double air = 0;           ///< p V of free air [J]
  double temperature = 0;   ///< static [K]
  std::vector<NodeGas> gases;
  std::vector<NodeLaw> laws;
  bool sequential = false;
  bool closed_form = false;  ///< set by Prepare
  bool real_gas = false;     ///< set by Prepare: the first gas is a reservoir by BWR

  void Prepare();
};

/// Pressure and the state of the elements at it.
struct NodeState {
  double p = 0;           ///< [Pa]
  double slope = 0;       ///< dD/dp at constant temperatures [m3/Pa], > 0
  double gas_volume = 0;  ///< of a real-gas reservoir as just solved [m3]; 0 = not known
};

/// Solves the balance. `ambient` [K]; `state` = all states (gas temperature deviations) or null.
NodeState SolveNode(const Node& node, double D, double ambient, const double* state) noexcept;
/// The same for a reservoir of real gas, with its density as the unknown: the pressure is explicit
/// in it. False where the diaphragm rests on a stop (then the general solver takes over).
bool SolveRealGasNode(const Node& node, double D, double ambient, const double* state, double guess,
                      NodeState* out) noexcept;
/// Left side of the balance at p: D and its slope.
double CalcAbsorbed(const Node& node, double p, double ambient, const double* state,
                    double* slope) noexcept;
/// Energy stored above the static state [J].
double CalcNodeEnergy(const Node& node, double p, double ambient, const double* state) noexcept;

/// Temperature of a node's gas: its own state, or the surroundings'.
inline double GasTemperature(const NodeGas& g, double ambient, const double* state) {
  return g.state >= 0 && state != nullptr ? g.gas.reference_temperature + state[g.state] : ambient;
}

}  // namespace phs::hydraulics
