// Named results of a bound model at one instant: what the recorder writes and what the C API
// offers.
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "base/hdf5_series.h"
#include "plugin/binding.h"

namespace phs::plugin {

/// Two wheelsets of one frame, for bending and shear: names "lead"/"trail" with a common prefix.
struct BogiePair {
  std::string prefix;  ///< "" or "front_"
  int lead = -1;
  int trail = -1;
};

/// Finds the pairs among the wheelsets by their names.
std::vector<BogiePair> FindBogies(const Binding& binding);

/// Values of all channels; reads (m, d) after mj_forward or mj_step, changes nothing.
class Observer {
 public:
  Observer(const mjModel* m, const Binding& binding);
  const std::vector<Channel>& channels() const { return channels_; }
  /// `row` has one value per channel.
  void Observe(const mjModel* m, const mjData* d, double* row) const;

 private:
  void Name(const std::string& name, const std::string& unit, const std::string& description);
  void NameWheelset(const std::string& name);
  void NamePhs(const PhsBinding& phs, const std::string& prefix);

  const Binding& binding_;
  int car_body_;  ///< the heaviest body
  std::vector<BogiePair> bogies_;
  std::vector<Channel> channels_;
};

}  // namespace phs::plugin
