// A model bound to the physics: names resolved to ids, profiles, track and PHS systems loaded.
// Immutable once made; every query is a pure function of (m, d) and safe from many threads.
//
// Per step MuJoCo calls Passive (contact forces, dampers and PHS at the speed of the instant:
// half_step.h), Control (speed hold), and for each PHS actuator ActDyn and Bias. All is evaluated
// once in Passive; what the other callbacks and readers of results need stands in d->userdata,
// which is rewritten at every call and so carries no history (layout: UserData below). The model
// itself is not changed, but for the key named "test".
//
// With the Runge-Kutta integrator forces and rates are those of the instant; so are they while an
// InstantForces lives, for readers of mj_forward.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "hydraulics/phs_system.h"
#include "phs_model/phs_model.h"
#include "plugin/attach_options.h"
#include "plugin/elements.h"
#include "plugin/running_forces.h"
#include "rail/creep_conditions.h"
#include "rail/track.h"
#include "rail/wheel_rail.h"

namespace phs::plugin {

/// Largest PHS system: its values live on the stack during a step.
inline constexpr int kMaxCylinders = 16;
inline constexpr int kMaxLines = 16;
inline constexpr int kMaxStates = 96;

/// One wheelset: its ids and the dofs that its wrench acts on.
struct WheelsetBinding {
  std::string name;
  int body = -1;
  int spin_dof = -1;
  int yaw_joint = -1;       ///< primary yaw joint, or -1
  int drive_actuator = -1;  ///< or -1
  std::vector<int> dofs;    ///< of the body and its ancestors
};

/// One PHS system and its actuators.
struct PhsBinding {
  std::string name;
  std::string model_path;
  std::shared_ptr<const hydraulics::PhsSystem> system;
  std::vector<int> cylinder;           ///< actuator ids
  std::vector<double> length0;         ///< tendon length at rest [m]
  std::vector<std::vector<int>> dofs;  ///< that move each cylinder
  std::vector<int> state_actuator;     ///< actuator id that carries each state
  int forces_at = 0;                   ///< userdata: actuator force per cylinder [N]
  int speeds_at = 0;                   ///< userdata: speed of the instant per cylinder [m/s]
  int rates_at = 0;                    ///< userdata: mean state rate per state
  int pistons_at = 0;                  ///< userdata: piston of each cylinder from static [m]
  int pressures_at = 0;                ///< userdata: of each line, absolute [Pa]
  int states_at = 0;                   ///< userdata: the states that the forces belong to
};

/// d->userdata, first entries; then the speed of the instant of every dof (w of half_step.h), the
/// position of every joint (qpos), and the PHS. All belong to the position that MuJoCo last worked
/// out, also after mj_step, when qpos, qvel and act have gone on already.
struct UserData {
  static constexpr int kCreepPower = 0;     ///< lost to slip, all wheels [W]
  static constexpr int kContactPower = 1;   ///< lost to contact and support damping [W]
  static constexpr int kContactEnergy = 2;  ///< stored in contacts and supports [J]
  static constexpr int kPhsPower = 3;       ///< lost in the PHS [W]
  static constexpr int kPhsEnergy = 4;      ///< stored in the PHS, where MuJoCo sums energy [J]
  static constexpr int kLifted = 5;         ///< number of wheels without contact
  static constexpr int kBeyondProfile = 6;  ///< number of wheels at the end of a profile
  static constexpr int kMaxLateral = 7;     ///< largest |lateral| of a wheelset [m]
  static constexpr int kTrainPower = 8;     ///< given by the train at the coupler [W]
  static constexpr int kBrakePower = 9;     ///< lost at the brake blocks [W]
  static constexpr int kDamperPower = 10;   ///< lost in elements between bodies [W]
  static constexpr int kDrivePower = 11;    ///< given by the drives [W]
  static constexpr int kAppliedPower = 12;  ///< given by qfrc_applied and xfrc_applied [W]
  static constexpr int kHoldMore = 13;      ///< what the speed hold gives beyond its controls [N m]
  static constexpr int kTime = 14;          ///< [s]
  static constexpr int kHeader = 15;
};

/// Forces and motion of one wheelset at one instant (T axes: x forward, y left, z up).
struct WheelsetState {
  rail::TrackFrame frame;
  rail::Vec3 centre{};             ///< world [m]
  double lateral = 0;              ///< y_T of the centre [m]
  double vertical = 0;             ///< z_T of the centre [m]
  double yaw = 0;                  ///< against the radial direction = angle of attack [rad]
  double roll = 0;                 ///< [rad]
  double speed = 0;                ///< along the track [m/s]
  double spin = 0;                 ///< [rad/s]
  rail::WheelRailForces wheel[2];  ///< by rail::Side, C axes
  rail::Vec3 force{};              ///< on the wheelset, world [N]
  rail::Vec3 moment{};             ///< about its centre, world [N m]
  rail::Vec3 moment_T{};           ///< the same in T axes [N m]
};

/// Takes the forces of the instant (no half step) from mj_forward as long as it lives.
class InstantForces {
 public:
  explicit InstantForces(mjModel* m) : m_(m), integrator_(m->opt.integrator) {
    m->opt.integrator = mjINT_RK4;  // mj_forward itself does not look at it
  }
  ~InstantForces() { m_->opt.integrator = integrator_; }
  InstantForces(const InstantForces&) = delete;
  InstantForces& operator=(const InstantForces&) = delete;

