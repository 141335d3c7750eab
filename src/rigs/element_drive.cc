#include "rigs/element_drive.h"

#include <algorithm>
#include <cmath>

#include "rigs/element_bench.h"
#include "rigs/implicit_move.h"
#include "rigs/mounted_friction.h"

namespace phs::rigs {
namespace {

constexpr double kGamma = 1 - M_SQRT1_2;

class DrivenPart {
 public:
  DrivenPart(const hydraulics::PhsSystem& system, const RigMotion& motion,
             const ElementStart& start)
      : system_(system),
        motion_(motion),
        part_(system.params().element),
        x_(start.x_m),
        v_(start.v_m_s),
        friction_(system.friction(0), system.mount(0), start.x_m, motion.step_s) {}

  double x() const { return x_; }

  /// From sample `at` over `share` of a step of the clock.
  void Step(double at, double share) {
    const double h = share * motion_.step_s, a = kGamma * h;
    MountedFriction friction = friction_;
    const double v1 = Stage(at + kGamma * share, a, a, x_, v_, &friction);
    const double rest = (1 - kGamma) * h, a1 = (v1 - v_) / a;
    friction = friction_;
    const double base_x = x_ + rest * v1, base_v = v_ + rest * a1;
    const double v2 = Stage(at + share, h, a, base_x, base_v, &friction);
    x_ = base_x + a * v2, v_ = v2;
    friction_ = friction;
  }

 private:
  /// Speed at the end of a stage of length `a` from base values, `h` after the step's begin;
  /// `friction`: at that begin, then at the end.
  double Stage(double at, double h, double a, double base_x, double base_v,
               MountedFriction* friction) {
    double extra[hydraulics::kMaxExtra];
    const hydraulics::FrictionPlace place = ElementPlace(system_, motion_, at, extra);
    const double force = ForceAt(at), m = part_.mass_kg;
    const MountedFriction begin = *friction;
    const double move = FindMove(a * base_v, m / (a * a), &guess_, [&](double trial) {
      const double v = trial / a, x = base_x + trial;
      *friction = begin;
      return m * (v - base_v) / a + ElementForce(part_, x, v, place.bore_rise) +
             friction->After(h, x, v, place) - force;
    });
    return move / a;
  }

  /// The cubic with the slopes of central differences at both samples: straight lines would cut a
  /// sine by (w h)²/12.
  double ForceAt(double at) const {
    const std::vector<double>& force = motion_.position_m[0];
    const auto i = std::min(static_cast<size_t>(at), force.size() - 2);
    const double u = at - static_cast<double>(i), rise = force[i + 1] - force[i];
    const double begin = i > 0 ? 0.5 * (force[i + 1] - force[i - 1]) : rise;
    const double end = i + 2 < force.size() ? 0.5 * (force[i + 2] - force[i]) : rise;
    return force[i] + u * (begin + u * (3 * rise - 2 * begin - end + u * (begin + end - 2 * rise)));
  }

  const hydraulics::PhsSystem& system_;
  const RigMotion& motion_;
  const hydraulics::ElementParams& part_;
  double x_, v_;
  MoveGuess guess_;
  MountedFriction friction_;
};

/// Steps per sample with which the part swings on its spring by at most a tenth of a radian each:
/// what the method is then off by, 0.04 (w h)² of a swing, is half a thousandth.
int StepsFor(const hydraulics::ElementParams& part, double step_s) {
  constexpr double kMost = 0.1;
  const double gas = part.gas_force_N == 0
                         ? 0
                         : part.gas_exponent * part.gas_force_N / std::abs(part.gas_length_m);
  const double stiffness = std::max(0.0, part.stiffness_N_per_m + gas);
  return std::max(
      1, static_cast<int>(std::ceil(step_s * std::sqrt(stiffness / part.mass_kg) / kMost)));
}

}  // namespace

Status RunElementByForce(const hydraulics::PhsSystem& system, const RigMotion& motion,
                         const ElementStart& start, int substeps, std::vector<double>* position) {
  if (!(system.params().element.mass_kg > 0)) {
    return Error{"element.mass_kg", "is 0: a force would move the part at once", "> 0",
                 "declare the mass that moves"};
  }
  if (!system.loads().empty()) {
    return Error{"driven_by", "force: an effect stands between the force and the part",
                 "no moving_mass, load_flexibility or law on the mounting", "element.mass_kg"};
  }
  const int steps = std::max(substeps, StepsFor(system.params().element, motion.step_s));
  DrivenPart part(system, motion, start);
  const int n = motion.num_samples();
  position->resize(static_cast<size_t>(n));
  for (int i = 0; i < n; ++i) {
    (*position)[static_cast<size_t>(i)] = part.x();
    if (!std::isfinite(part.x())) return Error{system.params().name, "the part flies away", ""};
    if (i + 1 == n) continue;
    for (int s = 0; s < steps; ++s) {
      part.Step(i + static_cast<double>(s) / steps, 1.0 / steps);
    }
  }
  return {};
}

}  // namespace phs::rigs
