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
      {"piston_leakage",
       Spread::kAll,
       {"conductance_m3_per_Pas"},
       {{1e-16}, {1e-15}, {1e-14}, {1e-13}}},
      {"piston_leakage",
       Spread::kAll,
       {"conductance_m3_per_Pas"},
       {{3e-16}, {1e-14}},
       {{"exponent", 0.5}}},
      {"external_leakage",
       Spread::kEachLine,
       {"conductance_m3_per_Pas"},
       {{1e-17}, {1e-16}, {1e-15}, {1e-14}}},
      {"external_leakage",
       Spread::kEachLine,
       {"conductance_m3_per_Pas"},
       {{3e-17}, {1e-15}},
       {{"exponent", 0.5}}},
      {"line_resistance", Spread::kAll, {"laminar_Pas_per_m3"}, {{2e8}, {2e9}, {2e10}}},
      {"line_resistance",
       Spread::kAll,
       {"turbulent_Pas2_per_m6"},
       {{1e12}, {1e13}, {1e14}},
       {{"laminar_Pas_per_m3", 3e7}}},
      {"line_inertance",
       Spread::kAll,
       {"inertance_kg_per_m4", "laminar_Pas_per_m3"},
       {{1e7, 2e8}, {3e7, 5e8}, {1e8, 1e9}, {6e8, 1e10}}},
      {"check_restriction",
       Spread::kAll,
       {"out_Pas_per_m3", "in_Pas_per_m3"},
       {{1e10, 1e9}, {1e9, 1e10}, {1e11, 1e9}, {1e9, 1e11}}},
      {"check_restriction",
       Spread::kAll,
       {"turbulent_out_Pas2_per_m6"},
       {{1e13}, {1e14}},
       {{"out_Pas_per_m3", 3e7}, {"in_Pas_per_m3", 3e7}}},
      {"check_restriction",
       Spread::kAll,
       {"turbulent_in_Pas2_per_m6"},
       {{1e13}, {1e14}},
       {{"out_Pas_per_m3", 3e7}, {"in_Pas_per_m3", 3e7}}},
      {"entrained_air", Spread::kEachLine, {"air_fraction"}, {{1e-3}, {5e-3}, {2e-2}}},
      {"entrained_air",
       Spread::kEachLine,
       {"air_fraction", "saturation_Pa"},
       {{5e-3, 4e6}, {1e-2, 1e7}}},
      {"entrained_air",
       Spread::kAll,
       {"air_fraction", "dissolving_time_s"},
       {{1e-2, 0.4}, {1e-2, 2}},
       {{"saturation_Pa", 8e6}}},
      {"hose_expansion",
       Spread::kEachLine,
       {"compliance_m3_per_Pa", "stiffening_Pa"},
       {{2e-13, 8e6}, {1e-12, 8e6}, {4e-13, 5e7}}},
      {"hose_expansion",
       Spread::kAll,
       {"creep_m3_per_Pa", "creep_time_s"},
       {{1e-13, 0.3}, {1e-13, 1}, {1e-13, 4}},
       {{"compliance_m3_per_Pa", 0}}},
      {"gas_thermal", Spread::kAll, {"thermal_time_s"}, {{0.5}, {3}, {15}}},
      {"gas_thermal",
       Spread::kAll,
       {"thermal_time_s", "heat_capacity_ratio"},
       {{1, 10}, {4, 10}, {1, 50}, {4, 50}}},
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
      {"stribeck",
       Spread::kAll,
       {"extra_N", "speed_m_s"},
       {{200, 1e-3}, {200, 4e-3}},
       {{"exponent", 2}}},
      {"presliding",
       Spread::kAll,
       {"stiffness_N_per_m", "breakaway_ratio"},
       {{6e6, 0.5}, {2.5e7, 0.5}, {1e8, 0.5}}},
      {"presliding",
       Spread::kAll,
       {"stiffness_N_per_m"},
       {{1e7}, {4e7}, {1.5e8}},
       {{"creeping", 1}, {"breakaway_ratio", 0}}},
      {"pressure_friction", Spread::kAll, {"bore_N_per_Pa"}, {{2e-5}}, {{"rod_N_per_Pa", 0}}},
      {"pressure_friction", Spread::kAll, {"rod_N_per_Pa"}, {{2e-5}}, {{"bore_N_per_Pa", 0}}},
      {"pressure_friction", Spread::kAll, {"bore_N_per_Pa", "rod_N_per_Pa"}, {{2e-5, 2e-5}}},
      {"pressure_friction",
       Spread::kAll,
       {"difference_N_per_Pa"},
       {{2e-5}},
       {{"bore_N_per_Pa", 0}, {"rod_N_per_Pa", 0}}},
      {"position_friction", Spread::kAll, {"slope_1_per_m"}, {{0}}},
      {"position_friction",
       Spread::kAll,
       {"spot_share", "spot_centre_m", "spot_width_m"},
       {{0.1, -1.5e-3, 1e-3},
        {0.1, -5e-4, 1e-3},
        {0.1, 5e-4, 1e-3},
        {0.1, 1.5e-3, 1e-3},
        {0.1, -6e-3, 3e-3},
        {0.1, 0, 3e-3},
        {0.1, 6e-3, 3e-3}},
       {{"slope_1_per_m", 0}}},
      {"position_friction",
       Spread::kAll,
       {"wave_sine", "wave_cosine", "wave_length_m"},
       {{0, 0, 8e-4}, {0, 0, 1.1e-3}, {0, 0, 1.5e-3}, {0, 0, 2e-3}, {0, 0, 3e-3}, {0, 0, 6e-3}},
       {{"slope_1_per_m", 0}}},
      {"position_friction", Spread::kAll, {"slope_1_per_m", "curvature_1_per_m2"}, {{0, 0}}},
      {"dwell_friction",
       Spread::kAll,
       {"extra_N", "time_s", "length_m"},
       {{300, 1, 1e-4}, {300, 10, 1e-4}, {300, 3, 5e-4}, {300, 3, 2e-5}}},
      {"viscous_friction",
       Spread::kAll,
       {"extension_Ns_per_m", "retraction_Ns_per_m"},
       {{1e3, 1e3}, {2e4, 2e4}}},
      {"viscous_friction",
       Spread::kAll,
       {"extension_Ns_per_m", "retraction_Ns_per_m"},
       {{3e3, 3e3}},
       {{"exponent", 2}}},
      {"viscous_friction",
       Spread::kAll,
       {"extension_Ns_per_m", "retraction_Ns_per_m"},
       {{1e4, 1e4}},
       {{"exponent", 0.65}}},
      {"asymmetric_friction", Spread::kAll, {"level_N"}, {{0}}, {{"viscous_Ns_per_m", 0}}},
      {"backlash",
       Spread::kAll,
       {"gap_m", "contact_N_per_m"},
       {{4e-6, 1e10}, {3e-5, 1e9}, {3e-5, 2e10}, {1e-4, 1e9}, {4e-4, 1e9}, {1e-4, 3e8}}},
      {"mount_compliance",
       Spread::kAll,
       {"stiffness_N_per_m"},
       {{2e7}, {7e7}, {2.5e8}, {1e9}, {5e9}}},
      {"bush_viscoelastic",
       Spread::kAll,
       {"stiffness_N_per_m", "relaxing_N_per_m", "relaxation_s"},
       {{3e7, 2e7, 0.1},
        {3e7, 2e7, 1},
        {1.5e8, 1e8, 0.1},
        {1.5e8, 1e8, 1},
        {1e9, 1e9, 0.1},
        {1e9, 1e9, 1},
        {8e9, 8e9, 0.3}}},
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
      {"sensor_drift",
       Spread::kAll,
       {"load_sine_N", "load_cosine_N", "period_s"},
       {{0, 0, 40}, {0, 0, 80}, {0, 0, 160}}},
      {"sensor_drift",
       Spread::kAll,
       {"p_bore_sine_Pa", "p_bore_cosine_Pa", "period_s"},
       {{0, 0, 40}, {0, 0, 80}, {0, 0, 160}}},
      {"sensor_drift",
       Spread::kAll,
       {"p_rod_sine_Pa", "p_rod_cosine_Pa", "period_s"},
       {{0, 0, 40}, {0, 0, 80}, {0, 0, 160}}},
      {"sensor_delay", Spread::kAll, {"load_s"}, {{2e-3}, {0.02}}},
      {"sensor_delay", Spread::kAll, {"p_bore_s"}, {{2e-3}, {0.02}}},
      {"sensor_delay", Spread::kAll, {"p_rod_s"}, {{2e-3}, {0.02}}},
      {"sensor_delay", Spread::kAll, {"p_bore_s", "p_rod_s"}, {{2e-3, 2e-3}, {0.02, 0.02}}},
      {"sensor_delay", Spread::kAll, {"piston_s"}, {{2e-3}, {0.02}}},
      {"sensor_gain", Spread::kAll, {"load"}, {{1}}},
      {"sensor_gain", Spread::kAll, {"p_bore"}, {{1}}},
      {"sensor_gain", Spread::kAll, {"p_rod"}, {{1}}},
      {"sensor_gain", Spread::kAll, {"piston"}, {{1}}},
      {"moving_mass", Spread::kAll, {"mass_kg"}, {{30}, {300}}},
      {"temperature_drift",
       Spread::kAll,
       {"rate_K_per_s", "settling_s"},
       {{0.04, 50}, {-0.04, 50}, {0.002, 1000}, {-0.002, 1000}}},
      {"temperature_drift",
       Spread::kAll,
       {"amplitude_K", "period_s"},
       {{1, 70}, {1, 110}, {1, 180}, {1, 300}},
       {{"rate_K_per_s", 0}}},
  };
  return rows;
}

