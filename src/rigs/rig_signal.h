// Generated motion of a rig's actuator, starting at rest at 0:
//   sine        x = a sin(2 pi f t)
//   triangle    x = a tri(f t), tri(1/4) = 1, tri(3/4) = -1: constant speed 4 a f
//   step        x goes to each of `levels_m` in turn within `rise_s` and holds for `hold_s`
//   ramp        x = v t from `start_s` up to |x| = a, then held
//   multisine   x = (a/peak) sum_k sin(2 pi f_k t + phi_k): `tones` equidistant f_k in [f, f_high],
//               phases phi_k = -pi k(k-1)/n (M. R. Schroeder, IEEE Trans. IT 16 (1970) 85: low
//               peak); less its value at t = 0
// Displacement [m], extension > 0; frequencies [Hz]; times [s].
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "base/yaml.h"

namespace phs::rigs {

enum class SignalKind { kSine, kTriangle, kStep, kRamp, kMultisine };

struct SignalParams {
  SignalKind kind = SignalKind::kSine;
  double amplitude_m = 0;            ///< a, > 0
  double frequency_Hz = 0;           ///< f, > 0
  double high_frequency_Hz = 0;      ///< f_high of the multisine, >= f
  int tones = 0;                     ///< of the multisine, 1 … 200
  double speed_m_s = 0;              ///< v of the ramp, not 0
  double start_s = 0;                ///< nothing moves before, >= 0
  std::vector<double> levels_m;      ///< of the steps
  double rise_s = 0.2, hold_s = 10;  ///< of the steps, > 0
};

/// One generated run: signals by channel ("actuator_m"); channels not named stand still.
struct RigSignals {
  double duration_s = 0;
  double sample_s = 0;
  std::vector<std::string> channels;
  std::vector<SignalParams> signals;
  int num_samples() const;
};

/// Reads the map `signal:` of a rig manifest (docs/rig.md); errors go into the map.
RigSignals ReadRigSignals(YamlMap map);
/// Samples at k * step_s.
std::vector<double> GenerateSignal(const SignalParams& signal, int num_samples, double step_s);

}  // namespace phs::rigs
