// FASTSIM: the simplified theory of rolling contact on an ellipse (Kalker, A fast algorithm for the
// simplified theory of rolling contact, Vehicle System Dynamics 11 (1982) 1).
//
// Growth of the traction on the rail per unit of way, from the leading edge x = +a backwards:
//   dp_x = -(xi/L1 - phi y/L3) dx,   dp_y = -(eta/L2 + phi x/L3) dx,   |p| <= f p_z,
//   L1 = 8a/(3 C11 G),  L2 = 8a/(3 C22 G),  L3 = pi a sqrt(a/b)/(4 C23 G),
// where the tractions that exceed the bound are cut back along their direction. Bound p_z:
// parabolic 2N/(pi a b)(1 - r^2) (classic; consistent with the theory) or Hertz's elliptic
// 3N/(2 pi a b) sqrt(1 - r^2), with r^2 = (x/a)^2 + (y/b)^2.
//
// Normalised (lengths by a and b, tractions by f p_z(0)) only four numbers remain:
//   u = a xi/(L1 f p0),  v = a eta/(L2 f p0),  w = (a + b) a phi/(L3 f p0),  chi = a/(a + b):
//   dp_x = -(u - w (1 - chi) y) dx,   dp_y = -(v + w chi x) dx.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "rail/creep.h"
#include "rail/kalker.h"

namespace phs::rail {

/// kStrip: every strip has the same number of slices over its own length, and the first slice grows
/// over half its length (traction at its centre): second-order, the default.
/// kUniform: equal cells on the circumscribed rectangle, those counted whose centre lies inside,
/// full growth in the first; CONTACT's grid, for comparison with its published numbers.
enum class FastsimCells { kStrip, kUniform };

struct FastsimParams {
  int strips = 40;  ///< across, 2 … kMaxStrips
  int slices = 40;  ///< along, 2 … 1000
  bool elliptic_bound = false;
  FastsimCells cells = FastsimCells::kStrip;
  double margin = 1;  ///< kUniform: the rectangle is this much larger than the ellipse, 1 … 2
};

/// The four numbers above.
struct NormalisedCreepage {
  double u = 0;
  double v = 0;
  double w = 0;
  double chi = 0.5;  ///< 0 … 1
};

/// Force by f N; moment by f N (a + b). Signs of the force on the rail.
struct NormalisedForce {
  double x = 0;
  double y = 0;
  double moment = 0;
};

/// Slope of the force over u and v.
struct NormalisedSlope {
  double x_u = 0, x_v = 0;
  double y_u = 0, y_v = 0;
};

class Fastsim {
 public:
  static constexpr int kMaxStrips = 400;

  /// @pre strips and slices in range.
  explicit Fastsim(const FastsimParams& params);
  NormalisedForce Calc(const NormalisedCreepage& creepage) const noexcept;
  /// Linear limit of this grid: the same without a bound. Closed form, kStrip only.
  NormalisedForce CalcAdhesion(const NormalisedCreepage& creepage) const noexcept;
  const FastsimParams& params() const { return params_; }

 private:
  NormalisedForce CalcStrips(const NormalisedCreepage& creepage) const noexcept;
  template <bool kElliptic>
  NormalisedForce MarchStrips(const NormalisedCreepage& creepage) const noexcept;
  NormalisedForce CalcUniform(const NormalisedCreepage& creepage) const noexcept;

  FastsimParams params_;
  double scale_ = 1;                       ///< cell sum of the bound -> 1
  std::array<double, kMaxStrips> y_{};     ///< centre of each strip
  std::array<double, kMaxStrips> half_{};  ///< half its length
};

/// Creepages of a patch in normalised form. @pre a, b, normal, friction > 0.
inline NormalisedCreepage Normalise(const CreepInput& in, const KalkerCoefficients& c,
                                    double shear_modulus, bool elliptic_bound) noexcept {
  constexpr double kPi = std::numbers::pi;
  // G over the peak f p0 of the bound.
  const double s = shear_modulus * (kPi * in.a * in.b) /
                   (in.friction * in.normal * (elliptic_bound ? 1.5 : 2.0));
  const double sum = in.a + in.b;
  return {s * 0.375 * c.c11 * in.xi, s * 0.375 * c.c22 * in.eta,
          s * (4 / kPi) * c.c23 * std::sqrt(in.b / in.a) * sum * in.phi, in.a / sum};
}

/// Blended flexibility (CONTACT's FASTSIM): towards large creepage the three flexibilities turn
/// into one, as classic FASTSIM with L1 != L2 slides in a wrong direction. With f3 = 8a/3 and
/// f4 = pi a^2/4:
///   L = (xi^2 + eta^2 + (phi f4/f3)^2)/(xi^2/L1 + eta^2/L2 + (phi f4/f3)^2/L3),
///   Li <- (1 - t) Li + t L,  t = min(1, sqrt((xi^2 + eta^2)/(cx^2 + cy^2))/3),
///   cx = f N/(G a b C11), cy = f N/(G a b C22).
/// Source: CONTACT v25.2, set-up of the simplified theory. As only xi/L1 … count, it is written as
/// changed creepages.
CreepInput WithBlendedFlexibility(const CreepInput& input, const KalkerCoefficients& c,
                                  double shear_modulus) noexcept;
/// Creepages multiplied by the slope reduction k.
CreepInput WithSlopeReduction(const CreepInput& input, const KalkerCoefficients& c,
                              double shear_modulus, const SlopeReduction& reduction) noexcept;

}  // namespace phs::rail