 private:
  mjModel* m_;
  int integrator_;
};

/// PHS values at one instant; vectors sized by the system.
struct PhsState {
  std::vector<double> displacement, speed, state;
  std::vector<double> force, pressure_force, friction_force, piston, p_bore, p_rod, pressure;
  double stored_energy = 0;
  double lost_power = 0;
};

class Binding {
 public:
  /// Resolves names and loads data. Errors name the MJCF element.
  static Result<std::unique_ptr<Binding>> Create(mjModel* m, const AttachOptions& options);
  /// True if the model names at least one wheelset, PHS system or element.
  static bool Concerns(const mjModel* m);

  void Passive(const mjModel* m, mjData* d) const noexcept;
  void Control(const mjModel* m, mjData* d) const noexcept;
  /// True if actuator `id` belongs to a PHS system.
  bool Owns(int actuator) const noexcept { return owner_[actuator] != nullptr; }
  double ActDyn(const mjModel* m, const mjData* d, int actuator) const noexcept;
  double Bias(const mjData* d, int actuator) const noexcept;

  /// States of the cylinders go on by `h` while they move from where (m, d) has them at the speeds
  /// qvel: for readers that prescribe the motion.
  void AdvanceStates(const mjModel* m, mjData* d, double h) const noexcept;
  /// Oil has passed between throttled chambers and their lines until nothing flows there, with the
  /// cylinders where the positions of (m, d) have them: for readers that look for a place of rest.
  void SettleChambers(const mjModel* m, mjData* d) const;
  /// Of a body, at the speed of the instant, world axes [m/s]. Allocates.
  rail::Vec3 CentreOfMassVelocity(const mjModel* m, const mjData* d, int body) const;
  /// A wheelset and its forces at the speed of the instant.
  WheelsetState CalcWheelset(const mjModel* m, const mjData* d, int index) const noexcept;
  /// Allocates; for recording, not for the step itself.
  PhsState CalcPhs(const mjModel* m, const mjData* d, int index) const;

  bool has_rail() const { return track_ != nullptr; }
  const rail::Track& track() const { return *track_; }
  const rail::WheelRail& wheel_rail() const { return *wheel_rail_; }
  const std::vector<WheelsetBinding>& wheelsets() const { return wheelsets_; }
  const std::vector<PhsBinding>& phs() const { return phs_; }
  const ElementList& elements() const { return elements_; }
  double target_speed() const { return target_speed_; }
  double start_s() const { return start_s_; }
  double friction() const { return friction_; }
  /// Positions [nq] and speeds [nv] of the instant, as the last call of Passive left them.
  JointState Joints(const mjModel* m, const mjData* d) const {
    return {Speed(d) + m->nv, Speed(d)};
  }
  /// Speed of the instant of every dof [nv], as the last call of Passive left it.
  const double* Speed(const mjData* d) const { return d->userdata + UserData::kHeader; }

