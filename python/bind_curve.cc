// phs.run and phs.compare: the job of `phs simulate` and `phs compare`.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>

#include "base/result_dir.h"
#include "jobs/curve_job.h"
#include "python/bindings.h"
#include "python/own_functions.h"
#include "vehicle/scenario_file.h"

namespace phs::python {
namespace {

/// A finished job. Arrays look into it and keep it alive.
struct FinishedCurve {
  jobs::Curve curve;
};
using Finished = std::shared_ptr<FinishedCurve>;

struct Asked {
  std::string scenario, changes;  ///< ScenarioWith
  std::vector<std::string> bogies;
  bool compare = false, verify = false, csv = false, overwrite = false;
  std::string out;
};

Asked ReadAsked(const py::dict& asked) {
  return {asked["scenario"].cast<std::string>(),
          asked["changes"].cast<std::string>(),
          jobs::ExpandBogies(asked["bogies"].cast<std::vector<std::string>>()),
          asked["compare"].cast<bool>(),
          asked["verify"].cast<bool>(),
          asked["csv"].cast<bool>(),
          asked["overwrite"].cast<bool>(),
          asked["out"].cast<std::string>()};
}

/// Prepares, runs and writes. False: stopped.
Result<bool> Work(const Asked& asked, jobs::Curve* curve, const jobs::Watch& watch,
                  std::optional<ResultDir>* dir) {
  auto ended = jobs::RunCurve(curve, watch);
  if (!ended.ok() || !ended.value() || !*dir) return ended;
  const auto files = asked.compare ? jobs::CurveFiles::kCompare : jobs::CurveFiles::kSingle;
  if (Status s = jobs::WriteCurve(*curve, files, asked.csv, &**dir); !s.ok()) return s.error();
  if (Status s = (*dir)->Commit(); !s.ok()) return s.error();
  return true;
}

Finished Run(const py::dict& given, const py::object& begin, const py::object& progress) {
  const Asked asked = ReadAsked(given);
  const OriginNotes notes =
      NotesOf(given["call"].cast<std::string>(), given["given"].cast<std::string>());
  auto scenario = asked.changes.empty() ? vehicle::LoadScenario(asked.scenario)
                                        : vehicle::ScenarioWith(asked.scenario, asked.changes);
  jobs::CurveRequest request{
      .scenario = Take(std::move(scenario)), .bogies = asked.bogies, .verify = asked.verify};
  const auto fault = std::make_shared<RaisedFault>();
  if (!begin.is_none()) {
    request.own = [&begin, fault](const vehicle::Simulation& simulation) {
      return BindOwnFunctions(simulation, begin, fault);
    };
  }
  std::optional<ResultDir> dir;
  if (!asked.out.empty()) dir.emplace(Take(ResultDir::Create(asked.out, asked.overwrite)));
  auto finished = std::make_shared<FinishedCurve>();
  LongWork long_work(progress);
  auto prepared = long_work.Do([&](const jobs::Watch&) { return jobs::PrepareCurve(request); });
  finished->curve = Take(std::move(prepared));
  auto ended = long_work.Do(
      [&](const jobs::Watch& watch) { return Work(asked, &finished->curve, watch, &dir); });
  fault->Raise();
  if (!Take(std::move(ended))) Raise({"run", "was stopped", "", ""});
  finished->curve.own = {};
  return finished;
}

const jobs::CurveRun& RunAt(const Finished& finished, size_t run) {
  return finished->curve.runs.at(run);
}

/// A recorded channel as a view, read only.
py::array Column(const Finished& finished, size_t run, size_t channel) {
  const std::vector<double>& column = RunAt(finished, run).outcome.columns.at(channel);
  py::array_t<double> view(static_cast<py::ssize_t>(column.size()), column.data(),
                           py::cast(finished));
  view.attr("flags").attr("writeable") = false;
  return view;
}

py::list Channels(const Finished& finished, size_t run) {
  py::list channels;
  for (const Channel& channel : RunAt(finished, run).outcome.channels) {
    channels.append(py::make_tuple(channel.name, channel.unit, channel.description));
  }
  return channels;
}

}  // namespace

void BindCurve(py::module_* module) {
  py::class_<FinishedCurve, Finished>(*module, "Curve")
      .def("names",
           [](const Finished& f) {
             std::vector<std::string> names;
             for (const jobs::CurveRun& run : f->curve.runs) names.push_back(run.bogie);
             return names;
           })
      .def("compared", [](const Finished& f) { return f->curve.Compared().dump(); })
      .def("single", [](const Finished& f) { return f->curve.Single().dump(); })
      .def("channels", &Channels)
      .def("column", &Column);
  module->def("run_curve", &Run);
}

}  // namespace phs::python
