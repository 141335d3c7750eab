#include "screen/player.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

namespace phs::screen {

const std::vector<KeyRow>& Keys() {
  static const std::vector<KeyRow> kKeys = {
      {GLFW_KEY_SPACE, "Space", "run or pause", [](Player& p, bool) { p.running_ = !p.running_; }},
      {GLFW_KEY_RIGHT, "Right", "pause, one recorded step on (Shift: ten)",
       [](Player& p, bool shift) {
         p.running_ = false;
         p.SetTime(p.time_ + (shift ? 10 : 1) * p.interval_s_);
       }},
      {GLFW_KEY_LEFT, "Left", "pause, one recorded step back (Shift: ten)",
       [](Player& p, bool shift) {
         p.running_ = false;
         p.SetTime(p.time_ - (shift ? 10 : 1) * p.interval_s_);
       }},
      {GLFW_KEY_UP, "Up", "twice as fast",
       [](Player& p, bool) { p.speed_ = std::min(64.0, 2 * p.speed_); }},
      {GLFW_KEY_DOWN, "Down", "half as fast",
       [](Player& p, bool) { p.speed_ = std::max(1.0 / 64, 0.5 * p.speed_); }},
      {GLFW_KEY_HOME, "Home", "to the begin", [](Player& p, bool) { p.SetTime(p.begin_s_); }},
      {GLFW_KEY_END, "End", "to the end", [](Player& p, bool) { p.SetTime(p.end_s_); }},
      {GLFW_KEY_V, "V", "next camera (Shift: the one before)",
       [](Player& p, bool shift) {
         const int count = static_cast<int>(view::Views().size());
         const int at = static_cast<int>(p.view_ - view::Views().data());
         p.view_ = &view::Views()[static_cast<size_t>((at + (shift ? count - 1 : 1)) % count)];
         p.swing_ = {};
         p.look_.contacts = p.view_->target == view::Target::kContact;
       }},
      {GLFW_KEY_Z, "Z", "camera as it was", [](Player& p, bool) { p.swing_ = {}; }},
      {GLFW_KEY_F, "F", "arrows of forces",
       [](Player& p, bool) { p.look_.forces = !p.look_.forces; }},
      {GLFW_KEY_C, "C", "outlines of wheels, places of contact",
       [](Player& p, bool) { p.look_.contacts = !p.look_.contacts; }},
      {GLFW_KEY_Y, "Y", "yaw drawn 1, 10, 20, 50 times (Shift: sideways)",
       [](Player& p, bool shift) {
         double& factor = shift ? p.look_.magnify.lateral : p.look_.magnify.yaw;
         factor = factor < 10 ? 10 : factor < 20 ? 20 : factor < 50 ? 50 : 1;
       }},
      {GLFW_KEY_B, "B", "car body", [](Player& p, bool) { p.look_.body = !p.look_.body; }},
      {GLFW_KEY_N, "N", "next bogie of the result",
       [](Player& p, bool) { p.vehicle_ = (p.vehicle_ + 1) % p.vehicles_; }},
      {GLFW_KEY_G, "G", "another bogie as a ghost", [](Player& p, bool) { p.ghost_ = !p.ghost_; }},
      {GLFW_KEY_P, "P", "plots", [](Player& p, bool) { p.plots_ = !p.plots_; }},
      {GLFW_KEY_H, "H", "these keys", [](Player& p, bool) { p.help_ = !p.help_; }},
      {GLFW_KEY_ESCAPE, "Esc", "end", [](Player& p, bool) { p.done_ = true; }},
  };
  return kKeys;
}

std::string KeyHelp() {
  std::string help;
  for (const KeyRow& row : Keys()) help += std::string(row.name) + ": " + row.text + "\n";
  return help + "mouse: left turns, right shifts, wheel nears";
}

Player::Player(const view::Request& request, double begin_s, double end_s, double interval_s,
               int vehicles)
    : view_(view::FindView(request.view)),
      look_(view::LookOf(request)),
      begin_s_(begin_s),
      end_s_(end_s),
      interval_s_(interval_s),
      vehicles_(vehicles),
      time_(std::max(begin_s, request.from)),
      speed_(request.speed) {}

void Player::SetTime(double time) { time_ = std::clamp(time, begin_s_, end_s_); }

void Player::Advance(double seconds) {
  if (!running_) return;
  SetTime(time_ + speed_ * seconds);
  if (time_ >= end_s_) running_ = false;
}

bool Player::Press(int key, bool shift) {
  for (const KeyRow& row : Keys()) {
    if (row.key != key) continue;
    row.press(*this, shift);
    return true;
  }
  return false;
}

mjvCamera Player::CameraOf(const view::Stage& stage) const {
  mjvCamera camera = stage.CameraOf(*view_);
  camera.azimuth += swing_.azimuth_deg;
  camera.elevation = std::clamp(camera.elevation + swing_.elevation_deg, -89.9, 89.9);
  camera.distance *= swing_.zoom;
  for (int i = 0; i < 3; ++i) camera.lookat[i] += swing_.shift[i];
  return camera;
}

void Player::Drag(bool turn, double dx, double dy) {
  constexpr double kDegrees = 180;
  if (turn) {
    swing_.azimuth_deg -= kDegrees * dx;
    swing_.elevation_deg -= kDegrees * dy;
    return;
  }
  const double distance = view_->distance_m * swing_.zoom;
  const double azimuth = (view_->azimuth_deg + swing_.azimuth_deg) * M_PI / 180;
  swing_.shift[0] -= dx * distance * std::sin(azimuth);
  swing_.shift[1] += dx * distance * std::cos(azimuth);
  swing_.shift[2] += dy * distance;
}

void Player::Zoom(double steps) {
  swing_.zoom = std::clamp(swing_.zoom * std::pow(0.9, steps), 0.02, 20.0);
}

}  // namespace phs::screen
