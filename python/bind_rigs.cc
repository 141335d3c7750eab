// phs.rig and phs.identify: the jobs of the verbs of the same names, from a manifest to a result
// directory.
#include <pybind11/stl.h>

#include "jobs/rig_job.h"
#include "python/bindings.h"
#include "python/crossing.h"

namespace phs::python {
namespace {

/// (text of result.json, summary in words)
py::tuple Rig(const std::string& manifest, const std::string& out, bool overwrite,
              const std::string& call, const std::string& given) {
  const OriginNotes notes = NotesOf(call, given);
  ResultDir dir = Take(ResultDir::Create(out, overwrite));
  const auto outcome = Take(
      LongWork(py::none()).Do([&](const jobs::Watch&) { return jobs::RunRig(manifest, dir); }));
  Take(dir.Commit());
  return py::make_tuple(outcome.result.dump(), outcome.summary);
}

py::tuple Identify(const std::string& manifest, const std::string& out, bool overwrite, int threads,
                   int max_effects, const std::vector<std::string>& between,
                   const py::object& progress, const std::string& call, const std::string& given) {
  const OriginNotes notes = NotesOf(call, given);
  ResultDir dir = Take(ResultDir::Create(out, overwrite));
  identify::search::SearchOptions options;
  options.effort.threads = threads;
  options.effort.max_effects = max_effects;
  options.between = between;
  const auto identified = Take(LongWork(progress).Do(
      [&](const jobs::Watch& watch) { return jobs::Identify(manifest, options, watch, dir); }));
  if (identified.outcome.cancelled) Raise({"identify", "was stopped", "", ""});
  Take(dir.Commit());
  return py::make_tuple(identified.outcome.result.dump(), identified.outcome.summary);
}

}  // namespace

void BindRigs(py::module_* module) {
  module->def("rig", &Rig);
  module->def("identify", &Identify);
}

}  // namespace phs::python
