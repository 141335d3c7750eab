// Part of the moving mass hangs on a spring and a damper behind the driven point:
//   m_f y" = k (x - y) + c (x' - y'),   F = (m - m_f) x" + k (x - y) + c (x' - y')
// with k = m_f (2 pi f)², c = 2 zeta m_f 2 pi f. f: natural frequency with the drive held. Slow
// motion sees the whole mass m, fast motion only m - m_f. Element rig only. Stepped exactly for
// motion that is linear over a sample.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& LoadFlexibilityInfo();

}  // namespace phs::effects
