#include "effects/seal_shuttle.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::FlowPlace;
using hydraulics::Port;

class ShuttleFlow final : public hydraulics::FlowLaw {
 public:
  /// `rest`: d in the static state, where the ring stands without friction.
  ShuttleFlow(double volume, double width, double centre, double friction, double time, double rest)
      : half_(volume / 2),
        width_(width),
        centre_(centre),
        friction_(friction),
        time_(time),
        rest_(half_ * std::tanh((rest - centre) / width)) {}

  double Flow(const FlowPlace& at, double dp, double* slope) const noexcept override {
    const double stands = rest_ + at.passed, moved = Pushed(stands, dp);
    *slope = 0;
    if (moved == 0) return 0;
    const double u = (rest_ + at.passed + moved) / half_;
    *slope = half_ * std::max(1 - u * u, 0.0) / (width_ * time_);
    return moved / time_;
  }
  double Return(const FlowPlace& at, double dp) const noexcept override {
    return Pushed(rest_ + at.passed, dp) == 0 ? 0 : 1 / time_;
  }
  double Stored(double passed) const noexcept override {
    return Energy(rest_ + passed) - Energy(rest_);
  }
  double Held(double passed) const noexcept override {
    return centre_ + width_ * std::atanh(Share(rest_ + passed));
  }

 private:
  // How far the ring would go from where it stands [m3].
  double Pushed(double stands, double dp) const {
    const double up = half_ * std::tanh((dp - centre_ - friction_) / width_) - stands;
    const double down = half_ * std::tanh((dp - centre_ + friction_) / width_) - stands;
    return up > 0 ? up : std::min(down, 0.0);
  }
  double Share(double stands) const { return std::clamp(stands / half_, -kMost, kMost); }
  double Energy(double stands) const {
    const double u = Share(stands);
    return centre_ * stands + width_ * half_ * (u * std::atanh(u) + 0.5 * std::log1p(-u * u));
  }
  static constexpr double kMost = 1 - 1e-12;

  double half_, width_, centre_, friction_, time_, rest_;
};

Status InstallSealShuttle(const EffectParams& effect, Extension* extension) {
  if (!(effect.values.at("volume_m3") > 0)) return {};
  for (int i : TargetCylinders(effect, extension->params())) {
    const auto& cylinder = extension->params().cylinders[static_cast<size_t>(i)];
    const double rest = StaticPressure(cylinder.bore_line, *extension) -
                        StaticPressure(cylinder.rod_line, *extension);
    extension->AddFlow(Port::kBore, Port::kRod, i, -1, "seal_shuttle",
                       std::make_unique<ShuttleFlow>(
                           effect.values.at("volume_m3"), effect.values.at("width_Pa"),
                           effect.values.at("centre_Pa"), effect.values.at("friction_Pa"),
                           effect.values.at("slide_s"), rest));
  }
  return {};
}

}  // namespace

const EffectInfo& SealShuttleInfo() {
  static const EffectInfo info = {
      "seal_shuttle",
      "hydraulic",
      "cylinders",
      "V/2 tanh((d -+ P_h - d_c)/P) from bore to rod, d = p_bore - p_rod, with the seal's ring",
      {
          {"volume_m3", "m3", 5e-7, 0, 1e-4, 1e-9, 1e-5, "V: clearance of the groove, ring area"},
          {"width_Pa", "Pa", 5e5, 1e3, 1e8, 1e4, 1e7,
           "P: half the difference that moves it across"},
          {"centre_Pa", "Pa", 0, -1e8, 1e8, -1e7, 1e7, "d_c: where it stands in the middle"},
          {"friction_Pa", "Pa", 0, 0, 1e7, 1e4, 3e6, "P_h: difference at which it comes loose"},
          {"slide_s", "s", 2e-3, 1e-4, 1e3, 2e-3, 1, "tau"},
      },
      InstallSealShuttle,
      {
          .rig =
              {
                  {.free = {{"volume_m3", 3e-7}, {"width_Pa", 2e5, 3e6, 3}}},
              },
          .options =
              {
                  {.free = {{"friction_Pa", 2e5, 1e6, 2}}},
                  {.free = {{"slide_s", 0.02, 0.1, 2}}},
                  {.free = {{"centre_Pa", -2e6, 2e6, 3}}},
              },
          .over = {"m3", "pq"},
      }};
  return info;
}

}  // namespace phs::effects
