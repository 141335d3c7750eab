#include "effects/cavitation.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "effects/dissolving_air.h"
#include "effects/targets.h"
#include "hydraulics/gas_law.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Places;

class ReleasedAir final : public hydraulics::VolumeLaw {
 public:
  // A line whose static pressure is below p_c has its air out already: p_c is taken there.
  ReleasedAir(double volume, double release, double p0)
      : pV_(volume * hydraulics::kAtmosphere), release_(std::min(release, p0)) {}
  void Add(double pressure, double, double* volume, double* slope) const noexcept override {
    if (pressure >= release_) return;
    *volume -= pV_ * (1 / pressure - 1 / release_);
    *slope += pV_ / (pressure * pressure);
  }
  double Energy(double pressure, double) const noexcept override {
    return pressure >= release_ ? 0 : pV_ * std::log(pressure / release_);
  }

 private:
  double pV_, release_;
};

constexpr double kAtOnce = 1e-3;  // [s] beside a lag of the other way

Status InstallCavitation(const EffectParams& effect, Extension* extension) {
  for (int line : TargetLines(effect, extension->params())) {
    const hydraulics::LineParams& l = extension->line(line);
    const double air = effect.values.at("solubility") *
                       LineFactor(effect, extension->params(), line) * l.oil_volume_m3;
    const double release = effect.values.at("release_Pa");
    const double out = effect.values.at("release_time_s");
    const double back = effect.values.at("dissolving_time_s");
    if (out > 0 || back > 0) {
      const LagTimes times{std::max(out, kAtOnce), std::max(back, kAtOnce)};
      const Solution solution{std::min(release, l.static_pressure_Pa), 0};
      extension->AddVolume(line, std::make_unique<LaggingAir>(Bubble{air, 1}, solution, times,
                                                              l.static_pressure_Pa));
    } else {
      extension->AddVolume(line, std::make_unique<ReleasedAir>(air, release, l.static_pressure_Pa));
    }
  }
  return {};
}

}  // namespace

const EffectInfo& CavitationInfo() {
  static const EffectInfo info = {
      "cavitation",
      "hydraulic",
      "lines",
      "air released below p_c: V = b V_oil p_a (1/p - 1/p_c)",
      {
          {"release_Pa", "Pa", 1e5, 1e2, 1e8, 2e3, 1.5e6, "p_c"},
          {"solubility", "-", 0.09, 0, 0.5, 0.01, 0.5, "b"},
          {"release_time_s", "s", 0, 0, 1e6, 0, 10, "air comes out with this lag; 0 = at once"},
          {"dissolving_time_s", "s", 0, 0, 1e6, 0, 60, "and goes back with this; 0 = at once"},
          {"rod_ratio", "-", 1, 1e-3, 1e3, 0.2, 5, "air of rod lines over that of bore lines"},
      },
      InstallCavitation,
      {
          .rig =
              {
                  {.free = {{"release_Pa", 8e4, 1.2e6, 4}, {"solubility", 0.05}},
                   .places = Places::kEach},
                  {.free = {{"release_Pa", 2.5e5, 1.2e6, 3},
                            {"solubility", 0.05},
                            {"dissolving_time_s", 1, 3, 2}},
                   .held = {{"release_time_s", 0.3}},
                   .places = Places::kEach},
              },
          .options =
              {
                  {.free = {{"release_time_s", 0.3}, {"dissolving_time_s", 0.3, 3, 2}}},
                  {.free = {{"release_time_s", 0.3}}},
                  {.free = {{"rod_ratio", 1}}, .of_sides = true},
              },
      }};
  return info;
}

}  // namespace phs::effects
