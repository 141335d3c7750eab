#include "vehicle/summary.h"

#include <algorithm>
#include <cmath>

#include "plugin/observer.h"

namespace phs::vehicle {
namespace {

using Json = nlohmann::ordered_json;

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

/// Mean of a channel over the window; NaN (null in JSON) if the run never got there.
double Mean(const RunOutcome& run, const Window& window, const std::string& channel) {
  const int at = run.Find(channel);
  if (at < 0 || window.rows.empty()) return std::nan("");
  double sum = 0;
  for (const size_t row : window.rows) sum += run.columns[static_cast<size_t>(at)][row];
  return sum / static_cast<double>(window.rows.size());
}

Json WheelsetMeans(const RunOutcome& run, const Window& window, const std::string& name) {
  return {{"name", name},
          {"lateral_m", Mean(run, window, name + "_lateral_m")},
          {"angle_of_attack_rad", Mean(run, window, name + "_angle_of_attack_rad")},
          {"yaw_rad", Mean(run, window, name + "_yaw_rad")},
          {"sum_Y_N", Mean(run, window, name + "_sum_Y_N")},
          {"X_N", Mean(run, window, name + "_X_N")},
          {"slip", Mean(run, window, name + "_slip")}};
}

Json WheelMeans(const RunOutcome& run, const Window& window, const std::string& wheelset,
                bool outer, bool curves_left) {
  const std::string side = outer == curves_left ? "_right" : "_left";
  const std::string wheel = wheelset + side;
  return {{"name", wheelset + (outer ? "_outer" : "_inner")},
          {"side", side.substr(1)},
          {"Y_N", Mean(run, window, wheel + "_Y_N")},
          {"Q_N", Mean(run, window, wheel + "_Q_N")},
          {"Y_over_Q", Mean(run, window, wheel + "_Y_over_Q")},
          {"T_gamma_N", Mean(run, window, wheel + "_T_gamma_N")},
          {"T_gamma_spin_N", Mean(run, window, wheel + "_T_gamma_spin_N")},
          {"X_N", Mean(run, window, wheel + "_X_N")},
          {"adhesion_used", Mean(run, window, wheel + "_adhesion_used")},
          {"contacts", Mean(run, window, wheel + "_contacts")},
          {"contact_angle_rad", Mean(run, window, wheel + "_contact_angle_rad")},
          {"flange_N", Mean(run, window, wheel + "_flange_N")}};
}

Json SteadyCurve(const Simulation& sim, const RunOutcome& run, const Window& window) {
  // On straight track "outer" is the left wheel.
  const bool curves_left = window.curvature > 0;
  Json curve;
  curve["begin_s_m"] = window.begin_s;
  curve["end_s_m"] = window.end_s;
  curve["radius_m"] = window.curvature == 0 ? Json(nullptr) : Json(1 / window.curvature);
  curve["speed_m_s"] = Mean(run, window, "speed_m_s");
  curve["wheelsets"] = Json::array();
  curve["wheels"] = Json::array();
  for (const auto& w : sim.binding().wheelsets()) {
    curve["wheelsets"].push_back(WheelsetMeans(run, window, w.name));
    for (const bool outer : {true, false}) {
      curve["wheels"].push_back(WheelMeans(run, window, w.name, outer, curves_left));
    }
  }
  for (const plugin::BogiePair& bogie : plugin::FindBogies(sim.binding())) {
    curve[bogie.prefix + "bending_rad"] = Mean(run, window, bogie.prefix + "bending_rad");
    curve[bogie.prefix + "shear_rad"] = Mean(run, window, bogie.prefix + "shear_rad");
  }
  curve["cylinders"] = Json::array();
  curve["lines"] = Json::array();
  const bool several = sim.binding().phs().size() > 1;
  for (const auto& phs : sim.binding().phs()) {
    const std::string prefix = several ? phs.name + "_" : "";
    for (const std::string& name : phs.system->cylinder_names()) {
      const std::string cylinder = prefix + "cylinder_" + name;
      curve["cylinders"].push_back({{"name", several ? prefix + name : name},
                                    {"force_N", Mean(run, window, cylinder + "_force_N")},
                                    {"friction_N", Mean(run, window, cylinder + "_friction_N")},
                                    {"piston_m", Mean(run, window, cylinder + "_piston_m")}});
    }
    for (const std::string& name : phs.system->line_names()) {
      curve["lines"].push_back(
          {{"name", several ? prefix + name : name},
           {"pressure_Pa", Mean(run, window, prefix + "line_" + name + "_pressure_Pa")}});
    }
  }
  return curve;
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

Json WholeRun(const Simulation& sim, const RunOutcome& run) {
  double y_over_q = 0;
  double sum_y = 0;
  double attack = 0;
  double min_q = std::numeric_limits<double>::infinity();
  for (const auto& w : sim.binding().wheelsets()) {
    for (const char* side : {"_left", "_right"}) {
      y_over_q = std::max(y_over_q, LargestMagnitude(run, w.name + side + "_Y_over_Q"));
      for (const double q : run.columns[static_cast<size_t>(run.Find(w.name + side + "_Q_N"))]) {
        min_q = std::min(min_q, q);
      }
    }
    sum_y = std::max(sum_y, LargestMagnitude(run, w.name + "_sum_Y_N"));
    attack = std::max(attack, LargestMagnitude(run, w.name + "_angle_of_attack_rad"));
  }
  const EnergyBook& e = run.energy;
  return {{"T_gamma_total_J", TotalTGamma(sim, run)},
          {"max_Y_over_Q", y_over_q},
          {"max_sum_Y_N", sum_y},
          {"max_angle_of_attack_rad", attack},
          {"min_Q_N", min_q},
          {"energy_error_relative", e.RelativeError()},
          {"work_in_J", e.work_in},
          {"lost_creep_J", e.lost_creep},
          {"lost_contact_J", e.lost_contact},
          {"lost_dampers_J", e.lost_dampers},
          {"lost_phs_J", e.lost_phs},
          {"lost_brakes_J", e.lost_brakes},
          {"end_time_s", run.end_time_s},
          {"steps", run.steps}};
}

Json MomentBudget(const Simulation& sim, const RunOutcome& run, const Window& window) {
  Json budget;
  for (const auto& w : sim.binding().wheelsets()) {
    budget[w.name] = {{"creep_Nm", Mean(run, window, w.name + "_steering_moment_Nm")},
                      {"phs_pressure_Nm", Mean(run, window, w.name + "_phs_pressure_moment_Nm")},
                      {"phs_friction_Nm", Mean(run, window, w.name + "_phs_friction_moment_Nm")},
                      {"primary_Nm", Mean(run, window, w.name + "_primary_moment_Nm")}};
  }
  return budget;
}

/// a / b wherever both hold a number; names are kept so that the entries can be found.
Json Ratio(const Json& a, const Json& b) {
  if (a.is_number() && b.is_number()) {
    const double denominator = b.get<double>();
    return denominator == 0 ? Json(nullptr) : Json(a.get<double>() / denominator);
  }
  if (a.is_object() && b.is_object()) {
    Json ratio = Json::object();
    for (const auto& [key, value] : a.items()) {
      if (!b.contains(key)) continue;
      if (key == "name" || key == "side") {
        ratio[key] = value;
      } else if (Json part = Ratio(value, b[key]); !part.is_null()) {
        ratio[key] = part;
      }
    }
    return ratio;
  }
  if (a.is_array() && b.is_array()) {
    Json ratio = Json::array();
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) ratio.push_back(Ratio(a[i], b[i]));
    return ratio;
  }
  return nullptr;
}

}  // namespace

Json Summarise(const Simulation& sim, const RunOutcome& run) {
  Json summary;
  summary["status"] = run.status;
  summary["reason"] = run.reason;
  summary["bogie"] = sim.scenario().bogie;
  summary["real_time_factor"] = run.real_time_factor;
  summary["timestep_s"] = sim.scenario().timestep_s;
  summary["largest_stable_step_s"] = sim.largest_stable_step();
  summary["warnings"] = WarningsJson(run.warnings);
  if (run.columns.empty() || run.columns[0].empty()) return summary;
  const Window window = SteadyWindow(sim.binding().track(), run);
  summary["steady_curve"] = SteadyCurve(sim, run, window);
  summary["run"] = WholeRun(sim, run);
  summary["budget"] = MomentBudget(sim, run, window);
  return summary;
}

Json Compare(const std::vector<std::pair<std::string, Json>>& summaries, const Scenario& scenario,
             const rail::Track& track) {
  Json out;
  for (const auto& [name, summary] : summaries) out["bogies"][name] = summary;
  out["ratios"] = Json::object();
  for (const auto& [a, of_a] : summaries) {
    for (const auto& [b, of_b] : summaries) {
      if (a == b) continue;
      Json ratio;
      for (const char* part : {"steady_curve", "run", "budget"}) {
        if (of_a.contains(part) && of_b.contains(part)) ratio[part] = Ratio(of_a[part], of_b[part]);
      }
      out["ratios"][a + "_over_" + b] = ratio;
    }
  }
  out["scenario"] = DescribeScenario(scenario);
  out["track"] = DescribeTrack(track);
  return out;
}

}  // namespace phs::vehicle
