#include "measurement/manifest.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "base/data_path.h"
#include "base/yaml.h"
#include "phs_model/bogie_spread.h"
#include "phs_model/effects_yaml.h"
#include "phs_model/model_changes.h"

namespace phs::measurement {
namespace {

namespace fs = std::filesystem;

constexpr char kFolder[] = "models/rigs";
constexpr char kThesis[] = "lowe";  ///< below it: the tests behind the figures of the thesis

Window ReadWindow(YamlMap& map, const std::string& key,
                  const char* allowed = "[begin, end] in seconds, begin < end") {
  if (!map.Has(key)) return {};
  const std::vector<double> ends = map.Numbers(key, {});
  if (ends.size() != 2 || !(ends[1] > ends[0])) {
    map.Fail(key, "is no window", allowed);
    return {};
  }
  return {ends[0], ends[1]};
}

std::string Resolve(const std::string& manifest, const std::string& data) {
  const fs::path given(data);
  if (given.is_absolute()) return data;
  const fs::path beside = fs::path(manifest).parent_path() / given;
  return fs::exists(beside) || !fs::exists(given) ? beside.string() : data;
}

/// Puts the value of ${NAME} in place; a variable that is not set fails at "data".
std::string ExpandEnvironment(YamlMap& map, std::string text) {
  for (size_t begin = text.find("${"); begin != std::string::npos; begin = text.find("${")) {
    const size_t end = text.find('}', begin);
    if (end == std::string::npos) {
      map.Fail("data", "a ${ is not closed", "${NAME}");
      return text;
    }
    const std::string name = text.substr(begin + 2, end - begin - 2);
    const char* value = std::getenv(name.c_str());
    if (value == nullptr || std::string(value).find("${") != std::string::npos) {
      map.Fail("data", "the environment variable " + name + " is not set", "",
               "set it to the folder that holds the data (models/rigs/README.md says where they "
               "come from)");
      return text;
    }
    text.replace(begin, end + 1 - begin, value);
  }
  return text;
}

RunSpec ReadRun(YamlMap& map, const std::string& path) {
  RunSpec run;
  run.data = Resolve(path, ExpandEnvironment(map, map.Text("data")));
  run.estimation = ReadWindow(map, "estimation");
  run.validation = ReadWindow(map, "validation");
  const Window &e = run.estimation, &v = run.validation;
  if (!e.empty() && !v.empty() && e.begin < v.end && v.begin < e.end) {
    map.Fail("validation", "overlaps the estimation window", "windows apart from each other",
             "data used for fitting cannot judge the fit");
  }
  return run;
}

/// One of the `runs:`, which may have a model of its own; of a step table always, with a setup and
/// no windows.
RunSpec ReadOneOfRuns(YamlMap& map, const std::string& path, bool steps) {
  RunSpec run = ReadRun(map, path);
  if (map.Has("model")) run.model = BesideFile(path, map.Text("model"));
  run.setup = map.Integer("setup", 1, 1000000, 0);
  if (!steps && run.setup != 0) {
    map.Fail("setup", "a run of this rig has no setup of its own", "rig: steps");
  }
  if (steps && run.model.empty()) map.Text("model");
  if (steps && (!run.estimation.empty() || !run.validation.empty())) {
    map.Fail("estimation", "steps have no windows", "each step is left out in turn");
  }
  return run;
}

/// No row of a file may be fitted in one run and judge in another.
void RefuseSharedRows(const Manifest& m, YamlMap* map) {
  std::error_code none;
  for (const RunSpec& fitted : m.runs) {
    for (const RunSpec& judged : m.runs) {
      const Window &e = fitted.estimation, &v = judged.validation;
      if (&fitted == &judged || e.empty() || v.empty()) continue;
      if (e.begin >= v.end || v.begin >= e.end) continue;
      if (fitted.data != judged.data && !fs::equivalent(fitted.data, judged.data, none)) continue;
      map->Fail("runs", "one validates on rows of " + judged.data + " that another is fitted to",
                "windows apart from each other", "data used for fitting cannot judge the fit");
      return;
    }
  }
}

/// What is driven, and by what.
void ReadDriven(YamlMap& map, const std::string& rig, WindowNeed need, rigs::RigOptions* options) {
  const std::vector<std::string> drives = {"position", "force", "pressure"};
  const std::string word = map.Word("driven_by", drives, drives.front());
  for (size_t i = 0; i < drives.size(); ++i) {
    if (drives[i] == word) options->driven_by = static_cast<rigs::Drive>(i);
  }
  options->moving_mass_kg =
      map.Number("moving_mass_kg", {.min = 0, .open_min = true}, options->moving_mass_kg);
  options->actuators = map.Integer("actuators", 2, 4, options->actuators);
  if (options->actuators == 3) map.Fail("actuators", "three are not driven", "2 or 4");
  if (options->actuators == 4 && rig != "full") {
    map.Fail("actuators", "are not four on rig: " + rig, "rig: full");
  }
  if (options->driven_by == rigs::Drive::kPosition) return;
  if (rig == "element" && options->driven_by == rigs::Drive::kForce) return;
  if (rig != "cylinder" && rig != "quarter") {
    map.Fail("driven_by", "is not for rig: " + rig, "cylinder, quarter; force: element, too");
  }
  if (need == WindowNeed::kEstimation) {
    map.Fail("driven_by", "nothing is fitted to a rig driven by " + word, "position",
             "phs rig runs it");
  }
}

/// Changes of the declared model, as a scenario has them; a bogie's stand in its scenario.
phs_model::PhsChanges ReadChanges(YamlMap& map, const std::string& rig) {
  phs_model::PhsChanges changes;
  if (map.Has("phs_parameters")) phs_model::ReadParameters(map.Map("phs_parameters"), &changes);
  if (map.Has("effects")) changes.effects = phs_model::ReadEffects(map.Map("effects"));
  changes.failures = phs_model::ReadFailures(&map, 0, 0);
  for (const phs_model::Failure& failure : changes.failures) {
    if (std::isfinite(failure.at_m) || !failure.system.empty()) {
      map.Fail("failures", "a rig has one system and no track", "at_s");
    }
    if (rig == "steps" && HasTime(failure)) {
      map.Fail("failures", failure.kind + " has a time and steps have no clock", "rig: quarter");
    }
  }
  for (const char* key : {"phs_parameters", "effects", "failures"}) {
    if (rig == "bogie" && map.Has(key)) {
      map.Fail(key, "stands in the scenario of a bogie", "", "put it into the model's file");
    }
  }
  return changes;
}

rigs::RigOptions ReadOptions(YamlMap& map) {
  rigs::RigOptions options;
  options.substeps = map.Integer("substeps", 1, 1000, options.substeps);
  if (map.Has("beam")) {
    YamlMap b = map.Map("beam");
    rigs::BeamParams& beam = options.beam;
    const Range positive{.min = 0, .open_min = true}, not_negative{.min = 0};
    beam.lever_m = b.Number("lever_m", positive, beam.lever_m);
    beam.inertia_kg_m2 = b.Number("inertia_kg_m2", positive, beam.inertia_kg_m2);
    beam.damping_Nms_per_rad =
        b.Number("damping_Nms_per_rad", not_negative, beam.damping_Nms_per_rad);
    beam.hinge_friction_Nm = b.Number("hinge_friction_Nm", not_negative, beam.hinge_friction_Nm);
  }
  return options;
}

TestLimits ReadLimits(YamlMap map) {
  TestLimits limits;
  limits.stroke_m = ReadWindow(map, "stroke_m", "[low, high] in metres, low < 0 < high");
  if (!limits.stroke_m.empty() && !limits.stroke_m.Contains(0)) {
    map.Fail("stroke_m", "does not hold 0, where a test begins", "low <= 0 < high");
  }
  limits.speed_m_s = map.Number("speed_m_s", {.min = 0, .open_min = true}, 0.0);
  limits.force_N = map.Number("force_N", {.min = 0, .open_min = true}, 0.0);
  limits.duration_s = map.Number("duration_s", {.min = 10, .max = 3600}, 60.0);
  return limits;
}

/// What a run is driven by: signals, or measured runs.
void ReadDrive(YamlMap& map, WindowNeed need, Manifest* m) {
  if (map.Has("signal")) {
    if (map.Has("data") || map.Has("runs")) {
      map.Fail("signal", "is given together with data", "either `data:` or `signal:`");
    }
    if (need == WindowNeed::kEstimation || m->rig == "steps") {
      map.Fail("signal", "nothing was measured", "`data:`", "generated motion is for phs rig");
    }
    m->signal = rigs::ReadRigSignals(map.Map("signal"));
  } else if (map.Has("runs")) {
    for (YamlMap& run : map.Maps("runs")) {
      m->runs.push_back(ReadOneOfRuns(run, m->path, m->rig == "steps"));
    }
    if (m->runs.empty()) map.Fail("runs", "names no run", "at least one");
    RefuseSharedRows(*m, &map);
  } else {
    m->runs.push_back(ReadRun(map, m->path));
  }
}

/// Further channels: columns like the others, and in the rig's options by name until they are read.
void ReadExtra(YamlMap& extra, Manifest* m) {
  auto series = std::make_shared<hydraulics::ExtraSeries>();
  for (const std::string& key : extra.Keys()) {
    m->columns[key] = extra.Text(key);
    m->extra.push_back(key);
    series->names.push_back(key), series->values.push_back({0});
    if (static_cast<int>(m->extra.size()) > hydraulics::kMaxExtra) {
      extra.Fail(key, "is one channel too many", "at most 8");
    }
    if (m->rig == "steps" || m->rig == "bogie") {
      extra.Fail(key, "is not for rig: " + m->rig, "cylinder, quarter, full, element");
    }
  }
  if (!m->extra.empty()) m->options.extra = std::move(series);
}

/// Names of the catalogue as a list; or a map of such names and of laws of one's own.
void ReadCandidates(YamlMap& map, Manifest* m) {
  if (m->rig == "steps" && map.Has("candidates")) {
    map.Fail("candidates", "is not for rig: steps", "cylinder, quarter, full, element, bogie");
  }
  if (!map.IsMap("candidates")) {
    m->candidates = map.Texts("candidates");
    return;
  }
  YamlMap candidates = map.Map("candidates");
  for (const std::string& name : candidates.Keys()) {
    YamlMap entry = candidates.Map(name);
    if (!entry.Has("where") && !entry.Has("expression") && !entry.Has("parameters")) {
      m->candidates.push_back(name);
      continue;
    }
    m->own.push_back(ReadOwnCandidate(candidates, name, m->extra));
    if (m->rig == "bogie") {
      candidates.Fail(name, "a law of one's own is not for rig: bogie",
                      "cylinder, quarter, full, element");
    }
  }
}

/// To be fitted to, one run at least has an estimation window, and each has one of the two.
void AskForWindows(const Manifest& m, YamlMap* map) {
  bool any_estimation = false;
  for (const RunSpec& run : m.runs) any_estimation |= !run.estimation.empty();
  if (!any_estimation) {
    map->Fail("estimation", "no run has an estimation window", "[begin, end] in seconds");
  }
  for (size_t r = 0; r < m.runs.size(); ++r) {
    if (!m.runs[r].estimation.empty() || !m.runs[r].validation.empty()) continue;
    map->Fail("runs", "run " + std::to_string(r + 1) + " has neither window",
              "estimation: [begin, end], validation: [begin, end], or one of them");
  }
}

/// Keys that this rig would not read: a wrong result is better refused than explained.
void RefuseOfOthers(YamlMap& map, const Manifest& m) {
  const auto only = [&](const char* key, bool here, const char* where) {
    if (map.Has(key) && !here) map.Fail(key, "is not read by rig: " + m.rig, where);
  };
  only("compare_below_Hz", m.rig == "element", "rig: element");
  only("beam", m.rig == "full", "rig: full");
  only("setup", m.rig == "steps", "rig: steps");
  only("moving_mass_kg", m.options.driven_by == rigs::Drive::kForce, "driven_by: force");
}

/// Another manifest; to be fitted to, there is none.
std::string ReadComparison(YamlMap& map, const Manifest& manifest, WindowNeed need) {
  if (!map.Has("compare_with")) return "";
  if (need == WindowNeed::kEstimation || !HasClock(manifest)) {
    map.Fail("compare_with", "is for phs rig, and rigs driven over time", kRigsWithClock);
  }
  return BesideFile(manifest.path, map.Text("compare_with"));
}

}  // namespace

Result<std::string> FindManifest(const std::string& name) {
  const fs::path given(name);
  if (given.has_extension()) return name;
  if (given.has_parent_path() && fs::is_regular_file(given)) return name;
  return FindData("manifest", kFolder, name, {".yaml"}, {kThesis});
}

std::vector<std::string> ListManifests() { return ListData(kFolder, {".yaml"}, {kThesis}); }

bool HasClock(const Manifest& manifest) {
  return manifest.rig != "steps" && manifest.rig != "bogie";
}

Result<Manifest> LoadManifest(const std::string& path, WindowNeed need) {
  Result<YamlMap> loaded = YamlMap::Load(path);
  if (!loaded.ok()) return loaded.error();
  YamlMap& map = loaded.value();
  Manifest m;
  m.path = path;
  m.rig = map.Word("rig", {"cylinder", "quarter", "full", "element", "steps", "bogie"});
  if (map.Has("model")) m.model = BesideFile(path, map.Text("model"));
  ReadDrive(map, need, &m);
  const bool each_its_model =
      std::any_of(m.runs.begin(), m.runs.end(), [](const RunSpec& r) { return !r.model.empty(); });
  for (RunSpec& run : m.runs) {
    if (each_its_model && run.model.empty()) run.model = m.model;
    if (m.model.empty()) m.model = run.model;
  }
  if (m.model.empty()) {
    map.Fail("model", "is missing", "a name in models/phs, or a path", "model: quarter_setup2");
  }
  m.setup = map.Integer("setup", 1, 1000000, 0);
  m.options = ReadOptions(map);
  ReadDriven(map, m.rig, need, &m.options);
  m.changes = ReadChanges(map, m.rig);
  YamlMap columns = map.Map("columns"), extra = map.Map("extra"), factors = map.Map("factors");
  for (const std::string& key : columns.Keys()) m.columns[key] = columns.Text(key);
  ReadExtra(extra, &m);
  for (const std::string& key : factors.Keys()) {
    m.factors[key] = factors.Number(key, {.min = -1e15, .max = 1e15});
    if (m.factors[key] == 0) factors.Fail(key, "a factor of 0 leaves nothing", "-1, 1e3, …");
  }
  m.free = map.Texts("free");
  m.shared = map.Texts("shared");
  if (!m.shared.empty() && !each_its_model) {
    map.Fail("shared", "there are no runs to share a number", "runs: with a model each",
             "runs: [{model: …, data: …}, …]");
  }
  ReadCandidates(map, &m);
  if (map.Has("limits")) m.limits = ReadLimits(map.Map("limits"));
  m.compare_below_Hz = map.Number("compare_below_Hz", {.min = 0}, 0.0);
  m.low_pass_Hz = map.Number("low_pass_Hz", {.min = 0}, 0.0);
  m.measured_ways = map.Word("ways", {"measured", "predicted"}, "measured") == "measured";
  if (map.Has("ways") && m.rig != "bogie") {
    map.Fail("ways", "are measured on rig: " + m.rig, "rig: bogie");
  }
  m.compare_with = ReadComparison(map, m, need);
  RefuseOfOthers(map, m);
  if (need == WindowNeed::kEstimation && m.rig != "steps") AskForWindows(m, &map);
  if (Status s = map.Finish(); !s.ok()) return s.error();
  for (const OwnCandidate& own : m.own) {
    if (Status s = CheckNumbersAreUsed(own); !s.ok()) return s.error();
  }
  return m;
}

Manifest OfRun(const Manifest& manifest, size_t run) {
  Manifest out = manifest;
  out.runs = {manifest.runs[run]};
  if (!out.runs.front().model.empty()) out.model = out.runs.front().model;
  return out;
}

bool HasOwnModels(const Manifest& manifest) {
  return !manifest.runs.empty() && !manifest.runs.front().model.empty();
}

Result<hydraulics::PhsParams> DeclaredModel(const Manifest& manifest, const std::string& name) {
  auto params = phs_model::FindPhsParams(name.empty() ? manifest.model : name);
  if (!params.ok()) return params.error();
  if (manifest.rig == "full" && phs_model::IsQuarter(params.value())) {
    params = phs_model::SpreadOverBogie(params.value());
  }
  if (Status s = phs_model::ApplyChanges(manifest.changes, "", &params.value()); !s.ok()) {
    Error error = s.error();
    error.where = manifest.path + ": " + error.where;
    return error;
  }
  return params;
}

}  // namespace phs::measurement
