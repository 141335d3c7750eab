// A body that moves with the driven ends of cylinders over a step: the beam of a full rig, a mass.
#pragma once

#include "hydraulics/phs_instant.h"

namespace phs::hydraulics {

class CarriedBody {
 public:
  virtual ~CarriedBody() = default;
  /// What it holds against its way over the step, without the cylinders (inertia, dampers, less
  /// what drives it), and the slope of that, > 0; way and force in units of the body (rad and N m,
  /// or m and N).
  virtual double Hold(double way, double* slope) const = 0;
  /// Way of each driven end over that of the body [m per unit]; 0: it is given.
  double arm[kMaxCylinders] = {};
};

}  // namespace phs::hydraulics
