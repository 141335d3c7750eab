#include "identify/driven_formula.h"

#include <algorithm>
#include <cmath>

namespace phs::identify::search {

FoundFormula SearchForceFormula(const FitProblem& problem, const FreeModel& model,
                                const FitResult& fit, const FormulaLimits& limits) {
  const int channel = problem.FindOutput("load_cell_N");
  const effects::RigKind kind = problem.data().kind;
  if (channel < 0 || (kind != effects::RigKind::kQuarter && kind != effects::RigKind::kCylinder)) {
    return {};
  }
  Result<std::vector<hydraulics::ForcePlace>> places =
      problem.Places(problem.Params(model, fit.values));
  if (!places.ok()) return {};
  const int n = problem.samples();
  FormulaData data;
  data.residual = fit.residual.segment(channel * n, n);
  data.jacobian = fit.jacobian.middleRows(channel * n, n);
  data.places = {std::move(places.value())};
  data.column = [&](const std::vector<std::vector<double>>& force) {
    return problem.Weighted(channel, force.front());
  };
  data.independent = [](const Eigen::VectorXd& r) {
    return EffectiveSamples(r, 0, static_cast<int>(r.size()));
  };
  data.has_pressure = true;
  data.has_rod_pressure = kind == effects::RigKind::kQuarter;
  return SearchFormula(data, limits);
}

Candidate FormulaCandidate(const FoundFormula& found, double most) {
  Candidate c;
  c.effect = c.params.name = "unlisted";
  c.params.formula = found.text;
  for (int k = 1; k <= 6; ++k) c.params.values["c" + std::to_string(k) + "_N"] = 0;
  c.starts = {{}};
  for (size_t k = 0; k < found.coefficients.size(); ++k) {
    FreeParameter p;
    p.name = "effects.unlisted.c" + std::to_string(k + 1) + "_N";
    p.start = found.coefficients[k];
    p.low = -most, p.high = most;
    p.scale = std::max(std::abs(p.start), 1e-3 * most);
    c.free.push_back(p);
    c.starts[0].push_back(p.start);
    c.params.values["c" + std::to_string(k + 1) + "_N"] = p.start;
  }
  return c;
}

}  // namespace phs::identify::search
