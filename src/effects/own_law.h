// A law that a model or a user's candidate brings with it, under a name of its own, in place of a
// row of the catalogue: where it acts, what it gives, its states, and further channels of the record
// that it asks for. In a model file:
//
//   effects:
//     coil_drag:
//       formula: "piston = k*z*coil/1[V]; dz_m/dt = v - abs(v)*z/z0; given coil_V"
//       k_N_per_m: 3.0e4
//       z0_m: 2.0e-4
//
// Numbers, states and channels are written with their unit (`k_N_per_m`, `z_m`, `coil_V`) and named
// in formulas without it (`k`, `z`, `coil`); a name without ending is a plain number. The other
// variables, units and functions: formula.h. States begin at 0. Where it acts:
//
//   piston      force beside friction, F > 0 tension [N]   x v s p q t dT, states, channels
//   mounting    force beside the cylinder, at the driven end of a bench or quarter rig, shown by its
//               load cell [N]                              x v t (bench: p), states, channels
//   reading_N   what the load cell shows beyond the truth  x p q t, channels
//   reading_m   what the piston's sensor shows beyond it   x p q t, channels
//   reading_Pa  what pressure sensors of lines show        x p q t, channels; targets: lines
//   volume      taken up by lines [m3]                     p; targets: lines
//   flow        out of a line, or from bore to rod of a cylinder [m3/s], 0 at p = 0   p t; targets
//
// Not passive by construction. Channels exist on rigs only: elsewhere such a law is refused.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "hydraulics/extension.h"

namespace phs::effects {

/// The parts of such a formula, as text.
struct OwnLaw {
  std::string where;                                        ///< "piston" …
  std::string expression;                                   ///< what it gives
  std::vector<std::pair<std::string, std::string>> states;  ///< name with unit, its rate
  std::vector<std::string> channels;                        ///< with unit
};

/// The places, for messages and schemas.
const std::vector<std::string>& OwnPlaces();

/// As `formula` of an effect has it.
std::string ToText(const OwnLaw& law);
/// Splits the text; what its parts say is checked when a model is made of it.
Result<OwnLaw> ParseOwnLaw(const std::string& text);

/// The row of all such laws (EffectTable::own).
const hydraulics::EffectInfo& OwnLawInfo();
/// True if it gives or takes oil.
bool OwnActsOnOil(const hydraulics::EffectParams& effect);
/// True if it is of the rig, not of the cylinder: a reading, or beside the cylinder.
bool StaysOnRig(const hydraulics::EffectParams& effect);

}  // namespace phs::effects
