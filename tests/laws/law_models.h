// Models and tracks written for one law each: coned wheels, linear creep, nothing else.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace phs::laws {

/// A folder for the files of one test; gone afterwards.
class TestFolder {
 public:
  TestFolder() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    path_ = std::filesystem::path(testing::TempDir()) /
            (std::string("phs_") + info->test_suite_name() + "_" + info->name());
    std::filesystem::create_directories(path_);
  }
  ~TestFolder() { std::filesystem::remove_all(path_); }
  std::string Write(const std::string& name, const std::string& text) const {
    const std::string file = (path_ / name).string();
    std::ofstream(file) << text;
    return file;
  }

 private:
  std::filesystem::path path_;
};

/// Straight track on 1067 mm gauge.
inline std::string StraightTrack(double length) {
  return fmt::format(
      "name: law_straight\ngauge_m: 1.067\nsegments:\n  - {{kind: tangent, length_m: {}}}\n", length);
}

/// Tangent, transition, arc canted for equilibrium at `speed`.
inline std::string CurvedTrack(double radius, double speed, const std::string& hand = "left") {
  const double base = 1.067 + 0.07;
  const double cant = base * std::sin(std::atan(speed * speed / (9.81 * radius)));
  return fmt::format(
      "name: law_curve\ngauge_m: 1.067\ncant_base_m: {0}\nsegments:\n"
      "  - {{kind: tangent, length_m: 30}}\n  - {{kind: transition, length_m: 60}}\n"
      "  - {{kind: curve, radius_m: {1}, hand: {2}, length_m: 300, cant_m: {3:.9f}}}\n"
      "  - {{kind: transition, length_m: 60}}\n  - {{kind: tangent, length_m: 30}}\n",
      base, radius, hand, cant);
}

/// One free wheelset: boxes that do not spin (light) and the spinning wheelset.
inline std::string FreeWheelset(double mass, double radius) {
  return fmt::format(
      "<mujoco model='free_wheelset'><size nuserdata='96'/>"
      "<option timestep='0.0005' gravity='0 0 -9.81'><flag contact='disable' "
      "constraint='disable'/></option><worldbody><body name='boxes' pos='0 0 {1}'><freejoint/>"
      "<inertial pos='0 0 0' mass='1' diaginertia='0.5 0.5 0.5'/><body name='wheelset'>"
      "<joint name='spin' axis='0 1 0'/><inertial pos='0 0 0' mass='{0}' diaginertia='{2} {3} {2}'/>"
      "</body></body></worldbody><custom><numeric name='phs_wheel_radius_m' data='{1}'/>"
      "<tuple name='wheelset:lead'><element objtype='body' objname='wheelset'/>"
      "<element objtype='joint' objname='spin'/></tuple></custom>"
      "<keyframe><key name='test'/></keyframe></mujoco>",
      mass, radius, 0.4 * mass, 0.1 * mass);
}

}  // namespace phs::laws
