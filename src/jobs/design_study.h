// A design study as a file: a question, the parts that answer it, what its report shows of them.
// Read from models/studies/*.yaml (docs/studies.md). A sweep's file alone is a study of one part.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace phs::jobs {

/// Curves of a sweep's table: `y` over `x`, one for each set of values in the columns `by`.
struct StudyPlot {
  std::string title = {};
  std::string x = {};
  std::string y = {};
  std::vector<std::string> by = {};
};

/// How far the columns `of` lie apart, for each set of values in the columns `by`.
struct StudySpread {
  std::string title = {};
  std::vector<std::string> of = {};
  std::vector<std::string> by = {};
  double within_factor = 0;  ///< wanted: largest over least at most this; 0 = nothing is wanted
};

struct StudyPart {
  std::string name = {};
  std::string text = {};
  std::vector<std::string> words = {};  ///< of the command: verb, arguments
  bool is_sweep = false;
  bool may_fail = false;  ///< runs that end badly are part of the answer
  std::vector<StudyPlot> plots = {};
  std::vector<StudySpread> spreads = {};
};

struct DesignStudy {
  std::string path = {};
  std::string name = {};  ///< file name without extension
  std::string text = {};  ///< of the file, kept with the result
  std::string question = {};
  std::vector<StudyPart> parts = {};
};

/// A name of models/studies or of models/sweeps, or a path to a file of either kind. The question of
/// a sweep is empty. Errors name file:line and key.
Result<DesignStudy> LoadDesignStudy(const std::string& name);
/// The file of a design study alone.
Result<DesignStudy> ReadDesignStudy(const std::string& path);

}  // namespace phs::jobs
