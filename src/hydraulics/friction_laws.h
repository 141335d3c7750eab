// What effects change of the friction of one cylinder (friction.h).
//
// Level: max((curve * of_curve + extra) * of_all, 0); several laws multiply and add into the same
// three numbers, so their order does not count. Forces beside friction add. One bristle law.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hydraulics/force_place.h"

namespace phs::hydraulics {

/// What a friction level may depend on beside speed.
struct FrictionPlace {
  double bore_rise = 0;  ///< p_bore above static [Pa]
  double rod_rise = 0;   ///< p_rod above static [Pa]
  double piston = 0;     ///< y [m]
  double time = 0;       ///< [s]
  double warmer = 0;     ///< temperature above the model's [K]
  /// Of the level laws that have one, in their order, then the states of the forces; null: 0.
  const double* memory = nullptr;
  const double* extra = nullptr;  ///< further measured channels (extra_series.h); null: 0
};

/// A friction level in the making.
struct LevelParts {
  double of_curve = 1;  ///< factor on the declared curve alone, >= 0
  double extra = 0;     ///< [N]
  double of_all = 1;    ///< factor on all of it, >= 0
};

/// Where a level is asked for.
struct LevelPlace {
  int sign = 1;      ///< 1 extension, -1 retraction
  double speed = 0;  ///< |v| [m/s]
  const FrictionPlace& at;
  double memory = 0;
};

/// What changes the level. Dissipative whatever it says, as the level stays >= 0. A law may have a
/// memory, one number that follows the motion: 0 in the static state, after long rest.
class LevelLaw {
 public:
  virtual ~LevelLaw() = default;
  virtual void Add(const LevelPlace& place, LevelParts* level) const noexcept = 0;
  virtual bool DependsOnPressure() const { return false; }
  /// Name of the memory among the states, "dwell"; empty = none.
  virtual std::string MemoryName() const { return {}; }
  virtual double MemoryRate(double /*v*/, double /*memory*/) const noexcept { return 0; }
  /// The memory after h seconds at constant v, exact or at least stable for any h.
  virtual double AdvanceMemory(double /*h*/, double /*v*/, double memory) const noexcept {
    return memory;
  }
};

/// A force beside friction, F > 0 tension. It may have states: 0 in the static state.
class ForceLaw {
 public:
  virtual ~ForceLaw() = default;
  virtual double Force(const ForcePlace& place) const noexcept = 0;
  virtual std::vector<std::string> StateNames() const { return {}; }
  /// d(state)/dt.
  virtual void CalcRates(const ForcePlace& /*place*/, double* /*rate*/) const noexcept {}
  /// `state` after h seconds at constant speed, stable for any h; `place` in the middle of the way.
  virtual void Advance(double /*h*/, const ForcePlace& /*place*/,
                       double* /*state*/) const noexcept {}
  /// True where it depends on the speed alone: pressures and direction then need not be known.
  virtual bool OfSpeedAlone() const { return false; }
  /// d(force)/d(speed) about rest, or more [N s/m], >= 0, for motion of direction `sign`.
  virtual double Damping(int /*sign*/) const { return 0; }
};

/// How friction comes up to its level: a bristle of stiffness sigma0 is bent and yields,
/// dz/dt = v (1 - yield), up to z_s = share level/sigma0. Stored energy sigma0 z²/2.
class BristleLaw {
 public:
  virtual ~BristleLaw() = default;
  virtual double Stiffness() const = 0;  ///< sigma0 > 0 [N/m]
  /// Of the level that sticks, 0 … 1; the rest slides at once.
  virtual double Share() const { return 1; }
  /// Largest d(force)/d(position) over sigma0.
  virtual double Steepest() const { return 1; }
  /// Yield at deflection `along` in the direction of motion, z_s > 0; at most 1 up to z_s.
  virtual double Yield(double along, double z_s) const noexcept = 0;
  /// Deflection after a way > 0. Exact.
  virtual double Advance(double along, double way, double z_s) const noexcept = 0;
};

/// All that effects add to the friction of one cylinder.
struct FrictionLaws {
  std::vector<std::unique_ptr<const LevelLaw>> levels;
  std::vector<std::unique_ptr<const ForceLaw>> forces;
  std::unique_ptr<const BristleLaw> bristle;  ///< empty: as declared
};

}  // namespace phs::hydraulics
