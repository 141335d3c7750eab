// Controls and forces of the caller's own in a run: his controller, his force on a body.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "plugin/guest.h"
#include "plugin/observer.h"

namespace phs::vehicle {

/// What the caller sees when he is asked. `m` and `d` are those of now; the channels are those of
/// the instant before (one step ago; at the start, of the start), since forces come after him.
struct OwnView {
  const mjModel* m = nullptr;
  const mjData* d = nullptr;
  const double* channels = nullptr;  ///< [channel] of plugin::Observer
};

/// What he may give, set anew in every evaluation; what is left out is as without him.
struct OwnValues {
  std::vector<std::pair<int, double>> controls;  ///< actuator, its control
  struct Wrench {
    int body = 0;
    double force[3] = {0, 0, 0};   ///< world axes, at the body's centre of mass [N]
    double moment[3] = {0, 0, 0};  ///< world axes [N m]
  };
  std::vector<Wrench> wrenches;  ///< of one body add up
};

/// Asked in every evaluation of forces, with the same state perhaps several times: the answer must
/// follow from the view alone. Must not throw. False ends the run with status "stopped".
using OwnInputs = std::function<bool(const OwnView& view, OwnValues* values)>;

/// Brings own inputs into the steps that this thread takes with `d` while it lives.
class OwnInputsInRun {
 public:
  OwnInputsInRun(const mjModel* m, mjData* d, const plugin::Observer* observer,
                 const OwnInputs& inputs);
  OwnInputsInRun(const OwnInputsInRun&) = delete;
  OwnInputsInRun& operator=(const OwnInputsInRun&) = delete;

  /// After every mj_step: the channels that the next view shows.
  void AfterStep(const mjModel* m, const mjData* d);
  /// False once the inputs have asked for the end.
  bool going_on() const { return going_on_; }

 private:
  void Set(const mjModel* m, mjData* d);

  const plugin::Observer* observer_;
  const OwnInputs* inputs_;
  std::vector<double> channels_;
  std::vector<double> start_control_;
  OwnValues values_;
  bool going_on_ = true;
  plugin::Guest guest_;
};

}  // namespace phs::vehicle
