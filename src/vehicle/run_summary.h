// The numbers that a run ends in: means over the steady curve, sums over the run, moment budget.
//
// The steady curve is the last third of the first circular arc (of the whole track if it has none);
// "outer" is the high rail of that curve, the left one on straight track. A mean that the run never
// got to is not a number.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "vehicle/phs_watch.h"
#include "vehicle/simulation.h"

namespace phs::vehicle {

/// Means of one wheelset.
struct WheelsetMeans {
  std::string name = {};
  double lateral_m = 0;
  double angle_of_attack_rad = 0;
  double yaw_rad = 0;
  double sum_Y_N = 0;
  double X_N = 0;
  double slip = 0;
};

/// Means of one wheel.
struct WheelMeans {
  std::string name = {};  ///< "lead_outer"
  std::string side = {};  ///< "left", "right"
  double Y_N = 0;
  double Q_N = 0;
  double Y_over_Q = 0;
  double T_gamma_N = 0;
  double T_gamma_spin_N = 0;
  double X_N = 0;
  double adhesion_used = 0;
  double contacts = 0;
  double contact_angle_rad = 0;
  double flange_N = 0;
};

/// Means of the two axles of a bogie against each other.
struct BogieMeans {
  std::string prefix = {};  ///< "", "front_"
  double bending_rad = 0;
  double shear_rad = 0;
};

struct CylinderMeans {
  std::string name = {};
  double force_N = 0;
  double friction_N = 0;
  double piston_m = 0;
};

struct LineMeans {
  std::string name = {};
  double pressure_Pa = 0;
};

struct SteadyMeans {
  double begin_s_m = 0;
  double end_s_m = 0;
  double curvature_1_m = 0;  ///< > 0 to the left
  double speed_m_s = 0;
  std::vector<WheelsetMeans> wheelsets = {};
  std::vector<WheelMeans> wheels = {};  ///< outer and inner of each wheelset
  std::vector<BogieMeans> bogies = {};
  std::vector<CylinderMeans> cylinders = {};
  std::vector<LineMeans> lines = {};

