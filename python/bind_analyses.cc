// phs.modes, phs.stability, phs.curving, phs.loads: the jobs of the verbs of the same names. Each
// takes its options by name and returns the text of the verb's JSON file.
#include <pybind11/stl.h>

#include <optional>

#include "jobs/curving_job.h"
#include "jobs/loads_job.h"
#include "jobs/modes_job.h"
#include "jobs/stability_job.h"
#include "python/bindings.h"
#include "python/crossing.h"
#include "vehicle/scenario_file.h"

namespace phs::python {
namespace {

template <typename Value>
void Read(const py::dict& options, const char* name, Value* value) {
  if (options.contains(name)) *value = options[name].cast<Value>();
}

/// What every analysis of a bogie may be told: keys of a scenario, read as those of its file. The
/// track stays open unless it is given.
vehicle::Scenario ReadScenario(const py::dict& options) {
  auto scenario = Take(vehicle::ScenarioWith("", options["scenario"].cast<std::string>()));
  scenario.track.clear();
  Read(options, "track", &scenario.track);
  return scenario;
}

OriginNotes NotesFrom(const py::dict& options) {
  return NotesOf(options["call"].cast<std::string>(), options["given"].cast<std::string>());
}

std::optional<ResultDir> OpenDir(const py::dict& options) {
  std::string out;
  bool overwrite = false;
  Read(options, "out", &out);
  Read(options, "overwrite", &overwrite);
  std::optional<ResultDir> dir;
  if (!out.empty()) dir.emplace(Take(ResultDir::Create(out, overwrite)));
  return dir;
}

/// Writes by `write(dir)` and commits, if a directory was asked for.
template <typename Write>
void Finish(std::optional<ResultDir>* dir, const Write& write) {
  if (!*dir) return;
  Take(write(&**dir));
  Take((*dir)->Commit());
}

std::string Modes(const py::dict& options, const py::object& progress) {
  const OriginNotes notes = NotesFrom(options);
  jobs::ModesRequest request;
  request.scenario = ReadScenario(options);
  Read(options, "beside", &request.beside);
  Read(options, "frequency_Hz", &request.measure.frequency_Hz);
  auto dir = OpenDir(options);
  const auto all = Take(LongWork(progress).Do(
      [&](const jobs::Watch& watch) { return jobs::MeasureModes(request, watch); }));
  Finish(&dir, [&](ResultDir* d) { return jobs::WriteModes(all, request, d); });
  Json json = Json::array();
  for (const jobs::MeasuredModes& measured : all) {
    json.push_back(jobs::ModesJson(measured, request));
  }
  return json.dump();
}

std::string Loads(const py::dict& options, const py::object& progress) {
  const OriginNotes notes = NotesFrom(options);
  const vehicle::Scenario scenario = ReadScenario(options);
  auto dir = OpenDir(options);
  const auto loads =
      Take(LongWork(progress).Do([&](const jobs::Watch&) { return jobs::CalcLoads(scenario); }));
  Finish(&dir, [&](ResultDir* d) { return jobs::WriteLoads(loads, d); });
  return loads.json.dump();
}

std::string Stability(const py::dict& options, const py::object& progress) {
  const OriginNotes notes = NotesFrom(options);
  jobs::StabilityRequest request;
  request.scenario = ReadScenario(options);
  request.timestep_s = request.scenario.timestep_s;
  Read(options, "from_m_s", &request.scan.min_speed_m_s);
  Read(options, "to_m_s", &request.scan.max_speed_m_s);
  Read(options, "speeds", &request.scan.speeds);
  Read(options, "ramp", &request.ramp);
  Read(options, "ramp_from_m_s", &request.cycle.high_speed_m_s);
  Read(options, "ramp_to_m_s", &request.cycle.low_speed_m_s);
  Read(options, "ramp_rate_m_s2", &request.cycle.rate_m_s2);
  auto dir = OpenDir(options);
  const auto stability = Take(LongWork(progress).Do(
      [&](const jobs::Watch& watch) { return jobs::AnalyseStability(request, watch, watch); }));
  Finish(&dir, [&](ResultDir* d) { return jobs::WriteStability(stability, d); });
  return stability.json.dump();
}

std::string Curving(const py::dict& options, const py::object& progress) {
  const OriginNotes notes = NotesFrom(options);
  jobs::CurvingRequest request;
  request.scenario = ReadScenario(options);
  request.scenario.name = "curving";
  request.track = request.scenario.track;
  Read(options, "bogies", &request.bogies);
  Read(options, "radii_m", &request.radii);
  Read(options, "speed_limit_km_h", &request.speed_limit_km_h);
  Read(options, "cant_m", &request.largest_cant_m);
  Read(options, "deficiency_m", &request.deficiency_m);
  Read(options, "time_run", &request.time_run);
  auto dir = OpenDir(options);
  const Json curves = Take(LongWork(progress).Do(
      [&](const jobs::Watch& watch) { return jobs::SolveCurves(request, watch); }));
  Finish(&dir, [&](ResultDir* d) { return jobs::WriteCurves(curves, d); });
  return curves.dump();
}

}  // namespace

void BindAnalyses(py::module_* module) {
  module->def("modes", &Modes);
  module->def("loads", &Loads);
  module->def("stability", &Stability);
  module->def("curving", &Curving);
}

}  // namespace phs::python
