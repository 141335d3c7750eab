#include "effects/restriction.h"

#include <cmath>
#include <utility>

#include "effects/targets.h"

namespace phs::effects {

using hydraulics::FlowLaw;
using hydraulics::GapFlow;
using hydraulics::PipeFlow;
namespace {

/// G of GapFlow that lets q0 pass at R q0.
double Conductance(double R, double exponent) {
  return std::pow(GapFlow::kReference / (R * kRestrictionFlow), exponent - 1) / R;
}

/// What flows as a power of its drop; none with the power one.
std::unique_ptr<FlowLaw> Lifted(const RestrictionWay& out, const RestrictionWay& in,
                                double exponent, double viscosity) {
  if (exponent == 1) return nullptr;
  const double away = Conductance(out.laminar, exponent);
  const double back = Conductance(in.laminar, exponent);
  constexpr double kAlways = -1e300;
  return std::make_unique<GapFlow>(away / viscosity, exponent, kAlways, back / away);
}

/// The turbulent drop, and the laminar one unless it is `lifted`.
std::unique_ptr<FlowLaw> Pipe(const RestrictionWay& out, const RestrictionWay& in, bool lifted,
                              double viscosity) {
  if (lifted && out.turbulent == 0 && in.turbulent == 0) return nullptr;
  constexpr double kNone = 1e3;  // [Pa s/m3]
  const auto way = [&](const RestrictionWay& w) {
    return PipeFlow::Resistance{lifted ? kNone : w.laminar * viscosity, w.turbulent};
  };
  return std::make_unique<PipeFlow>(way(out), way(in), 0);
}

/// A valve's spring.
std::unique_ptr<FlowLaw> Spring(const RestrictionWay& out, const RestrictionWay& in) {
  if (out.cracking_Pa == 0 && in.cracking_Pa == 0) return nullptr;
  return std::make_unique<hydraulics::PoppetFlow>(out.cracking_Pa, in.cracking_Pa,
                                                  kRestrictionFlow);
}

/// One behind the other, as far as they are there.
std::unique_ptr<FlowLaw> Behind(std::unique_ptr<FlowLaw> first, std::unique_ptr<FlowLaw> second) {
  if (first == nullptr) return second;
  if (second == nullptr) return first;
  return hydraulics::InSeries(std::move(first), std::move(second));
}

}  // namespace

std::unique_ptr<FlowLaw> MakeRestriction(const RestrictionWay& out, const RestrictionWay& in,
                                         double exponent, const hydraulics::PhsParams& params) {
  const double viscosity = AtModelTemperature(1, params);
  auto lifted = Lifted(out, in, exponent, viscosity);
  const bool by_power = lifted != nullptr;
  // The other two have drops in closed form, so their sum stands behind what has a flow so.
  return Behind(std::move(lifted), Behind(Pipe(out, in, by_power, viscosity), Spring(out, in)));
}

}  // namespace phs::effects
