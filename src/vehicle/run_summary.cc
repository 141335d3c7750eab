#include "vehicle/run_summary.h"

#include <algorithm>
#include <limits>

#include "plugin/observer.h"

namespace phs::vehicle {
namespace {

/// Rows over which the steady curve is averaged.
struct Window {
  double begin_s = 0;
  double end_s = 0;
  double curvature = 0;
  std::vector<size_t> rows;
};

Window SteadyWindow(const rail::Track& track, const RunOutcome& run) {
  Window window{0, track.length(), 0, {}};
  for (const rail::TrackSection& section : track.sections()) {
    if (section.kind == "curve") {
      window = {section.begin_s, section.end_s, section.curvature, {}};
      break;
    }
  }
  window.begin_s = window.end_s - (window.end_s - window.begin_s) / 3;
  const std::vector<double>& s = run.columns[static_cast<size_t>(run.Find("s_m"))];
  for (size_t i = 0; i < s.size(); ++i) {
    if (s[i] >= window.begin_s && s[i] <= window.end_s) window.rows.push_back(i);
  }
  return window;
}

double Mean(const RunOutcome& run, const Window& window, const std::string& channel) {
  const int at = run.Find(channel);
  if (at < 0 || window.rows.empty()) return std::nan("");
  double sum = 0;
  for (const size_t row : window.rows) sum += run.columns[static_cast<size_t>(at)][row];
  return sum / static_cast<double>(window.rows.size());
}

/// Every number of a part from the channel PREFIX + its own ending.
template <typename Part, size_t n>
Part MeansOf(const RunOutcome& run, const Window& window, const std::string& prefix,
             const SummaryNumber<Part> (&numbers)[n], Part part) {
  for (const auto& number : numbers) {
    part.*number.value = Mean(run, window, prefix + number.channel);
  }
  return part;
}

SteadyMeans MeansOver(const Simulation& sim, const RunOutcome& run, const Window& window) {
  const bool curves_left = window.curvature > 0;
  SteadyMeans means{window.begin_s, window.end_s, window.curvature, Mean(run, window, "speed_m_s")};
  for (const auto& w : sim.binding().wheelsets()) {
    means.wheelsets.push_back(
        MeansOf(run, window, w.name + "_", kWheelsetNumbers, WheelsetMeans{w.name}));
    for (const bool outer : {true, false}) {
      const std::string side = outer == curves_left ? "right" : "left";
      means.wheels.push_back(MeansOf(run, window, w.name + "_" + side + "_", kWheelNumbers,
                                     WheelMeans{w.name + (outer ? "_outer" : "_inner"), side}));
    }
  }
  for (const plugin::BogiePair& bogie : plugin::FindBogies(sim.binding())) {
    means.bogies.push_back(
        MeansOf(run, window, bogie.prefix, kBogieNumbers, BogieMeans{bogie.prefix}));
  }
  const bool several = sim.binding().phs().size() > 1;
  for (const auto& phs : sim.binding().phs()) {
    const std::string prefix = several ? phs.name + "_" : "";
    for (const std::string& name : phs.system->cylinder_names()) {
      means.cylinders.push_back(MeansOf(run, window, prefix + "cylinder_" + name + "_",
                                        kCylinderNumbers, CylinderMeans{prefix + name}));
    }
    for (const std::string& name : phs.system->line_names()) {
      means.lines.push_back(MeansOf(run, window, prefix + "line_" + name + "_", kLineNumbers,
                                    LineMeans{prefix + name}));
    }
  }
  return means;
}

double LargestMagnitude(const RunOutcome& run, const std::string& channel) {
  const int at = run.Find(channel);
  double largest = 0;
  for (const double x : run.columns[static_cast<size_t>(at)])
    largest = std::max(largest, std::abs(x));
  return largest;
}

/// Integral of all wheels' T-gamma over the distance run [N m = J].
double TotalTGamma(const Simulation& sim, const RunOutcome& run) {
  const std::vector<double>& t = run.columns[static_cast<size_t>(run.Find("t_s"))];
  const std::vector<double>& v = run.columns[static_cast<size_t>(run.Find("speed_m_s"))];
  double total = 0;
  for (const auto& w : sim.binding().wheelsets()) {
    for (const char* side : {"_left", "_right"}) {
      const auto& tg = run.columns[static_cast<size_t>(run.Find(w.name + side + "_T_gamma_N"))];
      for (size_t i = 1; i < t.size(); ++i) {
        total += 0.5 * (tg[i] * v[i] + tg[i - 1] * v[i - 1]) * (t[i] - t[i - 1]);
      }
    }
  }
  return total;
}

WholeRun OverTheRun(const Simulation& sim, const RunOutcome& run) {
  WholeRun whole;
  whole.min_Q_N = std::numeric_limits<double>::infinity();
  for (const auto& w : sim.binding().wheelsets()) {
    for (const char* side : {"_left", "_right"}) {
      whole.max_Y_over_Q =
          std::max(whole.max_Y_over_Q, LargestMagnitude(run, w.name + side + "_Y_over_Q"));
      for (const double q : run.columns[static_cast<size_t>(run.Find(w.name + side + "_Q_N"))]) {
        whole.min_Q_N = std::min(whole.min_Q_N, q);
      }
    }
    whole.max_sum_Y_N = std::max(whole.max_sum_Y_N, LargestMagnitude(run, w.name + "_sum_Y_N"));
    whole.max_angle_of_attack_rad = std::max(
        whole.max_angle_of_attack_rad, LargestMagnitude(run, w.name + "_angle_of_attack_rad"));
  }
  whole.T_gamma_total_J = TotalTGamma(sim, run);
  const EnergyBook& e = run.energy;
  whole.energy_error_relative = e.RelativeError();
  whole.work_in_J = e.work_in;
  whole.lost_creep_J = e.lost_creep;
  whole.lost_contact_J = e.lost_contact;
  whole.lost_dampers_J = e.lost_dampers;
  whole.lost_phs_J = e.lost_phs;
  whole.lost_brakes_J = e.lost_brakes;
  whole.end_time_s = run.end_time_s;
  whole.steps = run.steps;
  return whole;
}

std::vector<AxleMoments> MomentBudget(const Simulation& sim, const RunOutcome& run,
                                      const Window& window) {
  std::vector<AxleMoments> budget;
  for (const auto& w : sim.binding().wheelsets()) {
    budget.push_back(MeansOf(run, window, w.name + "_", kMomentNumbers, AxleMoments{w.name}));
  }
  return budget;
}

}  // namespace

double SteadyMeans::TGamma() const {
  double sum = 0;
  for (const WheelMeans& wheel : wheels) sum += wheel.T_gamma_N;
  return sum;
}

const WheelsetMeans* SteadyMeans::FindWheelset(const std::string& end) const {
  const auto at = std::find_if(wheelsets.begin(), wheelsets.end(),
                               [&](const WheelsetMeans& w) { return w.name.ends_with(end); });
  return at == wheelsets.end() ? nullptr : &*at;
}

SteadyMeans CalcSteadyMeans(const Simulation& sim, const RunOutcome& run) {
  return MeansOver(sim, run, SteadyWindow(sim.binding().track(), run));
}

RunSummary Summarise(const Simulation& sim, const RunOutcome& run) {
  RunSummary summary{run.status,
                     run.reason,
                     sim.scenario().bogie,
                     run.real_time_factor,
                     sim.scenario().timestep_s,
                     sim.largest_stable_step(),
                     run.warnings,
                     {}};
  if (run.columns.empty() || run.columns[0].empty()) return summary;
  const Window window = SteadyWindow(sim.binding().track(), run);
  summary.numbers =
      RunNumbers{MeansOver(sim, run, window), OverTheRun(sim, run), MomentBudget(sim, run, window)};
  return summary;
}

}  // namespace phs::vehicle
