// How the leading wheels lie on their rails at instants of a run.
//
// Recorded are the wheelset's lateral position, angle of attack, speed and slip and each wheel's load
// Q. Sought are height z (downwards) and roll of the wheelset at which rail::WheelRail, with the
// creep law of the run, gives both wheels the recorded load:
//     Q_left(z, roll) = Q_left recorded,  Q_right(z, roll) = Q_right recorded
// by a root in z for each wheel (rail/height_under_load.h) and by equal heights of both in roll. The patches
// are those found there. Left away: rates of roll and height (they change creepage on a flange), so
// what is found is the contact of a quiet run.
#pragma once

#include <array>
#include <vector>

#include "report/replay.h"
#include "view/stage.h"

namespace phs::film {

/// One wheel at one instant; the patches stand in C axes (rail/frames.h).
struct WheelOnRail {
  bool found = false;
  rail::WheelRailForces forces;
  double roll = 0;    ///< C axes [rad]
  double height = 0;  ///< z of the wheelset's centre, C axes [m]
};
/// Left and right, by rail::Side.
std::array<WheelOnRail, 2> FindWheelsOnRails(const view::Picture& picture,
                                             const rail::WheelRail& law, size_t wheelset);

/// Contact of the vehicle with the creep law of its run: pictures need none.
Result<rail::WheelRail> LawOfRun(const view::ViewModel& model, const vehicle::Scenario& scenario);

/// Left and right wheel of the leading wheelset over all instants.
class ContactFilm {
 public:
  /// `law` must outlive it.
  ContactFilm(const view::ViewModel& model, const rail::WheelRail& law);
  /// After the stage's SetMoment without magnification.
  void Add(const view::Picture& picture);
  void Finish(report::ReplayBogie* bogie) const;

 private:
  const rail::WheelRail& law_;
  bool has_profiles_ = false;
  std::vector<report::ReplayWheel> wheels_;
  std::vector<std::array<double, 2>> wheel_outline_, rail_outline_;
};

}  // namespace phs::film
