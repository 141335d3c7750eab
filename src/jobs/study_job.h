// A design study carried out: `phs study`. Its parts are commands of this program, made one after
// the other in DIR.unfinished/NAME; a study that is stopped or killed goes on from there. When all
// are made, they become DIR with study.json, a copy of the study's file and report.html.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.h"
#include "jobs/design_study.h"

namespace phs::jobs {

/// How a command ended: its exit code, or 128 + the signal that ended it.
/// `words`: verb and arguments; what it prints goes into the file `printed`.
using RunCommand =
    std::function<Result<int>(const std::vector<std::string>& words, const std::string& printed)>;

struct StudyRequest {
  DesignStudy study;
  std::string out;
  bool resume = false;
  bool overwrite = false;
  int workers = 0;  ///< for parts that can work at several things at a time; 0: their own choice
  RunCommand run = {};
  /// Whether a verb takes --workers.
  std::function<bool(const std::string& verb)> takes_workers = {};
};

struct MadeStudy {
  bool all = false;             ///< false: stopped; what is finished is kept in DIR.unfinished
  std::string stopped_in = {};  ///< part
  nlohmann::ordered_json json;  ///< study.json
};

/// Makes all parts that are not made yet, then the result. Errors: DIR exists, an unfinished study
/// without `resume`, another study under `resume`, a part with wrong input, a column that a table
/// will lack.
Result<MadeStudy> MakeStudy(const StudyRequest& request);

}  // namespace phs::jobs
