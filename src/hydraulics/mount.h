// The mounting of one cylinder: its laws (mount_law.h) as one element between x and y.
#pragma once

#include <vector>

#include "hydraulics/mount_law.h"

namespace phs::hydraulics {

class Mount {
 public:
  Mount() = default;
  explicit Mount(MountLaws laws);

  bool present() const { return !laws_.empty(); }
  const std::vector<MaxwellBranch>& branches() const { return branches_; }
  double play() const { return play_.total; }

  /// e: what of `u` is beyond the play [m].
  double PlayFree(double u) const {
    const double compression = play_.total - play_.tension;
    return u > play_.tension ? u - play_.tension : (u < -compression ? u + compression : 0);
  }
  /// Force of the springs [N] and its slope.
  double SpringForce(double e, double* slope) const;
  /// Force at deflection u and branch deflections q [N]; `slope` = dF/du. With h > 0 that after a
  /// step h: q follows e by backward Euler.
  double Force(double u, const double* q, double h, double* slope) const;
  double Energy(double u, const double* q) const;  ///< [J]
  /// Power lost in the branches [W].
  double Loss(double u, const double* q) const;
  /// Mean rates of q over a step h at whose end the deflection is u.
  void CalcRates(double u, const double* q, double h, double* rate) const;

 private:
  Stiffening Stiffen(double e) const;

  MountLaws laws_;
  Play play_;
  double stiffness_ = 0;
  std::vector<MaxwellBranch> branches_;
};

}  // namespace phs::hydraulics
