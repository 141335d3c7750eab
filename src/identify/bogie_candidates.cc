#include "identify/bogie_candidates.h"

#include <algorithm>

#include "base/check.h"
#include "effects/catalogue.h"
#include "vehicle/running_effects.h"

namespace phs::identify::search {
namespace {

struct BogieRecipe {
  const char* effect;
  bool each_line;  ///< on each line alone instead of everywhere
  std::vector<const char*> free;
  std::vector<std::vector<double>> starts;
};

const std::vector<BogieRecipe>& Recipes() {
  static const std::vector<BogieRecipe> rows = {
      // wheel and track
      {"cant_error", false, {"cant_m"}, {{0}}},
      {"gauge_error", false, {"widening_m"}, {{0}}},
      {"tread_wear", false, {"depth_m"}, {{2e-4}, {1e-3}}},
      {"wheel_rail_friction", false, {"coefficient"}, {{0.7}, {1.3}}},  // times the declared
      // hydraulics
      {"piston_leakage", false, {"conductance_m3_per_Pas"}, {{1e-13}, {3e-12}}},
      {"external_leakage", true, {"conductance_m3_per_Pas"}, {{1e-13}, {1e-12}}},
      {"line_resistance", false, {"laminar_Pas_per_m3"}, {{2e9}, {2e10}}},
      {"entrained_air", false, {"air_fraction"}, {{3e-3}, {2e-2}}},
      {"hose_expansion", false, {"compliance_m3_per_Pa"}, {{1e-12}}},
      {"gas_thermal", false, {"thermal_time_s"}, {{3}}},
      // seals
      {"viscous_friction",
       false,
       {"extension_Ns_per_m", "retraction_Ns_per_m"},
       {{5e3, 5e3}, {5e4, 5e4}}},
      {"stribeck", false, {"extra_N", "speed_m_s"}, {{200, 3e-3}}},
      {"asymmetric_friction", false, {"level_N"}, {{0}}},
      {"pressure_friction", false, {"bore_N_per_Pa", "rod_N_per_Pa"}, {{2e-5, 2e-5}}},
      {"position_friction", false, {"slope_1_per_m"}, {{0}}},
      {"dwell_friction", false, {"extra_N", "time_s", "length_m"}, {{300, 3, 1e-4}}},
      // mounting
      {"backlash", false, {"gap_m"}, {{1e-4}, {5e-4}}},
      {"mount_compliance", false, {"stiffness_N_per_m"}, {{3e7}, {2e8}}},
  };
  return rows;
}

const hydraulics::EffectInfo& InfoOf(const std::string& effect) {
  if (const auto* running = vehicle::FindRunningEffect(effect)) return running->info;
  const auto* info = effects::Catalogue().Find(effect);
  PHS_CHECK(info != nullptr);
  return *info;
}

}  // namespace

std::vector<Candidate> ListBogieCandidates(const hydraulics::PhsParams& params, double friction) {
  std::vector<Candidate> out;
  for (const BogieRecipe& row : Recipes()) {
    const bool present = std::any_of(params.effects.begin(), params.effects.end(),
                                     [&](const auto& e) { return e.name == row.effect; });
    if (present) continue;
    auto starts = row.starts;
    if (std::string(row.effect) == "wheel_rail_friction") {
      for (auto& start : starts) start[0] *= friction;
    }
    Candidate candidate = MakeCandidate(InfoOf(row.effect), row.free, starts);
    if (!row.each_line) {
      out.push_back(std::move(candidate));
      continue;
    }
    for (const auto& line : params.lines) {
      candidate.params.targets = {line.name};
      out.push_back(candidate);
    }
  }
  return out;
}

std::vector<std::string> BogieCandidateNames() {
  std::vector<std::string> names;
  for (const BogieRecipe& row : Recipes()) names.push_back(row.effect);
  return names;
}

}  // namespace phs::identify::search
