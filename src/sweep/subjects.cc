#include "sweep/subjects.h"

#include "sweep/rig_case.h"
#include "sweep/rig_run.h"
#include "sweep/scenario_case.h"

namespace phs::sweep {
namespace {

std::vector<Subject> MakeSubjects() {
  return {
      {"scenario",
       "scenario.yaml",
       "simulate",
       "summary.json",
       {{"scenario.", "KEY"},
        {"track.", "KEY"},
        {"model.", "PARAMETER"},
        {"bogie.", "ELEMENT.ATTRIBUTE"},
        {"note.", "NAME"}},
       {"scenario.bogie", "scenario.vehicle", "scenario.phs"},
       &FindScenario,
       &WriteScenarioCase,
       &CheckScenario,
       nullptr},
      {"rig",
       "rig.yaml",
       "rig",
       "result.json",
       {{"rig.", "KEY"}, {"model.", "PARAMETER"}, {"note.", "NAME"}},
       {"rig.rig", "rig.model", "rig.driven_by", "rig.data"},
       &FindRig,
       &WriteRigCase,
       &CheckRig,
       &RigRecords},
  };
}

}  // namespace

std::span<const Subject> Subjects() {
  static const std::vector<Subject> subjects = MakeSubjects();
  return subjects;
}

const Subject* ReadSubject(YamlMap* map) {
  const Subject* named = nullptr;
  for (const Subject& subject : Subjects()) {
    if (!map->Has(subject.key)) continue;
    if (named != nullptr) {
      map->Fail(subject.key, std::string("is given beside `") + named->key + "`", "one of them");
    }
    if (named == nullptr) named = &subject;
  }
  return named == nullptr ? &Subjects().front() : named;
}

}  // namespace phs::sweep
