#include "effects/warm_leakage.h"

#include <algorithm>
#include <memory>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::FlowPlace;
using hydraulics::Port;

class WarmGap final : public hydraulics::FlowLaw {
 public:
  explicit WarmGap(const EffectParams& effect)
      : conductance_(effect.values.at("conductance_m3_per_Pas")),
        opens_K_(effect.values.at("opens_K")),
        range_K_(effect.values.at("range_K")) {}
  double Flow(const FlowPlace& at, double dp, double* slope) const noexcept override {
    *slope = conductance_ * std::clamp((at.warmer - opens_K_) / range_K_, 0.0, 1.0);
    return *slope * dp;
  }

 private:
  double conductance_, opens_K_, range_K_;
};

Status Install(const EffectParams& effect, Extension* extension) {
  for (int line : TargetLines(effect, extension->params())) {
    extension->AddFlow(Port::kLine, Port::kAtmosphere, -1, line, "warm_leakage",
                       std::make_unique<WarmGap>(effect));
  }
  return {};
}

}  // namespace

const EffectInfo& WarmLeakageInfo() {
  static const EffectInfo info = {
      "warm_leakage",
      "hydraulic",
      "lines",
      "q = G s (p - p_atmosphere), s = (warmth - opens)/range within 0 … 1",
      {
          {"conductance_m3_per_Pas", "m3/(Pa s)", 1e-13, 0, 1e-3, 1e-16, 1e-11, "G, fully open"},
          {"opens_K", "K", -5, -100, 100, -5, 40, "warmth above static at which it opens"},
          {"range_K", "K", 10, 0.1, 100, 1, 30, "from there to fully open"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
