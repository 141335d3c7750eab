// What hangs on the driven end of a bench, or of a cylinder on a rig behind its load cell.
#pragma once

#include <memory>
#include <vector>

#include "hydraulics/extra_series.h"

namespace phs::hydraulics {

/// How the driven end moves, sample by sample.
struct LoadMotion {
  double step_s;                            ///< between samples
  const std::vector<double>& acceleration;  ///< [m/s2]
  const std::vector<double>& pressure;      ///< of the bench's channel [Pa]; empty: none
  const std::vector<double>& position;      ///< [m]
  const std::vector<double>& speed;         ///< [m/s]
  double t0_s;                              ///< of the first sample
  const ExtraSeries* extra;                 ///< further measured channels; null: none
};

/// Adds its force, tension > 0, to that of every sample [N]; starts from rest.
class LoadLaw {
 public:
  virtual ~LoadLaw() = default;
  virtual void Add(const LoadMotion& motion, std::vector<double>* force) const = 0;
};
using LoadLaws = std::vector<std::unique_ptr<const LoadLaw>>;

}  // namespace phs::hydraulics
