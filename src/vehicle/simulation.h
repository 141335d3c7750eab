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
#include "vehicle/engine.h"
#include "vehicle/scenario.h"

namespace phs::vehicle {

/// Energies and works since the start [J]. Work in = change of kinetic, potential and stored energy
/// + losses; `error` is what is left over.
struct EnergyBook {
  double kinetic = 0;
  double stored = 0;   ///< gravity, springs, contacts, PHS; relative to the start
  double work_in = 0;  ///< drives
  double lost_creep = 0;
  double lost_contact = 0;
  double lost_dampers = 0;  ///< joint dampers, without lent damping
  double lost_phs = 0;
  double lent = 0;         ///< kinetic energy of the inertia that lent damping adds (binding.h)
  double start_kinetic = 0;
  double Error() const {
    return work_in - (kinetic - start_kinetic) - stored - lost_creep - lost_contact - lost_dampers -
           lost_phs;
  }
  /// Error over the largest of work in and losses.
  double RelativeError() const;
};

struct RunOutcome {
  std::string status = "ok";  ///< ok | derailed | diverged
  std::string reason;
  double end_time_s = 0;
  double real_time_factor = 0;  ///< simulated time / processor time of one core, recording included
  long steps = 0;
  EnergyBook energy;
  std::vector<Channel> channels;
  std::vector<std::vector<double>> columns;  ///< [channel][row]
  int Find(const std::string& name) const;
};

/// Called now and then with the share done (0 … 1); returns false to stop the run.
using Progress = std::function<bool(double)>;

class Simulation {
 public:
  /// Loads, binds and settles. Refuses a step that is too large for the stiffness.
  static Result<Simulation> Create(const Scenario& scenario);
  Simulation(Simulation&&) noexcept = default;
  Simulation& operator=(Simulation&&) noexcept = default;
  ~Simulation();

  /// Runs to the end of the track (or the duration).
  Result<RunOutcome> Run(const Progress& progress = {});

  const mjModel* model() const { return model_.get(); }
  mjModel* mutable_model() { return model_.get(); }
  mjData* data() { return data_.get(); }
  const plugin::Binding& binding() const;
  const Scenario& scenario() const { return scenario_; }
  /// Largest step at which the vehicle on straight track is numerically stable [s]; 0 = not found.
  double largest_stable_step() const { return largest_stable_step_; }

 private:
  Simulation() = default;
  Scenario scenario_;
  ModelPtr model_;
  DataPtr data_;
  double largest_stable_step_ = 0;
};

}  // namespace phs::vehicle
