#include "rail/creep_law.h"

#include <cmath>

#include "rail/fastsim.h"
#include "rail/kalker.h"
#include "rail/polach.h"

namespace phs::rail {
namespace {

bool InContact(const CreepInput& in) {
  return in.normal > 0 && in.friction > 0 && in.a > 0 && in.b > 0;
}

class LinearLaw : public CreepLaw {
 public:
  explicit LinearLaw(const ContactMaterial& m)
      : shear_(m.shear_modulus_Pa), curve_(m.poisson_ratio) {}
  CreepForce Calc(const CreepInput& in) const noexcept override {
    if (!InContact(in)) return {};
    return CalcLinearCreep(in, curve_.At(in.a / in.b), shear_);
  }
  std::string name() const override { return "linear"; }

 private:
  double shear_;
  KalkerCurve curve_;
};

class PolachLaw : public CreepLaw {
 public:
  explicit PolachLaw(const CreepLawParams& p)
      : shear_(p.material.shear_modulus_Pa),
        adhesion_(p.polach_adhesion),
        slip_(p.polach_slip),
        curve_(p.material.poisson_ratio) {}
  CreepForce Calc(const CreepInput& in) const noexcept override {
    if (!InContact(in)) return {};
    return CalcPolach(in, curve_.At(in.a / in.b), shear_, adhesion_, slip_);
  }
  std::string name() const override { return "polach"; }

 private:
  double shear_;
  double adhesion_;
  double slip_;
  KalkerCurve curve_;
};

class FastsimLaw : public CreepLaw {
 public:
  explicit FastsimLaw(const CreepLawParams& p)
      : params_(p),
        curve_(p.material.poisson_ratio),
        fastsim_({p.fastsim_strips, p.fastsim_slices, p.elliptic_bound, FastsimCells::kStrip}) {}
  CreepForce Calc(const CreepInput& original) const noexcept override {
    if (!InContact(original)) return {};
    const double shear = params_.material.shear_modulus_Pa;
    const KalkerCoefficients c = curve_.At(original.a / original.b);
    CreepInput in = original;
    if (params_.slope_reduction.active()) {
      in = WithSlopeReduction(in, c, shear, params_.slope_reduction);
    }
    if (params_.blended_flexibility) in = WithBlendedFlexibility(in, c, shear);
    const NormalisedForce f = fastsim_.Calc(Normalise(in, c, shear, params_.elliptic_bound));
    const double limit = in.friction * in.normal;
    return {limit * f.x, limit * f.y, limit * (in.a + in.b) * f.moment};
  }
  std::string name() const override { return "fastsim"; }

 private:
  CreepLawParams params_;
  KalkerCurve curve_;
  Fastsim fastsim_;
};

Status InRange(const char* key, double value, double low, double high) {
  if (value >= low && value <= high) return {};
  return Error{key, "is " + std::to_string(value),
               std::to_string(low) + " … " + std::to_string(high), ""};
}

Status Validate(const CreepLawParams& p) {
  const Status checks[] = {
      InRange("shear_modulus_Pa", p.material.shear_modulus_Pa, 1e9, 1e12),
      InRange("poisson_ratio", p.material.poisson_ratio, 0, 0.5),
      InRange("fastsim_strips", p.fastsim_strips, 2, Fastsim::kMaxStrips),
      InRange("fastsim_slices", p.fastsim_slices, 2, 1000),
      InRange("slope_reduction.k0", p.slope_reduction.k0, 1e-3, 1),
      InRange("slope_reduction.alpha", p.slope_reduction.alpha, 0, 1),
      InRange("slope_reduction.beta", p.slope_reduction.beta, 0, 1e3),
      InRange("polach_adhesion", p.polach_adhesion, 1e-3, 1),
      InRange("polach_slip", p.polach_slip, 1e-3, p.polach_adhesion),
  };
  for (const Status& check : checks) {
    if (!check.ok()) return check;
  }
  return {};
}

}  // namespace

double FrictionLaw::At(double slip_speed) const {
  return coefficient *
         ((1 - falling_ratio) * std::exp(-falling_rate_s_m * slip_speed) + falling_ratio);
}

const std::vector<std::string>& CreepLawNames() {
  static const std::vector<std::string> names = {"linear", "fastsim", "polach", "kalker_table"};
  return names;
}

Result<std::unique_ptr<CreepLaw>> CreateCreepLaw(const CreepLawParams& params) {
  const Status valid = Validate(params);
  if (!valid.ok()) return valid.error();
  using Law = std::unique_ptr<CreepLaw>;
  if (params.method == "linear") return Law(new LinearLaw(params.material));
  if (params.method == "polach") return Law(new PolachLaw(params));
  if (params.method == "fastsim" || params.method == "kalker_table") {
    return Law(new FastsimLaw(params));
  }
  return Error{"creep law", "'" + params.method + "' is not known",
               "linear, fastsim, polach, kalker_table", ""};
}

}  // namespace phs::rail
