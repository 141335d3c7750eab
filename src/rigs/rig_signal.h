// Generated motion of a rig's actuator, starting at rest at 0:
//   sine        x = a sin(2 pi f t + phi)
//   triangle    x = a tri(f t + phi/2pi), tri(1/4) = 1, tri(3/4) = -1: constant speed 4 |a| f
//   step        x goes to each of `levels_m` in turn within `rise_s` and holds for `hold_s`
//   ramp        x = v t from `start_s` up to |x| = a, then held
//   multisine   x = (a/peak) sum_k sin(2 pi f_k t + phi_k): `tones` equidistant f_k in [f, f_high],
//               phases phi_k = -pi k(k-1)/n (M. R. Schroeder, IEEE Trans. IT 16 (1970) 85: low
//               peak); less its value at t = 0
// t counts from `start_s`. A negative amplitude turns a wave over. A sine or triangle with a phase
// waits at 0 until the wave passes through 0 for the first time, so that nothing jumps; with
// `periods` it ends at 0 after so many. A list of signals runs one after the other; each but the
// last ends after its periods (sine, triangle).
// Displacement [m], extension > 0, or force [N], tension > 0; frequencies [Hz]; times [s].
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "base/yaml.h"

namespace phs::rigs {

enum class SignalKind { kSine, kTriangle, kStep, kRamp, kMultisine };

/// Displacements in m; in N where `force` says so.
struct SignalParams {
  SignalKind kind = SignalKind::kSine;
  bool force = false;
  double amplitude = 0;              ///< a, not 0; of a ramp > 0
  double frequency_Hz = 0;           ///< f, > 0
  double phase_deg = 0;              ///< of sine and triangle, -360 … 360
  int periods = 0;                   ///< of sine and triangle; 0: to the end
  double high_frequency_Hz = 0;      ///< f_high of the multisine, >= f
  int tones = 0;                     ///< of the multisine, 1 … 200
  double rate = 0;                   ///< v of the ramp [m/s, N/s], not 0
  double start_s = 0;                ///< nothing moves before, >= 0
  std::vector<double> levels;        ///< of the steps
  double rise_s = 0.2, hold_s = 10;  ///< of the steps, > 0

  bool IsWave() const { return kind == SignalKind::kSine || kind == SignalKind::kTriangle; }
  /// From start_s to where the wave first passes through 0 [s].
  double Wait() const;
  /// End of a wave of so many periods; without, it has none.
  double End() const { return start_s + Wait() + periods / frequency_Hz; }
};

/// One generated run: signals by channel ("actuator_m"), each list one after the other; channels
/// not named stand still.
struct RigSignals {
  double duration_s = 0;
  double sample_s = 0;
  std::vector<std::string> channels;
  std::vector<std::vector<SignalParams>> signals;
  int num_samples() const;
};

/// Reads the map `signal:` of a rig manifest (docs/rig.md); errors go into the map.
RigSignals ReadRigSignals(YamlMap map);
/// Samples at k * step_s.
std::vector<double> GenerateSignal(const SignalParams& signal, int num_samples, double step_s);
std::vector<double> GenerateSignals(const std::vector<SignalParams>& parts, int num_samples,
                                    double step_s);

}  // namespace phs::rigs