  /// A wheelset where it stands, ready for its forces at any speed; of the plugin alone.
  struct PressedWheelset;

 private:
  Status LoadRail(mjModel* m, const AttachOptions& options);
  Status BindWheelsets(mjModel* m);
  Status BindCoupler(const mjModel* m, const AttachOptions& options);
  Status BindPhs(mjModel* m, const AttachOptions& options);
  struct Work;
  /// All wheelsets, on MuJoCo's stack or where somebody keeps them.
  void PressWheelsets(mjData* d, Work* work) const noexcept;
  void PressWheelset(const mjData* d, int index, PressedWheelset* at) const noexcept;
  void MoveWheelset(const mjModel* m, const mjData* d, int index, const double* speed,
                    PressedWheelset* at, rail::WheelDamping* damping) const noexcept;
  /// Forces of wheels, train, brakes, elements and cylinders at `speed` [nv] into work->force;
  /// powers and cylinder forces into userdata. With `slopes` also the rows of the contacts' damping
  /// into work->matrix.
  void CalcForces(const mjModel* m, mjData* d, const double* speed, bool slopes,
                  Work* work) const noexcept;
  void AddWheelsetForces(const mjModel* m, mjData* d, const double* speed, bool slopes,
                         Work* work) const noexcept;
  void AddRunningForces(const mjModel* m, mjData* d, const double* speed, bool slopes,
                        Work* work) const noexcept;
  /// Pistons and pressures, which serve every speed of the step.
  void SolveCylinders(const mjData* d, Work* work) const noexcept;
  void AddCylinderForces(const mjModel* m, mjData* d, const double* speed, bool slopes,
                         Work* work) const noexcept;
  bool Factor(const mjModel* m, const mjData* d, bool again, Work* work) const noexcept;
  void FollowCylinders(const mjModel* m, mjData* d, const double* speed, Work* work) const noexcept;
  void AddDrives(const mjModel* m, mjData* d, Work* work) const noexcept;
  void HalfStep(const mjModel* m, mjData* d, Work* work) const noexcept;
  void CalcRest(const mjModel* m, mjData* d, Work* work) const noexcept;
  void CalcRates(mjData* d, double h, const Work& work) const noexcept;
  void AddElementForces(const mjModel* m, const mjData* d, const double* speed,
                        Work* work) const noexcept;
  /// Forces of MuJoCo's own dampers at `speed`, which may be a difference of speeds.
  void AddEngineDampers(const mjModel* m, const mjData* d, const double* speed,
                        double* force) const noexcept;
  void BookPowers(const mjModel* m, mjData* d, Work* work) const noexcept;
  double DriveControl(const mjModel* m, const mjData* d, const WheelsetBinding& w) const noexcept;
  /// Of the speed hold on an axle that moves with `velocity`, world axes [N m].
  double HeldTorque(const mjData* d, const rail::Vec3& velocity) const noexcept;
  /// Adds what the speed hold gives at `speed` beyond its controls, which are those of v_n.
  void AddSpeedHold(const mjModel* m, mjData* d, const double* speed, Work* work) const noexcept;
  bool Drives() const { return has_rail() && target_speed_ > 0 && root_body_ >= 0; }

  std::unique_ptr<rail::Track> track_;
  std::unique_ptr<rail::WheelRail> wheel_rail_;
  std::vector<WheelsetBinding> wheelsets_;
  std::vector<PhsBinding> phs_;
  ElementList elements_;
  std::vector<int> ancestors_;            ///< AncestorsOf the model
  std::vector<const PhsBinding*> owner_;  ///< [actuator]
  std::vector<int> cylinder_at_;          ///< [actuator] userdata index of its force, or -1
  std::vector<int> rate_at_;              ///< [actuator] userdata index of its state rate, or -1
  double friction_ = 0.3;
  double target_speed_ = 0;
  double start_s_ = 0;
  double speed_gain_ = 0;  ///< torque per speed error and driven axle [N m s/m]
  int root_body_ = -1;     ///< body whose speed is held
  RunningForces running_;
  int coupler_site_ = -1;
  std::vector<int> coupler_dofs_;
};

}  // namespace phs::plugin
