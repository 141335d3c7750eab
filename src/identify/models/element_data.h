// Measured runs of a part on a bench (rig: element), made ready for fitting.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "hydraulics/phs_params.h"
#include "measurement/band_limit.h"
#include "measurement/manifest.h"
#include "measurement/rig_data.h"
#include "rigs/rig_model.h"

namespace phs::identify::element {

/// One run. "Rows" are the samples that are compared: thinned to the compared band.
struct ElementRecord {
  std::string source;
  rigs::RigMotion motion;               ///< smoothed, full rate
  std::vector<double> speed_deviation;  ///< standard deviation of motion.speed_m_s[0]
  std::vector<double> force_N;          ///< full rate, gaps bridged
  double start_m = 0, start_m_s = 0;    ///< where a force takes it up
  measurement::BandLimit band{1, 0};
  std::vector<double> row_force_N;   ///< in the band
  std::vector<double> row_value;     ///< of what is compared, in the band
  std::vector<int> row_sample;       ///< full-rate sample of each row
  std::vector<char> fitted, scored;  ///< row in the estimation, in the validation window
  std::shared_ptr<const hydraulics::ExtraSeries> extra;  ///< further channels; null: none
  measurement::Window estimation, validation;

  double Time(int sample) const { return motion.t0_s + sample * motion.step_s; }
  /// True if row `k` lies in the estimation window, whether it takes part or not.
  bool InEstimation(size_t k) const { return estimation.Contains(Time(row_sample[k])); }
};

struct ElementData {
  std::vector<ElementRecord> records;
  bool by_force = false;             ///< the force drives and the position is compared
  std::string compared = "force_N";  ///< or "x_m"
  double noise = 0;                  ///< of what is compared, in the band
  double force_noise_N = 0, position_noise_m = 0;
  bool has_pressure = false, has_temperature = false;
  double compare_below_Hz = 0;
  std::vector<std::string> candidates;             ///< effects to look for; empty: all
  std::vector<measurement::OwnCandidate> own;      ///< and the user's own
  std::vector<measurement::DataFinding> findings;  ///< what was found wrong, and left out
  /// A motion that lies above a quarter of its sampling rate most of the time.
  std::optional<Error> too_fast;

  int CountRows(bool fitted) const;
};

/// Reads and checks every run of the manifest. Errors say what cannot be identified and why.
Result<ElementData> ReadElementData(const measurement::Manifest& manifest);

}  // namespace phs::identify::element
