// The blow-off accumulators open at another gas precharge than declared. [Pa] absolute at static
// temperature. Acts on lines that have an accumulator. Table B-1 of the thesis points to 14.3 MPa
// where 15 MPa was declared.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& AccumulatorPrechargeInfo();

}  // namespace phs::effects
