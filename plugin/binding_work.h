// What the files of one step of Binding share: wheelsets pressed on the track, numbers of an
// evaluation, small vectors. Internal to plugin.
#pragma once

#include <algorithm>

#include "plugin/binding.h"
#include "plugin/half_step.h"

namespace phs::plugin {

inline rail::Vec3 Load(const mjtNum* p) { return {p[0], p[1], p[2]}; }
inline double Dot(const rail::Vec3& a, const rail::Vec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline rail::Vec3 Cross(const rail::Vec3& a, const rail::Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline void Add(rail::Vec3* a, const rail::Vec3& b) {
  for (int i = 0; i < 3; ++i) (*a)[i] += b[i];
}

/// Velocity of a body: rotation and that of its frame's origin, world axes.
struct BodyVelocity {
  rail::Vec3 rotation{};
  rail::Vec3 centre{};
};
/// At speeds `speed` of the dofs `dofs` that move it.
BodyVelocity VelocityOf(const mjModel* m, const mjData* d, int body, const std::vector<int>& dofs,
                        const double* speed);
/// Adds the generalised force of a wrench on a body: force and moment about the centre of mass of
/// the tree, where MuJoCo keeps the axes of dofs.
void AddWrench(const mjData* d, const std::vector<int>& dofs, const rail::Vec3& force,
               const rail::Vec3& moment, double* out);

/// Slope now, slope in the matrix, force and speed of the round before, of each cylinder.
inline constexpr int kCylinderNumbers = 4 * kMaxCylinders;

/// A wheelset where it stands, ready for its forces at any speed.
struct Binding::PressedWheelset {
  WheelsetState state;
  rail::WheelsetMotion motion[2];
  rail::PressedWheel wheel[2];
  rail::WheelMemo memo[2];

  /// What stands at `other`, but for the memories of its creep laws.
  void TakePlace(const PressedWheelset& other) {
    state = other.state;
    std::copy(other.motion, other.motion + 2, motion);
    std::copy(other.wheel, other.wheel + 2, wheel);
  }
};

/// Numbers of one evaluation, on MuJoCo's stack.
struct Binding::Work {
  PressedWheelset** wheelsets = nullptr;  ///< [wheelset]
  double* force = nullptr;                ///< of wheels, train, brakes, elements made here [nv]
  double* cylinder = nullptr;  ///< the part of the cylinders, which MuJoCo adds itself [nv]
  double* rest = nullptr;      ///< all other forces but Coriolis', at v_n [nv]
  double* drive = nullptr;     ///< the part of actuators that are no cylinders [nv]
  double* row = nullptr;       ///< scratch [nv]
  double* contact = nullptr;   ///< M + h/2 (C of all but cylinders) [nM]
  double* entries = nullptr;   ///< the same with cylinders, factorised [nM + nv]
  double half = 0;             ///< h/2 [s]
  StepMatrix* matrix = nullptr;
  double* slope = nullptr;                  ///< kCylinderNumbers of each PHS
  hydraulics::Instant* instants = nullptr;  ///< of each PHS
};

}  // namespace phs::plugin
