// The rigs of the thesis as models: a PHS driven by measured or generated motion on a uniform
// clock. `phs rig` and the identification call the same object; thousands of runs are made per fit.
//
//   cylinder  one cylinder, bore chamber closed, driven
//   quarter   cylinder "1", lines of its bore and rod side
//   full      cylinders 1 and 2 driven by actuators, 3 and 4 on a beam hinged at the frame (bogie
//             yaw of the trailing axle), with the beam's own inertia, friction and play; or all
//             four driven (RigOptions::actuators)
//   steps     a quarter rig moved in steps and held (Table B-1), see steps_table.h
//   element   any part moved by a prescribed motion (element_bench.h)
//
// Channel names are those of the measured data: quarter and cylinder
// `piston_m,load_cell_N,p_bore_Pa,p_rod_Pa` from `actuator_m`; full `piston1_m…piston4_m,
// load1_N…load4_N,pL1_Pa…pL4_Pa` from `actuator1_m,actuator2_m`; element `force_N` from `x_m`
// (optionally `v_m_s`, `p_Pa`, `temperature_K`), or `x_m` from `force_N` (element_drive.h). One
// cylinder may be driven by `force_N` instead, or its `p_bore_Pa, p_rod_Pa` given beside
// `actuator_m` (RigOptions::driven_by). Signs: extension > 0, tension > 0; pressures absolute.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "hydraulics/phs_params.h"
#include "hydraulics/phs_system.h"
#include "rigs/rig.h"

namespace phs::rigs {

class RigModel {
 public:
  /// Checks that the model fits the rig (number of cylinders, effects known, ranges).
  static Result<RigModel> Create(RigKind kind, const hydraulics::PhsParams& params,
                                 const RigOptions& options = {});
  RigModel(RigModel&&) noexcept;
  RigModel& operator=(RigModel&&) noexcept;
  ~RigModel();

  RigKind kind() const;
  /// Driving channels, e.g. {"actuator_m"}.
  const std::vector<std::string>& input_names() const;
  /// Predicted channels, e.g. {"piston_m","load_cell_N","p_bore_Pa","p_rod_Pa"}.
  const std::vector<std::string>& output_names() const;
  const hydraulics::PhsSystem& system() const;

  /// Simulates the whole motion. Deterministic, thread-safe. Errors: shapes that do not match,
  /// numbers that are not finite.
  Status Run(const RigMotion& motion, RigPrediction* prediction) const;
  /// The same from what was kept of an earlier run on this motion by a model with the same KeptOf;
  /// null: computed, and kept in `kept` (stays null for a bench and for a cylinder driven by force or
  /// pressures).
  Status Run(const RigMotion& motion, RigPrediction* prediction,
             std::shared_ptr<const KeptRun>* kept) const;

 private:
  struct Impl;
  explicit RigModel(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// The part of a model that what is kept of a run depends on. One cylinder on rigid mountings: all
/// but friction, instruments and what else acts on forces alone. With several cylinders, or
/// mountings that yield, friction acts back on the pressures: all but the instruments.
hydraulics::PhsParams KeptOf(RigKind kind, const hydraulics::PhsParams& params);

}  // namespace phs::rigs
