// Named results of a bound model at one instant: what the recorder writes and what the C API
// offers. The channels are the rows of channels.h.
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "base/hdf5_series.h"
#include "plugin/channels.h"

namespace phs::plugin {

/// Values of all channels; reads (m, d) after mj_forward or mj_step, changes nothing.
class Observer {
 public:
  Observer(const mjModel* m, const Binding& binding);
  const std::vector<Channel>& channels() const { return channels_; }
  /// `row` has one value per channel.
  void Observe(const mjModel* m, const mjData* d, double* row) const;

 private:
  struct Source {
    const ChannelRow* row;
    ChannelPlace place;
  };
  /// A channel for each row, called `prefix` and the row's name.
  void Add(std::span<const ChannelRow> rows, const std::string& prefix, ChannelPlace place);
  void AddElements(const mjModel* m);
  Instant InstantOf(const mjModel* m, const mjData* d) const;

  const Binding& binding_;
  int car_body_;  ///< the heaviest body
  std::vector<BogiePair> bogies_;
  std::vector<Channel> channels_;
  std::vector<Source> sources_;  ///< of each channel
};

}  // namespace phs::plugin
