// A law of the user's own that a search is offered beside the catalogue (effects/own_law.h):
//
//   extra: {coil_V: u_coil}               # a further column of the record, under a name with unit
//   candidates:
//     coil_drag:
//       where: piston                     # or mounting, reading_N, reading_m, reading_Pa, volume, flow
//       expression: "k*z*coil/1[V]"
//       parameters: {k_N_per_m: [1.0e3, 1.0e6], z0_m: [1.0e-5, 1.0e-2]}   # ranges; amount first
//       states: {z_m: "v - abs(v)*z/z0"}  # dz/dt
//       targets: [L2]                     # of volume, flow, reading_Pa
//
// Numbers are sought inside their ranges, by factors where a range is positive and spans more than a
// factor 20. The first is the amount: without it the law is not there.
#pragma once

#include <string>
#include <vector>

#include "base/yaml.h"
#include "hydraulics/phs_params.h"

namespace phs::measurement {

struct OwnCandidate {
  struct Number {
    std::string name;  ///< with unit
    double low = 0, high = 0;
  };
  hydraulics::EffectParams effect;  ///< its numbers in the middle of their ranges
  std::vector<Number> numbers;      ///< in the order of the file
  std::string where;                ///< of the file, for messages: "m.yaml:7: candidates.coil_drag"
};

/// Reads the entry `name` of `candidates:`. `channels`: those of `extra:`. Errors go to the document.
OwnCandidate ReadOwnCandidate(YamlMap& candidates, const std::string& name,
                              const std::vector<std::string>& channels);
/// Every number of a law that was read well stands in it: of another the record says nothing.
Status CheckNumbersAreUsed(const OwnCandidate& own);

}  // namespace phs::measurement
