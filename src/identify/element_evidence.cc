#include "identify/element_evidence.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace phs::identify::element {
namespace {

/// Mean square on blocks left out in turn; the fit without them by one linear step.
double CrossValidated(const ElementFit& fit) {
  constexpr int kBlocks = 8;
  const Eigen::Index n = fit.residual.size(), k = fit.jacobian.cols();
  const Eigen::MatrixXd all = fit.jacobian.transpose() * fit.jacobian;
  const Eigen::VectorXd right = fit.jacobian.transpose() * fit.residual;
  double held = 0;
  for (int b = 0; b < kBlocks; ++b) {
    const Eigen::Index begin = b * n / kBlocks, count = (b + 1) * n / kBlocks - begin;
    const auto j = fit.jacobian.middleRows(begin, count);
    const auto r = fit.residual.segment(begin, count);
    Eigen::MatrixXd rest = all - j.transpose() * j;
    rest.diagonal() += 1e-4 * all.diagonal() + Eigen::VectorXd::Constant(k, 1e-12);
    const Eigen::VectorXd step = rest.ldlt().solve(j.transpose() * r - right);
    held += (r + j * step).squaredNorm();
  }
  return held / static_cast<double>(n);
}

}  // namespace

ElementEvidence CompareFits(const ElementFit& without, const ElementFit& with) {
  const double n = with.independent;
  ElementEvidence e;
  e.delta_bic = n * std::log(without.mean_square / std::max(with.mean_square, 1e-300)) -
                (double(with.values.size()) - double(without.values.size())) * std::log(n);
  e.estimation_gain = 1 - std::sqrt(with.mean_square / without.mean_square);
  e.cross_validation_gain = 1 - std::sqrt(CrossValidated(with) / CrossValidated(without));
  return e;
}

}  // namespace phs::identify::element
