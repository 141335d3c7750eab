#include "rail/shen_hedrick_elkins.h"

#include <cmath>

#include "rail/kalker.h"

namespace phs::rail {
namespace {

class ShenHedrickElkins : public CreepLaw {
 public:
  explicit ShenHedrickElkins(const ContactMaterial& m)
      : shear_(m.shear_modulus_Pa), curve_(m.poisson_ratio) {}
  CreepForce Calc(const CreepInput& in) const noexcept override {
    if (!InContact(in)) return {};
    CreepForce f = CalcLinearCreep(in, curve_.At(in.a / in.b), shear_);
    const double r = std::hypot(f.x, f.y) / (in.friction * in.normal);
    const double share = r < 3 ? 1 - r / 3 + r * r / 27 : 1 / r;
    f = {f.x * share, f.y * share, f.moment * share};
    return WithoutDelivery(in, f);
  }
  std::string name() const override { return "shen_hedrick_elkins"; }

 private:
  double shear_;
  KalkerCurve curve_;
};

}  // namespace

CreepLawRow ShenHedrickElkinsRow() {
  return {"shen_hedrick_elkins",
          "linear theory cut back to the friction limit",
          {},
          [](const CreepLawParams& p) {
            return std::unique_ptr<CreepLaw>(new ShenHedrickElkins(p.material));
          }};
}

}  // namespace phs::rail
