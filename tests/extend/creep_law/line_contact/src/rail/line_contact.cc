#include "rail/line_contact.h"

#include <cmath>
#include <numbers>

#include "rail/carter.h"

namespace phs::rail {
namespace {

/// R of the middle strip [m]: a² = 4 (1 - nu) N' R/(pi G). Of an ellipsoidal pressure it carries
/// N' = 3 N/(4 b) per length.
double RelativeRadius(const CreepInput& in, const ContactMaterial& m) {
  const double per_length = 0.75 * in.normal / in.b;
  return std::numbers::pi * m.shear_modulus_Pa * in.a * in.a /
         (4 * (1 - m.poisson_ratio) * per_length);
}

class LineContact : public CreepLaw {
 public:
  explicit LineContact(const ContactMaterial& m) : material_(m) {}
  CreepForce Calc(const CreepInput& in) const noexcept override {
    if (!InContact(in)) return {};
    const double slip = std::hypot(in.xi, in.eta);
    if (!(slip > 0)) return {};
    const double share = CalcCarterStrips(slip, RelativeRadius(in, material_), in.a, in.friction);
    const double force = in.friction * in.normal * share / slip;
    return {force * in.xi, force * in.eta, 0};
  }
  std::string name() const override { return "line_contact"; }

 private:
  ContactMaterial material_;
};

}  // namespace

CreepLawRow LineContactRow() {
  return {"line_contact", "Carter's theory on strips", {}, [](const CreepLawParams& p) {
            return std::unique_ptr<CreepLaw>(new LineContact(p.material));
          }};
}

}  // namespace phs::rail
