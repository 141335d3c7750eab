// The blow-off accumulators open at another gas precharge than declared. [Pa] absolute at static
// temperature. Acts on lines that have an accumulator. Table B-1 of the thesis points to 14.3 MPa
// where 15 MPa was declared. A bladder lifts off gradually: three equal parts of the accumulator
// have precharges whose standard deviation is spread_Pa; 0 = at once.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& AccumulatorPrechargeInfo();

}  // namespace phs::effects
