// What an identification is asked to do: rig, declared model, measured runs and their windows.
//
// `data` may name environment variables: ${PHS_EMPS_DIR}/emps_train.csv.
//
//   rig: quarter            # cylinder | quarter | full | element | steps | bogie
//   model: quarter_setup2   # name in models/phs, or a path
//   data: run01.csv
//   estimation: [0.0, 79.0]     # s
//   validation: [79.0, 128.0]   # s, never used for fitting or choosing
//
// Beyond that, where wanted:
//   runs: [{data: a.csv, estimation: [0, 60], validation: [60, 90]}, …]   instead of the three
//   runs: [{model: quarter_setup2, data: table.csv}, …], shared: [lines.oil_volume_m3, …]
//                                         a model (of a step table also `setup:`) each; the
//                                         numbers that all runs share, the others are own
//   columns: {x_m: x_mm, force_N: F_N}    names in the file, where they differ; the unit is read
//                                         from the ending: _mm, _ms, _bar, _MPa, _kPa, _kN, …
//   factors: {force_N: 35.15}             on top of that, for a channel given in another quantity
//   free: [L1.gas_volume_m3, …]           free parameters of the baseline, instead of the usual
//   candidates: [cant_error, …]           effects to look for, instead of all (rigs, element
//                                         bench and bogie; on rigs also unlisted: a formula)
//   candidates: {coil_drag: {where: …}}   laws of one's own, beside them (own_candidate.h)
//   extra: {coil_V: u_coil}               further channels for such laws: NAME_UNIT: column
//   compare_below_Hz: 40                  element bench: model and measurement are compared below
//                                         this frequency, both filtered alike (band_limit.h)
//   low_pass_Hz: 20                       all channels, forwards and backwards (no lag)
//   ways: predicted                       bogie: forces and pressures as its run has them, though
//                                         all pistons are measured (identify/models/measured_ways.h)
//   signal: {duration_s: 40, actuator_m: {kind: sine, …}}   generated motion instead of data
//   setup: 2                              rows of a step table (default: by the model's name)
//   limits: {stroke_m: [-2e-3, 3e-3], speed_m_s: 0.02, force_N: 8e4, duration_s: 60}
//                                         what the rig can do in a next test; as far as the record
//                                         went where not said, and 60 s
//   beam: {lever_m: 1.0, …}, substeps: 1  how the rig is simulated (full rig, time step)
//   actuators: 4                          full rig: all pistons driven, no beam
//   driven_by: force, moving_mass_kg: 30  one cylinder: a force instead of a position; `pressure`:
//                                         position and both pressures given, force predicted
//   driven_by: force                      a part on a bench: the force is given, x_m predicted
//   phs_parameters: {temperature_K: 253}  changes of the declared model, as in a scenario; with
//   effects: {…}, failures: [{…}]         effects beside its own, and failures at their times
//   compare_with: quarter_sine            phs rig: another manifest, whose prediction this one is
//                                         compared with (rig_numbers.h)
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "measurement/own_candidate.h"
#include "phs_model/phs_model.h"
#include "rigs/rig_model.h"
#include "rigs/rig_signal.h"

namespace phs::measurement {

/// Half-open span of time [s].
struct Window {
  double begin = 0;
  double end = 0;
  bool empty() const { return !(end > begin); }
  bool Contains(double t) const { return t >= begin && t < end; }
};

struct RunSpec {
  std::string data;  ///< path, already resolved against the manifest's folder
  Window estimation, validation;
  std::string model;  ///< of this run; empty: the manifest's
  int setup = 0;      ///< step tables: of this run; 0: the manifest's
};

/// What a rig can do, as far as the manifest says so; 0: not said.
struct TestLimits {
  Window stroke_m;  ///< of the driven position
  double speed_m_s = 0, force_N = 0, duration_s = 0;
};

struct Manifest {
  std::string path;
  std::string rig;
  std::string model;  ///< name, or path already resolved against the manifest's folder
  std::vector<RunSpec> runs;
  std::map<std::string, std::string> columns;  ///< our channel -> column of the file
  std::map<std::string, double> factors;       ///< our channel -> factor
  std::vector<std::string> free;
  std::vector<std::string> shared;  ///< of runs with a model each: numbers with one value for all
  std::vector<std::string> candidates;  ///< of the catalogue; empty: all
  std::vector<OwnCandidate> own;        ///< the user's, beside them
  std::vector<std::string> extra;       ///< further channels, with unit; columns are in `columns`
  double low_pass_Hz = 0;               ///< 0: none
  bool measured_ways = true;            ///< of a bogie: taken where all pistons are measured
  double compare_below_Hz = 0;          ///< 0: all frequencies
  std::optional<rigs::RigSignals> signal;  ///< then no run is read
  int setup = 0;                           ///< of a step table; 0: by the model's name
  rigs::RigOptions options;
  phs_model::PhsChanges changes;  ///< of the declared model
  TestLimits limits;
  std::string compare_with;  ///< manifest, name or path already resolved; empty: none
};

/// A manifest as a user names it: one that ships ("quarter_sine", "lowe/fig_6_10"), or a file.
Result<std::string> FindManifest(const std::string& name);
/// Those that ship.
std::vector<std::string> ListManifests();

/// Cylinder, quarter, full, element: driven over time, by one motion.
bool HasClock(const Manifest& manifest);
inline constexpr char kRigsWithClock[] = "cylinder, quarter, full, element";

enum class WindowNeed {
  kEstimation,  ///< some run has an estimation window, nothing is generated: to fit
  kNone,        ///< to run only
};
Result<Manifest> LoadManifest(const std::string& path, WindowNeed need = WindowNeed::kEstimation);

/// One run of a manifest, with its model, as a manifest of its own.
Manifest OfRun(const Manifest& manifest, size_t run);
/// True if the runs have models, and so numbers, of their own.
bool HasOwnModels(const Manifest& manifest);

/// The declared model of a manifest with its changes; a quarter model on the full rig is spread
/// over its cylinders. `name`: that of one of its runs; empty: the manifest's.
Result<hydraulics::PhsParams> DeclaredModel(const Manifest& manifest, const std::string& name = "");

}  // namespace phs::measurement
