#include "view/recording.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/result_dir.h"
#include "vehicle/running_effects.h"

namespace phs::view {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kOne[] = "summary.json";
constexpr char kSeveral[] = "compare.json";

Result<Json> ReadJson(const std::string& path) {
  auto text = ReadFile(path);
  if (!text.ok()) return text.error();
  Json json = Json::parse(text.value(), nullptr, false);
  if (!json.is_object() || !json.contains("scenario")) {
    return Error{path, "is no result of simulate or compare", "a file written by phs", ""};
  }
  return json;
}

std::string TextOf(const Json& json, const char* key) {
  return json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : "";
}

double NumberOf(const Json& json, const char* key) {
  return json.contains(key) && json[key].is_number() ? json[key].get<double>() : 0;
}

/// What a scenario without the number has, where it is not told.
double KnownOf(const Json& json, const char* key, double usual) {
  return json.contains(key) && json[key].is_number() ? json[key].get<double>() : usual;
}

/// What `effects` of a scenario does to track and wheels is drawn, too.
Status AddEffects(const Json& json, vehicle::Scenario* scenario) {
  if (!json.contains("effects") || !json["effects"].is_object()) return {};
  for (const auto& [name, own] : json["effects"].items()) {
    hydraulics::EffectParams effect;
    effect.name = name;
    if (own.is_object()) {
      for (const auto& [key, value] : own.items()) {
        if (value.is_number()) effect.values[key] = value.get<double>();
      }
      effect.formula = TextOf(own, "formula");
      for (const Json& target : own.value("targets", Json::array())) {
        if (target.is_string()) effect.targets.push_back(target.get<std::string>());
      }
    }
    if (Status s = AddEffect(effect, scenario); !s.ok()) return s;
  }
  return {};
}

/// As far as a picture needs it.
Result<vehicle::Scenario> ScenarioOf(const Json& json, const std::string& bogie,
                                     const std::string& path) {
  vehicle::Scenario scenario;
  scenario.name = TextOf(json, "name");
  scenario.track = TextOf(json, "track");
  if (const std::string vehicle = TextOf(json, "vehicle"); !vehicle.empty()) {
    scenario.vehicle = vehicle;
  }
  scenario.wheel = TextOf(json, "wheel");
  scenario.rail = TextOf(json, "rail");
  scenario.phs = TextOf(json, "phs");
  scenario.speed_m_s = NumberOf(json, "speed_m_s");
  scenario.creep = TextOf(json, "creep");
  rail::FrictionSettings& friction = scenario.friction;
  friction.condition = TextOf(json, "friction_condition");
  friction.tread = KnownOf(json, "friction", friction.tread);
  friction.flange = KnownOf(json, "flange_friction", friction.flange);
  friction.falling_ratio = KnownOf(json, "falling_ratio", friction.falling_ratio);
  friction.falling_rate_s_m = KnownOf(json, "falling_rate_s_m", friction.falling_rate_s_m);
  vehicle::UseBogie(bogie, &scenario);
  if (Status s = AddEffects(json, &scenario); !s.ok()) {
    Error error = s.error();
    error.where = path + ": effects: " + error.where;
    return error;
  }
  return scenario;
}

/// The result's own checks: what a replay cannot do without.
Result<Recording> Complete(Recording recording, const std::string& where) {
  recording.time_column = recording.Find("t_s");
  if (recording.time_column < 0 || recording.Find("s_m") < 0 ||
      recording.columns[static_cast<size_t>(recording.time_column)].empty()) {
    return Error{where, "holds no rows with t_s and s_m", "the time series of a run",
                 "run simulate or compare again with --out"};
  }
  return recording;
}

Result<Recording> ReadRecording(const Json& json, const std::string& bogie,
                                const std::string& label, const std::string& json_path,
                                const std::string& series_path) {
  Recording recording;
  recording.label = label;
  auto scenario = ScenarioOf(json["scenario"], bogie, json_path);
  if (!scenario.ok()) return scenario.error();
  recording.scenario = std::move(scenario).value();
  auto series = ReadSeries(series_path);
  if (!series.ok()) return series.error();
  recording.channels = std::move(series.value().channels);
  recording.columns = std::move(series.value().columns);
  return Complete(std::move(recording), series_path);
}

}  // namespace

