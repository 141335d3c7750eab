// Friction of the true rig: force F on the load path, > 0 against extension (v > 0), N.
//
// Base: a table of speed and force times `scale`. Everything else works on top of the base:
//   F = [base or presliding model](v) · H · (1 + position) + soft_sign(v) · (extra terms) + viscous
// with soft_sign(v) = v / 0.2 mm/s between ±1, the same transition as the table's.
#pragma once

#include <array>

namespace rigdata {

enum class StribeckForm { kNone, kGaussian, kExponential, kLorentz };
enum class PreslidingForm { kNone, kLuGre, kMaxwellSlip, kDahl };
enum class PressureFrictionForm { kNone, kSum, kDifference, kRodSeal };
enum class PositionFrictionForm { kNone, kLinear, kTightSpot, kWave };
enum class DwellForm { kNone, kAgeing, kSaturating };
enum class ViscousForm { kNone, kLinear, kRoot, kSquare };

inline constexpr int kMaxwellElements = 6;

struct FrictionParams {
  double scale = 1;

  StribeckForm stribeck = StribeckForm::kNone;
  double stribeck_force = 0;     // N above the base at v → 0
  double stribeck_speed = 1e-3;  // m/s

  PreslidingForm presliding = PreslidingForm::kNone;
  double presliding_share = 1;         // of the base that sticks; the rest follows the table
  double presliding_distance = 50e-6;  // m, breakaway level / stiffness
  double presliding_damping = 0;       // N s/m, LuGre only

  PressureFrictionForm pressure = PressureFrictionForm::kNone;
  double pressure_area = 0;  // N/Pa

  PositionFrictionForm position = PositionFrictionForm::kNone;
  double position_share = 0;      // relative change
  double position_centre = 0;     // m
  double position_length = 2e-3;  // m

  DwellForm dwell = DwellForm::kNone;
  double dwell_force = 0;         // N per e-fold (ageing) or limit (saturating)
  double dwell_time = 1;          // s
  double dwell_distance = 60e-6;  // m of sliding that wipes the memory

  ViscousForm viscous = ViscousForm::kNone;
  double viscous_force = 0;  // N at 20 mm/s

  double asymmetry = 0;  // relative, + against extension, − against retraction

  // Not on the list of known effects.
  double heating_share = 0;       // relative loss of friction per 100 J of dissipated heat kept
  double heating_tau = 60;        // s, cooling
  double swelling_share = 0;      // relative growth in the long run
  double swelling_tau = 80;       // s
  double acceleration_share = 0;  // relative change per 0.1 m/s² along the speed
};

struct FrictionState {
  std::array<double, kMaxwellElements> strain{};  // m (LuGre and Dahl use the first; Dahl: N)
  double rest_age = 0;                            // s
  double heat = 0;                                // J
  double time = 0;                                // s
};

// What the force depends on at one instant.
struct FrictionInput {
  double x = 0, v = 0, acceleration = 0, p_bore = 0, p_rod = 0;
};

class FrictionTruth {
 public:
  explicit FrictionTruth(const FrictionParams& params) : params_(params) {}
  // Force after a step of h that ends at `in`; the new memory goes to *after.
  double Force(const FrictionState& before, const FrictionInput& in, double h,
               FrictionState* after) const;
  FrictionState Initial() const { return {}; }

  // The table alone (scale 1).
  static double Table(double v);
  static double SoftSign(double v);

 private:
  double Level(double v) const;  // sliding level of the presliding models, N > 0
  double Presliding(const FrictionState& before, double v, double h, FrictionState* after) const;
  double PositionFactor(double x) const;
  double Extras(const FrictionState& state, const FrictionInput& in) const;

  FrictionParams params_;
};

}  // namespace rigdata
