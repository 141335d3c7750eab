// What effects put between the mounting of a cylinder and its piston.
//
//   x o--[ plays ]--+--[ springs ]----------+--o y piston     u = x - y
//                   +--[ k_b ]--q--[ c_b ]--+                 e: what of u is beyond the plays
//
//   F = k r e f(e) + sum k_b (e - q_b),   dq_b/dt = k_b (e - q_b)/c_b,   F > 0 tension
// Several laws: plays add; springs stand in series, 1/k = sum 1/k_i, and share one e: their ratios
// r multiply, and the one that stiffens most gives f; Maxwell branches lie beside all springs.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace phs::hydraulics {

/// Free way of a pin in its hole [m].
struct Play {
  double total = 0;    ///< >= 0
  double tension = 0;  ///< of it that is crossed before tension, from rest, 0 … total
};

/// A spring and a damper one behind the other.
struct MaxwellBranch {
  std::string name;      ///< of its state q, "bush"
  double stiffness = 0;  ///< k_b > 0 [N/m]
  double damping = 0;    ///< c_b > 0 [N s/m]
};

/// How a spring departs from k e: force k r e f(e).
struct Stiffening {
  double side = 1;    ///< r > 0 of this sign of e: stiffness about rest over k
  double factor = 1;  ///< f(e) > 0, f(0) = 1
  double slope = 1;   ///< d(e f)/de > 0
};

class MountLaw {
 public:
  virtual ~MountLaw() = default;
  virtual Play FreePlay() const { return {}; }
  /// k about e = 0 [N/m]; 0: rigid.
  virtual double Stiffness() const { return 0; }
  virtual Stiffening Stiffen(double /*e*/) const noexcept { return {}; }
  virtual std::vector<MaxwellBranch> Branches() const { return {}; }
};
using MountLaws = std::vector<std::unique_ptr<const MountLaw>>;

}  // namespace phs::hydraulics