  /// T-gamma of all wheels, without spin [N].
  double TGamma() const;
  /// The wheelset whose name ends so; null without one.
  const WheelsetMeans* FindWheelset(const std::string& end) const;
};

/// Sums and extremes over the whole run.
struct WholeRun {
  double T_gamma_total_J = 0;
  double max_Y_over_Q = 0;
  double max_sum_Y_N = 0;
  double max_angle_of_attack_rad = 0;
  double min_Q_N = 0;
  double energy_error_relative = 0;
  double work_in_J = 0;
  double lost_creep_J = 0;
  double lost_contact_J = 0;
  double lost_dampers_J = 0;
  double lost_phs_J = 0;
  double lost_brakes_J = 0;
  double end_time_s = 0;
  long steps = 0;
};

/// Yaw moments on one wheelset, means over the steady curve.
struct AxleMoments {
  std::string name = {};
  double creep_Nm = 0;
  double phs_pressure_Nm = 0;
  double phs_friction_Nm = 0;
  double primary_Nm = 0;
};

struct RunNumbers {
  SteadyMeans steady_curve;
  WholeRun run;
  std::vector<AxleMoments> budget;
};

struct RunSummary {
  std::string status;
  std::string reason;
  std::string bogie;
  double real_time_factor = 0;
  double timestep_s = 0;
  double largest_stable_step_s = 0;
  std::vector<PhsWarning> warnings;
  std::optional<RunNumbers> numbers;  ///< none where nothing was recorded
};

RunSummary Summarise(const Simulation& simulation, const RunOutcome& run);
/// Means over the recorded rows that lie in the steady curve.
SteadyMeans CalcSteadyMeans(const Simulation& simulation, const RunOutcome& run);

/// How a number is judged against the same number at half the step (discretisation.h).
enum class Judged {
  kNot,
  kByItsSize,
  kByLargest,  ///< it changes sign: against its largest magnitude on that bogie in the run
};

/// A number of a part: its name in summary.json, and the end of the recorded channel it comes from.
template <typename Part>
struct SummaryNumber {
  const char* key;
  double Part::*value;
  Judged judged = Judged::kNot;
  const char* channel = key;
  double nothing = 0;  ///< so small that a change is not judged at all, in its unit
};

inline constexpr SummaryNumber<WheelsetMeans> kWheelsetNumbers[] = {
    {"lateral_m", &WheelsetMeans::lateral_m, Judged::kByLargest},
    {"angle_of_attack_rad", &WheelsetMeans::angle_of_attack_rad, Judged::kByLargest},
    {"yaw_rad", &WheelsetMeans::yaw_rad, Judged::kByLargest},
    {"sum_Y_N", &WheelsetMeans::sum_Y_N, Judged::kByItsSize},
    {"X_N", &WheelsetMeans::X_N},
    {"slip", &WheelsetMeans::slip}};

/// Y changes sign without being judged by its largest: below a thousandth of the wheel load it is as
/// good as none. So is wear of a tenth of a newton: a steered axle has some.
inline constexpr SummaryNumber<WheelMeans> kWheelNumbers[] = {
    {"Y_N", &WheelMeans::Y_N, Judged::kByItsSize, "Y_N", 100},
    {"Q_N", &WheelMeans::Q_N, Judged::kByItsSize},
    {"Y_over_Q", &WheelMeans::Y_over_Q, Judged::kByItsSize, "Y_over_Q", 1e-3},
    {"T_gamma_N", &WheelMeans::T_gamma_N, Judged::kByItsSize, "T_gamma_N", 0.1},
    {"T_gamma_spin_N", &WheelMeans::T_gamma_spin_N, Judged::kByItsSize, "T_gamma_spin_N", 0.1},
    {"X_N", &WheelMeans::X_N},
    {"adhesion_used", &WheelMeans::adhesion_used},
    {"contacts", &WheelMeans::contacts},
    {"contact_angle_rad", &WheelMeans::contact_angle_rad},
    {"flange_N", &WheelMeans::flange_N}};

inline constexpr SummaryNumber<BogieMeans> kBogieNumbers[] = {
    {"bending_rad", &BogieMeans::bending_rad, Judged::kByLargest},
    {"shear_rad", &BogieMeans::shear_rad, Judged::kByLargest}};

inline constexpr SummaryNumber<CylinderMeans> kCylinderNumbers[] = {
    {"force_N", &CylinderMeans::force_N, Judged::kByLargest},
    {"friction_N", &CylinderMeans::friction_N, Judged::kByLargest},
    {"piston_m", &CylinderMeans::piston_m, Judged::kByLargest}};

inline constexpr SummaryNumber<LineMeans> kLineNumbers[] = {
    {"pressure_Pa", &LineMeans::pressure_Pa, Judged::kByItsSize}};

inline constexpr SummaryNumber<AxleMoments> kMomentNumbers[] = {
    {"creep_Nm", &AxleMoments::creep_Nm, Judged::kByLargest, "steering_moment_Nm"},
    {"phs_pressure_Nm", &AxleMoments::phs_pressure_Nm, Judged::kByLargest,
     "phs_pressure_moment_Nm"},
    {"phs_friction_Nm", &AxleMoments::phs_friction_Nm, Judged::kByLargest,
     "phs_friction_moment_Nm"},
    {"primary_Nm", &AxleMoments::primary_Nm, Judged::kByLargest, "primary_moment_Nm"}};

inline constexpr SummaryNumber<WholeRun> kRunNumbers[] = {
    {"T_gamma_total_J", &WholeRun::T_gamma_total_J, Judged::kByItsSize},
    {"max_Y_over_Q", &WholeRun::max_Y_over_Q, Judged::kByItsSize},
    {"max_sum_Y_N", &WholeRun::max_sum_Y_N, Judged::kByItsSize},
    {"max_angle_of_attack_rad", &WholeRun::max_angle_of_attack_rad, Judged::kByItsSize},
    {"min_Q_N", &WholeRun::min_Q_N, Judged::kByItsSize},
    {"energy_error_relative", &WholeRun::energy_error_relative},
    {"work_in_J", &WholeRun::work_in_J},
    {"lost_creep_J", &WholeRun::lost_creep_J, Judged::kByItsSize},
    {"lost_contact_J", &WholeRun::lost_contact_J},
    {"lost_dampers_J", &WholeRun::lost_dampers_J},
    {"lost_phs_J", &WholeRun::lost_phs_J, Judged::kByItsSize},
    {"lost_brakes_J", &WholeRun::lost_brakes_J},
    {"end_time_s", &WholeRun::end_time_s}};

}  // namespace phs::vehicle
