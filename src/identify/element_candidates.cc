#include "identify/element_candidates.h"

#include <algorithm>
#include <cmath>

#include "effects/catalogue.h"
#include "measurement/series.h"
#include "phs_model/phs_model.h"

namespace phs::identify::element {

using measurement::Quantile;
using measurement::StandardDeviation;
namespace {

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

/// One free number of a candidate: its allowed range of the catalogue cut to what the data can
/// tell.
struct Number {
  const char* name;
  double low, high, scale;  ///< scale 0: logarithmic
};

class CandidateList {
 public:
  explicit CandidateList(const FreeModel& model) : model_(model) {}

  void Add(const std::string& effect, const std::vector<Number>& numbers,
           std::vector<std::vector<double>> starts,
           const std::vector<std::pair<const char*, double>>& fixed = {}) {
    for (const auto& present : model_.params.effects) {
      if (present.name == effect) return;
    }
    const EffectInfo* info = effects::Catalogue().Find(effect);
    PHS_CHECK(info != nullptr);
    Candidate c;
    c.effect = c.params.name = effect;
    for (const auto& p : info->parameters) c.params.values[p.name] = p.otherwise;
    for (const auto& [name, value] : fixed) c.params.values[name] = value;
    for (const Number& n : numbers) {
      const auto* p = &*std::find_if(info->parameters.begin(), info->parameters.end(),
                                     [&](const auto& q) { return q.name == n.name; });
      FreeParameter free;
      free.name = "effects." + effect + "." + n.name;
      free.low = std::max(n.low, p->min), free.high = std::min(n.high, p->max);
      free.logarithmic = n.scale == 0;
      free.scale = n.scale == 0 ? 1 : n.scale;
      c.free.push_back(free);
    }
    c.starts = std::move(starts);
    out_.push_back(std::move(c));
  }
  std::vector<Candidate> Take() { return std::move(out_); }

