// The parts of the curving report, one function each; every part reads the saved results only.
#pragma once

#include <string>
#include <vector>

#include "report/curving_results.h"
#include "report/report_page.h"

namespace phs::report {

// curving_tables.cc
void AddStatus(const CurvingResults& results, ReportPage* page);
void AddKeyFigures(const CurvingResults& results, ReportPage* page);
void AddHeadlineTable(const CurvingResults& results, ReportPage* page);
void AddComparisonBars(const CurvingResults& results, ReportPage* page);
void AddEnergyTable(const CurvingResults& results, ReportPage* page);
void AddInputs(const CurvingResults& results, ReportPage* page);

// curving_remarks.cc
void AddRunWarnings(const CurvingResults& results, ReportPage* page);
void AddDiscretisation(const CurvingResults& results, ReportPage* page);

// curving_standards.cc
bool HasStandards(const CurvingResults& results);
void AddStandards(const CurvingResults& results, ReportPage* page);

// curving_facts.cc
/// Radius, cant, speed, balance.
void AddTrackWords(const CurvingResults& results, ReportPage* page);
/// The wheels that carry most in the steady curve.
void AddWheelWords(const CurvingResults& results, ReportPage* page);

// curving_words.cc
void AddSteeringWords(const CurvingResults& results, ReportPage* page);
void AddNextSteps(const CurvingResults& results, ReportPage* page);

// curving_plan.cc
void AddPlanView(const CurvingResults& results, ReportPage* page);
void AddMomentBudget(const CurvingResults& results, ReportPage* page);

// curving_bogie_plots.cc
void AddMomentPlots(const CurvingResults& results, ReportPage* page);
void AddHydraulicPlots(const CurvingResults& results, ReportPage* page);

// curving_hydraulic_table.cc
/// `system`: prefix of the hydraulics' channels, "" or "front_bogie_". Nothing where there are none.
void AddHydraulicTable(const CurvingResults& results, const BogieRun& run, const std::string& bogie,
                       const std::string& system, ReportPage* page);

// curving_plots.cc
void AddTrackPlots(const CurvingResults& results, ReportPage* page);

/// Yaw moments on one axle in the steady curve [N m], counted positive where they turn the axle
/// towards the radial direction (steer) and negative where they turn it away (hold back). The
/// radial direction asks the leading axle of a curve to the left to turn left in its bogie, and the
/// trailing axle to turn right; the signs of the recorded moments (about the vertical axis,
/// positive to the left) are changed accordingly. A steady state adds up to zero; `rest` is what is
/// missing.
struct MomentBudget {
  double creep = 0;
  double phs_pressure = 0;
  double phs_friction = 0;
  double primary = 0;
  double rest = 0;
  bool known = false;
};
/// `axle` is "lead" or "trail" with the bogie's prefix.
MomentBudget CalcBudget(const BogieRun& run, const CurvingResults& results,
                        const std::string& axle);

}  // namespace phs::report
