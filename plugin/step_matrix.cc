#include "plugin/step_matrix.h"

#include <algorithm>

namespace phs::plugin {
namespace {

/// to += factor from; the two do not overlap.
inline void AddScaled(double factor, const double* __restrict from, int count,
                      double* __restrict to) {
  for (int i = 0; i < count; ++i) to[i] += factor * from[i];
}

}  // namespace

void StepMatrix::SetMass(const mjData* d) { std::copy(d->qM, d->qM + m_->nM, entries_); }

void StepMatrix::AddOuter(double coefficient, const double* row) {
  for (int i = 0; i < m_->nv; ++i) {
    if (row[i] == 0) continue;
    const double scaled = coefficient * row[i];
    double* entry = entries_ + m_->dof_Madr[i];
    for (int j = i; j >= 0; j = m_->dof_parentid[j]) *entry++ += scaled * row[j];
  }
}

void StepMatrix::AddOuter(double coefficient, const double* row, const int* dofs, int count) {
  // Entries begin at the dof itself and go up: so does the row, turned round.
  double up[kMaxChain];
  for (int i = 0; i < count; ++i) up[count - 1 - i] = row[i];
  for (int i = 0; i < count; ++i) {
    AddScaled(coefficient * row[i], up + (count - 1 - i), i + 1, entries_ + m_->dof_Madr[dofs[i]]);
  }
}

bool StepMatrix::Factor() {
  for (int k = m_->nv - 1; k >= 0; --k) {
    double* own = entries_ + m_->dof_Madr[k];
    if (!(own[0] > 0)) return false;
    const double inverse = 1 / own[0];
    // The ancestors of k: each row is as long as what is left of the way up.
    int left = RowLength(k) - 1;
    double* along = own + 1;
    for (int i = m_->dof_parentid[k]; i >= 0; i = m_->dof_parentid[i]) {
      const double share = *along * inverse;
      AddScaled(-share, along, left, entries_ + m_->dof_Madr[i]);
      *along++ = share;
      --left;
    }
    own[0] = inverse;
  }
  return true;
}

void StepMatrix::Solve(double* x) const {
  for (int i = m_->nv - 1; i >= 0; --i) {
    const double* entry = entries_ + m_->dof_Madr[i] + 1;
    for (int j = m_->dof_parentid[i]; j >= 0; j = m_->dof_parentid[j]) x[j] -= *entry++ * x[i];
  }
  // From the root on, so that a sum waits for its newest term alone. Dofs are numbered depth first:
  // those of smaller depth that were last seen are the ancestors.
  double* seen = entries_ + m_->nM;
  for (int i = 0; i < m_->nv; ++i) {
    const double* entry = entries_ + m_->dof_Madr[i];
    const int depth = RowLength(i) - 1;
    double sum = 0;
    for (int k = 0; k < depth; ++k) sum += entry[depth - k] * seen[k];
    seen[depth] = x[i] = x[i] * entry[0] - sum;
  }
}

}  // namespace phs::plugin
