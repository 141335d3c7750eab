// What an identification found: the corrected model, the effects in it, and everything tried.
#pragma once

#include <string>
#include <vector>

#include "identify/discrepancy/formula_selection.h"
#include "identify/fit/effect_variants.h"
#include "identify/fit/evidence.h"
#include "identify/fit/search_fit.h"

namespace phs::identify::search {

struct CandidateRecord {
  std::string effect;
  std::string variant;  ///< targets and free numbers
  int round = 0;
  double screening_gain = 0;  ///< of the criterion, on the coarse record
  bool fitted = false;
  Evidence evidence;
  std::string verdict;  ///< "accepted", or why not
  /// Refused for nothing but amounts at the end of what is plausible: these.
  std::vector<std::string> at_end = {};
};

/// What explains as much as an accepted effect, with the numbers that it was fitted with.
struct Rival {
  Candidate form;
  std::vector<double> values;
};

struct AcceptedEffect {
  Candidate candidate;
  Evidence evidence;
  std::vector<std::string> confusable_with;
  /// Effects that contain it and that chance may have put behind it.
  std::vector<std::string> special_case_of = {};
  std::vector<Rival> rivals = {};  ///< the same
};

struct Identification {
  FreeModel declared, corrected;
  FitResult before;  ///< declared, by plain least squares: what its numbers can do alone
  FitResult base;    ///< declared, by likelihood: what evidence is counted from
  FitResult after;
  std::vector<AcceptedEffect> effects;  ///< strongest first
  FoundFormula formula;                 ///< of the effect `unlisted`, if accepted
  std::vector<CandidateRecord> candidates;
  bool cancelled = false;
};

/// The model of the accepted effects but one, and the numbers that these have now.
std::vector<double> ValuesWithout(const Identification& found, size_t dropped, FreeModel* model);

/// False if beside the later ones an amount of the effect has gone to the end of its range, or to none.
bool IsToldInTheEnd(const Identification& found, size_t effect);

/// Leaves the core alone of the effect accepted last: the further numbers of its form go. Then `after`
/// is to be fitted anew.
void KeepCore(Identification* found);

/// Takes the further numbers of the effects' forms out that have gone to the end of their range since
/// (effect_form.h asks the same when an effect is tried); true if there were any: then `after` is to
/// be fitted anew, its values are those of the numbers that are left.
bool TakeOutEdges(Identification* found);

/// What is said of the accepted among the candidates is what was accepted in the end; strongest
/// first; what stands beside an effect is not confused with it.
void UpdateRecords(Identification* found);

/// The effect, with its part where the same on another part explains the record, too.
std::string NameBesideRivals(const AcceptedEffect& effect);

}  // namespace phs::identify::search
