// Two wheelsets of one frame, for bending and shear.
#pragma once

#include <string>
#include <vector>

#include "plugin/binding.h"

namespace phs::plugin {

/// Wheelsets named "lead" and "trail" with a common prefix.
struct BogiePair {
  std::string prefix;  ///< "" or "front_"
  int lead = -1;
  int trail = -1;
};

/// Finds the pairs among the wheelsets by their names.
std::vector<BogiePair> FindBogies(const Binding& binding);

}  // namespace phs::plugin
