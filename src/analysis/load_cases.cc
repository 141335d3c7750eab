#include "analysis/load_cases.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "analysis/axle_pattern.h"
#include "plugin/observer.h"

namespace phs::analysis {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSteps = 200;          ///< load steps to the end of a case
constexpr double kMoveProbe = 1e-7;  ///< of finite differences [m, rad]
constexpr double kTolerance = 1.0;   ///< of the equilibrium [N, N m]
constexpr int kMostBalanceSteps = 60;

using Vector = Eigen::Vector4d;  ///< lead x, lead yaw, trail x, trail yaw

/// The bogie lifted off its rails with four free coordinates.
class HeldBogie {
 public:
  static Result<HeldBogie> Create(const vehicle::Simulation& simulation) {
    HeldBogie bogie;
    bogie.m_ = simulation.model();
    bogie.binding_ = &simulation.binding();
    if (bogie.binding_->phs().empty()) {
      return Error{"bogie '" + simulation.scenario().bogie + "'", "has no PHS to load",
                   "a bogie with cylinders", ""};
    }
    const auto pairs = plugin::FindBogies(*bogie.binding_);
    const std::string prefix = pairs.empty() ? "" : pairs[0].prefix;
    const char* names[4] = {"lead_x", "lead_yaw", "trail_x", "trail_yaw"};
    for (int i = 0; i < 4; ++i) {
      const std::string name = prefix + names[i];
      const int id = mj_name2id(bogie.m_, mjOBJ_JOINT, name.c_str());
      if (id < 0) {
        return Error{"MJCF joint '" + name + "'", "is missing: the load cases move it",
                     "slides *_x and hinges *_yaw of both axles against the frame", ""};
      }
      bogie.qpos_[i] = bogie.m_->jnt_qposadr[id];
      bogie.dof_[i] = bogie.m_->jnt_dofadr[id];
    }
    bogie.d_.reset(mj_makeData(bogie.m_));
    mj_resetData(bogie.m_, bogie.d_.get());
    for (int j = 0; j < bogie.m_->njnt; ++j) {
      // No wheel touches its rail: the contact search is out of the game.
      if (bogie.m_->jnt_type[j] == mjJNT_FREE) bogie.d_->qpos[bogie.m_->jnt_qposadr[j] + 2] += 1.0;
    }
    for (int i = 0; i < 4; ++i) bogie.rest_[i] = bogie.d_->qpos[bogie.qpos_[i]];
    return bogie;
  }

  /// Springs, linkages and PHS at displacement u from rest.
  Vector Resistance(const Vector& u) {
    for (int i = 0; i < 4; ++i) d_->qpos[qpos_[i]] = rest_[i] + u[i];
    binding_->SettleChambers(m_, d_.get());
    mj_forward(m_, d_.get());
    Vector force;
    for (int i = 0; i < 4; ++i) force[i] = d_->qfrc_passive[dof_[i]] + d_->qfrc_actuator[dof_[i]];
    return force;
  }
  /// From now on displacements count from here.
  void RestAt(const Vector& u) {
    for (int i = 0; i < 4; ++i) rest_[i] += u[i];
  }

  LoadState Describe(double load, const Vector& u) {
    Resistance(u);
    const plugin::PhsState phs = binding_->CalcPhs(m_, d_.get(), 0);
    LoadState state;
    state.load_N = load;
    for (int i = 0; i < 2; ++i) {
      state.x_m[i] = u[2 * i];
      state.yaw_rad[i] = u[2 * i + 1];
    }
    state.force_N = phs.force;
    state.piston_m = phs.piston;
    state.pressure_Pa = phs.pressure;
    return state;
  }

  const hydraulics::PhsSystem& system() const { return *binding_->phs()[0].system; }

  /// Change of the resistance with displacement about u.
  Eigen::Matrix4d Slope(const Vector& u) {
    Eigen::Matrix4d slope;
    for (int k = 0; k < 4; ++k) {
      Vector plus = u;
      Vector minus = u;
      plus[k] += kMoveProbe;
      minus[k] -= kMoveProbe;
      slope.col(k) = (Resistance(plus) - Resistance(minus)) / (2 * kMoveProbe);
    }
    return slope;
  }

