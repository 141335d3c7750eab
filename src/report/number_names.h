// Numbers of a run's summary as a reader knows them: "steady_curve.wheelsets.lead.sum_Y_N" is the
// "Track-shifting force ΣY, leading axle" in kN.
#pragma once

#include <string>

namespace phs::report {

struct NumberName {
  std::string words;  ///< as in the other tables of the page, without unit
  std::string unit;   ///< shown
  double factor = 1;  ///< from the file's unit to the shown one
};

/// Of a number by its path in summary.json; a path that is not known keeps its words.
NumberName NameOfNumber(const std::string& path);

/// "front bogie, leading outer wheel" of "front_lead_outer" with noun "wheel"; a name of another
/// kind as it is.
std::string PlaceWords(const std::string& name, const std::string& noun);

}  // namespace phs::report
