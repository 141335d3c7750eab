#include "vehicle/discretisation.h"

#include <algorithm>
#include <cmath>

namespace phs::vehicle {
namespace {

using Json = nlohmann::ordered_json;
const double kNone = std::nan("");

/// A number of every entry of a list, or of every wheelset's budget.
struct Listed {
  const char* list;
  const char* key;
  /// Ending of the recorded channel that gives the scale; "" = judged by its own size.
  const char* channel;
};

const Listed kOfSteadyCurve[] = {{"wheelsets", "lateral_m", "_lateral_m"},
                                 {"wheelsets", "angle_of_attack_rad", "_angle_of_attack_rad"},
                                 {"wheelsets", "yaw_rad", "_yaw_rad"},
                                 {"wheelsets", "sum_Y_N", ""},
                                 {"wheels", "Y_N", ""},
                                 {"wheels", "Q_N", ""},
                                 {"wheels", "Y_over_Q", ""},
                                 {"wheels", "T_gamma_N", ""},
                                 {"wheels", "T_gamma_spin_N", ""},
                                 {"cylinders", "force_N", "_force_N"},
                                 {"cylinders", "friction_N", "_friction_N"},
                                 {"cylinders", "piston_m", "_piston_m"},
                                 {"lines", "pressure_Pa", ""}};

const Listed kOfBudget[] = {{"", "creep_Nm", "_steering_moment_Nm"},
                            {"", "phs_pressure_Nm", "_phs_pressure_moment_Nm"},
                            {"", "phs_friction_Nm", "_phs_friction_moment_Nm"},
                            {"", "primary_Nm", "_primary_moment_Nm"}};

const char* const kOfRun[] = {
    "T_gamma_total_J", "max_Y_over_Q", "max_sum_Y_N", "max_angle_of_attack_rad",
    "min_Q_N",         "lost_creep_J", "lost_phs_J"};

/// Numbers whose ratios between bogies are headlines.
const char* const kOfRatios[] = {"run.T_gamma_total_J", "steady_curve.T_gamma_N",
                                 "run.lost_creep_J", "run.max_Y_over_Q"};

double NumberOf(const Json& object, const std::string& key) {
  return object.contains(key) && object[key].is_number() ? object[key].get<double>() : kNone;
}

/// Part of a name that tells the bogie: "front_" of "front_lead"; "" of "lead".
std::string BogieOf(const std::string& name) {
  const size_t at = name.rfind('_');
  return at == std::string::npos ? "" : name.substr(0, at + 1);
}

double LargestMagnitude(const std::vector<double>& column) {
  double largest = 0;
  for (const double x : column) largest = std::max(largest, std::abs(x));
  return largest;
}

/// Largest magnitude of all channels of a bogie with this ending.
double Scale(const RunOutcome& run, const std::string& bogie, const std::string& ending) {
  double largest = 0;
  for (size_t i = 0; i < run.channels.size(); ++i) {
    const std::string& name = run.channels[i].name;
    if (name.starts_with(bogie) && name.ends_with(ending)) {
      largest = std::max(largest, LargestMagnitude(run.columns[i]));
    }
  }
  return largest;
}

Json Change(double value, double half, double scale) {
  Json change = {{"value", value},
                 {"half_step", half},
                 {"relative", nullptr},
                 {"of_scale", nullptr},
                 {"scale", nullptr}};
  if (half != 0) change["relative"] = value / half - 1;
  if (scale > 0) {
    change["of_scale"] = (value - half) / scale;
    change["scale"] = scale;
  }
  return change;
}

/// Collects the changes of one run.
class Changes {
 public:
  Changes(const RunOutcome& run, const Json& summary, const Json& half)
      : run_(run), summary_(summary), half_(half) {}

  /// `scale` = 0: judged by its own size.
  void Add(const std::string& name, double value, double half, double scale) {
    if (!std::isfinite(value) || !std::isfinite(half)) return;
    changes_[name] = Change(value, half, scale);
    if (std::abs(JudgedChange(changes_[name])) > kMovingShare) moving_.push_back(name);
  }

