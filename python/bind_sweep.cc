// phs.sweep: the job of the verb of the same name. Called by phs/_sweeps.py in a process of its own:
// the workers are forked, and the user's Python may have threads.
#include <pybind11/stl.h>

#include "jobs/sweep_job.h"
#include "python/bindings.h"
#include "python/crossing.h"
#include "sweep/study_file.h"

namespace phs::python {
namespace {

std::string Failed(const Error& error) {
  return Json{{"error", {error.where, error.what, error.allowed, error.mend}}}.dump();
}

/// `progress` hears the share done and answers whether to go on. What was made or went wrong comes
/// back as JSON.
std::string Sweep(const std::string& study_file, const std::string& out, int workers, bool resume,
                  bool overwrite, const py::function& progress, const std::string& call,
                  const std::string& given) {
  const OriginNotes notes = NotesOf(call, given);
  const auto study = sweep::LoadStudy(study_file);
  if (!study.ok()) return Failed(study.error());
  const auto made = jobs::MakeSweep(
      study.value(), {.out = out, .workers = workers, .resume = resume, .overwrite = overwrite},
      {.progress = [&](double share) { return progress(share).cast<bool>(); }});
  if (!made.ok()) return Failed(made.error());
  return Json{{"all", made.value().all}, {"done", made.value().done}}.dump();
}

}  // namespace

void BindSweep(py::module_* module) { module->def("sweep", &Sweep); }

}  // namespace phs::python
