#include "hydraulics/phs_numbers.h"

namespace phs::hydraulics {
namespace {

Range Positive(double max) { return {.min = 0, .max = max, .open_min = true}; }
Range Within(double min, double max) { return {.min = min, .max = max}; }
/// Absolute pressures: what is smaller was written in MPa or bar.
Range Pressure() { return Within(1e4, 1e8); }

/// The numbers of a gas behind a separator: `prefix` = "reservoir" or "accumulator".
template <GasChargeParams LineParams::*gas>
void AddGas(const std::string& prefix, const std::string& shell, const std::string& stop,
            std::vector<NumberRow<LineParams>>* rows) {
  const auto add = [&](const char* key, const char* unit, Range allowed, double low, double high,
                       const std::string& text, double& (*of)(LineParams&)) {
    rows->push_back({{prefix + "." + key, unit, allowed, low, high, text}, of});
  };
  add("volume_m3", "m3", Within(0, 1), 0, 5e-3, shell,
      [](LineParams& l) -> double& { return (l.*gas).volume_m3; });
  add("min_gas_volume_m3", "m3", Within(0, 1), 0, 2e-4, stop,
      [](LineParams& l) -> double& { return (l.*gas).min_gas_volume_m3; });
  add("polytropic_exponent", "-", Within(0.9, 2), 1.0, 1.6, "n of the polytropic law",
      [](LineParams& l) -> double& { return (l.*gas).polytropic_exponent; });
  add("thermal_time_s", "s", Positive(1e9), 0.1, 100,
      "time constant of the heat that the gas gives off (`ideal`, `bwr`)",
      [](LineParams& l) -> double& { return (l.*gas).thermal_time_s; });
}

bool ByCoulomb(const PhsParams& p) { return p.friction.curve == FrictionCurve::kCoulomb; }

std::vector<NumberRow<CylinderParams>> CylinderRows() {
  return {
      {{"bore_m", "m", Positive(1), 0.02, 0.3, "bore diameter"},
       [](CylinderParams& c) -> double& { return c.bore_m; }},
      {{"rod_m", "m", Within(0, 1), 0.005, 0.2, "rod diameter, less than `bore_m`"},
       [](CylinderParams& c) -> double& { return c.rod_m; }},
      {{"end_stop.clearance_m", "m", Positive(1), 0.001, 0.1, "free stroke to each side"},
       [](CylinderParams& c) -> double& { return c.end_stop.clearance_m; }},
      {{"end_stop.stiffness_N_per_m", "N/m", Positive(1e12), 1e6, 1e10, "of the stop, k"},
       [](CylinderParams& c) -> double& { return c.end_stop.stiffness_N_per_m; }},
      {{"end_stop.damping_Ns_per_m", "N s/m", Within(0, 1e9), 0, 1e6,
        "of the stop; it never pulls"},
       [](CylinderParams& c) -> double& { return c.end_stop.damping_Ns_per_m; }},
      {{"end_stop.transition_m", "m", Positive(0.1), 1e-4, 1e-2,
        "d: the force is k s²/(2 d) for a penetration s below d, k (s − d/2) beyond"},
       [](CylinderParams& c) -> double& { return c.end_stop.transition_m; }},
  };
}

std::vector<NumberRow<LineParams>> LineRows() {
  std::vector<NumberRow<LineParams>> rows = {
      {{"static_pressure_Pa", "Pa", Pressure(), 1e5, 5e6,
        "pressure the line is filled to, absolute. Bore and rod side of a cylinder balance where "
        "`p_rod A_rod = p_bore A_bore`"},
       [](LineParams& l) -> double& { return l.static_pressure_Pa; }},
      {{"oil_volume_m3", "m3", Positive(1), 2e-4, 5e-3,
        "oil of the line: chambers, pipes, reservoir"},
       [](LineParams& l) -> double& { return l.oil_volume_m3; }},
      {{"bulk_modulus_Pa", "Pa", Within(1e6, 1e11), 0.5e9, 2.2e9,
        "of the oil with pipes and hoses, at the static pressure"},
       [](LineParams& l) -> double& { return l.bulk_modulus_Pa; }},
      {{"bulk_modulus_slope", "-", Within(0, 20), 0, 12,
        "rise of the bulk modulus with pressure; times the static pressure below 0.9 "
        "`bulk_modulus_Pa`"},
       [](LineParams& l) -> double& { return l.bulk_modulus_slope; }},
      {{"free_air_m3", "m3", Within(0, 1), 0, 5e-5,
        "air that is not dissolved, as a volume at 101325 Pa"},
       [](LineParams& l) -> double& { return l.free_air_m3; }},
      {{"gas_volume_m3", "m3", Within(0, 1), 1e-6, 3.2e-4,
        "gas of the reservoir at the static pressure; 0: no gas spring", "reservoir.gas_volume_m3"},
       [](LineParams& l) -> double& { return l.gas_volume_m3; }},
      {{"temperature_K", "K", Within(0, 400), 253, 323,
        "of this line's oil and gas at the start, 200 … 400; 0: the model's. Only with "
        "`filled_at_K`"},
       [](LineParams& l) -> double& { return l.temperature_K; },
       [](const LineParams& l) { return l.temperature_K != 0; }},
      {{"accumulator_precharge_Pa", "Pa", Pressure(), 5e6, 2.5e7,
        "of the blow-off accumulator's gas, absolute: it opens there", "accumulator.precharge_Pa"},
       [](LineParams& l) -> double& { return l.accumulator_precharge_Pa; }},
  };
  AddGas<&LineParams::reservoir>("reservoir", "shell of the reservoir; its gas is never larger",
                                 "the diaphragm stands on its stop there; at most `gas_volume_m3`",
                                 &rows);
  AddGas<&LineParams::accumulator>("accumulator", "shell of the blow-off accumulator; 0: none",
                                   "its bladder stands on its stop there", &rows);
  return rows;
}

std::vector<NumberRow<PhsParams>> WholeRows() {
  const std::string level = "level of fast sliding, curve `coulomb`";
  const std::string breakaway =
      "level at speed zero; level = Coulomb + (breakaway − Coulomb) exp(−v/v_s) + c v";
  return {
      {{"temperature_K", "K", Within(200, 400), 253, 323,
        "static temperature of oil, gas and surroundings; gas volumes and pressures of the file "
        "are stated at `filled_at_K`, where it is not given at this one"},
       [](PhsParams& p) -> double& { return p.temperature_K; }},
      {{"filled_at_K", "K", Within(0, 400), 253, 323,
        "temperature at which the lines were filled and their reservoirs charged, 200 … 400; "
        "pressures, gas and oil then follow to `temperature_K`. 0: filled at `temperature_K`"},
       [](PhsParams& p) -> double& { return p.filled_at_K; },
       [](const PhsParams& p) { return p.filled_at_K != 0; }},
      {{"oil_expansion_1_per_K", "1/K", Within(0, 0.01), 0, 1e-3,
        "of the oil against its housing, from filling to `temperature_K`: mineral oil 7e-4 less "
        "steel 3.5e-5"},
       [](PhsParams& p) -> double& { return p.oil_expansion_1_per_K; },
       [](const PhsParams& p) {
         return p.oil_expansion_1_per_K != PhsParams().oil_expansion_1_per_K;
       }},
      {{"friction.scale", "-", Within(0, 100), 0.2, 3, "multiplies every level"},
       [](PhsParams& p) -> double& { return p.friction.scale; }},
      {{"friction.coulomb_extension_N", "N", Within(0, 1e6), 0, 6000, level},
       [](PhsParams& p) -> double& { return p.friction.coulomb_extension_N; },
       &ByCoulomb},
      {{"friction.coulomb_retraction_N", "N", Within(0, 1e6), 0, 6000, level},
       [](PhsParams& p) -> double& { return p.friction.coulomb_retraction_N; },
       &ByCoulomb},
      {{"friction.breakaway_extension_N", "N", Within(0, 1e6), 0, 9000, breakaway},
       [](PhsParams& p) -> double& { return p.friction.breakaway_extension_N; },
       &ByCoulomb},
      {{"friction.breakaway_retraction_N", "N", Within(0, 1e6), 0, 9000, breakaway},
       [](PhsParams& p) -> double& { return p.friction.breakaway_retraction_N; },
       &ByCoulomb},
      {{"friction.stribeck_speed_m_s", "m/s", Positive(10), 1e-5, 0.1, "v_s"},
       [](PhsParams& p) -> double& { return p.friction.stribeck_speed_m_s; },
       &ByCoulomb},
      {{"friction.viscous_extension_Ns_per_m", "N s/m", Within(0, 1e7), 0, 1e5, "c"},
       [](PhsParams& p) -> double& { return p.friction.viscous_extension_Ns_per_m; },
       &ByCoulomb},
      {{"friction.viscous_retraction_Ns_per_m", "N s/m", Within(0, 1e7), 0, 1e5, "c"},
       [](PhsParams& p) -> double& { return p.friction.viscous_retraction_Ns_per_m; },
       &ByCoulomb},
      {{"friction.ramp_speed_m_s", "m/s", Positive(1), 1e-6, 0.01,
        "model `static`: the level is reached at this speed"},
       [](PhsParams& p) -> double& { return p.friction.ramp_speed_m_s; }},
      {{"friction.stiffness_N_per_m", "N/m", Positive(1e12), 1e6, 1e9,
        "model `presliding`: of the bristle"},
       [](PhsParams& p) -> double& { return p.friction.stiffness_N_per_m; }},
      {{"friction.damping_Ns_per_m", "N s/m", Within(0, 1e7), 0, 1e6, "of the bristle"},
       [](PhsParams& p) -> double& { return p.friction.damping_Ns_per_m; }},
      {{"friction.breakaway_ratio", "-", Within(0, 0.99), 0, 0.95,
        "below this share of the level the bristle is purely elastic"},
       [](PhsParams& p) -> double& { return p.friction.breakaway_ratio; }},
      {{"element.mass_kg", "kg", Within(0, 1e6), 0, 1e4, "part on a bench: its mass"},
       [](PhsParams& p) -> double& { return p.element.mass_kg; }},
      {{"element.stiffness_N_per_m", "N/m", Within(0, 1e12), 0, 1e9, "spring to the frame"},
       [](PhsParams& p) -> double& { return p.element.stiffness_N_per_m; }},
      {{"element.hardening_N_per_m3", "N/m3", Within(-1e15, 1e15), 0, 1e12, "of the spring: k₃ x³"},
       [](PhsParams& p) -> double& { return p.element.hardening_N_per_m3; },
       [](const PhsParams& p) { return p.element.hardening_N_per_m3 != 0; }},
      {{"element.damping_Ns_per_m", "N s/m", Within(0, 1e12), 0, 1e6,
        "c: the force is c v, beside any friction"},
       [](PhsParams& p) -> double& { return p.element.damping_Ns_per_m; },
       [](const PhsParams& p) { return p.element.damping_Ns_per_m != 0; }},
      {{"element.quadratic_damping_Ns2_per_m2", "N s2/m2", Within(0, 1e12), 0, 1e6,
        "d: the force is d v abs(v)"},
       [](PhsParams& p) -> double& { return p.element.quadratic_damping_Ns2_per_m2; },
       [](const PhsParams& p) { return p.element.quadratic_damping_Ns2_per_m2 != 0; }},
      {{"element.gas_force_N", "N", Within(0, 1e8), 0, 1e5,
        "gas spring: its absolute pressure at x = 0 times its area; what it pushes there is in "
        "`offset_N`"},
       [](PhsParams& p) -> double& { return p.element.gas_force_N; },
       [](const PhsParams& p) { return p.element.gas_force_N != 0; }},
      {{"element.gas_length_m", "m", Within(-100, 100), -1, 1,
        "gas spring: its volume at x = 0 over its area, not 0; below 0: x < 0 compresses it"},
       [](PhsParams& p) -> double& { return p.element.gas_length_m; },
       [](const PhsParams& p) { return p.element.gas_length_m != ElementParams().gas_length_m; }},
      {{"element.gas_exponent", "-", Within(0.9, 2), 1, 1.67, "1 isothermal … 1.4 adiabatic"},
       [](PhsParams& p) -> double& { return p.element.gas_exponent; },
       [](const PhsParams& p) { return p.element.gas_exponent != ElementParams().gas_exponent; }},
      {{"element.pressure_area_m2", "m2", Within(-10, 10), -0.1, 0.1,
        "on which the bench's pressure acts"},
       [](PhsParams& p) -> double& { return p.element.pressure_area_m2; }},
      {{"element.offset_N", "N", Within(-1e7, 1e7), -1e4, 1e4, "constant force"},
       [](PhsParams& p) -> double& { return p.element.offset_N; }},
  };
}

}  // namespace

template <>
const std::vector<NumberRow<PhsParams>>& Numbers() {
  static const auto rows = WholeRows();
  return rows;
}
template <>
const std::vector<NumberRow<CylinderParams>>& Numbers() {
  static const auto rows = CylinderRows();
  return rows;
}
template <>
const std::vector<NumberRow<LineParams>>& Numbers() {
  static const auto rows = LineRows();
  return rows;
}

}  // namespace phs::hydraulics
