#include "effects/hose_expansion.h"

#include <cmath>
#include <memory>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

class HoseVolume final : public hydraulics::VolumeLaw {
 public:
  HoseVolume(double compliance, double stiffening, double p0)
      : compliance_(compliance), stiffening_(stiffening), p0_(p0) {}
  void Add(double pressure, double* volume, double* slope) const noexcept override {
    *volume += compliance_ * stiffening_ * std::log1p((pressure - p0_) / (stiffening_ + p0_));
    *slope += compliance_ * stiffening_ / (stiffening_ + pressure);
  }
  double Energy(double pressure) const noexcept override {
    const double rise = pressure - p0_;
    return compliance_ * stiffening_ *
           (rise - stiffening_ * std::log1p(rise / (stiffening_ + p0_)));
  }

 private:
  double compliance_, stiffening_, p0_;
};

Status Install(const EffectParams& effect, Extension* extension) {
  for (int line : TargetLines(effect, extension->params())) {
    extension->AddVolume(line,
                         std::make_unique<HoseVolume>(effect.values.at("compliance_m3_per_Pa"),
                                                      effect.values.at("stiffening_Pa"),
                                                      extension->line(line).static_pressure_Pa));
  }
  return {};
}

}  // namespace

const EffectInfo& HoseExpansionInfo() {
  static const EffectInfo info = {
      "hose_expansion",
      "hydraulic",
      "lines",
      "volume C p_k ln((p_k + p)/(p_k + p0))",
      {
          {"compliance_m3_per_Pa", "m3/Pa", 2e-13, 0, 1e-9, 1e-14, 3e-12, "C"},
          {"stiffening_Pa", "Pa", 1e9, 1e4, 1e12, 5e6, 1e9, "p_k"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
