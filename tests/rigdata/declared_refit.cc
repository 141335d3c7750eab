#include "declared_refit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace rigdata {
namespace {

constexpr int kFree = 5;
constexpr long kStride = 5;  // samples left out in the fit
using Vector5 = Eigen::Matrix<double, kFree, 1>;
using Matrix5 = Eigen::Matrix<double, kFree, kFree>;

DeclaredFactors FromLog(const Vector5& q) {
  return {std::exp(q[0]), std::exp(q[1]), std::exp(q[2]), std::exp(q[3]), std::exp(q[4])};
}

double LinePressure(const LineTruth& line, double x) {
  return line.Solve(line.Initial(), x, 1.0, Surroundings{}).p_chamber;
}

struct Lines {
  LineTruth bore, rod;
  explicit Lines(const DeclaredFactors& f) : Lines(DeclaredRig(f)) {}
  explicit Lines(const RigParams& rig) : bore(rig.bore), rod(rig.rod) {}
};

std::array<double, kChannels> Predict(const Lines& lines, double friction, double x, double v) {
  std::array<double, kChannels> y{};
  y[kActuator] = y[kPiston] = x;
  y[kPBore] = LinePressure(lines.bore, x);
  y[kPRod] = LinePressure(lines.rod, x);
  y[kLoad] = y[kPRod] * kRodArea - y[kPBore] * kBoreArea + friction * FrictionTruth::Table(v);
  return y;
}

// Weighted residuals of load, p_bore and p_rod, every kStride-th sample of the window.
Eigen::VectorXd Residuals(const Vector5& q, const Record& record, const MotionEstimate& motion,
                          const std::vector<long>& rows,
                          const std::array<double, kChannels>& level) {
  const DeclaredFactors f = FromLog(q);
  const Lines lines(f);
  Eigen::VectorXd r(3 * static_cast<long>(rows.size()));
  long k = 0;
  for (const long i : rows) {
    const auto y = Predict(lines, f.friction, motion.x[i], motion.v[i]);
    for (const Channel c : {kLoad, kPBore, kPRod}) {
      r[k++] = (y[c] - record.channel[c][i]) / level[c];
    }
  }
  return r;
}

std::vector<long> RowsOf(const Record& record, const Window& window, long stride) {
  std::vector<long> rows;
  for (long i = 0; i < static_cast<long>(record.size()); i += stride) {
    if (record.t[i] >= window.begin && record.t[i] < window.end) rows.push_back(i);
  }
  return rows;
}

}  // namespace

RigParams DeclaredRig(const DeclaredFactors& f) {
  RigParams rig = NominalRig();
  rig.bore.oil_compliance *= f.oil_bore;
  rig.bore.gas_volume0 *= f.gas_bore;
  rig.rod.oil_compliance *= f.oil_rod;
  rig.rod.gas_volume0 *= f.gas_rod;
  rig.friction.scale = f.friction;
  return rig;
}

std::array<double, kChannels> DeclaredPrediction(const DeclaredFactors& factors, double x,
                                                 double v) {
  return Predict(Lines(factors), factors.friction, x, v);
}

DeclaredFactors FitDeclared(const Record& record, const MotionEstimate& motion,
                            const Window& window, const std::array<double, kChannels>& level) {
  const std::vector<long> rows = RowsOf(record, window, kStride);
  Vector5 q = Vector5::Zero();
  Eigen::VectorXd r = Residuals(q, record, motion, rows, level);
  double cost = r.squaredNorm(), damping = 1e-3;
  for (int iteration = 0; iteration < 40; ++iteration) {
    Eigen::MatrixXd jacobian(r.size(), kFree);
    for (int j = 0; j < kFree; ++j) {
      Vector5 shifted = q;
      shifted[j] += 1e-5;
      jacobian.col(j) = (Residuals(shifted, record, motion, rows, level) - r) / 1e-5;
    }
    const Matrix5 normal = jacobian.transpose() * jacobian;
    const Vector5 gradient = jacobian.transpose() * r;
    bool improved = false;
    for (int attempt = 0; attempt < 8 && !improved; ++attempt, damping *= 10) {
      const Matrix5 damped =
          normal + damping * Matrix5(normal.diagonal().asDiagonal()) + 1e-9 * Matrix5::Identity();
      Vector5 next = q - damped.ldlt().solve(gradient);
      next = next.cwiseMax(-3.0).cwiseMin(3.0);
      const Eigen::VectorXd trial = Residuals(next, record, motion, rows, level);
      if (trial.squaredNorm() < cost) {
        improved = cost - trial.squaredNorm() > 1e-7 * cost;
        q = next;
        r = trial;
        cost = trial.squaredNorm();
        damping = std::max(1e-9, damping / 100);
        break;
      }
    }
    if (!improved) break;
  }
  return FromLog(q);
}

std::array<double, kChannels> DeclaredError(const DeclaredFactors& factors, const Record& record,
                                            const MotionEstimate& motion, const Window& window) {
  const Lines lines(factors);
  const std::vector<long> rows = RowsOf(record, window, 1);
  std::array<double, kChannels> sum{};
  for (const long i : rows) {
    const auto y = Predict(lines, factors.friction, motion.x[i], motion.v[i]);
    for (int c = 0; c < kChannels; ++c) {
      const double e = y[c] - record.channel[c][i];
      sum[c] += e * e;
    }
  }
  for (double& s : sum) s = std::sqrt(s / static_cast<double>(std::max<size_t>(1, rows.size())));
  return sum;
}

}  // namespace rigdata