  void AddLists() {
    for (const Listed& item : kOfSteadyCurve) {
      const Json& list = summary_["steady_curve"][item.list];
      const Json& halves = half_["steady_curve"][item.list];
      for (size_t i = 0; i < std::min(list.size(), halves.size()); ++i) {
        const std::string name = list[i]["name"];
        const std::string ending = item.channel;
        Add(std::string("steady_curve.") + item.list + "." + name + "." + item.key,
            NumberOf(list[i], item.key), NumberOf(halves[i], item.key),
            ending.empty() ? 0 : Scale(run_, BogieOf(name), ending));
      }
    }
  }

  void AddBogies() {
    const Json& curve = summary_["steady_curve"];
    for (const auto& [key, value] : curve.items()) {
      if (!key.ends_with("bending_rad") && !key.ends_with("shear_rad")) continue;
      Add("steady_curve." + key, NumberOf(curve, key), NumberOf(half_["steady_curve"], key),
          Scale(run_, key, key));
    }
    Add("steady_curve.T_gamma_N", Wear(summary_), Wear(half_), 0);
  }

  void AddRun() {
    for (const char* key : kOfRun) {
      Add(std::string("run.") + key, NumberOf(summary_["run"], key), NumberOf(half_["run"], key),
          0);
    }
  }

  void AddBudget() {
    for (const auto& [wheelset, moments] : summary_["budget"].items()) {
      if (!half_["budget"].contains(wheelset)) continue;
      for (const Listed& item : kOfBudget) {
        Add("budget." + wheelset + "." + item.key, NumberOf(moments, item.key),
            NumberOf(half_["budget"][wheelset], item.key),
            Scale(run_, BogieOf(wheelset), item.channel));
      }
    }
  }

  const Json& changes() const { return changes_; }
  const Json& moving() const { return moving_; }

 private:
  /// T-gamma of all wheels.
  static double Wear(const Json& summary) {
    double sum = 0;
    for (const Json& wheel : summary["steady_curve"]["wheels"]) sum += NumberOf(wheel, "T_gamma_N");
    return sum;
  }

  const RunOutcome& run_;
  const Json& summary_;
  const Json& half_;
  Json changes_ = Json::object();
  Json moving_ = Json::array();
};

bool HasResults(const Json& summary) {
  return summary.contains("steady_curve") && summary.contains("run") && summary.contains("budget");
}

}  // namespace

double JudgedChange(const Json& change) {
  const Json& of_scale = change["of_scale"];
  const Json& judged = of_scale.is_number() ? of_scale : change["relative"];
  return judged.is_number() ? judged.get<double>() : kNone;
}

Json Discretisation(const RunOutcome& run, const Json& summary, const Json& half) {
  Changes changes(run, summary, half);
  if (HasResults(summary) && HasResults(half)) {
    changes.AddLists();
    changes.AddBogies();
    changes.AddRun();
    changes.AddBudget();
  }
  return {{"timestep_s", summary["timestep_s"]},
          {"half_step_s", half["timestep_s"]},
          {"half_step_status", half["status"]},
          {"changes", changes.changes()},
          {"moving", changes.moving()}};
}

Json RatioChanges(const std::vector<std::pair<std::string, Json>>& summaries) {
  Json changes = Json::object();
  Json moving = Json::array();
  for (const auto& [a, of_a] : summaries) {
    for (const auto& [b, of_b] : summaries) {
      if (a == b || !of_a.contains("discretisation") || !of_b.contains("discretisation")) continue;
      for (const char* name : kOfRatios) {
        const Json& own = of_a["discretisation"]["changes"];
        const Json& other = of_b["discretisation"]["changes"];
        if (!own.contains(name) || !other.contains(name)) continue;
        const double value = NumberOf(own[name], "value") / NumberOf(other[name], "value");
        const double half = NumberOf(own[name], "half_step") / NumberOf(other[name], "half_step");
        if (!std::isfinite(value) || !std::isfinite(half)) continue;
        const std::string path = a + "_over_" + b + "." + name;
        changes[path] = Change(value, half, 0);
        if (std::abs(JudgedChange(changes[path])) > kMovingShare) moving.push_back(path);
      }
    }
  }
  return {{"timestep_s", summaries.front().second.value("timestep_s", 0.0)},
          {"changes", changes},
          {"moving", moving}};
}

}  // namespace phs::vehicle
