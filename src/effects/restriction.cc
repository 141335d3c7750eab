#include "effects/restriction.h"

#include <cmath>

#include "effects/targets.h"

namespace phs::effects {

using hydraulics::GapFlow;
using hydraulics::PipeFlow;
namespace {

/// G of GapFlow that lets q0 pass at R q0.
double Conductance(double R, double exponent) {
  return std::pow(GapFlow::kReference / (R * kRestrictionFlow), exponent - 1) / R;
}

}  // namespace

std::unique_ptr<hydraulics::FlowLaw> MakeRestriction(PipeFlow::Resistance out,
                                                     PipeFlow::Resistance in, double exponent,
                                                     const hydraulics::PhsParams& params) {
  if (exponent == 1) {
    out.laminar = AtModelTemperature(out.laminar, params);
    in.laminar = AtModelTemperature(in.laminar, params);
    return std::make_unique<PipeFlow>(out, in, 0);
  }
  const double away = Conductance(out.laminar, exponent);
  const double back = Conductance(in.laminar, exponent);
  const double viscosity = AtModelTemperature(1, params);
  constexpr double kAlways = -1e300;
  auto lifted = std::make_unique<GapFlow>(away / viscosity, exponent, kAlways, back / away);
  if (out.turbulent == 0 && in.turbulent == 0) return lifted;
  constexpr double kNone = 1e3;  // [Pa s/m3]: no laminar drop beside it
  out.laminar = in.laminar = kNone;
  return hydraulics::InSeries(std::move(lifted), std::make_unique<PipeFlow>(out, in, 0));
}

}  // namespace phs::effects
