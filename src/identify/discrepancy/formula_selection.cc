#include "identify/discrepancy/formula_selection.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

namespace phs::identify {
namespace {

/// Least part of a term (of its norm) that the model's free numbers cannot imitate: below, it would
/// only take over what a listed law says.
constexpr double kOwnShare = 0.1;

Eigen::MatrixXd Joined(const std::vector<TermTrial>& terms) {
  Eigen::Index count = 0;
  for (const TermTrial& t : terms) count += t.columns.cols();
  Eigen::MatrixXd out(terms.empty() ? 0 : terms[0].columns.rows(), count);
  Eigen::Index at = 0;
  for (const TermTrial& t : terms) {
    out.middleCols(at, t.columns.cols()) = t.columns;
    at += t.columns.cols();
  }
  return out;
}

Eigen::VectorXd Solve(const Eigen::MatrixXd& columns, const Eigen::VectorXd& residual) {
  return columns.colPivHouseholderQr().solve(residual);
}

/// Evidence for going from `before` to `after` with `count` more numbers.
double Evidence(const SelectionData& data, const Eigen::VectorXd& before,
                const Eigen::VectorXd& after, Eigen::Index count, double tried) {
  const double n = data.independent(after);
  return n * std::log(before.squaredNorm() / std::max(after.squaredNorm(), 1e-300)) -
         static_cast<double>(count) * std::log(n) - 2 * tried;
}

/// Share of the rms that the terms remove from blocks on which they were not fitted.
double CrossValidate(const Eigen::MatrixXd& columns, const Eigen::VectorXd& residual) {
  constexpr int kBlocks = 8;
  const Eigen::Index n = residual.size();
  double held = 0;
  for (int b = 0; b < kBlocks; ++b) {
    const Eigen::Index begin = b * n / kBlocks, count = (b + 1) * n / kBlocks - begin;
    Eigen::MatrixXd c = columns;
    Eigen::VectorXd r = residual;
    c.middleRows(begin, count).setZero();
    r.segment(begin, count).setZero();
    const Eigen::VectorXd x = Solve(c, r);
    held += (residual.segment(begin, count) - columns.middleRows(begin, count) * x).squaredNorm();
  }
  return 1 - std::sqrt(held / std::max(residual.squaredNorm(), 1e-300));
}

void DropSuperfluous(const SelectionData& data, const FormulaLimits& limits,
                     const Eigen::VectorXd& residual, double tried, std::vector<TermTrial>* terms) {
  for (size_t i = 0; i < terms->size() && terms->size() > 1;) {
    std::vector<TermTrial> rest = *terms;
    rest.erase(rest.begin() + static_cast<long>(i));
    const Eigen::MatrixXd with = Joined(*terms), without = Joined(rest);
    const Eigen::VectorXd after = residual - with * Solve(with, residual);
    const Eigen::VectorXd before = residual - without * Solve(without, residual);
    const double evidence =
        Evidence(data, before, after, (*terms)[i].columns.cols(), tried + (*terms)[i].looked_at);
    if (evidence < limits.threshold) {
      *terms = rest;
      i = 0;
    } else {
      ++i;
    }
  }
}

}  // namespace

double RoundScale(double value) {
  if (!(value > 0) || !std::isfinite(value)) return 1;
  const double ten = std::pow(10.0, std::floor(std::log10(value)));
  const double lead = value / ten;
  return ten * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
}

Eigen::MatrixXd ModelSpace(const Eigen::MatrixXd& jacobian, Eigen::Index rows) {
  if (jacobian.cols() == 0) return Eigen::MatrixXd(rows, 0);
  Eigen::MatrixXd scaled = jacobian;
  for (Eigen::Index j = 0; j < scaled.cols(); ++j) {
    const double norm = scaled.col(j).norm();
    if (norm > 0) scaled.col(j) /= norm;
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(scaled);
  qr.setThreshold(1e-7);
  return qr.householderQ() * Eigen::MatrixXd::Identity(rows, qr.rank());
}

Eigen::MatrixXd TermLibrary::Own(const Eigen::MatrixXd& columns) const {
  return columns - model_space_ * (model_space_.transpose() * columns);
}

void TermLibrary::AddColumns(const std::string& text, const std::string& second, int factors,
                             double looked_at, const Eigen::MatrixXd& columns) {
  TermTrial trial{text, second, factors, looked_at, {}};
  trial.columns = Own(columns);
  for (Eigen::Index j = 0; j < columns.cols(); ++j) {
    if (!(trial.columns.col(j).norm() > kOwnShare * columns.col(j).norm())) return;
  }
  trials_.push_back(std::move(trial));
}

FoundFormula SelectTerms(const SelectionData& data, const Eigen::MatrixXd& space,
                         const FormulaLimits& limits, TermLibrary* terms_on_trial) {
  FoundFormula out;
  TermLibrary& library = *terms_on_trial;
  const Eigen::VectorXd residual = data.residual - space * (space.transpose() * data.residual);
  std::vector<TermTrial> terms;
  std::vector<FormulaTerm> words;
  Eigen::VectorXd now = residual;
  const double tried = std::log(std::max<size_t>(2, library.trials().size()));
  for (int round = 0; round < limits.max_terms; ++round) {
    const size_t lasting = library.trials().size();
    library.AddForResidual(now);
    const TermTrial* best = nullptr;
    double best_score = -std::numeric_limits<double>::infinity(), best_evidence = 0, best_gain = 0;
    const double independent = data.independent(now);
    const Eigen::MatrixXd taken =
        terms.empty() ? Eigen::MatrixXd(now.size(), 0) : ModelSpace(Joined(terms), now.size());
    for (const TermTrial& trial : library.trials()) {
      const Eigen::MatrixXd own = trial.columns - taken * (taken.transpose() * trial.columns);
      const Eigen::MatrixXd normal = own.transpose() * own;
      // A term that those taken already imitate brings nothing.
      if (normal.diagonal().minCoeff() < 1e-6 * trial.columns.squaredNorm()) continue;
      const Eigen::VectorXd right = own.transpose() * now;
      const double taken_off = right.dot(normal.ldlt().solve(right)) / now.squaredNorm();
      if (!(taken_off > 0 && taken_off < 1)) continue;
      const double score = -independent * std::log(1 - taken_off) - 2 * trial.looked_at -
                           2 * trial.factors -
                           static_cast<double>(trial.columns.cols()) * std::log(independent);
      if (score > best_score) best = &trial, best_score = score;
    }
    if (best != nullptr) {
      std::vector<TermTrial> joined = terms;
      joined.push_back(*best);
      const Eigen::MatrixXd columns = Joined(joined);
      const Eigen::VectorXd after = residual - columns * Solve(columns, residual);
      best_evidence = Evidence(data, now, after, best->columns.cols(), tried + best->looked_at);
      best_gain = 1 - after.norm() / std::max(now.norm(), 1e-300);
    }
    if (best == nullptr || best_evidence < limits.threshold || best_gain < limits.min_gain) break;
    terms.push_back(*best);
    words.push_back({best->text, best->second, best_evidence, best_gain});
    library.trials().resize(lasting);
    const Eigen::MatrixXd columns = Joined(terms);
    now = residual - columns * Solve(columns, residual);
  }
  if (terms.empty()) return out;
  DropSuperfluous(data, limits, residual, tried, &terms);
  std::erase_if(words, [&](const FormulaTerm& w) {
    return std::none_of(terms.begin(), terms.end(),
                        [&](const TermTrial& t) { return t.text == w.text; });
  });
  const Eigen::MatrixXd columns = Joined(terms);
  const Eigen::VectorXd x = Solve(columns, residual);
  out.gain = 1 - (residual - columns * x).norm() / std::max(residual.norm(), 1e-300);
  out.cross_validation_gain = CrossValidate(columns, residual);
  if (out.cross_validation_gain <= 0) return {};
  out.terms = std::move(words);
  out.coefficients.assign(x.data(), x.data() + x.size());
  int k = 0;
  for (const FormulaTerm& term : out.terms) {
    for (const std::string& text : {term.text, term.second}) {
      if (!text.empty()) out.text += fmt::format("{}c{}*{}", k > 0 ? " + " : "", k + 1, text), ++k;
    }
  }
  return out;
}

}  // namespace phs::identify
