#include "rail/creep_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/yaml.h"
#include "rail/fastsim.h"
#include "rail/kalker.h"

namespace phs::rail {
namespace {

class LinearLaw : public CreepLaw {
 public:
  explicit LinearLaw(const ContactMaterial& m)
      : shear_(m.shear_modulus_Pa), curve_(m.poisson_ratio) {}
  CreepForce Calc(const CreepInput& in) const noexcept override {
    if (!(in.normal > 0)) return {};
    const KalkerCoefficients c = curve_.At(in.a / in.b);
    const double ab = in.a * in.b;
    const double ab15 = ab * std::sqrt(ab);
    return {-shear_ * ab * c.c11 * in.xi, -shear_ * (ab * c.c22 * in.eta + ab15 * c.c23 * in.phi),
            shear_ * (ab15 * c.c23 * in.eta - ab * ab * c.c33 * in.phi)};
  }
  std::string name() const override { return "linear"; }

 private:
  double shear_;
  KalkerCurve curve_;
};

class FastsimLaw : public CreepLaw {
 public:
  explicit FastsimLaw(const CreepLawParams& p)
      : shear_(p.material.shear_modulus_Pa),
        curve_(p.material.poisson_ratio),
        grid_{p.fastsim_strips, p.fastsim_slices, p.elliptic_bound} {}
  CreepForce Calc(const CreepInput& in) const noexcept override {
    if (!(in.normal > 0)) return {};
    return CalcFastsim(in, curve_.At(in.a / in.b), shear_, grid_);
  }
  std::string name() const override { return "fastsim"; }

 private:
  double shear_;
  KalkerCurve curve_;
  FastsimGrid grid_;
};

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
  if (params.method == "linear") return std::unique_ptr<CreepLaw>(new LinearLaw(params.material));
  return std::unique_ptr<CreepLaw>(new FastsimLaw(params));
}

}  // namespace phs::rail
