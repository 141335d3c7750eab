#include "identify/models/element_candidates.h"

#include <algorithm>
#include <cmath>

#include "effects/catalogue.h"
#include "effects/unlisted.h"
#include "identify/models/own_candidates.h"
#include "measurement/series.h"
#include "phs_model/phs_model.h"

namespace phs::identify::element {

using measurement::Quantile;
using measurement::StandardDeviation;
namespace {

using hydraulics::EffectForm;
using hydraulics::EffectInfo;
using hydraulics::PhsParams;
using search::Candidate;
using search::FreeModel;
using search::FreeParameter;

FreeParameter Linear(const std::string& name, double start, double scale) {
  return {name, start, start - 1e3 * scale, start + 1e3 * scale, false, scale};
}
FreeParameter Logarithmic(const std::string& name, double start, double factor) {
  return {name, start, start / factor, start * factor, true, 1};
}

bool IsFree(const FreeModel& model, const std::string& name) {
  return std::any_of(model.free.begin(), model.free.end(),
                     [&](const FreeParameter& p) { return p.name.starts_with(name); });
}

/// Size of a number of this unit.
double SizeOf(const std::string& unit, const Sizes& s) {
  const double F = s.friction_N, L = s.length_m;
  const std::pair<const char*, double> sizes[] = {{"N", F},
                                                  {"m", L},
                                                  {"m/s", s.speed_m_s},
                                                  {"s", s.duration_s},
                                                  {"kg", s.force_N / s.acceleration_m_s2},
                                                  {"m2", s.force_N / s.pressure_Pa},
                                                  {"N/m", F / L},
                                                  {"N s/m", F / s.speed_m_s},
                                                  {"N/s", F / s.duration_s},
                                                  {"N/Pa", F / s.pressure_Pa},
                                                  {"1/m", 1 / L},
                                                  {"1/m2", 1 / (L * L)},
                                                  {"1/K", 1 / s.temperature_K}};
  for (const auto& [known, size] : sizes) {
    if (unit == known) return size;
  }
  return 1;
}

/// True if the part and its record have what the form needs, and nothing that says the same.
bool IsFor(const EffectForm& form, const FreeModel& model, const ElementData& data) {
  const auto has = [&](const std::string& name) {
    return (name == "p_Pa" && data.has_pressure) ||
           (name == "temperature_K" && data.has_temperature) || IsFree(model, name);
  };
  const bool stateless = model.params.friction.model == hydraulics::FrictionModel::kStatic;
  return std::all_of(form.needs.begin(), form.needs.end(), has) &&
         std::none_of(form.beside.begin(), form.beside.end(), has) &&
         (stateless || !form.of_static_friction);
}

/// Below the ramp of a static law there is no level that could depend on the speed.
void BoundSpeeds(const EffectForm& form, const EffectInfo& info, double slowest, Candidate* c) {
  for (size_t i = 0; i < form.free.size(); ++i) {
    for (const auto& p : info.parameters) {
      if (p.name != form.free[i].name || p.unit != "m/s") continue;
      c->free[i].low = std::max(c->free[i].low, std::min(slowest, 0.5 * c->free[i].high));
      for (auto& start : c->starts) start[i] = std::max(start[i], c->free[i].low);
    }
  }
}

}  // namespace

Sizes MeasureSizes(const ElementData& data) {
  Sizes s;
  std::vector<double> force, x, v, a, p, T;
  for (const ElementRecord& r : data.records) {
    const auto acceleration = rigs::AccelerationOf(r.motion, r.motion.speed_m_s[0]);
    for (size_t k = 0; k < r.row_sample.size(); ++k) {
      if (!r.fitted[k]) continue;
      const auto i = static_cast<size_t>(r.row_sample[k]);
      force.push_back(r.row_force_N[k]);
      x.push_back(r.motion.position_m[0][i]);
      v.push_back(std::abs(r.motion.speed_m_s[0][i]));
      a.push_back(std::abs(acceleration[i]));
      if (data.has_pressure) p.push_back(std::abs(r.motion.pressure_Pa[i]));
      if (data.has_temperature) T.push_back(r.motion.temperature_K[i]);
    }
    s.duration_s = std::max(s.duration_s, r.motion.step_s * r.motion.num_samples());
  }
  const auto positive = [](double value, double otherwise) {
    return value > 0 ? value : otherwise;
  };
  s.force_N = positive(StandardDeviation(force), 1);
  s.length_m = positive(0.5 * (Quantile(x, 0.99) - Quantile(x, 0.01)), 1e-3);
  s.speed_m_s = positive(Quantile(v, 0.95), 1e-3);
  s.acceleration_m_s2 = positive(Quantile(a, 0.95), 1);
  if (!p.empty()) s.pressure_Pa = positive(Quantile(p, 0.5), 1e5);
  if (!T.empty()) s.temperature_K = positive(0.5 * (Quantile(T, 0.99) - Quantile(T, 0.01)), 1);
  s.friction_N = s.force_N;
  return s;
}

Result<FreeModel> DeclaredElement(const PhsParams& declared, const std::vector<std::string>& named,
                                  const Sizes& s) {
  FreeModel model{declared, {}};
  const auto& f = declared.friction;
  const auto& e = declared.element;
  const double F = s.force_N;
  std::vector<FreeParameter> usual = {Linear("element.offset_N", e.offset_N, F)};
  // What is declared is uncertain; of a gas spring its filling, not its length.
  for (const char* name : {"element.mass_kg", "element.stiffness_N_per_m",
                           "element.hardening_N_per_m3", "element.damping_Ns_per_m",
                           "element.quadratic_damping_Ns2_per_m2", "element.gas_force_N"}) {
    const double value = phs_model::GetParameter(declared, name).value();
    if (value > 0) usual.push_back(Logarithmic(name, value, 30));
    if (value < 0) usual.push_back(Linear(name, value, -value));
  }
  if (e.pressure_area_m2 != 0) {
    usual.push_back(Linear("element.pressure_area_m2", e.pressure_area_m2, F / s.pressure_Pa));
  }
  const bool rubs = f.model != hydraulics::FrictionModel::kNone;
  if (rubs && f.curve == hydraulics::FrictionCurve::kTable) {
    usual.push_back(Logarithmic("friction.scale", std::max(f.scale, 1e-3), 100));
  } else if (rubs) {
    const auto level = [&](const char* both, const char* one, const char* two, double a, double b) {
      if (a == b) {
        if (a > 0) usual.push_back(Logarithmic(both, a, 30));
      } else {
        usual.push_back(Logarithmic(one, std::max(a, 1e-3 * F), 30));
        usual.push_back(Logarithmic(two, std::max(b, 1e-3 * F), 30));
      }
    };
    level("friction.coulomb_N", "friction.coulomb_extension_N", "friction.coulomb_retraction_N",
          f.coulomb_extension_N, f.coulomb_retraction_N);
    level("friction.viscous_Ns_per_m", "friction.viscous_extension_Ns_per_m",
          "friction.viscous_retraction_Ns_per_m", f.viscous_extension_Ns_per_m,
          f.viscous_retraction_Ns_per_m);
  }
  if (f.model == hydraulics::FrictionModel::kStatic &&
      f.curve == hydraulics::FrictionCurve::kCoulomb) {
    usual.push_back(Logarithmic("friction.ramp_speed_m_s", f.ramp_speed_m_s, 30));
  }
  if (f.model == hydraulics::FrictionModel::kPresliding) {
    usual.push_back(Logarithmic("friction.stiffness_N_per_m", f.stiffness_N_per_m, 30));
  }
  if (named.empty()) {
    model.free = usual;
    return model;
  }
  for (const std::string& name : named) {
    const auto found = std::find_if(usual.begin(), usual.end(),
                                    [&](const FreeParameter& p) { return p.name == name; });
    if (found != usual.end()) {
      model.free.push_back(*found);
      continue;
    }
    Result<double> value = phs_model::GetParameter(declared, name);
    if (!value.ok()) return Error{"free: " + name, value.error().what, "", value.error().mend};
    const bool either_sign = name.starts_with("effects." + effects::UnlistedInfo().name + ".");
    model.free.push_back(value.value() > 0 && !either_sign ? Logarithmic(name, value.value(), 30)
                                                           : Linear(name, value.value(), F));
  }
  return model;
}

std::vector<Candidate> ListElementCandidates(const FreeModel& model, const ElementData& data,
                                             const Sizes& s) {
  const auto& friction = model.params.friction;
  const bool rubs = friction.model != hydraulics::FrictionModel::kNone;
  const bool ramped = friction.model == hydraulics::FrictionModel::kStatic;
  const search::FormScale scale{[&](const std::string& unit) { return SizeOf(unit, s); }, {}};
  std::vector<Candidate> out;
  for (const EffectInfo& info : effects::Catalogue().effects()) {
    // A mounting has friction behind it, or nothing.
    const bool of_friction = info.family == "friction" || info.family == "mounting";
    if (search::IsIn(model.params, info.name) || (of_friction && !rubs)) continue;
    // What hangs between force and part: the mass that moves is free.
    if (data.by_force && info.family == "element") continue;
    for (const EffectForm& form : info.search.bench) {
      if (!IsFor(form, model, data)) continue;
      out.push_back(MakeCandidate(info, form, scale));
      if (ramped) BoundSpeeds(form, info, 3 * s.ramp_m_s, &out.back());
    }
  }
  std::erase_if(out, [&](const Candidate& c) {
    const auto& asked = data.candidates;
    return !asked.empty() && std::find(asked.begin(), asked.end(), c.effect) == asked.end();
  });
  search::AddOwnCandidates(data.own, model.params, &out);
  return out;
}

std::vector<std::string> ElementCandidateNames() {
  std::vector<std::string> names;
  for (const EffectInfo& info : effects::Catalogue().effects()) {
    if (!info.search.bench.empty()) names.push_back(info.name);
  }
  names.push_back(effects::UnlistedInfo().name);
  return names;
}

Result<rigs::RigModel> BenchOf(const PhsParams& params, const ElementRecord& record) {
  rigs::RigOptions options;
  options.extra = record.extra;
  return rigs::RigModel::Create(rigs::RigKind::kElement, params, options);
}

}  // namespace phs::identify::element
