#include "plugin/bias.h"

#include <algorithm>

#include "plugin/spatial.h"

namespace phs::plugin {
namespace {

/// a += (v x c) w.
PHS_WITHIN_WIDE void AddTurned(const Spatial& v, const Spatial& c, double w, Spatial* a) {
  Spatial turned;
  AddCross(v.first, c.first, &turned.first);
  AddCross(v.first, c.second, &turned.second);
  AddCross(v.second, c.first, &turned.second);
  AddScaledSpatial(w, turned, a);
}

/// MuJoCo's cinert: Ixx Iyy Izz Ixy Ixz Iyz, mass times offset, mass.
struct Inertia {
  Lanes x, y, z, offset;  ///< columns of the moments, mass times offset
  double mass;
};
PHS_WITHIN_WIDE void LoadInertia(const double* numbers, Inertia* out) {
  Lanes diagonal, rest;  // xx yy zz xy, zz xy xz yz
  LoadFour(numbers, &diagonal);
  LoadFour(numbers + 2, &rest);
  out->x = __builtin_shufflevector(diagonal, rest, 0, 3, 6, 6);
  out->y = __builtin_shufflevector(diagonal, rest, 3, 1, 7, 7);
  out->z = __builtin_shufflevector(diagonal, rest, 6, 7, 2, 2);
  LoadFour(numbers + 6, &out->offset);
  out->mass = numbers[9];
}

/// out += I v.
PHS_WITHIN_WIDE void AddInertia(const Inertia& inertia, const Spatial& v, Spatial* out) {
  out->first += inertia.x * v.first[0] + inertia.y * v.first[1] + inertia.z * v.first[2];
  AddCross(inertia.offset, v.second, &out->first);
  AddCross(v.first, inertia.offset, &out->second);
  out->second += inertia.mass * v.second;
}

/// Goes on through the dofs of a body. The three turns of a ball or free joint are of one instant:
/// each c' belongs to the velocity before them; translations of a free joint do not turn.
PHS_WITHIN_WIDE void FollowDofs(const mjModel* m, const mjData* d, int body, const double* speed,
                                Spatial* v, Spatial* a) {
  const int end = m->body_dofadr[body] + m->body_dofnum[body];
  for (int j = m->body_dofadr[body]; j < end;) {
    const int type = m->jnt_type[m->dof_jntid[j]];
    Spatial c;
    if (type == mjJNT_FREE) {
      for (const int last = j + 3; j < last; ++j) {
        LoadSix(d->cdof + 6 * j, &c);
        AddScaledSpatial(speed[j], c, v);
      }
    }
    const int turns = type == mjJNT_FREE || type == mjJNT_BALL ? 3 : 1;
    Spatial sum = *v;
    for (const int last = j + turns; j < last; ++j) {
      LoadSix(d->cdof + 6 * j, &c);
      AddTurned(*v, c, speed[j], a);
      AddScaledSpatial(speed[j], c, &sum);
    }
    *v = sum;
  }
}

}  // namespace

PHS_WIDE void CalcBiasAt(const mjModel* m, mjData* d, const double* speed, double* bias) {
  mjMARKSTACK;
  constexpr int kNumbers = 3 * kPadded;  // of a body: v, a, f
  double* numbers = mj_stackAlloc(d, kNumbers * m->nbody);
  std::fill(numbers, numbers + kNumbers, 0.0);
  if ((m->opt.disableflags & mjDSBL_GRAVITY) == 0) {
    double* fall = numbers + kPadded + kPadded / 2;
    for (int k = 0; k < 3; ++k) fall[k] = -m->opt.gravity[k];
  }
  for (int body = 1; body < m->nbody; ++body) {
    double* own = numbers + kNumbers * body;
    const double* parent = numbers + kNumbers * m->body_parentid[body];
    Spatial v, a;
    LoadPadded(parent, &v);
    LoadPadded(parent + kPadded, &a);
    FollowDofs(m, d, body, speed, &v, &a);
    Inertia inertia;
    LoadInertia(d->cinert + 10 * body, &inertia);
    Spatial momentum, f;
    AddInertia(inertia, v, &momentum);
    AddInertia(inertia, a, &f);
    AddCross(v.first, momentum.first, &f.first);
    AddCross(v.second, momentum.second, &f.first);
    AddCross(v.first, momentum.second, &f.second);
    StorePadded(v, own);
    StorePadded(a, own + kPadded);
    StorePadded(f, own + 2 * kPadded);
  }
  for (int body = m->nbody - 1; body > 0; --body) {
    double* parent = numbers + kNumbers * m->body_parentid[body] + 2 * kPadded;
    Spatial sum, f;
    LoadPadded(parent, &sum);
    LoadPadded(numbers + kNumbers * body + 2 * kPadded, &f);
    AddScaledSpatial(1, f, &sum);
    StorePadded(sum, parent);
  }
  for (int j = 0; j < m->nv; ++j) {
    Spatial c, f;
    LoadSix(d->cdof + 6 * j, &c);
    LoadPadded(numbers + kNumbers * m->dof_bodyid[j] + 2 * kPadded, &f);
    bias[j] = DotSpatial(c, f);
  }
  mjFREESTACK;
}

}  // namespace phs::plugin
