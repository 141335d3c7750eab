#include "rail/profile_smoothing.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace phs::rail {
namespace {

/// Linear interpolation at equal steps of arc length.
void Resample(double step, std::vector<double>* y, std::vector<double>* z) {
  std::vector<double> s(y->size(), 0.0);
  for (size_t i = 1; i < s.size(); ++i) {
    s[i] = s[i - 1] + std::hypot((*y)[i] - (*y)[i - 1], (*z)[i] - (*z)[i - 1]);
  }
  const int pieces = std::max(8, static_cast<int>(std::ceil(s.back() / step)));
  std::vector<double> ny, nz;
  size_t k = 1;
  for (int i = 0; i <= pieces; ++i) {
    const double at = s.back() * i / pieces;
    while (k + 1 < s.size() && s[k] < at) ++k;
    const double length = s[k] - s[k - 1];
    const double share = length > 0 ? std::clamp((at - s[k - 1]) / length, 0.0, 1.0) : 0;
    ny.push_back((*y)[k - 1] + share * ((*y)[k] - (*y)[k - 1]));
    nz.push_back((*z)[k - 1] + share * ((*z)[k] - (*z)[k - 1]));
  }
  *y = std::move(ny);
  *z = std::move(nz);
}

}  // namespace

void SmoothOutline(double wavelength, std::vector<double>* y, std::vector<double>* z) {
  Resample(wavelength / 20, y, z);
  const int n = static_cast<int>(y->size());
  double length = 0;
  for (int i = 1; i < n; ++i) length += std::hypot((*y)[i] - (*y)[i - 1], (*z)[i] - (*z)[i - 1]);
  const double h = length / (n - 1);
  const double mu = std::pow(wavelength / (2 * std::numbers::pi * h), 6);
  // Third difference v[i+3] - 3 v[i+2] + 3 v[i+1] - v[i].
  constexpr double kDifference[] = {-1, 3, -3, 1};
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<size_t>(17 * n));  // the diagonal, four times four of each difference
  for (int i = 0; i < n; ++i) entries.emplace_back(i, i, 1.0);
  for (int i = 0; i + 3 < n; ++i) {
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < 4; ++b) {
        entries.emplace_back(i + a, i + b, mu * kDifference[a] * kDifference[b]);
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  for (std::vector<double>* u : {y, z}) {
    Eigen::Map<Eigen::VectorXd> values(u->data(), n);
    values = Eigen::VectorXd(solver.solve(values));
  }
}

}  // namespace phs::rail
