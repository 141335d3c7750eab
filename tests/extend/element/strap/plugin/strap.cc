#include "plugin/strap.h"

#include <algorithm>

namespace phs::plugin {
namespace {

struct StrapParams {
  double stiffness, length, damping;
};

class Straps : public LineElements {
 public:
  Straps(const mjModel* m, const std::vector<DeclaredElement>& declared,
         std::vector<StrapParams> params)
      : LineElements(m, declared), params_(std::move(params)) {}

 private:
  SpringForce Spring(int index, double length) const noexcept override {
    const StrapParams& p = params_[static_cast<size_t>(index)];
    const double taut = length - p.length;
    if (!(taut > 0)) return {};
    return {-p.stiffness * taut, p.stiffness, p.stiffness * taut * taut / 2};
  }
  DamperForce Damper(int index, double length, double speed) const noexcept override {
    const StrapParams& p = params_[static_cast<size_t>(index)];
    const double pull = p.stiffness * (length - p.length);
    if (!(pull > 0)) return {};
    const double force = -p.damping * speed;
    return force > pull ? DamperForce{pull, 0} : DamperForce{force, p.damping};
  }
  std::vector<StrapParams> params_;
};

}  // namespace

Result<std::unique_ptr<const Elements>> FindStraps(const mjModel* m, const ElementKind& kind) {
  const auto declared = ReadDeclared(m, kind, 2);
  if (!declared.ok()) return declared.error();
  std::vector<StrapParams> params;
  for (const DeclaredElement& e : declared.value()) {
    params.push_back({e.numbers.at("stiffness_N_per_m"), e.numbers.at("length_m"),
                      e.numbers.at("damping_Ns_per_m")});
  }
  std::unique_ptr<const Elements> found;
  if (!params.empty()) found.reset(new Straps(m, declared.value(), std::move(params)));
  return found;
}

}  // namespace phs::plugin
