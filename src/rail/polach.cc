#include "rail/polach.h"

#include <cmath>
#include <numbers>

namespace phs::rail {

CreepForce CalcPolach(const CreepInput& in, const KalkerCoefficients& c, double shear,
                      double adhesion_factor, double slip_factor) noexcept {
  const double pi = std::numbers::pi;
  const double limit = in.friction * in.normal;
  const double turned = in.eta + in.phi * in.a;
  const double syc = std::abs(turned) > std::abs(in.eta) ? turned : in.eta;
  const double s = std::sqrt(in.xi * in.xi + syc * syc);
  if (!(s > 0)) return {};
  const double slip = std::sqrt(in.xi * in.xi + in.eta * in.eta);
  const double cx = slip > 0 ? c.c11 * in.xi / slip : 0.0;
  const double cy = slip > 0 ? c.c22 * in.eta / slip : c.c22;
  const double e = shear * pi * in.a * in.b * std::sqrt(cx * cx + cy * cy) * s / (4 * limit);
  const double ka = adhesion_factor * e;
  const double force = -2 * limit / pi * (ka / (1 + ka * ka) + std::atan(slip_factor * e));

  const double q = 1 + 6.3 * (1 - std::exp(-in.a / in.b));
  const double es =
      8.0 / 3 * shear * in.b * std::sqrt(in.a * in.b) * c.c23 * std::abs(syc) / (limit * q);
  const double d = (es * es - 1) / (es * es + 1);
  const double root = 1 - d * d;
  const double k = es * (d * d * d / 3 - d * d / 2 + 1.0 / 6) - root * std::sqrt(root) / 3;
  CreepForce f;
  f.x = force * in.xi / s;
  f.y = force * in.eta / s + 9.0 / 16 * in.a * limit * k * q * in.phi / s;
  const double size = std::sqrt(f.x * f.x + f.y * f.y);
  if (size > limit) {
    f.x *= limit / size;
    f.y *= limit / size;
  }
  return f;
}

namespace {

class PolachLaw : public CreepLaw {
 public:
  explicit PolachLaw(const CreepLawParams& p)
      : shear_(p.material.shear_modulus_Pa),
        adhesion_(p.polach_adhesion),
        slip_(p.polach_slip),
        curve_(p.material.poisson_ratio) {}
  CreepForce Calc(const CreepInput& in) const noexcept override {
    if (!InContact(in)) return {};
    return WithoutDelivery(in, CalcPolach(in, curve_.At(in.a / in.b), shear_, adhesion_, slip_));
  }
  std::string name() const override { return "polach"; }

 private:
  double shear_;
  double adhesion_;
  double slip_;
  KalkerCurve curve_;
};

}  // namespace

CreepLawRow PolachRow() {
  return {"polach", "Polach's closed form", {}, [](const CreepLawParams& p) {
            return std::unique_ptr<CreepLaw>(new PolachLaw(p));
          }};
}

}  // namespace phs::rail
