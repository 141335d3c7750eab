// What a next measurement should tell: two fitted models that the record does not tell apart.
//
// The record's own questions are an accepted effect against one that explains as much, the effects
// that explain alike what the accepted ones leave, and the two ends of what the record leaves open of
// a declared number (its interval spans all that it may be).
// Two effects that a user suspects are a question, too. Each is fitted to the record on top of what
// else was found there. Where its amount is told from none, it is as fitted; where not, it is the
// largest that the record leaves open: with the other numbers fitted anew, -2 ln L is higher than at
// its best by the 95 % quantile of chi squared with one degree of freedom, 3.84 (profile likelihood).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "identify/select/identification.h"
#include "identify/select/screening.h"
#include "identify/select/test_evidence.h"

namespace phs::identify::search {

struct Question {
  FittedModel one, other;
  bool number = false;  ///< the two ends of a declared number, else two effects
  /// Two effects that were asked for: what of each was taken for its design, else empty.
  std::vector<std::string> sizes = {};
};

/// An error where `between` is neither empty nor two different effects that may be tried on the
/// declared model, or what drives the model cannot be chosen.
Status CheckBetween(const ForwardModel& forward, const hydraulics::PhsParams& declared,
                    const std::vector<std::string>& between);

/// Those that the record itself leaves, at most four.
std::vector<Question> OpenQuestions(const FitProblem& problem, const Identification& found);

/// The two effects `between`. `coarse`: the problem on the coarse clock. `go_on`: asked on the way,
/// false = stop. Error: one of them could not be fitted.
Result<Question> AskedQuestion(const FitProblem& problem, const FitProblem& coarse,
                               const Identification& found, const std::vector<std::string>& between,
                               const Effort& effort, const std::function<bool()>& go_on = {});

/// The model with its number `amount` as large as the record leaves it, the others fitted anew (of
/// a form with several amounts: its first). `fit`: of the model.
FittedModel LargestLeftOpen(const FitProblem& problem, const FreeModel& model, const FitResult& fit,
                            size_t amount);

}  // namespace phs::identify::search
