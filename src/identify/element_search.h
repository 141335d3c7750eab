// Which effects does the declared model of a bench part lack? Baseline fit, forward selection over
// the catalogue with full fits of every candidate, a pass that drops what later effects made
// superfluous, then what remains as a formula (effect `unlisted`). A listed effect that a formula
// of no more numbers beats is replaced by it: listed effects are not bent to fit.
// Evidence: element_evidence.h. The validation windows are not looked at.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "identify/element_candidates.h"
#include "identify/element_evidence.h"
#include "identify/element_fit.h"
#include "identify/formula_search.h"

namespace phs::identify::element {

struct ElementRecordOfTrial {
  std::string effect, variant;
  int round = 0;
  ElementEvidence evidence;
  std::string verdict;
};

struct AcceptedElementEffect {
  search::Candidate candidate;
  ElementEvidence evidence;
  std::vector<std::string> confusable_with;
};

struct ElementSearchOptions {
  int threads = 2;
  int max_effects = 5;
  int full_fits = 8;  ///< candidates fitted in full per round
  double min_delta_bic = 12;
  double min_gain = 0.012;
  double margin = 0.02;  ///< residuals within this share cannot be told apart
};

struct ElementIdentification {
  FreeModel declared, corrected;
  ElementFit before, after;
  Sizes sizes;
  std::vector<AcceptedElementEffect> effects;  ///< strongest first
  std::vector<ElementRecordOfTrial> candidates;
  FoundFormula formula;  ///< of the effect `unlisted`, if accepted
  bool cancelled = false;
};

/// Progress from 0 to 1; false cancels.
using ElementProgress = std::function<bool(double)>;

Result<ElementIdentification> IdentifyElement(ElementProblem* problem,
                                              const hydraulics::PhsParams& declared,
                                              const std::vector<std::string>& free,
                                              const ElementSearchOptions& options,
                                              const ElementProgress& progress);

}  // namespace phs::identify::element
