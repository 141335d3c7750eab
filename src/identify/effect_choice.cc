#include "identify/effect_choice.h"

#include "identify/effect_options.h"
#include "identify/effect_reshape.h"
#include "identify/effect_verdict.h"

namespace phs::identify::search {

double MarginOver(const std::string& simple, const std::string& other) {
  return IsNested(simple, other) ? 3 : 1;
}

void ShapeContained(const FitProblem& problem, const FreeModel& model, const FitResult& without,
                    int best, std::vector<FullTrial>* trials, std::span<CandidateRecord> records) {
  const std::string general = (*trials)[static_cast<size_t>(best)].candidate->effect;
  for (size_t i = 0; i < trials->size(); ++i) {
    FullTrial& trial = (*trials)[i];
    CandidateRecord& record = records[i];
    if (!trial.fit.ok || record.verdict != kBeaten) continue;
    if (!IsNested(trial.candidate->effect, general)) continue;
    ShapeOnWhole(problem, model, &trial);
    record.variant = VariantName(trial.form);
    record.evidence = Compare(problem, without, trial.fit);
    const FreeModel whole = WithCandidate(model, trial.form);
    record.evidence.settled = IsSettled(whole, trial.fit, trial.form);
    if (OnBound(whole, trial.fit, trial.form)) record.verdict = kNotPlausible;
  }
}

int FindSimplest(const FitProblem& problem, const std::vector<FullTrial>& trials,
                 std::span<const CandidateRecord> records, int best) {
  const FullTrial& other = trials[static_cast<size_t>(best)];
  int simplest = best;
  for (size_t i = 0; i < trials.size(); ++i) {
    if (!trials[i].fit.ok || records[i].verdict != kBeaten) continue;
    if (trials[i].form.free.size() >= trials[static_cast<size_t>(simplest)].form.free.size()) {
      continue;
    }
    if (FitsAsWellWithFewer(problem, trials[i].fit, other.fit,
                            MarginOver(trials[i].candidate->effect, other.candidate->effect))) {
      simplest = static_cast<int>(i);
    }
  }
  return simplest;
}

bool IsOverruled(const FitProblem& problem, const std::vector<FullTrial>& trials, int best,
                 std::span<CandidateRecord> records) {
  constexpr double kFar = 0.4;  // ln of the mean square
  const int channels = problem.num_channels();
  const double mine = MeanLogSquare(trials[static_cast<size_t>(best)].fit.residual, channels);
  for (size_t i = 0; i < trials.size(); ++i) {
    if (!trials[i].fit.ok || records[i].verdict != kNotPlausible) continue;
    if (MeanLogSquare(trials[i].fit.residual, channels) > mine - kFar) continue;
    records[static_cast<size_t>(best)].verdict =
        trials[i].candidate->effect + " explains far more, with numbers that are not plausible";
    return true;
  }
  return false;
}

}  // namespace phs::identify::search
