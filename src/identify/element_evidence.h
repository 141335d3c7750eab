// What the better of two fits of a bench part brings:
// n_eff ln(s²_without/s²_with) - dk ln n_eff, n_eff independent samples in the coloured residual of
// the better model; the share of the residual's rms removed; the same on blocks left out in turn
// (the fit without them by one linear step).
#pragma once

#include "identify/element_fit.h"

namespace phs::identify::element {

struct ElementEvidence {
  double delta_bic = 0;
  double estimation_gain = 0;
  double cross_validation_gain = 0;
};

ElementEvidence CompareFits(const ElementFit& without, const ElementFit& with);

}  // namespace phs::identify::element
