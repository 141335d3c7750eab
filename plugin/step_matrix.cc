#include "plugin/step_matrix.h"

#include <algorithm>

#include "base/wide.h"

namespace phs::plugin {
namespace {

/// to += factor from; the two do not overlap.
PHS_WITHIN_WIDE void AddScaled(double factor, const double* __restrict from, int count,
                               double* __restrict to) {
  for (int i = 0; i < count; ++i) to[i] += factor * from[i];
}

}  // namespace

std::vector<int> AncestorsOf(const mjModel* m) {
  std::vector<int> ancestors;
  for (int i = 0; i < m->nv; ++i) {
    for (int j = i; j >= 0; j = m->dof_parentid[j]) ancestors.push_back(j);
  }
  return ancestors;
}

void StepMatrix::SetMass(const mjData* d) { std::copy(d->qM, d->qM + m_->nM, entries_); }

void StepMatrix::AddOuter(double coefficient, const double* row) {
  for (int i = 0; i < m_->nv; ++i) {
    if (row[i] == 0) continue;
    const double scaled = coefficient * row[i];
    const int first = m_->dof_Madr[i], end = first + RowLength(i);
    for (int k = first; k < end; ++k) entries_[k] += scaled * row[ancestors_[k]];
  }
}

PHS_WIDE void StepMatrix::AddSpatial(const SpatialMatrix& damping, const double* motions,
                                     const int* dofs, int count) {
  // Component by component, so that neighbouring dofs go side by side; four at a time.
  constexpr int kBlock = 4;
  double c[6][kMaxChain], y[6][kMaxChain];
  const int padded = (count + kBlock - 1) / kBlock * kBlock;
  for (int k = 0; k < 6; ++k) {
    for (int p = 0; p < count; ++p) c[k][p] = motions[6 * dofs[p] + k];
    for (int p = count; p < padded; ++p) c[k][p] = 0;
  }
  for (int k = 0; k < 6; ++k) {
    for (int p = 0; p < padded; p += kBlock) {
      double sum[kBlock] = {};
      for (int l = 0; l < 3; ++l) {
        AddScaled(damping[k].first[l], c[l] + p, kBlock, sum);
        AddScaled(damping[k].second[l], c[3 + l] + p, kBlock, sum);
      }
      std::copy(sum, sum + kBlock, y[k] + p);
    }
  }
  for (int q = 0; q < count; ++q) {
    double* entry = entries_ + m_->dof_Madr[dofs[q]] + q;  // of the root; the way up goes back
    double row[kMaxChain];
    for (int p = 0; p <= q; p += kBlock) {
      double sum[kBlock] = {};
      for (int k = 0; k < 6; ++k) AddScaled(y[k][q], c[k] + p, kBlock, sum);
      std::copy(sum, sum + kBlock, row + p);
    }
    for (int p = 0; p <= q; ++p) entry[-p] += row[p];
  }
}

PHS_WIDE bool StepMatrix::Factor() {
  for (int k = m_->nv - 1; k >= 0; --k) {
    double* own = entries_ + m_->dof_Madr[k];
    if (!(own[0] > 0)) return false;
    const double inverse = 1 / own[0];
    // The ancestors of k: each row is as long as what is left of the way up.
    int left = RowLength(k) - 1;
    double* along = own + 1;
    const int* ancestor = ancestors_ + m_->dof_Madr[k] + 1;
    for (; left > 0; --left) {
      const double share = *along * inverse;
      AddScaled(-share, along, left, entries_ + m_->dof_Madr[*ancestor++]);
      *along++ = share;
    }
    own[0] = inverse;
  }
  return true;
}

void StepMatrix::Solve(double* x) const {
  for (int i = m_->nv - 1; i >= 0; --i) {
    const int first = m_->dof_Madr[i], end = first + RowLength(i);
    for (int k = first + 1; k < end; ++k) x[ancestors_[k]] -= entries_[k] * x[i];
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

void StepMatrix::MulMass(const mjData* d, const double* x, double* out) const {
  for (int i = 0; i < m_->nv; ++i) {
    const int first = m_->dof_Madr[i], end = first + RowLength(i);
    const double own = x[i];
    double sum = d->qM[first] * own;
    for (int k = first + 1; k < end; ++k) {
      const int j = ancestors_[k];
      sum += d->qM[k] * x[j];
      out[j] += d->qM[k] * own;
    }
    out[i] = sum;
  }
}

}  // namespace phs::plugin