/// What a form may take on beyond its core, by effect.
struct OptionRow {
  const char* effect;
  std::vector<const char*> free;
  std::vector<std::vector<double>> starts;
};

const std::vector<OptionRow>& Options() {
  static const std::vector<OptionRow> rows = {
      {"piston_leakage", {"exponent"}, {{0.6}, {1.6}}},
      {"external_leakage", {"exponent"}, {{0.6}, {1.6}}},
      {"external_leakage", {"rod_ratio"}, {{1}}},
      {"line_resistance", {"laminar_Pas_per_m3"}, {{3e8}, {3e9}}},
      {"line_resistance", {"turbulent_Pas2_per_m6"}, {{1e12}, {1e13}, {1e14}}},
      {"line_resistance", {"oil_share"}, {{0.2}}},
      {"line_resistance", {"rod_ratio"}, {{1}}},
      {"line_inertance", {"oil_share"}, {{0.2}}},
      {"line_inertance", {"rod_ratio"}, {{1}}},
      {"check_restriction", {"out_Pas_per_m3"}, {{1e9}}},
      {"check_restriction", {"in_Pas_per_m3"}, {{1e9}}},
      {"check_restriction", {"turbulent_out_Pas2_per_m6"}, {{1e13}}},
      {"check_restriction", {"turbulent_in_Pas2_per_m6"}, {{1e13}}},
      {"check_restriction", {"oil_share"}, {{0.2}}},
      {"check_restriction", {"rod_ratio"}, {{1}}},
      {"entrained_air", {"rod_ratio"}, {{1}}},
      {"entrained_air", {"saturation_Pa"}, {{4e6}, {1e7}}},
      {"entrained_air", {"polytropic_exponent"}, {{1.1}}},
      {"entrained_air", {"dissolving_time_s"}, {{0.3}, {2}}},
      {"hose_expansion", {"stiffening_order"}, {{4}}},
      {"hose_expansion", {"creep_m3_per_Pa", "creep_time_s"}, {{1e-13, 0.5}, {1e-13, 4}}},
      {"hose_expansion", {"rod_ratio"}, {{1}}},
      {"gas_thermal", {"heat_capacity_ratio"}, {{2}, {30}}},
      {"gas_thermal", {"rod_ratio"}, {{1}}},
      {"cavitation", {"rod_ratio"}, {{1}}},
      {"stribeck", {"exponent"}, {{1.5}}},
      {"presliding", {"share"}, {{0.7}}},
      {"pressure_friction", {"difference_N_per_Pa"}, {{0}}},
      {"position_friction", {"slope_1_per_m"}, {{0}}},
      {"viscous_friction", {"exponent"}, {{0.7}, {1.6}}},
      {"temperature_drift", {"expansion_1_per_K"}, {{4e-4}}},
      {"mount_compliance", {"hardening_1_per_m2"}, {{1e5}, {3e6}, {1e8}, {3e9}}},
      {"mount_compliance", {"tension_ratio"}, {{1}}},
      {"bush_viscoelastic",
       {"second_N_per_m", "second_relaxation_s"},
       {{3e7, 0.03}, {3e7, 5}, {1e9, 0.03}, {1e9, 5}}},
      {"bush_viscoelastic", {"hardening_1_per_m2"}, {{1e5}, {3e6}, {1e8}}},
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

void AddOptions(const EffectInfo& info, const Recipe& recipe, Candidate* candidate) {
  const auto is_free = [&](const char* name) {
    return std::any_of(recipe.free.begin(), recipe.free.end(),
                       [&](const char* free) { return std::string(free) == name; });
  };
  for (const OptionRow& row : Options()) {
    if (info.name != row.effect) continue;
    if (std::any_of(row.free.begin(), row.free.end(), is_free)) continue;
    // Air that does not dissolve has no lag in it.
    const std::string first = row.free[0];
    if (first == "dissolving_time_s" && !is_free("saturation_Pa")) continue;
    EffectOption option{{}, row.starts};
    for (size_t i = 0; i < row.free.size(); ++i) {
      double smallest = row.starts[0][i];
      for (const auto& start : row.starts) smallest = std::min(smallest, start[i]);
      option.free.push_back(FreeNumber(info, row.free[i], smallest));
    }
    candidate->options.push_back(std::move(option));
  }
}

void AddVariants(const Recipe& recipe, const PhsParams& params, std::vector<Candidate>* out) {
  const EffectInfo* info = effects::Catalogue().Find(recipe.effect);
  if (info == nullptr) return;
  Candidate candidate = MakeCandidate(*info, recipe.free, recipe.starts, recipe.fixed);
  AddOptions(*info, recipe, &candidate);
  out->push_back(candidate);
  if (recipe.spread == Spread::kAll || params.lines.size() < 2) return;
  std::erase_if(candidate.options, [](const EffectOption& option) {
    return option.free[0].name.ends_with(".rod_ratio");
  });
  for (const auto& line : params.lines) {
    candidate.params.targets = {line.name};
    out->push_back(candidate);
  }
}

}  // namespace

Candidate MakeCandidate(const EffectInfo& info, const std::vector<const char*>& free,
                        const std::vector<std::vector<double>>& starts,
                        const std::vector<std::pair<const char*, double>>& fixed) {
  Candidate candidate;
  candidate.effect = info.name;
  candidate.params.name = info.name;
  for (const auto& p : info.parameters) candidate.params.values[p.name] = p.otherwise;
  for (const auto& [name, value] : fixed) candidate.params.values[name] = value;
  for (size_t i = 0; i < free.size(); ++i) {
    double smallest = starts[0][i];
    for (const auto& start : starts) smallest = std::min(smallest, start[i]);
    candidate.free.push_back(FreeNumber(info, free[i], smallest));
  }
  candidate.starts = starts;
  // One of two directions (or sides, or parts of a wave) may have none of it.
  const bool two = candidate.free.size() > 1 &&
                   (info.name == "check_restriction" || info.name == "viscous_friction" ||
                    info.name == "pressure_friction" ||
                    candidate.free[1].name.find("_cosine") != std::string::npos);
  // A hose that never stiffens is oil volume, which is free already.
  const bool stiffens =
      candidate.free.size() > 1 && candidate.free[1].name.ends_with("stiffening_Pa");
  candidate.mains = two || stiffens ? 2 : 1;
  candidate.hydraulic = info.family == "hydraulic";
  candidate.has_onset = candidate.hydraulic || info.family == "mounting" ||
                        info.name == "presliding" || info.name == "dwell_friction";
  return candidate;
}

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

std::vector<std::string> CandidateNames() {
  std::vector<std::string> names;
  for (const auto* rows : {&Hydraulic(), &FrictionAndMounting(), &InstrumentAndEnvironment()}) {
    for (const Recipe& recipe : *rows) {
      if (names.empty() || names.back() != recipe.effect) names.emplace_back(recipe.effect);
    }
  }
  names.emplace_back("unlisted");
  return names;
}

Candidate WithOption(const Candidate& candidate, size_t option) {
  Candidate out = candidate;
  for (const FreeParameter& p : candidate.options[option].free) out.free.push_back(p);
  out.options.erase(out.options.begin() + static_cast<long>(option));
  return out;
}

FreeModel WithCandidate(const FreeModel& model, const Candidate& candidate) {
  FreeModel out = model;
  out.params.effects.push_back(candidate.params);
  out.free.insert(out.free.end(), candidate.free.begin(), candidate.free.end());
  return out;
}

std::string VariantName(const Candidate& candidate) {
  std::string name;
  for (const auto& t : candidate.params.targets) name += (name.empty() ? "" : ",") + t;
  for (const auto& p : candidate.free) {
    name += (name.empty() ? "" : ",") + p.name.substr(p.name.rfind('.') + 1);
  }
  return name;
}

}  // namespace phs::identify::search
