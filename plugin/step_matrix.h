// The symmetric matrix of a half step, M + h/2 C, kept in the pattern of MuJoCo's mass matrix: an
// entry for every dof and each of its ancestors in the kinematic tree. A force on one body, or
// between a body and one of its ancestors, couples just these. What couples different branches (a
// linkage from axle to axle) has no entry and is left out: the matrix only steers Newton's steps,
// their residual knows every force.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <vector>

#include "plugin/spatial.h"

namespace phs::plugin {

inline constexpr int kMaxChain = 64;  ///< freedoms of a wheelset and the bodies that carry it

/// Symmetric, on spatial vectors; a row for each of the six numbers.
using SpatialMatrix = std::array<Spatial, 6>;

/// [entry of MuJoCo's mass matrix]: the dof of its column. The row of a dof holds the dof itself and
/// its ancestors up to the root.
std::vector<int> AncestorsOf(const mjModel* m);

/// Storage belongs to the caller. Factor: L^T D L without fill (Featherstone, Rigid Body Dynamics
/// Algorithms, 2008, section 8.3).
class StepMatrix {
 public:
  /// @param ancestors of `m` (AncestorsOf)
  /// @param entries room for m->nM + m->nv numbers
  StepMatrix(const mjModel* m, const int* ancestors, double* entries)
      : m_(m), ancestors_(ancestors), entries_(entries) {}

  /// Starts again as the mass matrix of `d`, in MuJoCo's layout.
  void SetMass(const mjData* d);
  /// Adds `value` to the diagonal.
  void AddDiagonal(int dof, double value) { entries_[m_->dof_Madr[dof]] += value; }
  /// Adds coefficient g g^T for a row g of nv numbers; entries outside the pattern are dropped.
  void AddOuter(double coefficient, const double* row);
  /// Adds J^T damping J for a body that is moved by a chain of dofs, each the parent of the next,
  /// from the root on, at most kMaxChain; J: their `motions` (MuJoCo's cdof of all dofs: rotation,
  /// translation).
  void AddSpatial(const SpatialMatrix& damping, const double* motions, const int* dofs, int count);
  /// Factorises in place; the diagonal then holds the inverse of D. False if it is not positive
  /// definite.
  bool Factor();
  /// x = matrix^-1 x, after Factor.
  void Solve(double* x) const;
  /// out = M x with the mass matrix of `d`.
  void MulMass(const mjData* d, const double* x, double* out) const;

 private:
  /// A dof and its ancestors.
  int RowLength(int dof) const {
    return (dof + 1 < m_->nv ? m_->dof_Madr[dof + 1] : m_->nM) - m_->dof_Madr[dof];
  }

  const mjModel* m_;
  const int* ancestors_;
  double* entries_;
};

}  // namespace phs::plugin
