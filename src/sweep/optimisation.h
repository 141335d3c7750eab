// A search for the best design, as a study describes it under `optimise:` (docs/sweep_optimise.md).
//
// A candidate is one value for every choice and every parameter. Each case analyses it, so a
// candidate takes as many runs as there are cases. Its objective
//   J = sum_i weight_i r_i
// is least; r_i a number of the result of a case, or its magnitude. Constraints bound such numbers:
//   g = (r - at_most)/s or (at_least - r)/s, s = |bound| (1 where the bound is 0); kept: g <= 0.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/yaml.h"
#include "sweep/study_case.h"

namespace phs::sweep {

/// A number of a case's result.
struct CaseNumber {
  int of_case = 0;          ///< number of the case
  std::string result = {};  ///< path in its result (base/json_path.h)
  bool magnitude = false;
};

struct ObjectiveTerm {
  CaseNumber number;
  double weight = 1;
};

struct DesignConstraint {
  CaseNumber number;
  double bound = 0;
  bool at_most = true;  ///< false: at least
  /// "loads: largest_shift_m <= 0.005".
  std::string name = {};
  double Violation(double value) const;  ///< g; NaN counts as broken
};

struct DesignChoice {
  std::string key = {};
  std::vector<std::string> values = {};
};

struct DesignParameter {
  std::string key = {};
  double min = 0, max = 0, start = 0;
  bool logarithmic = false;
  double AtShare(double u) const;  ///< u in [0, 1]
  double ShareOf(double value) const;
};

struct Optimisation {
  /// cobyla: local, linear models (Powell 1994); direct: divides the whole box, locally biased
  /// (Gablonsky, Kelley 2001); isres: random, from the study's seed (Runarsson, Yao 2005).
  enum class Method { kCobyla, kDirect, kIsres };
  Method method = Method::kCobyla;
  int evaluations = 60;     ///< candidates per combination of choices at most
  double tolerance = 1e-3;  ///< of a parameter's range: cobyla ends there
  std::vector<DesignChoice> choices;
  std::vector<DesignParameter> parameters;
  std::vector<ObjectiveTerm> objective;
  std::vector<DesignConstraint> constraints;

  /// The i-th combination of the choices, last fastest. @pre i < NumCombinations()
  std::vector<std::string> Combination(int i) const;
  int NumCombinations() const;
};

struct OptimisationBlock {
  Optimisation optimisation;
  std::vector<StudyCase> cases;  ///< base: as named, not yet looked up
};

/// Reads the block `optimise:` of a search over `subject`; `base` is that of cases without their own.
/// Errors stay in the map.
OptimisationBlock ReadOptimisation(const Subject& subject, YamlMap map, const std::string& base);

}  // namespace phs::sweep
