#include "identify/select/bent_form.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <set>

#include "identify/fit/evidence.h"

namespace phs::identify::search {
namespace {

using hydraulics::ForcePlace;

constexpr double kLargerPart = 0.5;
constexpr int kMostBends = 3;

using Variable = double (*)(const ForcePlace&);
constexpr Variable kVariables[] = {[](const ForcePlace& at) { return at.direction; },
                                   [](const ForcePlace& at) { return at.piston; },
                                   [](const ForcePlace& at) { return std::abs(at.speed); },
                                   [](const ForcePlace& at) { return at.bore_rise; },
                                   [](const ForcePlace& at) { return at.rod_rise; },
                                   [](const ForcePlace& at) { return at.time; }};

/// The variables on all rows of the residual; none: the forward model does not know them.
std::vector<Eigen::VectorXd> OnRows(const FitProblem& problem,
                                    const hydraulics::PhsParams& params) {
  std::vector<Eigen::VectorXd> out(std::size(kVariables),
                                   Eigen::VectorXd::Zero(problem.num_rows()));
  std::set<std::string> done;
  for (int b = 0; b < problem.num_blocks(); ++b) {
    const std::string& channel = problem.block_name(static_cast<size_t>(b));
    if (!done.insert(channel).second) continue;
    const auto frame = problem.forward().Frame(params, channel);
    if (!frame.ok()) return {};
    const auto on_rows = [&](const auto& value) {
      std::vector<std::vector<double>> values;
      for (const auto& run : frame.value().places) {
        values.emplace_back();
        for (const ForcePlace& at : run) values.back().push_back(value(at));
      }
      return problem.Weighted(channel, frame.value().rows(values));
    };
    const Eigen::VectorXd weight = on_rows([](const ForcePlace&) { return 1.0; });
    for (size_t k = 0; k < out.size(); ++k) {
      const Eigen::VectorXd weighted = on_rows(kVariables[k]);
      for (Eigen::Index i = 0; i < weight.size(); ++i) {
        if (weight[i] > 0) out[k][i] = weighted[i] / weight[i];
      }
    }
  }
  return out;
}

/// Coefficients of what an effect does to the residual, times each of its bends.
std::vector<Eigen::VectorXd> Bends(const Likelihood& likelihood, const Eigen::VectorXd& does,
                                   const std::vector<Eigen::VectorXd>& variables) {
  std::vector<Eigen::VectorXd> out;
  const auto add = [&](const Eigen::VectorXd& bent) {
    if (bent.squaredNorm() > 0) out.push_back(likelihood.Transform(bent));
  };
  Eigen::VectorXd by_size = does, rate = Eigen::VectorXd::Zero(does.size());
  for (const Block& block : likelihood.blocks()) {
    auto part = by_size.segment(block.begin, block.count);
    const double most = part.cwiseAbs().maxCoeff();
    if (most > 0) part.array() *= part.array().abs() / most;
    for (int i = block.begin + 1; i + 1 < block.begin + block.count; ++i) {
      rate[i] = 0.5 * (does[i + 1] - does[i - 1]);
    }
  }
  add(by_size), add(rate);
  for (const Eigen::VectorXd& v : variables) add(does.cwiseProduct(v));
  return out;
}

/// -2 ln L with these columns fitted; the weights follow what is left.
double ScoreWith(const Likelihood& likelihood, const FitResult& fit, const Eigen::VectorXd& start,
                 const Eigen::MatrixXd& columns) {
  constexpr int kRounds = 4;
  BandPowers powers = fit.powers;
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::VectorXd w = likelihood.Weights(powers);
    const Eigen::MatrixXd weighted = w.asDiagonal() * columns;
    Eigen::MatrixXd normal = weighted.transpose() * weighted;
    normal.diagonal().array() = normal.diagonal().array() * (1 + 1e-9) + 1e-12;
    const Eigen::VectorXd right = weighted.transpose() * w.cwiseProduct(start);
    powers = likelihood.Powers(start - columns * normal.ldlt().solve(right));
  }
  return likelihood.MinusTwoLog(powers);
}

/// By how much bends lower the criterion of a fit.
double GainOfBends(const Likelihood& likelihood, const FitResult& fit,
                   std::vector<Eigen::VectorXd> bends) {
  const Eigen::VectorXd start = likelihood.Transform(fit.residual);
  Eigen::MatrixXd columns = fit.slopes;
  double gain = 0;
  for (int n = 1; n <= kMostBends && !bends.empty(); ++n) {
    columns.conservativeResize(start.size(), columns.cols() + 1);
    double best = INFINITY;
    size_t which = 0;
    for (size_t k = 0; k < bends.size(); ++k) {
      columns.rightCols(1) = bends[k];
      const double score = ScoreWith(likelihood, fit, start, columns);
      if (score < best) best = score, which = k;
    }
    const double cost =
        n * std::log(likelihood.Count()) + 2 * std::log(static_cast<double>(bends.size()));
    if (!(fit.score - best - cost > gain)) break;
    gain = fit.score - best - cost;
    columns.rightCols(1) = bends[which];
    bends.erase(bends.begin() + static_cast<long>(which));
  }
  return gain;
}

/// What effect `host` does to the residual of `found`.
Eigen::VectorXd Does(const FitProblem& problem, const Identification& found, size_t host) {
  FreeModel without;
  const std::vector<double> values = ValuesWithout(found, host, &without);
  const Eigen::VectorXd plain = problem.Residual(without, values);
  if (plain.size() != found.after.residual.size()) return {};
  return plain - found.after.residual;
}

}  // namespace

std::optional<size_t> IsFormOf(const FitProblem& problem, const Identification& found, size_t i,
                               const FreeModel& model, const FitResult& rest) {
  const Likelihood& likelihood = problem.likelihood();
  const double alone = Criterion(problem, rest.score, rest.values.size()) -
                       Criterion(problem, found.after.score, found.after.values.size());
  Identification less = found;
  less.effects.erase(less.effects.begin() + static_cast<long>(i));
  less.corrected = model, less.after = rest;
  std::vector<Eigen::VectorXd> variables;
  for (size_t host = 0; host < found.effects.size(); ++host) {
    const bool stronger =
        found.effects[host].evidence.delta_bic > found.effects[i].evidence.delta_bic;
    if (host == i || !stronger) continue;
    if (variables.empty()) variables = OnRows(problem, ParamsOf(model, rest.values));
    if (variables.empty()) return {};
    const Eigen::VectorXd in_rest = Does(problem, less, host < i ? host : host - 1),
                          in_both = Does(problem, found, host);
    if (in_rest.size() == 0 || in_both.size() == 0) continue;
    const double beside =
        alone - GainOfBends(likelihood, rest, Bends(likelihood, in_rest, variables)) +
        GainOfBends(likelihood, found.after, Bends(likelihood, in_both, variables));
    if (beside < kLargerPart * alone) return host;
  }
  return {};
}

}  // namespace phs::identify::search
