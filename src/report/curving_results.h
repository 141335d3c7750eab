// Saved results of a curving run, read back for the report.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/hdf5_series.h"
#include "base/result.h"
#include "report/curving_input.h"
#include "report/report_page.h"

namespace phs::report {

/// One bogie's run.
struct BogieRun {
  std::string name = {};   ///< "rigid_link"
  std::string label = {};  ///< "rigid link"
  int colour = 0;
  int dash = 0;
  nlohmann::ordered_json summary = {};
  Series series = {};  ///< empty without a series file

  /// A recorded channel; null if it was not recorded.
  const std::vector<double>* Channel(const std::string& channel) const;
  /// Mean of a channel over [begin, end] of the lead wheelset's arc length; NaN if not recorded.
  double Mean(const std::string& channel, double begin, double end) const;
  /// Standard deviation over the same; NaN if not recorded.
  double Deviation(const std::string& channel, double begin, double end) const;
  /// Number at a JSON pointer of the summary; NaN if absent.
  double Number(const std::string& pointer) const;
  /// Quantity of a wheelset, wheel, cylinder or line of the steady curve; NaN if absent.
  double Steady(const std::string& list, const std::string& item, const std::string& key) const;
  bool ok() const { return summary.value("status", "ok") == "ok"; }
};

struct Section {
  std::string kind = {};  ///< tangent | transition | curve
  double begin = 0;
  double end = 0;
  double radius = 0;  ///< of a curve [m], without sign
};

/// An axle of a bogie as it is called in channels and in texts.
struct AxleName {
  std::string name = {};  ///< "lead"
  std::string word = {};  ///< "leading"
};

struct CurvingResults {
  nlohmann::ordered_json all = {};
  std::vector<BogieRun> runs = {};  ///< the reference first
  std::vector<Section> sections = {};
  std::string track_name = {};
  /// Names of the bogies on the vehicle as prefixes of channels: {""} or {"front_", "rear_"}.
  std::vector<std::string> prefixes = {};
  double steady_begin = 0;  ///< last third of the (first) circular arc [m]
  double steady_end = 0;
  double radius = 0;  ///< of that arc [m]; 0 = no arc
  int hand = 0;       ///< +1 the arc curves to the left, -1 to the right, 0 no arc

  const BogieRun& reference() const { return runs.front(); }
  /// Name of the wheel on the high rail ("outer") or low rail of the arc as side: left or right.
  std::string Side(bool outer) const;
  /// Axles of a bogie from front to rear: two, or three with a middle one.
  std::vector<AxleName> Axles(const std::string& prefix) const;
  /// Sum of T-gamma over the wheels of one bogie in the steady curve; of all with prefix "" [N].
  static double SteadyWear(const BogieRun& run, const std::string& prefix);
  /// The spin part of the same, |Mz phi|, which the wear number leaves away [N].
  static double SteadySpin(const BogieRun& run, const std::string& prefix);
};

Result<CurvingResults> ReadCurvingResults(const CurvingReportInput& input);

/// Magnitude of `other` over that of `own` in words: "2.1 ×"; where `own` is below `floor` (what
/// the run can resolve) "at least 40 ×", over that floor, and where both are "–".
std::string RatioText(double other, double own, double floor);

/// "R 550 m" of a curve, "transition"; empty for a tangent.
std::string SectionLabel(const Section& section);
/// "PHS" for "phs", "rigid link" for "rigid_link".
std::string BogieLabel(std::string name);
/// "front bogie, " for the prefix "front_"; empty for a single bogie.
std::string BogieWords(const std::string& prefix);

}  // namespace phs::report
