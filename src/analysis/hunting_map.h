// The map of hunting: at which speed does hunting of a given amplitude keep itself up?
//
// The whole vehicle on straight track by harmonic balance (harmonic_balance.h): wheels on rails,
// seals and oil by the same rates as in a run in time, forward speed prescribed as by a heavy train
// (limit_cycle.h). Where the speed falls with the amplitude the motion is a brink: below it hunting
// dies, above it grows. Where it rises hunting is stable. The least speed of the map is the one
// below which hunting cannot live. The attitude of a root that is a free joint is taken to first
// order: its products with turning speeds are a thousandth of them.
//
// The map begins with the linear mode at the critical speed and follows its branch through the plane
// of amplitude and speed; the amplitude may fall again on the way, where wheels are at their flanges.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "analysis/harmonic_balance.h"
#include "analysis/stability.h"

namespace phs::analysis {

struct HuntingMapOptions {
  int harmonics = 5;
  int samples = 64;           ///< of one period
  double least_m = 2e-5;      ///< first amplitude
  double largest_m = 6.3e-3;  ///< last amplitude
  double ratio = 1.25;        ///< of one amplitude to the one before, at most
  double step_m = 1e-4;       ///< between them, at most; between speeds at most a twentieth
};

struct HuntingPoint {
  double amplitude = 0;           ///< lateral, of the leading wheelset, first harmonic [m]
  double speed = 0;               ///< [m/s]
  double frequency = 0;           ///< [1/s]
  double phs_power = 0;           ///< lost in the PHS, mean over a period: its seals [W]
  std::vector<double> harmonics;  ///< amplitudes of harmonics 2 … N of that motion [m]
};

/// `mode`: of the linear critical speed (AnalyseStability). Ends where no motion is found any more.
Result<std::vector<HuntingPoint>> FindHuntingMap(vehicle::Simulation* simulation,
                                                 const VibrationMode& mode,
                                                 const HuntingMapOptions& options,
                                                 const vehicle::Progress& progress = {});

/// Amplitudes at a speed, between the points [m]; NaN where the map has none. `brink`: where the
/// speed falls with the amplitude, a smaller motion dies and a larger one grows; `cycle`: above it.
struct HuntingAt {
  double brink = 0;
  double cycle = 0;
};
HuntingAt HuntingAtSpeed(const std::vector<HuntingPoint>& map, double speed);

/// The lowest point; null if it is an end of the map.
const HuntingPoint* LeastSpeed(const std::vector<HuntingPoint>& map);

/// `harmonics`, `least` (null where the map ends falling), `points`.
nlohmann::ordered_json HuntingMapJson(const std::vector<HuntingPoint>& map,
                                      const HuntingMapOptions& options);

}  // namespace phs::analysis
