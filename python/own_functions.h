// A Python controller and Python forces inside the steps of a run.
#pragma once

#include <exception>
#include <memory>
#include <mutex>

#include "python/crossing.h"
#include "vehicle/own_inputs.h"
#include "vehicle/simulation.h"

namespace phs::python {

/// What the functions of all runs of one job have raised: the first one counts.
class RaisedFault {
 public:
  void Keep(std::exception_ptr fault);
  /// Raises it, if there is one. With the GIL.
  void Raise() const;

 private:
  mutable std::mutex mutex_;
  std::exception_ptr fault_;
};

/// `begin(names, arrays)` is called once per run and returns `step(time)`; `arrays` hold the state
/// of the moment whenever that is called. It returns ([(actuator, control)], [(body, 6 numbers)]).
vehicle::OwnInputs BindOwnFunctions(const vehicle::Simulation& simulation, const py::object& begin,
                                    std::shared_ptr<RaisedFault> fault);

}  // namespace phs::python
