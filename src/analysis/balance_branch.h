// Follows a branch of periodic motions (harmonic_balance.h) through the plane of the watched amplitude
// A and the parameter p, whichever way it turns there.
//
// From the last two motions it goes straight on by a step ds and looks for the motion on the line
// across: with a = A/A_s, b = p/p_s in parts of the largest steps A_s, p_s of either,
//   (a - a_guess) da + (b - b_guess) db = 0
// (pseudo-arclength, H. B. Keller 1977). Where none is found, or one that lies back or far off, ds is
// halved; each motion found doubles it again.
#pragma once

#include "analysis/harmonic_balance.h"

namespace phs::analysis {

struct BranchOptions {
  double ratio = 1.25;            ///< of one amplitude to the one before, at most
  double step = 1e-4;             ///< between amplitudes, at most
  double parameter_share = 0.05;  ///< of the parameter, a step at most
  double largest = 1;             ///< amplitude at which the branch is cut, met exactly
  BalanceOptions solver = {};
};

class BalanceBranch {
 public:
  /// Begins from two motions, the later one `second`.
  BalanceBranch(const VibratingSystem& system, const BranchOptions& options, PeriodicMotion first,
                PeriodicMotion second);
  const PeriodicMotion& last() const { return last_; }
  /// True if it went one motion on; false at its end or where no step is short enough.
  bool Next();

 private:
  double SizeOf(const PeriodicMotion& m) const { return m.Amplitude(system_.watched, 1); }

  const VibratingSystem& system_;
  BranchOptions options_;
  PeriodicMotion before_, last_;
  double part_ = 1;  ///< ds, of the largest step
};

}  // namespace phs::analysis
