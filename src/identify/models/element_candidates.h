// What may be free in the declared model of a bench part, and the effects of the catalogue that it
// may lack. Ranges and starts stand in the rows of the effects (EffectSearch::bench), in sizes seen in
// the data: a seal rubs with 5 N, a machine axis with 500.
#pragma once

#include <vector>

#include "identify/fit/effect_variants.h"
#include "identify/fit/search_fit.h"
#include "identify/models/element_data.h"

namespace phs::identify::element {

/// Sizes seen in the data.
struct Sizes {
  double force_N = 1;       ///< typical swing of the force (root mean square about its mean)
  double length_m = 1e-3;   ///< half the span of x
  double speed_m_s = 1e-3;  ///< high speed (95 % quantile)
  double acceleration_m_s2 = 1;
  double pressure_Pa = 1e5;  ///< typical |p|
  double temperature_K = 1;  ///< half the span of T
  double duration_s = 1;
  double ramp_m_s = 0;    ///< of a static friction model, as fitted
  double friction_N = 1;  ///< level of the fitted declared friction
};
Sizes MeasureSizes(const ElementData& data);

/// The declared model's free numbers: `named` (as SetParameter takes them), or the usual ones:
/// offset; mass, stiffness and pressure area where declared; friction level (both directions
/// alike where declared alike), viscous part, Stribeck excess, presliding stiffness.
Result<search::FreeModel> DeclaredElement(const hydraulics::PhsParams& declared,
                                          const std::vector<std::string>& named,
                                          const Sizes& sizes);

/// The model on the clock of one record, with its further channels.
Result<rigs::RigModel> BenchOf(const hydraulics::PhsParams& params, const ElementRecord& record);

/// Names of the effects that a bench can be searched for.
std::vector<std::string> ElementCandidateNames();

/// Effects that this data could show, with starts, of those asked for; and the user's own.
std::vector<search::Candidate> ListElementCandidates(const search::FreeModel& model,
                                                     const ElementData& data, const Sizes& sizes);

}  // namespace phs::identify::element
