#include "analysis/linear_model.h"

#include "analysis/drives_off.h"
#include "plugin/model_text.h"
#include "vehicle/engine.h"
#include "vehicle/tangent_state.h"

namespace phs::analysis {
namespace {

/// Accelerations and state rates at running + delta.
Eigen::VectorXd Rates(const mjModel* m, const mjData* running, const Eigen::VectorXd& delta,
                      mjData* d) {
  vehicle::SetState(m, running, delta, d);
  mj_forward(m, d);
  Eigen::VectorXd rates(m->nv + m->na);
  mju_copy(rates.data(), d->qacc, m->nv);
  mju_copy(rates.data() + m->nv, d->act_dot, m->na);
  return rates;
}

}  // namespace

LinearModel Linearise(mjModel* m, const plugin::Binding& binding, const mjData* running,
                      const DifferenceSteps& steps) {
  const plugin::InstantForces instant(m);
  const DrivesOff drives_off(m, binding);
  const vehicle::DataPtr d(mj_makeData(m));
  const int size = vehicle::TangentSize(m);
  LinearModel model{m->nv, m->na, Eigen::MatrixXd::Zero(size, size)};
  model.matrix.block(0, m->nv, m->nv, m->nv).setIdentity();
  const Eigen::VectorXd scale = vehicle::ActivationScale(m, binding);
  for (int k = 0; k < size; ++k) {
    const double step = k < m->nv       ? steps.position
                        : k < 2 * m->nv ? steps.speed
                                        : steps.activation * scale[k - 2 * m->nv];
    Eigen::VectorXd delta = Eigen::VectorXd::Zero(size);
    delta[k] = step;
    const Eigen::VectorXd plus = Rates(m, running, delta, d.get());
    model.matrix.col(k).tail(m->nv + m->na) =
        (plus - Rates(m, running, -delta, d.get())) / (2 * step);
  }
  return model;
}

std::vector<BodyMotion> BodyMotions(const mjModel* m, const mjData* running,
                                    const Eigen::VectorXcd& state) {
  using Rows = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>;
  std::vector<BodyMotion> motions;
  Rows place(3, m->nv);
  Rows turn(3, m->nv);
  for (int body = 1; body < m->nbody; ++body) {
    mj_jacBody(m, running, place.data(), turn.data(), body);
    const Eigen::Vector3cd translation = place * state.head(m->nv);
    const Eigen::Vector3cd rotation = turn * state.head(m->nv);
    BodyMotion motion{plugin::ObjectName(m, mjOBJ_BODY, body), {}, {}};
    for (int i = 0; i < 3; ++i) {
      motion.translation[i] = translation[i];
      motion.rotation[i] = rotation[i];
    }
    motions.push_back(std::move(motion));
  }
  return motions;
}

}  // namespace phs::analysis
