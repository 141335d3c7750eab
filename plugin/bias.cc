#include "plugin/bias.h"

#include <algorithm>

namespace phs::plugin {
namespace {

/// out += a x b.
inline void AddCross(const double* a, const double* b, double* out) {
  out[0] += a[1] * b[2] - a[2] * b[1];
  out[1] += a[2] * b[0] - a[0] * b[2];
  out[2] += a[0] * b[1] - a[1] * b[0];
}

/// a += (v x c) w.
inline void AddTurned(const double* v, const double* c, double w, double* a) {
  double turned[6] = {};
  AddCross(v, c, turned);
  AddCross(v, c + 3, turned + 3);
  AddCross(v + 3, c, turned + 3);
  for (int k = 0; k < 6; ++k) a[k] += turned[k] * w;
}

/// I v with MuJoCo's cinert: Ixx Iyy Izz Ixy Ixz Iyz, mass times offset, mass.
inline void MulInertia(const double* i, const double* v, double* out) {
  out[0] = i[0] * v[0] + i[3] * v[1] + i[4] * v[2] - i[8] * v[4] + i[7] * v[5];
  out[1] = i[3] * v[0] + i[1] * v[1] + i[5] * v[2] + i[8] * v[3] - i[6] * v[5];
  out[2] = i[4] * v[0] + i[5] * v[1] + i[2] * v[2] - i[7] * v[3] + i[6] * v[4];
  out[3] = i[8] * v[1] - i[7] * v[2] + i[9] * v[3];
  out[4] = i[6] * v[2] - i[8] * v[0] + i[9] * v[4];
  out[5] = i[7] * v[0] - i[6] * v[1] + i[9] * v[5];
}

/// Goes on through the dofs of a body. The three turns of a ball or free joint are of one instant:
/// each c' belongs to the velocity before them; translations of a free joint do not turn.
void FollowDofs(const mjModel* m, const mjData* d, int body, const double* speed, double* v,
                double* a) {
  const int end = m->body_dofadr[body] + m->body_dofnum[body];
  for (int j = m->body_dofadr[body]; j < end;) {
    const int type = m->jnt_type[m->dof_jntid[j]];
    const auto move = [&](int dof) {
      for (int k = 0; k < 6; ++k) v[k] += d->cdof[6 * dof + k] * speed[dof];
    };
    if (type == mjJNT_FREE) {
      for (const int last = j + 3; j < last; ++j) move(j);
    }
    const int turns = type == mjJNT_FREE || type == mjJNT_BALL ? 3 : 1;
    for (int k = j; k < j + turns; ++k) AddTurned(v, d->cdof + 6 * k, speed[k], a);
    for (int k = j; k < j + turns; ++k) move(k);
    j += turns;
  }
}

}  // namespace

void CalcBiasAt(const mjModel* m, mjData* d, const double* speed, double* bias) {
  mjMARKSTACK;
  constexpr int kNumbers = 18;  // of a body: v, a, f
  double* numbers = mj_stackAlloc(d, kNumbers * m->nbody);
  std::fill(numbers, numbers + kNumbers, 0.0);
  if ((m->opt.disableflags & mjDSBL_GRAVITY) == 0) {
    for (int k = 0; k < 3; ++k) numbers[9 + k] = -m->opt.gravity[k];
  }
  for (int body = 1; body < m->nbody; ++body) {
    double* v = numbers + kNumbers * body;
    double *a = v + 6, *f = v + 12;
    const double* parent = numbers + kNumbers * m->body_parentid[body];
    std::copy(parent, parent + 12, v);
    FollowDofs(m, d, body, speed, v, a);
    double momentum[6];
    MulInertia(d->cinert + 10 * body, v, momentum);
    MulInertia(d->cinert + 10 * body, a, f);
    AddCross(v, momentum, f);
    AddCross(v + 3, momentum + 3, f);
    AddCross(v, momentum + 3, f + 3);
  }
  for (int body = m->nbody - 1; body > 0; --body) {
    const double* f = numbers + kNumbers * body + 12;
    double* parent = numbers + kNumbers * m->body_parentid[body] + 12;
    for (int k = 0; k < 6; ++k) parent[k] += f[k];
  }
  for (int j = 0; j < m->nv; ++j) {
    const double *c = d->cdof + 6 * j, *f = numbers + kNumbers * m->dof_bodyid[j] + 12;
    bias[j] = c[0] * f[0] + c[1] * f[1] + c[2] * f[2] + (c[3] * f[3] + c[4] * f[4] + c[5] * f[5]);
  }
  mjFREESTACK;
}

}  // namespace phs::plugin
