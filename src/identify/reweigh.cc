#include "identify/reweigh.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "identify/near_fit.h"

namespace phs::identify::search {
namespace {

bool AreOther(const SampleWeights& a, const SampleWeights& b) {
  constexpr double kOther = 0.1;
  const auto square = [](const std::vector<double>& w) {
    return std::inner_product(w.begin(), w.end(), w.begin(), 1e-300);
  };
  for (size_t c = 0; c < a.size(); ++c) {
    if (std::abs(std::log(square(a[c]) / square(b[c]))) > kOther) return true;
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
