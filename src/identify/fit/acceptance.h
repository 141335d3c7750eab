// The numbers of the rule of acceptance (accept.h). Beside them decide: plausible ranges and starts
// of the effects, the half of its evidence that one must keep beside a bent law (bent_form.h),
// what a formula's single term must bring (formula_selection.h), and for the word of the verdict
// those of verdict.cc and motion_share.cc.
#pragma once

#include <span>

namespace phs::identify {

struct Acceptance {
  /// Wanted share of clean records on which anything is accepted. A structure is taken only if its
  /// likelihood, less what its numbers and the number of structures tried cost (likelihood.h), is
  /// better by 2 ln(1/false_alarms): by Bonferroni's inequality chance alone does not do that more
  /// often.
  double false_alarms = 0.01;
  /// Share of what the channel that gains most shows beyond its noise that an effect must remove,
  /// what it spoils in others counted against it (evidence.h): no model is quite right, and with many samples
  /// the likelihood sees every per mille of it. Below a third the larger cause is another.
  double least_share = 0.33;
  /// How well the power of noise and discrepancy is known in an octave (likelihood.h): the noise is
  /// estimated from the same record, its level not better than by 5 %.
  double noise_known = 0.1;
};

/// Periods that a wave over time must show. What is slow and has no period lies in a few lines: of k
/// lines as strong on average the strongest holds H_k/k of their power, H_k = 1 + 1/2 + ... + 1/k
/// (mean of the largest of k exponential powers over their sum). In the octave from k periods on that
/// is below `least_share` from this k on: 9 for a third.
int LeastPeriods(const Acceptance& accept);

/// The rule of a search: its numbers, and its parts, each of which can be left out to see what it
/// is worth (docs/identify_rule.md).
struct SearchRule {
  Acceptance accept;
  bool structures = true;
  bool cross_validation = true;
  bool beyond_zero = true;
  bool plain_first = true;
  bool options = true;
  bool elsewhere = true;
  bool superfluous = true;
  bool bends = true;
  bool challenge = true;
  bool names = true;
  bool formula = true;
};

struct AcceptanceNumber {
  const char* name;
  double Acceptance::*value;
  double low, high;  ///< allowed
};
std::span<const AcceptanceNumber> AcceptanceNumbers();

struct RulePart {
  const char* name;
  bool SearchRule::*holds;
  const char* text;  ///< what it does
};
std::span<const RulePart> RuleParts();

}  // namespace phs::identify