int Recording::Find(const std::string& channel) const {
  for (size_t i = 0; i < channels.size(); ++i) {
    if (channels[i].name == channel) return static_cast<int>(i);
  }
  return -1;
}

Moment Recording::At(double time) const {
  const std::vector<double>& t = columns[static_cast<size_t>(time_column)];
  if (t.size() < 2 || !(time > t.front())) return {t.front(), 0, 0};
  if (time >= t.back()) return {t.back(), t.size() - 2, 1};
  const size_t next = static_cast<size_t>(std::upper_bound(t.begin(), t.end(), time) - t.begin());
  return {time, next - 1, (time - t[next - 1]) / (t[next] - t[next - 1])};
}

double Recording::Value(int column, const Moment& at) const {
  if (column < 0) return 0;
  const std::vector<double>& values = columns[static_cast<size_t>(column)];
  const double before = values[at.row];
  return at.share == 0 ? before : before + at.share * (values[at.row + 1] - before);
}

double Recording::TimeAt(double s_m) const {
  const std::vector<double>& s = columns[static_cast<size_t>(Find("s_m"))];
  const std::vector<double>& t = columns[static_cast<size_t>(time_column)];
  for (size_t i = 0; i < s.size(); ++i) {
    if (s[i] >= s_m) {
      if (i == 0 || s[i] == s[i - 1]) return t[i];
      return t[i] - (t[i] - t[i - 1]) * (s[i] - s_m) / (s[i] - s[i - 1]);
    }
  }
  return t.back();
}

bool IsResult(const std::string& source) {
  const std::filesystem::path dir = source;
  return std::filesystem::exists(dir / kOne) || std::filesystem::exists(dir / kSeveral);
}

Result<std::vector<Recording>> LoadRecordings(const std::string& dir) {
  std::vector<Recording> recordings;
  const std::filesystem::path folder = dir;
  const bool several = std::filesystem::exists(folder / kSeveral);
  const std::string path = (folder / (several ? kSeveral : kOne)).string();
  auto json = ReadJson(path);
  if (!json.ok()) return json.error();
  if (!several) {
    const std::string bogie = TextOf(json.value(), "bogie");
    auto one = ReadRecording(json.value(), bogie, vehicle::BogieLabel(bogie), path,
                             (folder / "timeseries.h5").string());
    if (!one.ok()) return one.error();
    recordings.push_back(std::move(one).value());
    return recordings;
  }
  if (!json.value().contains("bogies") || !json.value()["bogies"].is_object()) {
    return Error{path, "names no bogies", "a file written by phs compare", ""};
  }
  for (const auto& [label, summary] : json.value()["bogies"].items()) {
    auto one = ReadRecording(json.value(), TextOf(summary, "bogie"), label, path,
                             (folder / (label + "_timeseries.h5")).string());
    if (!one.ok()) return one.error();
    recordings.push_back(std::move(one).value());
  }
  return recordings;
}

Result<Recording> Record(const vehicle::Scenario& scenario, const std::string& label,
                         const vehicle::Progress& progress) {
  auto simulation = vehicle::Simulation::Create(scenario);
  if (!simulation.ok()) return simulation.error();
  auto run = simulation.value().Run(progress);
  if (!run.ok()) return run.error();
  Recording recording;
  recording.label = label;
  recording.scenario = scenario;
  recording.channels = std::move(run.value().channels);
  recording.columns = std::move(run.value().columns);
  return Complete(std::move(recording), scenario.name);
}

}  // namespace phs::view
