#include "vehicle/stable_step.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "vehicle/engine.h"
#include "vehicle/tangent_state.h"

namespace phs::vehicle {
namespace {

/// Growth faster than this is numerical; hunting grows by a few per second [1/s].
constexpr double kGrowthRate = 20;
constexpr double kProbe = 1e-7;       ///< of position [m, rad] and activation
constexpr double kSpeedProbe = 1e-5;  ///< of speed [m/s, rad/s]
constexpr double kSmallest = 1e-5;    ///< [s]
constexpr double kLargest = 0.02;     ///< [s]
constexpr double kLongest = 0.05;     ///< no step of a vehicle is judged beyond it [s]

/// One step of the model from states near a base.
class Probe {
 public:
  Probe(const mjModel* m, const mjData* base) : m_(m), base_(base), data_(mj_makeData(m)) {}

  int size() const { return TangentSize(m_); }

  /// The state after one step from base + `delta`, as difference to base. NaN if MuJoCo found the
  /// state too bad to go on: it then starts again from its own reset, without a word.
  Eigen::VectorXd Step(const Eigen::VectorXd& delta) {
    mjData* d = data_.get();
    for (mjWarningStat& warning : d->warning) warning = {};
    SetState(m_, base_, delta, d);
    mj_step(m_, d);
    Eigen::VectorXd out(size());
    if (!EngineWarning(d).empty()) {
      out.fill(std::numeric_limits<double>::quiet_NaN());
      return out;
    }
    mj_differentiatePos(m_, out.data(), 1.0, base_->qpos, d->qpos);
    mju_sub(out.data() + m_->nv, d->qvel, base_->qvel, m_->nv);
    mju_sub(out.data() + 2 * m_->nv, d->act, base_->act, m_->na);
    return out;
  }

 private:
  const mjModel* m_;
  const mjData* base_;
  DataPtr data_;
};

}  // namespace

double StepSpectralRadius(mjModel* m, const mjData* d, double h,
                          const Eigen::VectorXd& activations) {
  const double old_step = m->opt.timestep;
  m->opt.timestep = h;
  Probe probe(m, d);
  const int n = probe.size();
  Eigen::MatrixXd transition(n, n);
  for (int k = 0; k < n; ++k) {
    double eps = k >= m->nv && k < 2 * m->nv ? kSpeedProbe : kProbe;
    if (k >= 2 * m->nv && activations.size() > 0) eps *= activations[k - 2 * m->nv];
    Eigen::VectorXd delta = Eigen::VectorXd::Zero(n);
    delta[k] = eps;
    const Eigen::VectorXd plus = probe.Step(delta);
    delta[k] = -eps;
    transition.col(k) = (plus - probe.Step(delta)) / (2 * eps);
  }
  m->opt.timestep = old_step;
  if (!transition.allFinite()) return std::numeric_limits<double>::infinity();
  return transition.eigenvalues().cwiseAbs().maxCoeff();
}

namespace {

bool Stable(mjModel* m, const mjData* d, const Eigen::VectorXd& activations, double h) {
  return StepSpectralRadius(m, d, h, activations) <= std::exp(kGrowthRate * h);
}

}  // namespace

Status CheckStep(mjModel* m, const mjData* d, const Eigen::VectorXd& activations, double* largest) {
  const double h = m->opt.timestep;
  if (!(h > 0 && h <= kLongest)) {
    return Error{"timestep_s", "is " + std::to_string(h) + " s", "1e-6 … 0.05 s", ""};
  }
  // From the step itself by doubles or halves, then to 2 % below.
  const bool holds = Stable(m, d, activations, h);
  if (holds && largest == nullptr) return {};
  double low = h, high = h;
  while (holds && low == high && high < kLargest) {
    high *= 2;
    if (Stable(m, d, activations, high)) low = high;
  }
  while (!holds && low == high && low > 0) {
    low = low > kSmallest ? std::max(0.5 * low, kSmallest) : 0;
    if (low > 0 && !Stable(m, d, activations, low)) high = low;
  }
  for (int i = 0; i < 5 && low > 0 && low < high; ++i) {
    const double middle = std::sqrt(low * high);
    (Stable(m, d, activations, middle) ? low : high) = middle;
  }
  if (largest != nullptr) *largest = low;
  if (holds) return {};
  if (low == 0) {
    return Error{"vehicle", "does not stand on straight track at any step", "",
                 "check profiles, gauge, masses and springs"};
  }
  return Error{"timestep_s", "is too large for the stiffness of this vehicle",
               "at most " + std::to_string(low) + " s", "make it smaller"};
}

}  // namespace phs::vehicle
