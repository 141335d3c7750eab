#include "plugin/step_matrix.h"

#include <algorithm>

namespace phs::plugin {

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
  for (int i = 0; i < count; ++i) {
    const double scaled = coefficient * row[i];
    double* entry = entries_ + m_->dof_Madr[dofs[i]];
    for (int j = i; j >= 0; --j) *entry++ += scaled * row[j];
  }
}

bool StepMatrix::Factor() {
  for (int k = m_->nv - 1; k >= 0; --k) {
    const double* own = entries_ + m_->dof_Madr[k];
    if (!(own[0] > 0)) return false;
    const double inverse = 1 / own[0];
    double* along = entries_ + m_->dof_Madr[k] + 1;
    for (int i = m_->dof_parentid[k]; i >= 0; i = m_->dof_parentid[i]) {
      const double share = *along * inverse;
      double* row = entries_ + m_->dof_Madr[i];
      const double* from = along;
      for (int j = i; j >= 0; j = m_->dof_parentid[j]) *row++ -= share * *from++;
      *along++ = share;
    }
  }
  return true;
}

void StepMatrix::Solve(double* x) const {
  for (int i = m_->nv - 1; i >= 0; --i) {
    const double* entry = entries_ + m_->dof_Madr[i] + 1;
    for (int j = m_->dof_parentid[i]; j >= 0; j = m_->dof_parentid[j]) x[j] -= *entry++ * x[i];
  }
  for (int i = 0; i < m_->nv; ++i) x[i] /= entries_[m_->dof_Madr[i]];
  for (int i = 0; i < m_->nv; ++i) {
    const double* entry = entries_ + m_->dof_Madr[i] + 1;
    for (int j = m_->dof_parentid[i]; j >= 0; j = m_->dof_parentid[j]) x[i] -= *entry++ * x[j];
  }
}

}  // namespace phs::plugin
