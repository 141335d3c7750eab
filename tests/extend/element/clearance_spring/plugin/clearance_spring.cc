#include "plugin/clearance_spring.h"

#include <cmath>

namespace phs::plugin {
namespace {

class ClearanceSprings : public LineElements {
 public:
  ClearanceSprings(const mjModel* m, std::vector<DeclaredElement> declared)
      : LineElements(m, declared), declared_(std::move(declared)) {}

 private:
  SpringForce Spring(int index, double length) const noexcept override {
    const auto& numbers = declared_[static_cast<size_t>(index)].numbers;
    const double stiffness = numbers.find("stiffness_N_per_m")->second;
    const double way = length - numbers.find("length_m")->second;
    const double beyond = std::abs(way) - numbers.find("clearance_m")->second;
    if (!(beyond > 0)) return {};
    return {-std::copysign(stiffness * beyond, way), stiffness, stiffness * beyond * beyond / 2};
  }
  DamperForce Damper(int, double, double) const noexcept override { return {}; }
  std::vector<DeclaredElement> declared_;
};

}  // namespace

Result<std::unique_ptr<const Elements>> FindClearanceSprings(const mjModel* m,
                                                             const ElementKind& kind) {
  auto declared = ReadDeclared(m, kind, 2);
  if (!declared.ok()) return declared.error();
  std::unique_ptr<const Elements> found;
  if (!declared.value().empty()) found.reset(new ClearanceSprings(m, std::move(declared).value()));
  return found;
}

}  // namespace phs::plugin
