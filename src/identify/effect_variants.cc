#include "identify/effect_variants.h"

#include <algorithm>
#include <cmath>

#include "effects/catalogue.h"

namespace phs::identify::search {
namespace {

using hydraulics::EffectInfo;
using hydraulics::PhsParams;

enum class Spread { kAll, kEachLine };  // on all targets only, or also on each line alone

/// One row: the effect, its free numbers, the starts, numbers held at other
/// than default values.
struct Recipe {
  const char* effect;
  Spread spread;
  std::vector<const char*> free;
  std::vector<std::vector<double>> starts;
  std::vector<std::pair<const char*, double>> fixed = {};
};

const std::vector<Recipe>& Hydraulic() {
  static const std::vector<Recipe> rows = {
      {"piston_leakage", Spread::kAll, {"conductance_m3_per_Pas"}, {{1e-14}, {1e-13}, {1e-12}}},
      {"external_leakage",
       Spread::kEachLine,
       {"conductance_m3_per_Pas"},
       {{1e-15}, {1e-14}, {1e-13}}},
      {"line_resistance", Spread::kAll, {"laminar_Pas_per_m3"}, {{2e8}, {2e9}, {2e10}}},
      {"line_resistance",
       Spread::kAll,
       {"laminar_Pas_per_m3", "turbulent_Pas2_per_m6"},
       {{3e8, 3e12}, {3e8, 3e13}, {1e9, 3e14}}},
      {"line_inertance",
       Spread::kAll,
       {"inertance_kg_per_m4", "laminar_Pas_per_m3"},
       {{1e7, 1e9}, {1e8, 3e9}, {6e8, 1e10}}},
      {"check_restriction",
       Spread::kAll,
       {"out_Pas_per_m3", "in_Pas_per_m3"},
       {{1e10, 1e9}, {1e9, 1e10}, {1e11, 1e9}, {1e9, 1e11}}},
      {"entrained_air", Spread::kEachLine, {"air_fraction"}, {{1e-3}, {5e-3}, {2e-2}}},
      {"entrained_air",
       Spread::kEachLine,
       {"air_fraction", "saturation_Pa"},
       {{5e-3, 4e6}, {1e-2, 1e7}}},
      {"hose_expansion",
       Spread::kEachLine,
       {"compliance_m3_per_Pa", "stiffening_Pa"},
       {{2e-13, 8e6}, {1e-12, 8e6}, {4e-13, 5e7}}},
      {"gas_thermal", Spread::kAll, {"thermal_time_s"}, {{0.5}, {3}, {15}}},
      {"accumulator_precharge",
       Spread::kAll,
       {"precharge_Pa"},
       {{11e6}, {13e6}, {14.3e6}, {15.7e6}, {17e6}}},
      {"diaphragm_stop",
       Spread::kEachLine,
       {"min_gas_volume_m3"},
       {{1e-6}, {2.5e-6}, {4e-6}, {6e-6}, {1e-5}}},
      {"cavitation",
       Spread::kEachLine,
       {"release_Pa", "solubility"},
       {{8e4, 0.05}, {2.5e5, 0.05}, {8e5, 0.05}}},
  };
  return rows;
}

const std::vector<Recipe>& FrictionAndMounting() {
  static const std::vector<Recipe> rows = {
      {"stribeck", Spread::kAll, {"extra_N", "speed_m_s"}, {{200, 5e-4}, {200, 3e-3}, {200, 1e-2}}},
      {"presliding",
       Spread::kAll,
       {"stiffness_N_per_m", "breakaway_ratio"},
       {{6e6, 0.5}, {2.5e7, 0.5}, {1e8, 0.5}}},
      {"pressure_friction", Spread::kAll, {"bore_N_per_Pa"}, {{2e-5}}, {{"rod_N_per_Pa", 0}}},
      {"pressure_friction", Spread::kAll, {"rod_N_per_Pa"}, {{2e-5}}, {{"bore_N_per_Pa", 0}}},
      {"pressure_friction", Spread::kAll, {"bore_N_per_Pa", "rod_N_per_Pa"}, {{2e-5, 2e-5}}},
      {"position_friction", Spread::kAll, {"slope_1_per_m"}, {{0}}},
      {"position_friction", Spread::kAll, {"slope_1_per_m", "curvature_1_per_m2"}, {{0, 0}}},
      {"dwell_friction",
       Spread::kAll,
       {"extra_N", "time_s", "length_m"},
       {{300, 1, 1e-4}, {300, 10, 1e-4}, {300, 3, 5e-4}, {300, 3, 2e-5}}},
      {"viscous_friction",
       Spread::kAll,
       {"extension_Ns_per_m", "retraction_Ns_per_m"},
       {{1e3, 1e3}, {2e4, 2e4}}},
      {"asymmetric_friction", Spread::kAll, {"level_N"}, {{0}}, {{"viscous_Ns_per_m", 0}}},
      {"backlash",
       Spread::kAll,
       {"gap_m", "contact_N_per_m"},
       {{4e-6, 1e10}, {3e-5, 1e9}, {3e-5, 2e10}, {1e-4, 1e9}, {4e-4, 1e9}, {1e-4, 3e8}}},
      {"mount_compliance", Spread::kAll, {"stiffness_N_per_m"}, {{2e7}, {7e7}, {2.5e8}, {1e9}}},
      {"bush_viscoelastic",
       Spread::kAll,
       {"stiffness_N_per_m", "relaxing_N_per_m", "relaxation_s"},
       {{3e7, 2e7, 0.1}, {3e7, 2e7, 1}, {1.5e8, 1e8, 0.1}, {1.5e8, 1e8, 1}}},
  };
  return rows;
}

const std::vector<Recipe>& InstrumentAndEnvironment() {
  static const std::vector<Recipe> rows = {
      {"sensor_offset", Spread::kAll, {"load_N"}, {{0}}},
      {"sensor_offset", Spread::kAll, {"p_bore_Pa"}, {{0}}},
      {"sensor_offset", Spread::kAll, {"p_rod_Pa"}, {{0}}},
      {"sensor_offset", Spread::kAll, {"piston_m"}, {{0}}},
      {"sensor_drift", Spread::kAll, {"load_N_per_s"}, {{0}}},
      {"sensor_drift", Spread::kAll, {"p_bore_Pa_per_s"}, {{0}}},
      {"sensor_drift", Spread::kAll, {"p_rod_Pa_per_s"}, {{0}}},
      {"sensor_drift", Spread::kAll, {"piston_m_per_s"}, {{0}}},
      {"sensor_drift", Spread::kAll, {"load_N_per_s", "settling_s"}, {{0.1, 30}}},
      {"sensor_drift", Spread::kAll, {"p_bore_Pa_per_s", "settling_s"}, {{100, 30}}},
      {"sensor_drift", Spread::kAll, {"p_rod_Pa_per_s", "settling_s"}, {{100, 30}}},
      {"sensor_drift", Spread::kAll, {"piston_m_per_s", "settling_s"}, {{1e-8, 30}}},
      {"sensor_delay", Spread::kAll, {"load_s"}, {{2e-3}, {0.02}}},
      {"sensor_delay", Spread::kAll, {"p_bore_s"}, {{2e-3}, {0.02}}},
      {"sensor_delay", Spread::kAll, {"p_rod_s"}, {{2e-3}, {0.02}}},
      {"sensor_delay", Spread::kAll, {"p_bore_s", "p_rod_s"}, {{2e-3, 2e-3}, {0.02, 0.02}}},
      {"sensor_delay", Spread::kAll, {"piston_s"}, {{2e-3}, {0.02}}},
      {"sensor_gain", Spread::kAll, {"load"}, {{1}}},
      {"sensor_gain", Spread::kAll, {"p_bore"}, {{1}}},
      {"sensor_gain", Spread::kAll, {"p_rod"}, {{1}}},
      {"sensor_gain", Spread::kAll, {"piston"}, {{1}}},
      {"temperature_drift", Spread::kAll, {"rate_K_per_s"}, {{0.002}, {-0.002}}},
      {"temperature_drift", Spread::kAll, {"rate_K_per_s", "limit_K"}, {{0.04, 2}, {-0.04, 2}}},
      {"temperature_drift",
       Spread::kAll,
       {"amplitude_K", "period_s"},
       {{1, 70}, {1, 110}, {1, 180}, {1, 300}},
       {{"rate_K_per_s", 0}}},
  };
  return rows;
}

/// Bounds: the plausible range of the catalogue; logarithmic where it spans
/// more than a factor 20. A range that begins at zero begins, for a number
/// whose starts are positive, at 1/300 of `start`, its smallest start.
FreeParameter FreeNumber(const EffectInfo& info, const std::string& name, double start) {
  for (const auto& p : info.parameters) {
    if (p.name != name) continue;
    FreeParameter free;
    free.name = "effects." + info.name + "." + name;
    free.low = std::max(p.low, p.min), free.high = std::min(p.high, p.max);
    if (free.low == 0 && start > 0) free.low = start / 300;
    free.logarithmic = free.low > 0 && free.high / free.low > 20;
    free.scale = (free.high - free.low) / (free.low > 0 ? 1 : 10);
    return free;
  }
  PHS_CHECK(false);
  return {};
}

void AddVariants(const Recipe& recipe, const PhsParams& params, std::vector<Candidate>* out) {
  const EffectInfo* info = effects::Catalogue().Find(recipe.effect);
  if (info == nullptr) return;
  Candidate candidate;
  candidate.effect = recipe.effect;
  candidate.params.name = recipe.effect;
  for (const auto& p : info->parameters) candidate.params.values[p.name] = p.otherwise;
  for (const auto& [name, value] : recipe.fixed) candidate.params.values[name] = value;
  for (size_t i = 0; i < recipe.free.size(); ++i) {
    double smallest = recipe.starts[0][i];
    for (const auto& start : recipe.starts) smallest = std::min(smallest, start[i]);
    candidate.free.push_back(FreeNumber(*info, recipe.free[i], smallest));
  }
  candidate.starts = recipe.starts;
  out->push_back(candidate);
  if (recipe.spread == Spread::kAll || params.lines.size() < 2) return;
  for (const auto& line : params.lines) {
    candidate.params.targets = {line.name};
    out->push_back(candidate);
  }
}

}  // namespace

std::vector<Candidate> ListCandidates(const PhsParams& params, effects::RigKind kind) {
  std::vector<Candidate> out;
  for (const auto* rows : {&Hydraulic(), &FrictionAndMounting(), &InstrumentAndEnvironment()}) {
    if (kind == effects::RigKind::kElement && rows == &Hydraulic()) continue;
    for (const Recipe& recipe : *rows) {
      const bool present = std::any_of(params.effects.begin(), params.effects.end(),
                                       [&](const auto& e) { return e.name == recipe.effect; });
      if (!present) AddVariants(recipe, params, &out);
    }
  }
  return out;
}

FreeModel WithCandidate(const FreeModel& model, const Candidate& candidate) {
  FreeModel out = model;
  out.params.effects.push_back(candidate.params);
  out.free.insert(out.free.end(), candidate.free.begin(), candidate.free.end());
  return out;
}

}  // namespace phs::identify::search
