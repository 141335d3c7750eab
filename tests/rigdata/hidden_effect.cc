#include "hidden_effect.h"

#include <algorithm>
#include <stdexcept>

namespace rigdata {

const std::vector<std::string>& ListedNames() {
  static const std::vector<std::string> names = {
      "piston_leakage",        "external_leakage",  "line_resistance",
      "line_inertance",        "check_restriction", "entrained_air",
      "hose_expansion",        "gas_thermal",       "cavitation",
      "accumulator_precharge", "stribeck",          "presliding",
      "pressure_friction",     "position_friction", "dwell_friction",
      "viscous_friction",      "backlash",          "mount_compliance",
      "bush_viscoelastic",     "sensor_offset",     "sensor_drift",
      "sensor_delay",          "sensor_gain",       "temperature_drift",
      "asymmetric_friction",   "diaphragm_stop"};
  return names;
}

const std::vector<std::string>& OffListNames() {
  static const std::vector<std::string> names = {
      "piston_area_error",    "friction_heating",      "actuator_ripple", "cogging_force",
      "relief_valve",         "acceleration_friction", "seal_swelling",   "pressure_crosstalk",
      "load_cell_hysteresis", "load_cell_curvature",   "oil_stiffening"};
  return names;
}

bool IsKnownEffect(const std::string& name) {
  const auto in = [&](const std::vector<std::string>& list) {
    return std::find(list.begin(), list.end(), name) != list.end();
  };
  return in(ListedNames()) || in(OffListNames());
}

HiddenEffect DrawEffect(const std::string& name, RandomSource random) {
  for (const auto draw : {DrawHydraulic, DrawFriction, DrawMounting, DrawInstrument, DrawOffList}) {
    RandomSource own = random;
    HiddenEffect effect = draw(name, own);
    if (effect.apply) {
      effect.name = name;
      return effect;
    }
  }
  throw std::logic_error("no such effect: " + name);
}

}  // namespace rigdata
