// The Passive Hydraulic Steering as one system: cylinders, lines, friction, effects. No MuJoCo.
// The rig, the MuJoCo plugin and the identification drive the same object.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "hydraulics/carried_body.h"
#include "hydraulics/extension.h"
#include "hydraulics/friction.h"
#include "hydraulics/mount.h"
#include "hydraulics/phs_instant.h"
#include "hydraulics/phs_outputs.h"
#include "hydraulics/phs_params.h"

namespace phs::hydraulics {

/// Immutable description plus pure functions. State (friction bristles, gas temperatures, line
/// flows, clearances …) lives with the caller: in a rig's array or in mjData's activations.
class PhsSystem {
 public:
  /// Reads models/phs/NAME.yaml (format: docs/phs_models.md). A file that names effects needs the
  /// catalogue: use phs_model::LoadPhsSystem.
  static Result<PhsSystem> Load(const std::string& path, const EffectTable* effects = nullptr);
  /// Validates and compiles parameters. Cheap: a few microseconds.
  /// `extra`: further channels of the record that it is run on, for laws that ask for them.
  static Result<PhsSystem> Create(const PhsParams& params, const EffectTable* effects = nullptr,
                                  std::shared_ptr<const ExtraSeries> extra = nullptr);
  PhsSystem(PhsSystem&&) noexcept;
  PhsSystem& operator=(PhsSystem&&) noexcept;
  ~PhsSystem();

  int num_cylinders() const;
  int num_lines() const;
  /// True if a cylinder's mounting yields: its piston is not the driven end.
  bool has_mounts() const;
  /// True if oil passes from one place to another: a resistance, a leak, a valve.
  bool has_flows() const;
  /// True if something lies between a chamber and its line: a throttle, a line resistance.
  bool has_split_lines() const;
  int num_states() const;  ///< deviations from the static state: all zero at rest
  const std::vector<std::string>& cylinder_names() const;
  const std::vector<std::string>& line_names() const;
  const std::vector<std::string>& state_names() const;  ///< "1.bristle", "L1.gas_temperature" …
  const std::string& name() const;
  const PhsParams& params() const;  ///< as given

  /// Forces and pressures at mounting displacements `x` [m] (extension > 0, from static), speeds
  /// `v` [m/s] and `state`, at `time`. Pure; no allocation; thread-safe.
  void Calc(double time, const double* x, const double* v, const double* state,
            PhsOutputs* out) const noexcept;
  /// Mean rate of the states over the coming step h at constant v: (state(t+h) - state(t)) / h,
  /// integrated implicitly or exactly inside, so that an explicit Euler step of the caller is
  /// stable for any h. h = 0 gives the instantaneous derivative.
  ///
  /// `v` is the mean speed over that step, so that states and x stay in step: with
  /// x_{n+1} = x_n + h v_{n+1}, as MuJoCo's Euler does, it is v_{n+1}. (States advanced with v_n
  /// lag x by one step and feed energy into a stuck bristle, growth h sigma0/(2 m).)
  ///
  /// `before`: mean piston speeds over the step before, of the same length, if known [m/s]; flows
  /// then answer to a speed that goes on to change as it did (second order in h), else to one.
  void CalcStateRate(double time, double h, const double* x, const double* v, const double* state,
                     double* rate, const double* before = nullptr) const noexcept;
  /// Lets oil pass between the chambers and their lines until all parts of a line have one
  /// pressure: changes the volumes of `state` that have passed there, and their flows to none. What
  /// else flows (leaks, a failure) and every other state stays as it is.
  void SettleChambers(double time, const double* x, double* state) const;
  /// Calc and CalcStateRate in parts: Solve finds pistons and pressures, which do not ask for
  /// speeds, from `at` as made or near by; `x` and `state` below are those of Solve. `piston_way`:
  /// ways of the pistons behind yielding mountings over h, a guess and the solution.
  void Solve(double time, const double* x, const double* state, Instant* at) const noexcept;
  void CalcAt(const Instant& at, const double* x, const double* v, const double* state,
              PhsOutputs* out) const noexcept;
  void CalcStateRateAt(const Instant& at, double h, const double* x, const double* v,
                       const double* state, double* rate, const double* before = nullptr,
                       double* piston_way = nullptr) const noexcept;
  /// Where a body that carries driven ends along goes over h, with yielding mountings: its way and
  /// those of the pistons behind them, both guesses, and the solution by one stage of backward
  /// Euler. `v`: mean speeds of the driven ends that are given. False: not found.
  bool BalanceBody(const Instant& at, double h, const double* x, const double* v,
                   const double* state, const CarriedBody& body, double* piston_way,
                   double* body_way) const noexcept;
  /// Without yielding mountings the pressures follow from the motion alone, whatever the friction:
  /// chamber pressures at an instant [Pa, absolute; per cylinder] and mean rates of the hydraulic
  /// states over the coming step h; other rates are left as they are. `instant`: of the step
  /// before, or as made; gets that of this step's start.
  void CalcHydraulics(double time, double h, const double* x, const StepSpeeds& v,
                      const double* state, Instant* instant, double* rate, double* p_bore,
                      double* p_rod) const noexcept;
  /// Calc where the chamber pressures are known; of `out` all but the line pressures and energies
  /// (out->energy is set to false).
  void CalcForces(double time, const double* x, const double* v, const double* state,
                  const double* p_bore, const double* p_rod, PhsOutputs* out) const noexcept;
  /// Mean rates of the friction's states where the chamber pressures are known: the first
  /// num_friction_states(); see CalcStateRate.
  void CalcFrictionRate(double time, double h, const double* x, const double* v,
                        const double* state, const double* p_bore, const double* p_rod,
                        double* rate) const noexcept;
  int num_friction_states() const;  ///< of a system without yielding mountings
  /// Largest stiffness [N/m] and damping [N s/m] seen from one cylinder alone while the other
  /// cylinders stand still, inside the stroke and on an end stop, for step-size checks.
  double max_stiffness() const;
  double max_damping() const;
  /// Fastest oscillation of oil with inertance I against the oil on both sides of it, K [Pa/m3],
  /// damped by its resistance R at rest: sqrt(K/I - (R/2I)^2) [rad/s]; 0 = none that rings. Steps
  /// longer than about 0.6 of its inverse damp it away.
  double max_line_frequency() const;

  /// Laws of an instrument of a cylinder, for rigs.
  const ReadingLaws& readings(int cylinder, Sensor sensor) const;
  /// Friction of a cylinder alone, for benches without oil.
  const Friction& friction(int cylinder) const;
  const Mount& mount(int cylinder) const;
  /// Temperature of surroundings and oil [K].
  double Ambient(double time) const;
  /// What hangs on the driven end of a bench or rig.
  const LoadLaws& loads() const;
  /// Further measured channels that laws may ask for; null: none.
  const ExtraSeries* extra() const;

 private:
  struct Impl;
  explicit PhsSystem(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace phs::hydraulics
