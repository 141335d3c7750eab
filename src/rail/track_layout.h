// The track file (YAML, docs/tracks.md) read into plain parameters: every value checked on its own;
// how segments fit together is checked by Alignment::Create.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "base/result.h"
#include "rail/alignment.h"
#include "rail/irregularity.h"
#include "rail/irregularity_psd.h"
#include "rail/track_frame.h"

namespace phs::rail {

/// Irregularities as named in the file: from a record or from a spectrum.
struct IrregularityLayout {
  std::optional<IrregularitySamples> samples;  ///< of a record
  IrregularityPsdParams psd;                   ///< used when there are no samples
  double fade = 20;                            ///< [m]
};

struct TrackLayout {
  std::string name;
  double gauge = 1.067;         ///< between the gauge faces [m]
  double gauge_height = 0.014;  ///< depth below rail top where the gauge is measured [m]
  double friction = std::numeric_limits<double>::quiet_NaN();
  AlignmentParams alignment;
  RailSupport support;
  bool mirrored = false;  ///< irregularities are mirrored with the track
  std::optional<IrregularityLayout> irregularity;
};

/// Reads a track file, following `mirror_of`. `mirror` swaps left and right; `speed_m_s` of the run
/// says how short the waves of a spectrum are taken (FinestWavelength).
Result<TrackLayout> ReadTrackLayout(const std::string& path, bool mirror, double speed_m_s);

/// Puts `errors` on top of the design: cant of the curves and what their transitions take from it,
/// gauge of every segment.
Status ApplyErrors(const TrackErrors& errors, TrackLayout* layout);

}  // namespace phs::rail
