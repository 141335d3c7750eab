#include "vehicle/discretisation.h"

#include <algorithm>

#include "base/json_path.h"

namespace phs::vehicle {
namespace {

using Json = nlohmann::ordered_json;

/// Numbers whose ratios between bogies are headlines.
const char* const kOfRatios[] = {"run.T_gamma_total_J", "steady_curve.T_gamma_N",
                                 "run.lost_creep_J", "run.max_Y_over_Q"};

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

/// `scale` = 0: judged by its own size, unless it is below `nothing`.
StepChange ChangeOf(const std::string& name, double value, double half, double scale,
                    double nothing = 0) {
  StepChange change{name, value, half};
  change.nothing = std::max(std::abs(value), std::abs(half)) < nothing;
  if (half != 0) change.relative = value / half - 1;
  if (scale > 0) {
    change.of_scale = (value - half) / scale;
    change.scale = scale;
  }
  return change;
}

/// Collects the changes of one run.
class Collector {
 public:
  Collector(const RunOutcome& run, std::vector<StepChange>* out) : run_(run), out_(out) {}

  void Add(const std::string& name, double value, double half, double scale, double nothing = 0) {
    if (std::isfinite(value) && std::isfinite(half)) {
      out_->push_back(ChangeOf(name, value, half, scale, nothing));
    }
  }

  /// The numbers of a part that are judged; its names begin with `path`.
  template <typename Part, size_t n>
  void AddPart(const std::string& path, const std::string& bogie, const Part& part,
               const Part& half, const SummaryNumber<Part> (&numbers)[n]) {
    for (const auto& number : numbers) {
      if (number.judged == Judged::kNot) continue;
      const std::string ending = std::string("_") + number.channel;
      Add(path + number.key, part.*number.value, half.*number.value,
          number.judged == Judged::kByLargest ? Scale(run_, bogie, ending) : 0, number.nothing);
    }
  }

  template <typename Part, size_t n>
  void AddList(const std::string& path, const std::vector<Part>& parts,
               const std::vector<Part>& halves, const SummaryNumber<Part> (&numbers)[n]) {
    for (size_t i = 0; i < std::min(parts.size(), halves.size()); ++i) {
      AddPart(path + "." + parts[i].name + ".", BogieOf(parts[i].name), parts[i], halves[i],
              numbers);
    }
  }

  void AddBogies(const std::vector<BogieMeans>& bogies, const std::vector<BogieMeans>& halves) {
    for (size_t i = 0; i < std::min(bogies.size(), halves.size()); ++i) {
      for (const auto& number : kBogieNumbers) {
        const std::string channel = bogies[i].prefix + number.channel;
        Add("steady_curve." + bogies[i].prefix + number.key, bogies[i].*number.value,
            halves[i].*number.value, Scale(run_, channel, channel));
      }
    }
  }

 private:
  const RunOutcome& run_;
  std::vector<StepChange>* out_;
};

const StepChange* FindChange(const StepChanges& changes, const std::string& name) {
  const auto at = std::find_if(changes.changes.begin(), changes.changes.end(),
                               [&](const StepChange& c) { return c.name == name; });
  return at == changes.changes.end() ? nullptr : &*at;
}

}  // namespace

StepChanges ChangesAtHalfStep(const RunOutcome& run, const RunSummary& summary,
                              const RunSummary& half) {
  StepChanges out{summary.timestep_s, half.timestep_s, half.status, {}};
  if (!summary.numbers || !half.numbers) return out;
  Collector collector(run, &out.changes);
  const SteadyMeans& curve = summary.numbers->steady_curve;
  const SteadyMeans& of_half = half.numbers->steady_curve;
  collector.AddList("steady_curve.wheelsets", curve.wheelsets, of_half.wheelsets, kWheelsetNumbers);
  collector.AddList("steady_curve.wheels", curve.wheels, of_half.wheels, kWheelNumbers);
  collector.AddList("steady_curve.cylinders", curve.cylinders, of_half.cylinders, kCylinderNumbers);
  collector.AddList("steady_curve.lines", curve.lines, of_half.lines, kLineNumbers);
  collector.AddBogies(curve.bogies, of_half.bogies);
  collector.Add("steady_curve.T_gamma_N", curve.TGamma(), of_half.TGamma(), 0);
  collector.AddPart("run.", "", summary.numbers->run, half.numbers->run, kRunNumbers);
  collector.AddList("budget", summary.numbers->budget, half.numbers->budget, kMomentNumbers);
  return out;
}

StepChanges RatioChanges(const std::vector<std::pair<std::string, StepChanges>>& bogies) {
  StepChanges out;
  if (!bogies.empty()) out.timestep_s = bogies.front().second.timestep_s;
  for (const auto& [a, of_a] : bogies) {
    for (const auto& [b, of_b] : bogies) {
      if (a == b) continue;
      for (const char* name : kOfRatios) {
        const StepChange* own = FindChange(of_a, name);
        const StepChange* other = FindChange(of_b, name);
        if (own == nullptr || other == nullptr) continue;
        const double value = own->value / other->value;
        const double half = own->half_step / other->half_step;
        if (!std::isfinite(value) || !std::isfinite(half)) continue;
        out.changes.push_back(ChangeOf(a + "_over_" + b + "." + name, value, half, 0));
      }
    }
  }
  return out;
}

Json DiscretisationJson(const StepChanges& changes) {
  Json out = {{"timestep_s", changes.timestep_s}};
  if (changes.half_step_s > 0) {
    out["half_step_s"] = changes.half_step_s;
    out["half_step_status"] = changes.half_step_status;
  }
  Json& all = out["changes"] = Json::object();
  Json moving = Json::array();
  for (const StepChange& c : changes.changes) {
    all[c.name] = {{"value", c.value},
                   {"half_step", c.half_step},
                   {"relative", NumberOrNull(c.relative)},
                   {"of_scale", NumberOrNull(c.of_scale)},
                   {"scale", NumberOrNull(c.scale)}};
    if (c.Moves()) moving.push_back(c.name);
  }
  out["moving"] = std::move(moving);
  return out;
}

double JudgedChange(const Json& change) {
  const Json& of_scale = change["of_scale"];
  const Json& judged = of_scale.is_number() ? of_scale : change["relative"];
  return judged.is_number() ? judged.get<double>() : std::nan("");
}

}  // namespace phs::vehicle
