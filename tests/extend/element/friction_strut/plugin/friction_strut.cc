#include "plugin/friction_strut.h"

#include <cmath>

namespace phs::plugin {
namespace {

struct StrutParams {
  double level, turn;
};

class FrictionStruts : public LineElements {
 public:
  FrictionStruts(const mjModel* m, const std::vector<DeclaredElement>& declared,
                 std::vector<StrutParams> params)
      : LineElements(m, declared), params_(std::move(params)) {}

 private:
  DamperForce Damper(int index, double, double speed) const noexcept override {
    const StrutParams& p = params_[static_cast<size_t>(index)];
    const double share = std::tanh(speed / p.turn);
    return {-p.level * share, p.level / p.turn * (1 - share * share)};
  }
  std::vector<StrutParams> params_;
};

}  // namespace

Result<std::unique_ptr<const Elements>> FindFrictionStruts(const mjModel* m,
                                                           const ElementKind& kind) {
  const auto declared = ReadDeclared(m, kind, 2);
  if (!declared.ok()) return declared.error();
  std::vector<StrutParams> params;
  for (const DeclaredElement& e : declared.value()) {
    params.push_back({e.numbers.at("level_N"), e.numbers.at("turn_m_s")});
  }
  std::unique_ptr<const Elements> found;
  if (!params.empty()) found.reset(new FrictionStruts(m, declared.value(), std::move(params)));
  return found;
}

}  // namespace phs::plugin
