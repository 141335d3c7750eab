#include "identify/driven_formula.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "identify/line_formula.h"
#include "identify/near_fit.h"

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

namespace {

/// Fits the formula together with all numbers of the model.
FormulaTrial FitFormula(const FitProblem& problem, const FreeModel& model, const FitResult& fit,
                        const FoundFormula& found, double most) {
  FormulaTrial out;
  if (found.empty()) return out;
  out.found = found;
  out.candidate = FormulaCandidate(found, most);
  out.model = WithCandidate(model, out.candidate);
  std::vector<double> start = fit.values;
  start.insert(start.end(), out.candidate.starts[0].begin(), out.candidate.starts[0].end());
  out.fit = FitNear(
      problem, out.model, start, fit.jacobian,
      {.first_own = static_cast<int>(fit.values.size()), .max_steps = 8, .final_jacobian = true});
  if (out.fit.ok) out.evidence = Compare(problem, fit, out.fit);
  return out;
}

}  // namespace

FormulaTrial TryFormula(const FitProblem& problem, const FitProblem& coarse, const FreeModel& model,
                        const FitResult& fit, const FormulaLimits& limits, int threads) {
  constexpr double kNoise = 1.1, kMostForce_N = 1e5, kMostOil = 1e-3;
  double pressures = 0, load = 0;
  for (int c = 0; c < problem.num_channels(); ++c) {
    const std::string& name = problem.data().outputs[static_cast<size_t>(c)].name;
    double& worst = name.ends_with("_Pa") ? pressures : load;
    if (name != "piston_m") worst = std::max(worst, fit.channel_ms[static_cast<size_t>(c)]);
  }
  FormulaTrial force, line;
  if (load > kNoise) {
    force = FitFormula(problem, model, fit, SearchForceFormula(problem, model, fit, limits),
                       kMostForce_N);
    if (force.fit.ok) {
      const auto c = static_cast<size_t>(problem.FindOutput("load_cell_N"));
      force.channel_gain = 1 - std::sqrt(force.fit.channel_ms[c] / fit.channel_ms[c]);
    }
  }
  if (pressures > kNoise && problem.data().kind != effects::RigKind::kFull) {
    line = FitFormula(problem, model, fit,
                      SearchLineFormula(coarse, model, fit.values, limits, threads), kMostOil);
    line.channel_gain = line.evidence.best_channel_gain;
  }
  if (!line.fit.ok) return force;
  if (!force.fit.ok) return line;
  const int channels = problem.num_channels();
  const bool better =
      MeanLogSquare(line.fit.residual, channels) < MeanLogSquare(force.fit.residual, channels);
  return better ? line : force;
}

Candidate FormulaCandidate(const FoundFormula& found, double most) {
  Candidate c;
  c.effect = c.params.name = "unlisted";
  c.params.formula = found.text;
  c.params.targets = found.targets;
  c.starts = {{}};
  for (size_t k = 0; k < found.coefficients.size(); ++k) {
    const std::string name = fmt::format("c{}_{}", k + 1, found.unit);
    FreeParameter p;
    p.name = "effects.unlisted." + name;
    p.start = found.coefficients[k];
    p.low = -most, p.high = most;
    p.scale = p.start != 0 ? std::abs(p.start) : 1e-3 * most;
    c.free.push_back(p);
    c.starts[0].push_back(p.start);
    c.params.values[name] = p.start;
  }
  return c;
}

}  // namespace phs::identify::search
