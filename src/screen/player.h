// What a window shows: the moment, running or not, from where, with what. Keys are rows of a table.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "view/request.h"
#include "view/stage.h"

namespace phs::screen {

/// What the mouse has added to a view.
struct Swing {
  double azimuth_deg = 0, elevation_deg = 0;
  double zoom = 1;              ///< of the distance
  double shift[3] = {0, 0, 0};  ///< of the point looked at [m]
};

class Player {
 public:
  Player(const view::Request& request, double begin_s, double end_s, double interval_s,
         int vehicles);
  /// Time goes on by `seconds` of the clock.
  void Advance(double seconds);
  /// The key of a row of Keys(); false if there is none.
  bool Press(int key, bool shift);
  mjvCamera CameraOf(const view::Stage& stage) const;
  void Drag(bool turn, double dx, double dy);  ///< in heights of the window
  void Zoom(double steps);

  double time() const { return time_; }
  bool done() const { return done_; }
  bool running() const { return running_; }
  double speed() const { return speed_; }
  const view::Look& look() const { return look_; }
  int vehicle() const { return vehicle_; }  ///< which recording stands in front
  bool ghost() const { return ghost_; }
  bool plots() const { return plots_; }
  bool help() const { return help_; }
  void SetTime(double time);

 private:
  friend struct KeyRow;
  friend const std::vector<struct KeyRow>& Keys();

  const view::View* view_;
  view::Look look_;
  Swing swing_;
  double begin_s_, end_s_, interval_s_;
  int vehicles_;
  double time_;
  double speed_;
  int vehicle_ = 0;
  bool running_ = true, ghost_ = false, plots_ = true, help_ = false, done_ = false;
};

/// One key: its GLFW code, how it is called, what it does.
struct KeyRow {
  int key;
  const char* name;
  const char* text;
  void (*press)(Player& player, bool shift);
};
const std::vector<KeyRow>& Keys();
/// All keys, a line each.
std::string KeyHelp();

}  // namespace phs::screen
