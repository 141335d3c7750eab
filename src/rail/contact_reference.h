// Where CONTACT puts the reference point of a wheel's contact, for comparisons with its tables.
//
// Its place, angle and creepages are those of the centre of the undeformed overlap, weighted with
// the square of its depth (OverlapCentre in contact_search.h), of all patches within 8 mm of each
// other: not those of the load. The two differ where tread and flange root bear at once.
#pragma once

#include <vector>

#include "base/result.h"
#include "base/table.h"
#include "rail/wheelset_cases.h"

namespace phs::rail {

/// In the units and axes of the table of results (y to the right).
struct ContactReference {
  double rail_y_mm = 0;
  double angle_rad = 0;
  double radius_mm = 0;  ///< of the wheel
};

/// Of every case of `result` = CalcWheelsetCases(cases), all on the side `cases.side`.
Result<std::vector<ContactReference>> CalcContactReferences(const WheelsetCases& cases,
                                                            const Table& result);

}  // namespace phs::rail
