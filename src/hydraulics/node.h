// One pressure: the volume balance of a line (or of a part of it behind a resistance).
//
//   D = V_oil (p - p0)/beta + [V_g0 - V_g(p, T)] + [V_acc - V_a(p, T)] + air (1/p0 - 1/p)
//       + laws(p)
//
// D: oil volume pushed in since the static state [m3]. Every term rises with p, so p(D) is unique;
// it is found from a closed form (exact for isothermal and ideal gas on plain oil) or, from there,
// by Newton's method inside a bracket. A trace of free air is always present: it keeps p > 0
// however far the volume is pulled, which is the cavitation floor of the declared model.
#pragma once

#include <cmath>
#include <vector>

#include "hydraulics/gas_law.h"
#include "hydraulics/oil_compression.h"
#include "hydraulics/oil_laws.h"

namespace phs::hydraulics {

/// Free air always assumed, as a share of the oil volume at atmospheric pressure.
inline constexpr double kTraceAir = 1e-6;

/// Gas volumes of a node: three parts each of a reservoir and of an accumulator.
inline constexpr int kMostGases = 8;

/// A compiled gas volume of a node.
struct NodeGas {
  GasVolume gas;
  double static_volume = 0;  ///< gas volume in the static state [m3]
  bool blow_off = false;     ///< an accumulator: closed below its precharge
  double boyle = 0;          ///< p V at the reference temperature [J]; set by Prepare
  double boyle_at_p0 = 0;    ///< its volume at the static pressure [m3]; set by Prepare
  int state = -1;            ///< index of its temperature state, or -1
  int wall_state = -1;       ///< of the state of its wall's temperature, or -1
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
  double p0 = 0;           ///< static pressure [Pa]
  double oil_volume = 0;   ///< [m3]
  OilStiffness oil = {};   ///< its bulk modulus
  double softening = 0;    ///< relative fall of beta per kelvin of the surroundings [1/K]
  double expansion = 0;    ///< of the oil against its housing [1/K]
  double air = 0;          ///< p V of free air [J]
  double temperature = 0;  ///< static [K]
  std::vector<NodeGas> gases;
  std::vector<NodeLaw> laws;
  bool sequential = false;
  double law_compliance = 0;  ///< of the laws at p0 [m3/Pa], for the guess; set by Prepare
  double air_at_p0 = 0;       ///< volume of the free air at p0 [m3]; set by Prepare
  double oil_compliance = 0;  ///< V_oil/beta [m3/Pa]; set by Prepare
  bool closed_form = false;   ///< set by Prepare
  bool plain = false;         ///< set by Prepare: closed_form, no gas has a temperature of its own
  bool real_gas = false;      ///< set by Prepare: the first gas is a reservoir by density

  void Prepare();
  /// Factor on the oil's compliance at a temperature of the surroundings: exp(s dT), > 0.
  double Softer(double ambient) const {
    return softening == 0 ? 1 : std::exp(softening * (ambient - temperature));
  }
  /// V_oil/beta [m3/Pa].
  double Compliance(double ambient) const { return oil_compliance * Softer(ambient); }
};

/// Pressure and the state of the elements at it.
struct NodeState {
  double p = 0;           ///< [Pa]
  double slope = 0;       ///< dD/dp at constant temperatures [m3/Pa], > 0
  double pushed = 0;      ///< the D it was solved for [m3]
  double gas_volume = 0;  ///< of a real-gas reservoir as just solved [m3]; 0 = not known
};

/// Temperature of a node's gas: its own state, or the surroundings'.
inline double GasTemperature(const NodeGas& g, double ambient, const double* state) {
  return g.state >= 0 && state != nullptr ? g.gas.reference_temperature + state[g.state] : ambient;
}

/// Temperature of what the gas gives its heat to: its wall's own state, or the surroundings'.
inline double WallTemperature(const NodeGas& g, double ambient, const double* state) {
  return g.wall_state >= 0 && state != nullptr ? g.gas.reference_temperature + state[g.wall_state]
                                               : ambient;
}

}  // namespace phs::hydraulics
