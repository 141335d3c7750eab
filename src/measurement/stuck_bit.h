// One bit of a channel's converter that is stuck, found in the readings themselves and read back.
//
// A bit of weight w that is stuck at 1 shows y + w wherever it should be 0 (stuck at 0: y - w
// wherever it should be 1). So the readings keep out of every second band of width w, and jump by w
// at the edges of these bands while the true value passes on. No continuous signal does so: a value
// that moves by less than w/4 from sample to sample cannot pass a band without a sample in it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "measurement/rig_data.h"

namespace phs::measurement {

struct StuckBit {
  double weight = 0;  ///< w, in the channel's unit
  bool at_one = true;
  std::size_t from = 0;     ///< first sample; 0: throughout, and at_one is then not told
  std::vector<char> wrong;  ///< 1: the bit should have the other value at this sample
  std::vector<char> told;   ///< 0: whether it should is not told, as the channel moves too fast
};

/// The stuck bit of a channel: of 8 noise levels or more, a two-thousandth to an eighth of what the
/// channel covers, with ten or more such jumps and no two samples in a row within the bands left out,
/// from `from` to the end.
std::optional<StuckBit> FindStuckBit(const std::vector<double>& y);

/// Reads the (measured) channel back, leaves out what is not told, and says so.
void ReadBackStuckBit(const RigRun& run, Channel* channel, std::vector<DataFinding>* findings);

}  // namespace phs::measurement
