#include "identify/effect_options.h"

namespace phs::identify::search {

const std::vector<OptionRow>& Options() {
  static const std::vector<OptionRow> rows = {
      {"piston_leakage", {"exponent"}, {{0.6}, {1.6}}},
      {"piston_leakage", {"return_ratio"}, {{0.3}, {3}}},
      {"piston_leakage", {"start_s"}, {{15}, {35}, {60}}},
      {"external_leakage", {"exponent"}, {{0.6}, {1.6}}},
      {"external_leakage", {"rod_ratio"}, {{1}}},
      {"external_leakage", {"start_s"}, {{15}, {35}, {60}}},
      {"line_resistance", {"laminar_Pas_per_m3"}, {{6e7}, {3e8}, {3e9}}},
      {"line_resistance", {"turbulent_Pas2_per_m6"}, {{1e12}, {1e13}, {1e14}}},
      {"line_resistance", {"oil_share"}, {{0.2}}},
      {"line_resistance", {"rod_ratio"}, {{1}}},
      {"line_inertance", {"oil_share"}, {{0.2}}},
      {"line_inertance", {"rod_ratio"}, {{0.7}, {0.85}, {1}, {1.2}, {1.45}}},
      {"check_restriction", {"out_Pas_per_m3"}, {{2e7}, {1e9}}},
      {"check_restriction", {"in_Pas_per_m3"}, {{2e7}, {1e9}}},
      {"check_restriction", {"turbulent_out_Pas2_per_m6"}, {{2e11}, {1e13}}},
      {"check_restriction", {"turbulent_in_Pas2_per_m6"}, {{2e11}, {1e13}}},
      {"check_restriction", {"oil_share"}, {{0.2}}},
      {"check_restriction", {"rod_ratio"}, {{1}}},
      {"entrained_air", {"rod_ratio"}, {{1}}},
      {"entrained_air", {"saturation_Pa"}, {{4e6}, {1e7}}},
      {"entrained_air", {"polytropic_exponent"}, {{1.1}}},
      {"entrained_air", {"dissolving_time_s"}, {{0.3}, {2}}},
      {"hose_expansion", {"stiffening_order"}, {{4}}},
      {"hose_expansion", {"creep_m3_per_Pa", "creep_time_s"}, {{1e-13, 0.5}, {1e-13, 4}}},
      {"hose_expansion", {"rod_ratio"}, {{1}}},
      {"gas_thermal", {"heat_capacity_ratio"}, {{0.7}, {2}, {30}}},
      {"gas_thermal", {"wall_heat_ratio", "wall_time_s"}, {{0.3, 20}, {0.3, 100}}},
      {"gas_thermal", {"density_exponent"}, {{0.3}}},
      {"gas_thermal", {"rod_ratio"}, {{1}}},
      {"gas_thermal", {"accumulator_ratio"}, {{0.02}, {3}}},
      {"accumulator_precharge", {"spread_Pa"}, {{2e5}, {8e5}}},
      {"diaphragm_stop", {"spread"}, {{0.1}, {0.4}}},
      {"cavitation", {"release_time_s", "dissolving_time_s"}, {{0.3, 0.3}, {0.3, 3}}},
      {"cavitation", {"release_time_s"}, {{0.3}}},
      {"cavitation", {"rod_ratio"}, {{1}}},
      {"stribeck", {"exponent"}, {{1.5}}},
      {"presliding", {"share"}, {{0.7}}},
      {"pressure_friction", {"difference_N_per_Pa"}, {{0}}},
      {"pressure_friction", {"retraction_ratio"}, {{1}}},
      {"position_friction", {"slope_1_per_m"}, {{0}}},
      {"viscous_friction", {"exponent"}, {{0.7}, {1.6}}},
      {"sensor_offset", {"p_bore_Pa"}, {{0}}},
      {"sensor_offset", {"p_rod_Pa"}, {{0}}},
      {"sensor_offset", {"load_N"}, {{0}}},
      {"sensor_gain", {"p_bore"}, {{1}}},
      {"sensor_gain", {"p_rod"}, {{1}}},
      {"temperature_drift", {"expansion_1_per_K"}, {{4e-4}}},
      {"temperature_drift", {"softening_1_per_K"}, {{4e-3}}},
      {"temperature_drift", {"rod_ratio"}, {{1}}},
      {"temperature_drift", {"start_s"}, {{15}, {35}, {60}}},
      {"backlash", {"tension_share"}, {{0.3}, {0.7}}},
      {"backlash", {"hardening_1_per_m2"}, {{1e8}, {1e10}}},
      {"mount_compliance", {"hardening_1_per_m2"}, {{1e5}, {3e6}, {1e8}, {3e9}}},
      {"mount_compliance", {"tension_ratio"}, {{1}}},
      {"bush_viscoelastic",
       {"second_N_per_m", "second_relaxation_s"},
       {{3e7, 0.03}, {3e7, 5}, {1e9, 0.03}, {1e9, 5}}},
      {"bush_viscoelastic", {"hardening_1_per_m2"}, {{1e5}, {3e6}, {1e8}}},
  };
  return rows;
}

bool IsNested(const std::string& simple, const std::string& general) {
  return (simple == "line_resistance" && general == "check_restriction") ||
         (simple == "line_resistance" && general == "line_inertance") ||
         (simple == "mount_compliance" && general == "bush_viscoelastic");
}

}  // namespace phs::identify::search
