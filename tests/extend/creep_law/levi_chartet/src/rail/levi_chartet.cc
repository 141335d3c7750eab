#include "rail/levi_chartet.h"

#include <cmath>

#include "base/numbers.h"
#include "rail/kalker.h"

namespace phs::rail {
namespace {

class LeviChartet : public CreepLaw {
 public:
  LeviChartet(const ContactMaterial& m, double power)
      : shear_(m.shear_modulus_Pa), power_(power), curve_(m.poisson_ratio) {}
  CreepForce Calc(const CreepInput& in) const noexcept override {
    if (!InContact(in)) return {};
    CreepForce f = CalcLinearCreep(in, curve_.At(in.a / in.b), shear_);
    const double r = std::hypot(f.x, f.y) / (in.friction * in.normal);
    const double share = std::pow(1 + std::pow(r, power_), -1 / power_);
    f = {f.x * share, f.y * share, f.moment * share};
    return WithoutDelivery(in, f);
  }
  std::string name() const override { return "levi_chartet"; }

 private:
  double shear_, power_;
  KalkerCurve curve_;
};

double PowerOf(const CreepLawParams& p) {
  return p.option.empty() ? 2 : ParseNumber(p.option).value_or(2);
}

bool ReadPower(const std::string& option, CreepLawParams* p) {
  const auto power = ParseNumber(option);
  if (!power || !(*power >= 1 && *power <= 10)) return false;
  p->option = option;
  return true;
}

}  // namespace

CreepLawRow LeviChartetRow() {
  return {"levi_chartet",
          "linear theory with Levi and Chartet's saturation",
          {"n", "n = 1 … 10, the power", ReadPower},
          [](const CreepLawParams& p) {
            return std::unique_ptr<CreepLaw>(new LeviChartet(p.material, PowerOf(p)));
          }};
}

}  // namespace phs::rail
