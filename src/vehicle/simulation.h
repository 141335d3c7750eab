// One run from start to end: owns model and data, steps, records, watches for derailment and
// divergence, keeps the books of energy.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/hdf5_series.h"
#include "plugin/binding.h"
#include "plugin/observer.h"
#include "vehicle/energy_book.h"
#include "vehicle/engine.h"
#include "vehicle/own_inputs.h"
#include "vehicle/phs_watch.h"
#include "vehicle/scenario.h"

namespace phs::vehicle {

struct RunOutcome {
  std::string status = "ok";  ///< ok | derailed | diverged | stopped
  std::string reason;
  double end_time_s = 0;
  double real_time_factor = 0;  ///< simulated time / processor time of one core, recording included
  long steps = 0;
  EnergyBook energy;
  std::vector<PhsWarning> warnings;  ///< limits of the hydraulics that were passed
  std::vector<Channel> channels;
  std::vector<std::vector<double>> columns;  ///< [channel][row]
  int Find(const std::string& name) const;
};

/// Called now and then with the share done (0 … 1); returns false to stop the run.
using Progress = std::function<bool(double)>;

/// What is asked of the step before a run: the largest stable one, or only whether it holds.
enum class StepCheck { kLargest, kHolds };

class Simulation {
 public:
  /// Loads, binds and settles. Refuses a step that is too large for the stiffness.
  static Result<Simulation> Create(const Scenario& scenario, StepCheck check = StepCheck::kLargest);
  Simulation(Simulation&&) noexcept = default;
  Simulation& operator=(Simulation&&) noexcept = default;
  ~Simulation();

  /// Runs to the end of the track (or the duration), with controls and forces of the caller's own
  /// where he gives some.
  Result<RunOutcome> Run(const Progress& progress = {}, const OwnInputs& own = {});

  const mjModel* model() const { return model_.get(); }
  mjModel* mutable_model() { return model_.get(); }
  /// mj_forward gives the forces of the instant as long as the result lives.
  plugin::InstantForces Instant() const { return plugin::InstantForces(model_.get()); }
  mjData* data() { return data_.get(); }
  const plugin::Binding& binding() const;
  /// As asked for; timestep_s is the step that is taken.
  const Scenario& scenario() const { return scenario_; }
  /// Largest step at which the vehicle on straight track is numerically stable [s]; 0 = not found,
  /// or not asked for.
  double largest_stable_step() const { return largest_stable_step_; }

 private:
  Simulation() = default;
  Scenario scenario_;
  ModelPtr model_;
  DataPtr data_;
  double largest_stable_step_ = 0;
};

}  // namespace phs::vehicle