 private:
  const FreeModel& model_;
  std::vector<Candidate> out_;
};

bool IsFree(const FreeModel& model, const std::string& name) {
  return std::any_of(model.free.begin(), model.free.end(),
                     [&](const FreeParameter& p) { return p.name.starts_with(name); });
}

void AddFriction(const FreeModel& model, const ElementData& data, const Sizes& s,
                 CandidateList* list) {
  const double F = s.friction_N, L = s.length_m, V = s.speed_m_s;
  const double c = F / V;  // viscous force as large as the level at high speed
  list->Add("asymmetric_friction", {{"viscous_Ns_per_m", -20 * c, 20 * c, c}},
            {{0.1 * c}, {-0.1 * c}}, {{"level_N", 0}});
  // A level that differs by direction and an offset of the load cell are one and the same force.
  if (!IsFree(model, "element.offset")) {
    list->Add("asymmetric_friction",
              {{"viscous_Ns_per_m", -20 * c, 20 * c, c}, {"level_N", -F, F, F}},
              {{0.1 * c, 0}, {-0.1 * c, 0}});
    list->Add("asymmetric_friction", {{"level_N", -F, F, F}}, {{0}}, {{"viscous_Ns_per_m", 0}});
  }
  if (data.has_pressure) {
    const double k = F / s.pressure_Pa;
    list->Add("pressure_friction", {{"bore_N_per_Pa", -k, 20 * k, k}}, {{0.1 * k}},
              {{"rod_N_per_Pa", 0}});
  }
  if (data.has_temperature) {
    const double a = 1 / s.temperature_K;
    list->Add("temperature_friction", {{"slope_1_per_K", -2 * a, 2 * a, a}}, {{0}});
  }
  list->Add("position_friction", {{"slope_1_per_m", -1 / L, 1 / L, 1 / L}}, {{0}});
  list->Add("position_friction",
            {{"slope_1_per_m", -1 / L, 1 / L, 1 / L},
             {"curvature_1_per_m2", -1 / (L * L), 5 / (L * L), 1 / (L * L)}},
            {{0, 0}});
  if (!IsFree(model, "friction.breakaway")) {
    // Below the ramp of a static model there is no level to fall.
    const bool ramped = model.params.friction.model == hydraulics::FrictionModel::kStatic;
    const double slowest = std::max(1e-3 * V, ramped ? 3 * s.ramp_m_s : 0.0);
    list->Add("stribeck", {{"extra_N", 0, 5 * F, F}, {"speed_m_s", slowest, V, 0}},
              {{0.2 * F, 0.01 * V}, {0.2 * F, 0.05 * V}, {0.2 * F, 0.3 * V}});
  }
  if (!IsFree(model, "friction.viscous")) {
    list->Add("viscous_friction",
              {{"extension_Ns_per_m", 0, 50 * c, c}, {"retraction_Ns_per_m", 0, 50 * c, c}},
              {{0.1 * c, 0.1 * c}});
  }
  if (model.params.friction.model == hydraulics::FrictionModel::kStatic) {
    list->Add("presliding", {{"stiffness_N_per_m", 2 * F / L, 1e6 * F / L, 0}},
              {{10 * F / L}, {100 * F / L}, {1000 * F / L}, {1e4 * F / L}},
              {{"breakaway_ratio", 0.5}});
  }
  list->Add("dwell_friction",
            {{"extra_N", 0, 5 * F, F},
             {"time_s", 1e-3 * s.duration_s, s.duration_s, 0},
             {"length_m", 1e-4 * L, L, 0}},
            {{0.2 * F, 0.02 * s.duration_s, 0.01 * L}, {0.2 * F, 0.1 * s.duration_s, 0.1 * L}});
}

}  // namespace

Sizes MeasureSizes(const ElementData& data) {
  Sizes s;
  std::vector<double> force, x, v, a, p, T;
  for (const ElementRecord& r : data.records) {
    const auto acceleration = rigs::DifferentiateMotion(r.motion.speed_m_s[0], r.motion.step_s);
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
  if (e.mass_kg > 0) usual.push_back(Logarithmic("element.mass_kg", e.mass_kg, 30));
  if (e.stiffness_N_per_m > 0) {
    usual.push_back(Logarithmic("element.stiffness_N_per_m", e.stiffness_N_per_m, 30));
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
    const bool either_sign = name.starts_with("effects.unlisted.");
    model.free.push_back(value.value() > 0 && !either_sign ? Logarithmic(name, value.value(), 30)
                                                           : Linear(name, value.value(), F));
  }
  return model;
}

std::vector<Candidate> ListElementCandidates(const FreeModel& model, const ElementData& data,
                                             const Sizes& s) {
  CandidateList list(model);
  const double F = s.friction_N, L = s.length_m;
  if (model.params.friction.model != hydraulics::FrictionModel::kNone) {
    AddFriction(model, data, s, &list);
    list.Add("mount_compliance", {{"stiffness_N_per_m", 2 * F / L, 1e5 * F / L, 0}},
             {{20 * F / L}, {500 * F / L}});
    list.Add("backlash", {{"gap_m", 1e-4 * L, L, 0}}, {{1e-3 * L}, {0.02 * L}},
             {{"contact_N_per_m", std::max(1e5, 1e5 * F / L)}});
  }
  if (data.has_pressure && !IsFree(model, "element.pressure_area")) {
    const double A = s.force_N / s.pressure_Pa;
    list.Add("pressure_area", {{"area_m2", -50 * A, 50 * A, A}}, {{0}});
  }
  const double m = s.force_N / s.acceleration_m_s2;
  if (!IsFree(model, "element.mass")) {
    list.Add("moving_mass", {{"mass_kg", 0, 20 * m, m}}, {{0.05 * m}});
  } else {
    list.Add("load_flexibility",
             {{"mass_kg", 1e-4 * m, 2 * m, 0},
              {"frequency_Hz", 1, 400, 0},
              {"damping_ratio", 2e-3, 2, 0}},
             {{0.1 * m, 8, 0.05}, {0.1 * m, 25, 0.05}, {0.1 * m, 60, 0.05}, {0.3 * m, 25, 0.3}});
  }
  list.Add("sensor_drift", {{"load_N_per_s", -F, F, F / s.duration_s}}, {{0}});
  list.Add("sensor_delay", {{"load_s", 0, 0.2, 0.01}}, {{1e-3}, {1e-2}});
  return list.Take();
}

}  // namespace phs::identify::element
