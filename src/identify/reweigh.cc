#include "identify/reweigh.h"

#include <utility>

#include "identify/near_fit.h"

namespace phs::identify::search {
namespace {

/// Mean square that a right model would leave weighed by `a` if `b` were right.
double MeanSquare(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0, count = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    if (a[i] > 0 && b[i] > 0) sum += a[i] * a[i] / (b[i] * b[i]), ++count;
  }
  return count > 0 ? sum / count : 1;
}

bool AreOther(const SampleWeights& a, const SampleWeights& b) {
  constexpr double kOther = 1.1;
  for (size_t c = 0; c < a.size(); ++c) {
    if (MeanSquare(a[c], b[c]) > kOther || MeanSquare(b[c], a[c]) > kOther) return true;
  }
  return false;
}

}  // namespace

void Reweigh(FitProblem* problem, FitProblem* coarse, Identification* found) {
  const auto params = problem->Params(found->corrected, found->after.values);
  Result<SampleWeights> full = problem->CalcWeights(params);
  if (!full.ok() || !AreOther(problem->weights(), full.value())) return;
  Result<SampleWeights> thin = coarse->CalcWeights(params);
  if (!thin.ok()) return;
  SampleWeights old = problem->weights();
  problem->SetWeights(std::move(full.value()));
  const auto again = [problem](const FreeModel& model, const FitResult& fit) {
    return FitBalanced(*problem, model, fit.values, {}, {.final_jacobian = true});
  };
  FitResult before = again(found->declared, found->before);
  FitResult after = again(found->corrected, found->after);
  if (!before.ok || !after.ok) return problem->SetWeights(std::move(old));
  coarse->SetWeights(std::move(thin.value()));
  found->before = std::move(before), found->after = std::move(after);
}

}  // namespace phs::identify::search