 private:
  const mjModel* m_ = nullptr;
  const plugin::Binding* binding_ = nullptr;
  vehicle::DataPtr d_;
  int qpos_[4] = {};
  int dof_[4] = {};
  double rest_[4] = {};
};

/// Generalised load of a pattern per unit of P; boxes at +-`lever`.
Vector PatternLoad(const std::string& pattern, double lever) {
  if (pattern == "traction") return {2, 0, 2, 0};
  if (pattern == "braking") return {-2, 0, -2, 0};
  return {0, 2 * lever, 0, 2 * lever};
}

/// Newton with step halving from `u`; false if it does not settle.
bool Balance(HeldBogie* bogie, const Vector& load, Vector* u) {
  Vector r = bogie->Resistance(*u) + load;
  for (int iteration = 0; iteration < kMostBalanceSteps; ++iteration) {
    if (r.cwiseAbs().maxCoeff() < kTolerance) return true;
    const Vector step = bogie->Slope(*u).partialPivLu().solve(-r);
    double share = 1;
    Vector next = *u + step;
    Vector r_next = bogie->Resistance(next) + load;
    while (r_next.norm() > r.norm() && share > 1e-3) {
      share /= 2;
      next = *u + share * step;
      r_next = bogie->Resistance(next) + load;
    }
    *u = next;
    r = r_next;
  }
  return false;
}

void NoteOnce(const std::string& what, double load, std::vector<LimitReached>* reached) {
  for (const LimitReached& r : *reached) {
    if (r.what == what) return;
  }
  reached->push_back({what, load});
}

void NoteLimits(const hydraulics::PhsSystem& system, const LoadState& s, const PartLimits& limits,
                std::vector<LimitReached>* reached) {
  for (size_t i = 0; i < s.force_N.size(); ++i) {
    const std::string name = "cylinder " + system.cylinder_names()[i];
    if (std::abs(s.force_N[i]) >= limits.cylinder_N) {
      NoteOnce(fmt::format("{} beyond {:.0f} kN", name, limits.cylinder_N / 1e3), s.load_N,
               reached);
    }
    if (std::abs(s.piston_m[i]) >= limits.stroke_m) {
      NoteOnce(name + " on its end stop", s.load_N, reached);
    }
  }
  for (size_t i = 0; i < s.pressure_Pa.size(); ++i) {
    const auto& line = system.params().lines[i];
    if (s.pressure_Pa[i] <= limits.pressure_floor_Pa) {
      NoteOnce("line " + line.name + " empty", s.load_N, reached);
    }
    if (line.accumulator.volume_m3 > 0 && s.pressure_Pa[i] >= line.accumulator_precharge_Pa) {
      NoteOnce("line " + line.name + " blows off", s.load_N, reached);
    }
  }
}

/// A held bogie whose axles have gone to where they stand without load.
Result<HeldBogie> StandingBogie(const vehicle::Simulation& simulation) {
  auto bogie = HeldBogie::Create(simulation);
  if (!bogie.ok()) return bogie.error();
  Vector rest = Vector::Zero();
  if (!Balance(&bogie.value(), Vector::Zero(), &rest)) {
    return Error{"load cases", "the bogie finds no equilibrium without load", "", ""};
  }
  bogie.value().RestAt(rest);
  return bogie;
}

/// The load laid on from `u` in steps; false at the first that finds no equilibrium.
bool LayOn(HeldBogie* bogie, const LoadCase& load_case, double lever, Vector* u) {
  for (int i = 1; i <= kSteps; ++i) {
    const double load = load_case.load_N * i / kSteps;
    if (!Balance(bogie, load * PatternLoad(load_case.pattern, lever), u)) return false;
  }
  return true;
}

Json LinesJson(const hydraulics::PhsSystem& system, const LoadState& state) {
  Json lines = Json::array();
  for (size_t i = 0; i < state.pressure_Pa.size(); ++i) {
    lines.push_back({{"name", system.line_names()[i]}, {"pressure_Pa", state.pressure_Pa[i]}});
  }
  return lines;
}

double ShearStiffness(HeldBogie* bogie, const Vector& u) {
  const Vector both(0, 1, 0, 1);  // same-sense yaw
  return -both.dot(bogie->Slope(u) * both);
}

double LargestMagnitude(const std::vector<double>& values) {
  double largest = 0;
  for (double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

double LargestShift(const LoadState& state) {
  return std::max(std::abs(state.x_m[0]), std::abs(state.x_m[1]));
}

double LeastPressure(const LoadState& state) {
  return *std::min_element(state.pressure_Pa.begin(), state.pressure_Pa.end());
}

Json ResultJson(const LoadResult& result, const hydraulics::PhsSystem& system) {
  Json json = {{"name", result.load_case.name},
               {"pattern", result.load_case.pattern},
               {"load_per_box_N", result.load_case.load_N},
               {"source", result.load_case.source},
               {"lead_x_m", result.end.x_m[0]},
               {"trail_x_m", result.end.x_m[1]},
               {"lead_yaw_rad", result.end.yaw_rad[0]},
               {"trail_yaw_rad", result.end.yaw_rad[1]},
               {"largest_shift_m", LargestShift(result.end)},
               {"largest_cylinder_N", LargestMagnitude(result.end.force_N)},
               {"least_pressure_Pa", LeastPressure(result.end)},
               {"cylinders", Json::array()},
               {"lines", Json::array()},
               {"limits", Json::array()}};
  for (size_t i = 0; i < result.end.force_N.size(); ++i) {
    json["cylinders"].push_back({{"name", system.cylinder_names()[i]},
                                 {"force_N", result.end.force_N[i]},
                                 {"piston_m", result.end.piston_m[i]}});
  }
  json["lines"] = LinesJson(system, result.end);
  for (const auto& limit : result.limits) {
    json["limits"].push_back({{"what", limit.what}, {"load_per_box_N", limit.load_N}});
  }
  return json;
}

}  // namespace

std::vector<LoadCase> StandardLoadCases() {
  const std::string source = "thesis, Table 4-2";
  return {{"steering", "shear", 30e3, source},
          {"traction, electric braking", "traction", 52e3, source},
          {"braking", "braking", 82e3, source},
          {"unusual (shunting, 5 g)", "braking", 175e3, source}};
}

Result<std::vector<LoadResult>> CalcLoadCases(const vehicle::Simulation& simulation,
                                              const std::vector<LoadCase>& cases,
                                              const PartLimits& limits) {
  const plugin::InstantForces instant = simulation.Instant();
  auto bogie = StandingBogie(simulation);
  if (!bogie.ok()) return bogie.error();
  const double lever = BoxLever(simulation.model());
  std::vector<LoadResult> results;
  for (const LoadCase& load_case : cases) {
    LoadResult result{load_case, {}, {}};
    Vector u = Vector::Zero();
    for (int i = 1; i <= kSteps; ++i) {
      const double load = load_case.load_N * i / kSteps;
      if (!Balance(&bogie.value(), load * PatternLoad(load_case.pattern, lever), &u)) {
        return Error{"load case '" + load_case.name + "'",
                     fmt::format("finds no equilibrium at {:.1f} kN per box", load / 1e3), "", ""};
      }
      result.end = bogie.value().Describe(load, u);
      NoteLimits(bogie.value().system(), result.end, limits, &result.limits);
    }
    results.push_back(std::move(result));
  }
  return results;
}

Json LoadsJson(const vehicle::Simulation& simulation, const std::vector<LoadResult>& results) {
  const hydraulics::PhsSystem& system = *simulation.binding().phs()[0].system;
  Json json;
  json["bogie"] = simulation.scenario().bogie;
  json["phs"] = system.name();
  json["cases"] = Json::array();
  for (const auto& result : results) json["cases"].push_back(ResultJson(result, system));
  return json;
}

Result<HeldShear> CalcHeldShear(const vehicle::Simulation& simulation,
                                const std::vector<LoadCase>& cases) {
  const plugin::InstantForces instant = simulation.Instant();
  auto made = StandingBogie(simulation);
  if (!made.ok()) return made.error();
  HeldBogie& bogie = made.value();
  const double lever = BoxLever(simulation.model());
  const Vector rest = Vector::Zero();
  HeldShear shear;
  shear.rest = {"rest", true, ShearStiffness(&bogie, rest), bogie.Describe(0, rest)};
  for (const LoadCase& load_case : cases) {
    Vector u = rest;
    HeldLoad one{load_case.name, LayOn(&bogie, load_case, lever, &u)};
    one.state = bogie.Describe(load_case.load_N, u);
    if (one.held) one.shear_stiffness_Nm_per_rad = ShearStiffness(&bogie, u);
    shear.cases.push_back(std::move(one));
  }
  return shear;
}

Json HeldShearJson(const vehicle::Simulation& simulation, const HeldShear& shear) {
  const hydraulics::PhsSystem& system = *simulation.binding().phs()[0].system;
  Json json = {{"rest",
                {{"shear_stiffness_Nm_per_rad", shear.rest.shear_stiffness_Nm_per_rad},
                 {"lines", LinesJson(system, shear.rest.state)}}},
               {"cases", Json::array()}};
  for (const HeldLoad& load : shear.cases) {
    const auto said = [&](double x) { return load.held ? Json(x) : Json(nullptr); };
    Json lines = LinesJson(system, load.state);
    if (!load.held) {
      for (Json& line : lines) line["pressure_Pa"] = nullptr;
    }
    json["cases"].push_back({{"name", load.name},
                             {"held", load.held ? 1 : 0},
                             {"shear_stiffness_Nm_per_rad", said(load.shear_stiffness_Nm_per_rad)},
                             {"largest_shift_m", said(LargestShift(load.state))},
                             {"least_pressure_Pa", said(LeastPressure(load.state))},
                             {"lines", std::move(lines)}});
  }
  return json;
}

}  // namespace phs::analysis
