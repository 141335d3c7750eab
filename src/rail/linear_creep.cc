#include "rail/linear_creep.h"

#include "rail/kalker.h"

namespace phs::rail {
namespace {

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

}  // namespace

CreepLawRow LinearCreepRow() {
  return {"linear", "Kalker's linear theory, without a limit", {}, [](const CreepLawParams& p) {
            return std::unique_ptr<CreepLaw>(new LinearLaw(p.material));
          }};
}

}  // namespace phs::rail
