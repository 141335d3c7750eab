// Hollow wear of a wheel tread, in one number: the depth of a trough about the place where the
// wheel mostly runs.
//
//   z_worn(y) = z(y) - d/2 (1 + cos(pi (y - y0)/w))   for |y - y0| < w, else z(y)
//
//        y outwards ->            z down: worn metal lies above the new tread line
//   flange \                      inside of y0 the tread gets steeper, outside flatter and at last
//           \____   ____  new     hollow: the conicity about the centred position grows from the
//                \_/      worn    flange's side
//
// Trough and slopes are smooth, so that a fit over d is. Shape after measured hollow-worn treads as
// described by Sawley, Urban and Walker, Wear 258 (2005) 1100: one trough about the running line,
// some 60 mm wide; the raised cosine is an assumption.
#pragma once

#include "base/result.h"
#include "rail/profile.h"

namespace phs::rail {

struct TreadWear {
  double depth_m = 0;          ///< d at the trough's bottom, 0 … 5 mm; < 0: metal left standing
  double half_width_m = 0.03;  ///< w, 10 … 60 mm
  double centre_m = 0;         ///< y0 in the wheel profile, -30 … 30 mm (tape circle: 0)
  bool any() const { return depth_m != 0; }
};

Status Validate(const TreadWear& wear);

/// Takes the worn metal off a wheel profile. @pre Validate(wear).ok()
void WearTread(const TreadWear& wear, Profile* wheel);

}  // namespace phs::rail
