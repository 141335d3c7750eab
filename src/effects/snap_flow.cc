#include "effects/snap_flow.h"

#include <algorithm>
#include <cmath>

namespace phs::effects {

using hydraulics::FlowPlace;

namespace {

/// Of V/2: where it would take an endless difference to go on.
constexpr double kMost = 1 - 1e-12;

double RestingShare(const SnapParams& p) {
  const double d = p.rest_Pa - p.centre_Pa;
  if (p.snap_Pa == 0) return std::tanh(d / p.width_Pa);
  double u = d < 0 ? -kMost : kMost;
  for (int i = 0; i < 200; ++i) u = std::tanh((d + p.snap_Pa * u) / p.width_Pa);
  return u;
}

}  // namespace

SnapFlow::SnapFlow(const SnapParams& params)
    : p_(params), half_(params.volume_m3 / 2), rest_(half_ * RestingShare(params)) {}

double SnapFlow::Flow(const FlowPlace& at, double dp, double* slope) const noexcept {
  const double stands = rest_ + at.passed, moved = Pushed(stands, dp);
  *slope = 0;
  if (moved == 0) return 0;
  const double u = (stands + moved) / half_;
  *slope = half_ * std::max(1 - u * u, 0.0) / (p_.width_Pa * p_.time_s);
  return moved / p_.time_s;
}

// Of a wall that helps itself over this is too much; a step iterates what is left.
double SnapFlow::Return(const FlowPlace& at, double dp) const noexcept {
  return Pushed(rest_ + at.passed, dp) == 0 ? 0 : 1 / p_.time_s;
}

double SnapFlow::Stored(double passed) const noexcept {
  return Energy(rest_ + passed) - Energy(rest_);
}

double SnapFlow::Held(double passed) const noexcept {
  const double u = Share(rest_ + passed);
  return p_.centre_Pa + p_.width_Pa * std::atanh(u) - p_.snap_Pa * u;
}

double SnapFlow::Pushed(double stands, double dp) const {
  const double d = dp - p_.centre_Pa + p_.snap_Pa * Share(stands);
  const double up = half_ * std::tanh((d - p_.friction_Pa) / p_.width_Pa) - stands;
  const double down = half_ * std::tanh((d + p_.friction_Pa) / p_.width_Pa) - stands;
  return up > 0 ? up : std::min(down, 0.0);
}

double SnapFlow::Share(double stands) const { return std::clamp(stands / half_, -kMost, kMost); }

double SnapFlow::Energy(double stands) const {
  const double u = Share(stands);
  return p_.centre_Pa * stands +
         half_ * (p_.width_Pa * (u * std::atanh(u) + 0.5 * std::log1p(-u * u)) -
                  0.5 * p_.snap_Pa * u * u);
}

}  // namespace phs::effects
