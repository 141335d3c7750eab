// Energy of every effect: work of the mountings = stored + lost, and lost power never negative.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "phs_model/phs_model.h"
#include "tests/effects/driven_cylinder.h"

namespace phs::effects {

using phs_model::AddEffect;
namespace {

using hydraulics::BoBo;

struct Balance {
  double work = 0, stored = 0, lost = 0, scale = 0;
  double least_power = 0;
  double Error() const { return std::abs(work - stored - lost) / scale; }
};

// Smooth motion with reversals and dwell, from rest and back to the start.
double Position(int cylinder, double t) {
  const double a = 1e-3 * (1 + 0.3 * cylinder), w = 2 * M_PI * 0.5;
  return a * std::sin(w * t + 0.4 * cylinder) * std::sin(0.25 * w * t);
}

Balance DriveOver(const PhsSystem& s, double duration, int steps) {
  const int n = s.num_cylinders();
  std::vector<double> state(s.num_states(), 0.0), rate(state), x(n), v(n), before(n);
  Evaluation e(s);
  Balance out;
  const double h = duration / steps;
  for (int i = 0; i <= steps; ++i) {
    const double t = i * h;
    for (int c = 0; c < n; ++c) x[c] = Position(c, t);
    // Force at both ends of each step with that step's speed: the trapezoid of a kinked power.
    double power = 0, lost = 0;
    if (i > 0) {
      s.Calc(t, x.data(), v.data(), state.data(), &e.out);
      for (int c = 0; c < n; ++c) power += e.force[c] * v[c];
      lost = e.out.lost_power;
      out.work += 0.5 * h * power;
      out.lost += 0.5 * h * lost;
      out.least_power = std::min(out.least_power, lost);
    }
    if (i == steps) break;
    for (int c = 0; c < n; ++c) v[c] = (Position(c, t + h) - x[c]) / h;
    s.Calc(t, x.data(), v.data(), state.data(), &e.out);
    power = 0;
    for (int c = 0; c < n; ++c) power += e.force[c] * v[c];
    if (i == 0) out.stored = -e.out.stored_energy;
    out.work += 0.5 * h * power;
    out.lost += 0.5 * h * e.out.lost_power;
    out.least_power = std::min(out.least_power, e.out.lost_power);
    out.scale += h * std::abs(power);
    s.CalcStateRate(t, h, x.data(), v.data(), state.data(), rate.data());
    for (size_t k = 0; k < state.size(); ++k) state[k] += h * rate[k];
  }
  out.stored += e.out.stored_energy;
  return out;
}

/// Warmth beyond that of the declared model [K]: of the model used, and that it has drifted by. An
/// effect is tried in one after the other until it acts.
struct Surroundings {
  double model_K, drift_K;
};
constexpr Surroundings kSurroundings[] = {{0, 0}, {60, 0}, {0, 60}};

/// A model in which the effect can act: without bristles of its own; warm as said.
PhsParams Beneath(const std::string& effect, bool whole, const Surroundings& warm) {
  PhsParams params = whole ? BoBo() : Quarter();
  if (effect == "presliding") params.friction.model = FrictionModel::kStatic;
  params.temperature_K += warm.model_K;
  if (warm.drift_K != 0) {
    params = With(params, "temperature_drift",
                  {{"rate_K_per_s", 10},
                   {"start_s", -100},
                   {"limit_K", warm.drift_K},
                   {"expansion_1_per_K", 0}});
  }
  return params;
}

/// True if the effect changes the work; its balance must hold either way.
bool Balances(const std::string& effect, bool whole, const Surroundings& warm) {
  const PhsParams beneath = Beneath(effect, whole, warm);
  PhsParams params = beneath;
  if (effect != "none") {
    EXPECT_TRUE(AddEffect(&params, effect).ok());
  }
  const PhsSystem s = Compile(params);
  // Chamber pressures settle in 0.2 ms (resistance) or ring at 90 Hz (inertance): resolve that.
  const bool fast =
      effect.starts_with("line_") || effect.starts_with("check_") || effect == "throttle";
  const int steps = (whole ? 8000 : 16000) * (fast ? 10 : 1);
  const Balance b = DriveOver(s, 4.0, steps);
  EXPECT_LT(b.Error(), 2e-3) << params.name << " work " << b.work << " stored " << b.stored
                             << " lost " << b.lost << " scale " << b.scale;
  EXPECT_GE(b.least_power, -1e-9);
  EXPECT_GT(b.lost, 0);
  // A balance that the effect does not enter would hold whatever the effect does.
  return b.work != DriveOver(Compile(beneath), 4.0, steps).work;
}

class EnergyOf : public ::testing::TestWithParam<std::string> {};

TEST_P(EnergyOf, WorkIsStoredPlusLost) {
  bool acts = GetParam() == "none";
  for (const Surroundings& warm : kSurroundings) {
    for (bool whole : {false, true}) acts = Balances(GetParam(), whole, warm) || acts;
    if (acts) break;
  }
  EXPECT_TRUE(acts)
      << "changes no work, also 60 K warmer, so its balance says nothing: let it act with its "
         "default values, or give it a model to act in (Beneath)";
}

/// The further forms of effects: with memory, other exponents, more branches.
struct Form {
  const char* effect;
  std::map<std::string, double> values;
};

TEST(EnergyOfForms, WorkIsStoredPlusLost) {
  const Form forms[] = {
      {"hose_expansion",
       {{"compliance_m3_per_Pa", 0}, {"creep_m3_per_Pa", 4e-13}, {"creep_time_s", 0.3}}},
      {"hose_expansion",
       {{"compliance_m3_per_Pa", 5e-13}, {"stiffening_Pa", 5e6}, {"stiffening_order", 3}}},
      {"hose_expansion",
       {{"compliance_m3_per_Pa", 5e-13}, {"stiffening_Pa", 5e6}, {"stated_at_Pa", 2e6}}},
      {"hose_expansion", {{"creep_m3_per_Pa", 4e-13}, {"creep_time_s", 0.3}, {"creep_spread", 4}}},
      {"hose_expansion",
       {{"compliance_m3_per_Pa", 4e-13},
        {"stiffening_Pa", 5e6},
        {"creep_time_s", 0.3},
        {"late_share", 0.6}}},
      {"hose_expansion",
       {{"compliance_m3_per_Pa", 4e-13},
        {"stiffening_Pa", 5e6},
        {"stiffening_order", 8},
        {"creep_time_s", 0.3},
        {"creep_spread", 3},
        {"late_share", 1}}},
      {"oil_stiffening", {{"slope", 0}, {"softness", 0.8}, {"over_Pa", 4e6}}},
      {"gas_loss", {{"loss_1_per_s", 0.02}}},
      {"gas_loss", {{"loss_1_per_s", 0.05}, {"exponent", 0.5}, {"start_Pa", 2.2e6}}},
      {"entrained_air", {{"air_fraction", 0.02}, {"saturation_Pa", 6e6}}},
      {"entrained_air",
       {{"air_fraction", 0.02},
        {"saturation_Pa", 6e6},
        {"dissolving_time_s", 0.4},
        {"rod_ratio", 2}}},
      {"entrained_air",
       {{"air_fraction", 0.02},
        {"saturation_Pa", 6e6},
        {"dissolving_time_s", 0.4},
        {"release_ratio", 0.3},
        {"polytropic_exponent", 1.3}}},
      {"gas_thermal", {{"heat_capacity_ratio", 5}, {"rod_ratio", 0.5}, {"accumulator_ratio", 3}}},
      {"gas_thermal", {{"heat_capacity_ratio", 5}, {"real_gas", 1}}},
      {"gas_thermal", {{"heat_capacity_ratio", 0.6}}},
      {"gas_thermal", {{"thermal_time_s", 0.3}, {"wall_heat_ratio", 2}, {"wall_time_s", 0.5}}},
      {"gas_thermal", {{"wall_heat_ratio", 2}, {"wall_time_s", 0.5}, {"real_gas", 1}}},
      {"gas_thermal", {{"thermal_time_s", 0.3}, {"density_exponent", 0.7}}},
      {"cavitation", {{"release_Pa", 1.5e6}, {"release_time_s", 0.1}, {"dissolving_time_s", 0.6}}},
      {"accumulator_precharge", {{"precharge_Pa", 2.6e6}, {"spread_Pa", 4e5}}},
      {"diaphragm_stop", {{"min_gas_volume_m3", 12e-6}, {"spread", 0.3}}},
      {"diaphragm_stop", {{"min_gas_volume_m3", 14e-6}, {"spread", 0.3}, {"share", 0.6}}},
      {"diaphragm_stop",
       {{"min_gas_volume_m3", 0}, {"precharge_Pa", 1.7e6}, {"spread", 0.1}, {"share", 0.8}}},
      {"check_restriction", {{"out_Pas_per_m3", 3e8}, {"cracking_out_Pa", 5e4}}},
      {"line_resistance", {{"cracking_Pa", 2e4}}},
      {"reservoir_drag", {{"friction_Pa", 2e4}, {"turbulent_Pas2_per_m6", 3e13}}},
      {"line_inertance", {{"laminar_Pas_per_m3", 4e9}, {"unsteady_share", 1}}},
      {"piston_leakage", {{"exponent", 0.5}}},
      {"piston_leakage", {{"return_ratio", 0.1}}},
      {"piston_leakage", {{"conductance_m3_per_Pas", 1e-12}, {"from_m", 2e-4}, {"edge_m", 1e-4}}},
      {"external_leakage", {{"exponent", 1.7}, {"rod_ratio", 3}}},
      {"external_leakage", {{"conductance_m3_per_Pas", 1e-12}, {"opening_Pa", 2.2e6}}},
      {"backlash", {{"gap_m", 2e-4}, {"tension_share", 0.2}, {"hardening_1_per_m2", 1e9}}},
      {"mount_compliance", {{"hardening_1_per_m2", 3e6}, {"tension_ratio", 0.7}}},
      {"mount_compliance", {{"opens_N", 3e3}, {"tension_ratio", 0.4}}},
      {"bush_viscoelastic",
       {{"second_N_per_m", 3e7}, {"second_relaxation_s", 0.05}, {"hardening_1_per_m2", 1e6}}},
      {"presliding", {{"creeping", 1}, {"share", 0.6}}},
      {"presliding", {{"creeping", 1}, {"exponent", 2}}},
      {"presliding", {{"creeping", 1}, {"exponent", 0.6}}},
      {"position_friction", {{"spot_share", 0.4}, {"wave_sine", 0.2}}},
      {"viscous_friction", {{"exponent", 2}}},
      {"pressure_friction", {{"turn_m_s", 1e-3}}},
      {"pressure_friction", {{"bore_N_per_Pa", 0}, {"rod_N_per_Pa", 0}, {"larger_1_per_Pa", 3e-7}}},
      {"asymmetric_friction", {{"turn_m_s", 1e-3}}},
      {"asymmetric_friction", {{"level_N", -300}, {"one_way", 1}}},
      {"throttle",
       {{"laminar_Pas_per_m3", 2e9}, {"turbulent_Pas2_per_m6", 3e14}, {"relief_Pa", 3e4}}},
  };
  for (const Form& form : forms) {
    PhsParams params = Quarter();
    params.effects.push_back({form.effect, {}, form.values});
    if (std::string(form.effect) == "gas_thermal") {  // so low that the accumulators take part
      for (auto& l : params.lines) l.accumulator_precharge_Pa = 1.2 * l.static_pressure_Pa;
    }
    const PhsSystem s = Compile(params);
    const Balance b = DriveOver(s, 4.0, 16000);
    EXPECT_LT(b.Error(), 2e-3) << form.effect << " work " << b.work << " stored " << b.stored
                               << " lost " << b.lost << " scale " << b.scale;
    EXPECT_GE(b.least_power, -1e-9) << form.effect;
  }
}

// What a supply of its own brings in counts as lost below zero: the balance holds with it.
TEST(EnergyOfForms, AValveThatFeedsALineBringsItsWorkIn) {
  for (const double n : {0.5, 1.0}) {
    PhsParams params = Quarter();
    params.effects.push_back(
        {"makeup_valve",
         {"L2"},
         {{"conductance_m3_per_Pas", 5e-13}, {"opening_Pa", 1.7e6}, {"exponent", n}}});
    const Balance b = DriveOver(Compile(params), 4.0, 32000);
    EXPECT_LT(b.Error(), 2e-3) << n << " work " << b.work << " stored " << b.stored << " lost "
                               << b.lost << " scale " << b.scale;
    EXPECT_LT(b.least_power, -0.01) << "it feeds";
  }
}

std::vector<std::string> PassiveEffects() {
  std::vector<std::string> names = {"none"};
  for (const auto& info : Catalogue().effects()) {
    // Parts on a bench carry no oil; a formula need not be passive; instruments do no work
    // (instrument_laws_test.cc); a valve that feeds a line brings work in (below).
    const bool other = info.family == "environment" || info.family == "element" ||
                       info.family == "instrument" || info.has_formula ||
                       info.name == "makeup_valve";
    if (!other) names.push_back(info.name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(EveryEffect, EnergyOf, ::testing::ValuesIn(PassiveEffects()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace phs::effects
