// The verbs of `phs`, in the order of --help. A verb is a file verb_NAME.cc and its row here.
#pragma once

#include <CLI/CLI.hpp>  // for the verbs alone: six seconds of every file that reads it

#include "cli/verbs.h"

namespace phs::cli {

/// Adds the options of a verb to its own subcommand and says what it does when it is chosen.
using AddVerb = void(CLI::App* verb, Action* action);

struct Verb {
  const char* name;
  const char* text;  ///< one line of --help
  AddVerb* add;
};

AddVerb AddSimulate, AddCompare, AddContact, AddModes, AddIdentify, AddImport, AddLoads,
    AddStability, AddRig, AddCurving, AddReport, AddSweep, AddValidate, AddList, AddShow, AddNew,
    AddSchema, AddView, AddVideo, AddAlarms, AddStudy, AddMakeTestData;

inline constexpr Verb kVerbs[] = {
    {"simulate", "One bogie on one track", &AddSimulate},
    {"compare", "The same run with several bogies", &AddCompare},
    {"contact", "Wheel-rail contact alone: creepage cases, or a wheelset placed on track",
     &AddContact},
    {"modes", "Stiffness and damping of the axle modes", &AddModes},
    {"identify", "Find the physical effect that a declared model lacks, add it, prove it",
     &AddIdentify},
    {"import", "A URDF bogie as MJCF, ready for simulate", &AddImport},
    {"loads", "Loads on the axle boxes and which part of the PHS gives first", &AddLoads},
    {"stability", "Eigenvalues over speed, critical speed, limit cycle on straight track",
     &AddStability},
    {"rig", "A hydraulic rig driven by measured or generated motion, beside what was measured",
     &AddRig},
    {"curving", "Steady state in curves of many radii, found without running through time",
     &AddCurving},
    {"report", "Draw report.html of a result again, or a page of all results in a folder",
     &AddReport},
    {"sweep", "Many runs of one scenario, resumable, on all cores or a cluster", &AddSweep},
    {"study", "A design study repeated: a question, its parts, a report", &AddStudy},
    {"alarms", "Which pair of line pressures tells a lost hose, how soon, how often falsely",
     &AddAlarms},
    {"make-test-data",
     "Rig records with something hidden in them, and the score of identify on them",
     &AddMakeTestData},
    {"validate", "Every published check: ours, reference, difference, tolerance", &AddValidate},
    {"view", "A run in a window, in three dimensions", &AddView},
    {"video", "A run as a film or picture, without a display", &AddVideo},
    {"list", "What ships and can be asked for by name, with a line each", &AddList},
    {"show", "The file, or the numbers, behind a name that `list` prints", &AddShow},
    {"new", "A commented start of one's own that runs as it is", &AddNew},
    {"schema", "JSON schema of a kind of YAML file, for editors", &AddSchema},
};

}  // namespace phs::cli
