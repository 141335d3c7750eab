#include "plugin/engine_elements.h"

#include <algorithm>

#include "plugin/model_text.h"

namespace phs::plugin {
namespace {

/// Kinds whose forces MuJoCo adds: their energy stands in mjData::energy.
class EngineElements : public Elements {
 public:
  bool InEngine() const override { return true; }
  void AddSprings(const mjModel*, const mjData*, double*) const noexcept override {}
  double StoredEnergy(const mjModel*, const mjData*) const noexcept override { return 0; }
  int Count() const override { return static_cast<int>(ids_.size()); }

 protected:
  explicit EngineElements(std::vector<int> ids) : ids_(std::move(ids)) {}
  int Id(int index) const { return ids_[static_cast<size_t>(index)]; }
  const std::vector<int>& ids() const { return ids_; }

 private:
  std::vector<int> ids_;
};

/// Hinges and slides: l is the joint's position. Balls and free joints have dampers only here.
class JointElements : public EngineElements {
 public:
  explicit JointElements(std::vector<int> ids) : EngineElements(std::move(ids)) {}
  std::string Name(const mjModel* m, int index) const override {
    return ObjectName(m, mjOBJ_JOINT, Id(index));
  }
  ElementState StateOf(const mjModel* m, const mjData* d, const double* speed,
                       int index) const noexcept override {
    const int joint = Id(index), dof = m->jnt_dofadr[joint];
    ElementState state{d->qpos[m->jnt_qposadr[joint]], speed[dof], 0};
    state.force = Spring(m, d->qpos, joint) - m->dof_damping[dof] * state.speed;
    return state;
  }
  void AddDampers(const mjModel* m, const mjData*, const double* speed,
                  double* force) const noexcept override {
    for (int i = 0; i < m->nv; ++i) force[i] -= m->dof_damping[i] * speed[i];
  }
  void AddSlopes(const mjModel* m, const mjData*, const double*, double scale, double*,
                 StepMatrix* matrix) const noexcept override {
    for (int i = 0; i < m->nv; ++i) {
      if (m->dof_damping[i] != 0) matrix->AddDiagonal(i, scale * m->dof_damping[i]);
    }
  }
  double LostPower(const mjModel* m, const mjData*, const double* speed) const noexcept override {
    double power = 0;
    for (int i = 0; i < m->nv; ++i) power += m->dof_damping[i] * speed[i] * speed[i];
    return power;
  }
  void AddForceOnDof(const mjModel* m, const mjData*, const JointState& at, int dof,
                     double* force) const noexcept override {
    *force += Spring(m, at.position, m->dof_jntid[dof]) - m->dof_damping[dof] * at.speed[dof];
  }
  void AddStiffness(const mjModel* m, const mjData*, const double* along,
                    double* stiffness) const noexcept override {
    for (const int joint : ids()) {
      const double moved = along[m->jnt_dofadr[joint]];
      *stiffness += m->jnt_stiffness[joint] * moved * moved;
    }
  }

 private:
  static double Spring(const mjModel* m, const double* position, int joint) {
    const int at = m->jnt_qposadr[joint];
    return -m->jnt_stiffness[joint] * (position[at] - m->qpos_spring[at]);
  }
};

/// Calls `visit(dof, dlength_dqpos)` for every dof that moves tendon `t`. Reads the tendon Jacobian
/// of (m, d), dense or sparse.
template <typename Visit>
void ForEachDof(const mjModel* m, const mjData* d, int t, Visit visit) {
  const bool sparse = mj_isSparse(m) != 0;
  const int count = sparse ? d->ten_J_rownnz[t] : m->nv;
  const int first = sparse ? d->ten_J_rowadr[t] : t * m->nv;
  for (int k = 0; k < count; ++k) {
    const double moment = d->ten_J[first + k];
    if (moment != 0) visit(sparse ? d->ten_J_colind[first + k] : k, moment);
  }
}

class TendonElements : public EngineElements {
 public:
  explicit TendonElements(std::vector<int> ids) : EngineElements(std::move(ids)) {}
  std::string Name(const mjModel* m, int index) const override {
    return ObjectName(m, mjOBJ_TENDON, Id(index));
  }
  ElementState StateOf(const mjModel* m, const mjData* d, const double* speed,
                       int index) const noexcept override {
    const int t = Id(index);
    ElementState state{d->ten_length[t], Rate(m, d, t, speed), 0};
    state.force = Spring(m, d, t) - m->tendon_damping[t] * state.speed;
    return state;
  }
  void AddDampers(const mjModel* m, const mjData* d, const double* speed,
                  double* force) const noexcept override {
    for (const int t : ids()) {
      if (m->tendon_damping[t] == 0) continue;
      const double rate = Rate(m, d, t, speed);
      ForEachDof(m, d, t, [&](int dof, double moment) {
        force[dof] -= moment * m->tendon_damping[t] * rate;
      });
    }
  }
  void AddSlopes(const mjModel* m, const mjData* d, const double*, double scale, double* row,
                 StepMatrix* matrix) const noexcept override {
    for (const int t : ids()) {
      if (m->tendon_damping[t] == 0) continue;
      std::fill(row, row + m->nv, 0.0);
      ForEachDof(m, d, t, [&](int dof, double moment) { row[dof] = moment; });
      matrix->AddOuter(scale * m->tendon_damping[t], row);
    }
  }
  double LostPower(const mjModel* m, const mjData* d, const double* speed) const noexcept override {
    double power = 0;
    for (const int t : ids()) {
      const double rate = Rate(m, d, t, speed);
      power += m->tendon_damping[t] * rate * rate;
    }
    return power;
  }
  void AddForceOnDof(const mjModel* m, const mjData* d, const JointState& at, int dof,
                     double* force) const noexcept override {
    for (const int t : ids()) {
      ForEachDof(m, d, t, [&](int moved, double moment) {
        if (moved != dof) return;
        const double rate = Rate(m, d, t, at.speed);
        *force += moment * (Spring(m, d, t) - m->tendon_damping[t] * rate);
      });
    }
  }
  void AddStiffness(const mjModel* m, const mjData* d, const double* along,
                    double* stiffness) const noexcept override {
    for (const int t : ids()) {
      const double moment = Rate(m, d, t, along);
      *stiffness += m->tendon_stiffness[t] * moment * moment;
    }
  }

 private:
  static double Rate(const mjModel* m, const mjData* d, int t, const double* speed) {
    double rate = 0;
    ForEachDof(m, d, t, [&](int dof, double moment) { rate += moment * speed[dof]; });
    return rate;
  }
  static double Spring(const mjModel* m, const mjData* d, int t) {
    return m->tendon_stiffness[t] * (m->tendon_lengthspring[t] - d->ten_length[t]);
  }
};

}  // namespace

Result<std::unique_ptr<const Elements>> FindJointElements(const mjModel* m, const ElementKind&) {
  std::vector<int> ids;
  for (int joint = 0; joint < m->njnt; ++joint) {
    if (m->jnt_type[joint] == mjJNT_HINGE || m->jnt_type[joint] == mjJNT_SLIDE) {
      ids.push_back(joint);
    }
  }
  return std::unique_ptr<const Elements>(new JointElements(std::move(ids)));
}

Result<std::unique_ptr<const Elements>> FindTendonElements(const mjModel* m, const ElementKind&) {
  std::vector<int> ids;
  for (int t = 0; t < m->ntendon; ++t) {
    if (m->tendon_stiffness[t] != 0 || m->tendon_damping[t] != 0) ids.push_back(t);
  }
  return std::unique_ptr<const Elements>(new TendonElements(std::move(ids)));
}

}  // namespace phs::plugin
