// Elements between bodies: springs and dampers that act along a length, one row per kind in
// elements.cc.
//
// An element has a length l(q) that grows as its ends part, and a force F along it, > 0 pushes the
// ends apart:
//   F = F_s(l) + F_d(l, v),   v = dl/dq . qvel
//   generalised force   F (dl/dq)^T
//   stored energy       E(l), dE/dl = -F_s
//   lost power          -F_d v >= 0
//   slope               C = -dF_d/dv (dl/dq)^T (dl/dq), for the matrix of the half step
//   (half_step.h)
//
// MuJoCo knows springs and dampers of joints and tendons and adds their forces itself, at v_n. All
// other kinds are made here: their forces enter qfrc_passive at the speed w of their own instant.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "plugin/step_matrix.h"

namespace phs::plugin {

/// Where an element is and what it does at one instant.
struct ElementState {
  double length = 0;  ///< [m]
  double speed = 0;   ///< rate of length [m/s]
  double force = 0;   ///< along it, > 0 pushes the ends apart [N]
};

/// Where the joints of a model stand and how fast they move.
struct JointState {
  const double* position;  ///< as qpos [nq]
  const double* speed;     ///< as qvel [nv]
};

/// All elements of one kind in one model. Immutable; pure functions of (m, d) and of `speed` [nv],
/// the speed of every dof.
class Elements {
 public:
  virtual ~Elements() = default;

  virtual int Count() const = 0;
  /// KIND_NAME of a declared element, the joint's or tendon's own.
  virtual std::string Name(const mjModel* m, int index) const = 0;
  virtual ElementState StateOf(const mjModel* m, const mjData* d, const double* speed,
                               int index) const noexcept = 0;
  /// True if MuJoCo adds their forces and keeps their energy itself. Such forces are linear.
  virtual bool InEngine() const { return false; }

  /// Adds the generalised forces F_s to `force` [nv].
  virtual void AddSprings(const mjModel* m, const mjData* d, double* force) const noexcept = 0;
  /// Adds the generalised forces F_d.
  virtual void AddDampers(const mjModel* m, const mjData* d, const double* speed,
                          double* force) const noexcept = 0;
  /// Adds `scale` times C at `speed` to the matrix, as far as its pattern goes; `row`: scratch
  /// [nv].
  virtual void AddSlopes(const mjModel* m, const mjData* d, const double* speed, double scale,
                         double* row, StepMatrix* matrix) const noexcept = 0;
  virtual double StoredEnergy(const mjModel* m, const mjData* d) const noexcept = 0;
  virtual double LostPower(const mjModel* m, const mjData* d,
                           const double* speed) const noexcept = 0;

  /// Adds the generalised force on one dof to `force`; other positions than those of joints are
  /// read from `d`, where MuJoCo last worked them out.
  virtual void AddForceOnDof(const mjModel* m, const mjData* d, const JointState& at, int dof,
                             double* force) const noexcept = 0;
  /// Adds -dF/dl along a small motion `along` [nv], squared: the stiffness of that motion.
  virtual void AddStiffness(const mjModel* m, const mjData* d, const double* along,
                            double* stiffness) const noexcept = 0;
};

/// Of every kind that the model has, in the order of the rows.
using ElementList = std::vector<std::unique_ptr<const Elements>>;

/// A number in the text of a declared element (declared_element.h).
struct ElementKey {
  const char* key;   ///< with its unit
  double min;        ///< [in that unit]
  double max;        ///< the same
  double otherwise;  ///< where the text does not name it; NaN: it must
  const char* text;
};

struct ElementKind {
  const char* name;  ///< a declared element is called NAME:…
  const char* text;
  std::span<const ElementKey> keys;  ///< empty: MuJoCo's own, nothing is declared
  /// Those of the model; null if there are none. Errors name the MJCF element.
  Result<std::unique_ptr<const Elements>> (*find)(const mjModel* m, const ElementKind& kind);
};

}  // namespace phs::plugin
