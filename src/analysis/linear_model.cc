#include "analysis/linear_model.h"

#include "plugin/model_text.h"
#include "vehicle/engine.h"

namespace phs::analysis {
namespace {

/// Engine settings during the differences; put back on leaving.
class InstantSettings {
 public:
  InstantSettings(mjModel* m, const plugin::Binding& binding)
      : m_(m), integrator_(m->opt.integrator) {
    // With RK4 the plugin gives rates at the instant; mj_forward itself does not look at it.
    m->opt.integrator = mjINT_RK4;
    for (const plugin::WheelsetBinding& w : binding.wheelsets()) {
      if (w.drive_actuator < 0) continue;
      mjtNum* gain = m->actuator_gainprm + mjNGAIN * w.drive_actuator;
      gains_.emplace_back(gain, *gain);
      *gain = 0;
    }
  }
  ~InstantSettings() {
    m_->opt.integrator = integrator_;
    for (const auto& [gain, value] : gains_) *gain = value;
  }
  InstantSettings(const InstantSettings&) = delete;
  InstantSettings& operator=(const InstantSettings&) = delete;

 private:
  mjModel* m_;
  int integrator_;
  std::vector<std::pair<mjtNum*, mjtNum>> gains_;
};

/// Accelerations and state rates at running + delta.
Eigen::VectorXd Rates(const mjModel* m, const mjData* running, const Eigen::VectorXd& delta,
                      mjData* d) {
  mju_copy(d->qpos, running->qpos, m->nq);
  mj_integratePos(m, d->qpos, delta.data(), 1.0);
  mju_add(d->qvel, running->qvel, delta.data() + m->nv, m->nv);
  mju_add(d->act, running->act, delta.data() + 2 * m->nv, m->na);
  mju_zero(d->qacc_warmstart, m->nv);
  d->time = running->time;
  mj_forward(m, d);
  Eigen::VectorXd rates(m->nv + m->na);
  mju_copy(rates.data(), d->qacc, m->nv);
  mju_copy(rates.data() + m->nv, d->act_dot, m->na);
  return rates;
}

}  // namespace

LinearModel Linearise(mjModel* m, const plugin::Binding& binding, const mjData* running,
                      const DifferenceSteps& steps) {
  const InstantSettings settings(m, binding);
  const vehicle::DataPtr d(mj_makeData(m));
  const int size = 2 * m->nv + m->na;
  LinearModel model{m->nv, m->na, Eigen::MatrixXd::Zero(size, size)};
  model.matrix.block(0, m->nv, m->nv, m->nv).setIdentity();
  for (int k = 0; k < size; ++k) {
    const double step = k < m->nv ? steps.position : k < 2 * m->nv ? steps.speed : steps.activation;
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
