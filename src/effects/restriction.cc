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

/// Without a valve's spring.
std::unique_ptr<FlowLaw> Opening(const RestrictionWay& out, const RestrictionWay& in,
                                 double exponent, const hydraulics::PhsParams& params) {
  const double viscosity = AtModelTemperature(1, params);
  if (exponent == 1) {
    return std::make_unique<PipeFlow>(PipeFlow::Resistance{out.laminar * viscosity, out.turbulent},
                                      PipeFlow::Resistance{in.laminar * viscosity, in.turbulent},
                                      0);
  }
  const double away = Conductance(out.laminar, exponent);
  const double back = Conductance(in.laminar, exponent);
  constexpr double kAlways = -1e300;
  auto lifted = std::make_unique<GapFlow>(away / viscosity, exponent, kAlways, back / away);
  if (out.turbulent == 0 && in.turbulent == 0) return lifted;
  constexpr double kNone = 1e3;  // [Pa s/m3]: no laminar drop beside it
  return hydraulics::InSeries(
      std::move(lifted), std::make_unique<PipeFlow>(PipeFlow::Resistance{kNone, out.turbulent},
                                                    PipeFlow::Resistance{kNone, in.turbulent}, 0));
}

}  // namespace

std::unique_ptr<FlowLaw> MakeRestriction(const RestrictionWay& out, const RestrictionWay& in,
                                         double exponent, const hydraulics::PhsParams& params) {
  auto opening = Opening(out, in, exponent, params);
  if (out.cracking_Pa == 0 && in.cracking_Pa == 0) return opening;
  return hydraulics::InSeries(
      std::move(opening),
      std::make_unique<hydraulics::PoppetFlow>(out.cracking_Pa, in.cracking_Pa, kRestrictionFlow));
}

}  // namespace phs::effects
