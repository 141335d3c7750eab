// A shape that swings, seen from above: a mode of vibration, drawn at a phase that the reader moves
// or lets run. Each end of a line has its place at rest r and its complex motion m, and stands at
//   r + Re(m e^{i phi}) = r + Re(m) cos(phi) - Im(m) sin(phi),  phi growing with time.
// The motions are made here; the page's script (web/moving_shape.js) only turns the phase.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <vector>

namespace phs::report {

class ReportPage;

struct MovingPoint {
  double x = 0, y = 0;  ///< at rest: along the track, to the left [m]
  std::complex<double> dx = 0, dy = 0;
};

struct MovingLine {
  std::string name;  ///< of what is drawn; shown under the pointer
  int key = 0;       ///< into MovingShape::keys
  MovingPoint from, to;
  double width_px = 2;
  bool trace = false;  ///< faint, too, at the phases of MovingShape::traces_deg
  /// Growth of its length; drawn in the colour of `key` while positive, else of the next key.
  std::optional<std::complex<double>> stroke = {};
};

struct MovingShape {
  std::string title;
  struct Key {
    std::string label;
    int colour = 0, dash = 0;  ///< as of Curve (report_page.h)
  };
  std::vector<Key> keys;
  std::vector<MovingLine> lines = {};
  std::vector<int> traces_deg = {};
  double period_s = 4;  ///< of the running picture, from PlayedPeriod
};

/// A point that stays at (along, left) on a rigid body whose origin lies at `x` on the centre line,
/// moved by (dx, dy) and turned by a small yaw.
MovingPoint PointOfBody(double x, double along, double left, std::complex<double> dx,
                        std::complex<double> dy, std::complex<double> yaw);

/// Enlarges all motions alike until the largest is `drawn` [m]; nothing if nothing moves.
void Enlarge(double drawn, std::vector<MovingLine>* lines);

/// How long one period is in the picture: 4 s, longer only where the motion itself is slower.
double PlayedPeriod(double frequency_Hz);
/// The same in words, e.g. "Played 13.7 times slower than it is: one period in 4 s, not 0.293 s."
std::string PlayedWords(double frequency_Hz);
/// What a period leaves of a motion exp(growth t), in words; nothing for numbers that are not there.
std::string GrowthWords(double growth_1_s, double frequency_Hz);

void AddMovingShape(const MovingShape& shape, ReportPage* page);

}  // namespace phs::report
