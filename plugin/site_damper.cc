#include "plugin/site_damper.h"

#include <cmath>

namespace phs::plugin {
namespace {

class SiteDampers : public LineElements {
 public:
  SiteDampers(const mjModel* m, const std::vector<DeclaredElement>& declared,
              std::vector<SiteDamperParams> params)
      : LineElements(m, declared), params_(std::move(params)) {}

 private:
  DamperForce Damper(int index, double, double speed) const noexcept override {
    return CalcSiteDamper(params_[static_cast<size_t>(index)], speed);
  }
  std::vector<SiteDamperParams> params_;
};

}  // namespace

DamperForce CalcSiteDamper(const SiteDamperParams& p, double speed) {
  const double linear = p.damping * std::abs(speed);
  if (linear <= p.relief) return {-p.damping * speed, p.damping};
  const double beyond = std::abs(speed) - p.relief / p.damping;
  return {-std::copysign(p.relief + p.relief_damping * beyond, speed), p.relief_damping};
}

Result<std::unique_ptr<const Elements>> FindSiteDampers(const mjModel* m, const ElementKind& kind) {
  const auto declared = ReadDeclared(m, kind, 2);
  if (!declared.ok()) return declared.error();
  std::unique_ptr<const Elements> found;
  std::vector<SiteDamperParams> params;
  for (const DeclaredElement& e : declared.value()) {
    params.push_back({e.numbers.at("damping_Ns_per_m"), e.numbers.at("relief_N"),
                      e.numbers.at("relief_damping_Ns_per_m")});
    if (params.back().relief_damping <= params.back().damping) continue;
    return Error{
        "MJCF text 'damper:" + e.name + "'", "relief_damping_Ns_per_m is above damping_Ns_per_m",
        "at most the damping below the relief force: a valve that opens does not stiffen", ""};
  }
  if (!params.empty()) found.reset(new SiteDampers(m, declared.value(), std::move(params)));
  return found;
}

}  // namespace phs::plugin
