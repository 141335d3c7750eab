// Level higher at creeping speed: + F_s exp(-|v|/v_s), both directions. F_s [N] 0 … 2000, v_s [m/s]
// 1e-4 … 0.05 (Stribeck; Armstrong-Helouvry, Dupont and Canudas de Wit, Automatica 30 (1994) 1083).
// Dissipative: part of the friction level.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& StribeckInfo();

}  // namespace phs::effects
