// Level higher at creeping speed: + F_s exp(-|v|/v_s), in retraction retraction_ratio [-] times as
// much: a lip drags its film in one way only. F_s [N] 0 … 2000, v_s [m/s] 1e-4 … 0.05 (Stribeck;
// Armstrong-Helouvry, Dupont and Canudas de Wit, Automatica 30 (1994) 1083).
// The film does not thin at once: with a film time tau the law is over u, du/dt = (|v| - u)/tau, so
// that friction stays high where sliding begins and low where it ends (frictional memory: Hess and
// Soom, J. Tribology 112 (1990) 147). u = 0 after long rest. Dissipative: part of the friction
// level.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& StribeckInfo();

}  // namespace phs::effects
