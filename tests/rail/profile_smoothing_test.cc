#include "rail/profile_smoothing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <sstream>
#include <vector>

#include "rail/profile.h"

namespace phs::rail {
namespace {

TEST(Smoothing, LeavesArcsAndHalvesItsWavelength) {
  std::vector<double> y, z;
  for (int i = 0; i <= 400; ++i) {
    y.push_back(0.25e-3 * i);
    z.push_back(2.0 * y.back() * y.back());
  }
  std::vector<double> sy = y, sz = z;
  SmoothOutline(5e-3, &sy, &sz);
  for (size_t i = 0; i < sy.size(); ++i) EXPECT_NEAR(sz[i], 2 * sy[i] * sy[i], 2e-7);
  // A ripple of 1 um on a straight line.
  for (const auto& [length, left] : {std::pair{5e-3, 0.5}, {2.5e-3, 1.0 / 65}, {20e-3, 1.0}}) {
    sy = y;
    sz = y;
    for (double& v : sz) v = 1e-6 * std::sin(2 * std::numbers::pi * v / length);
    SmoothOutline(5e-3, &sy, &sz);
    double peak = 0;
    for (size_t i = sy.size() / 3; i < 2 * sy.size() / 3; ++i) peak = std::max(peak, sz[i]);
    EXPECT_NEAR(peak / 1e-6, left, 0.03) << length;
  }
}

// A measured rail head: radius 200 mm, noise of 10 um at points 0.2 mm apart.
TEST(Smoothing, KeepsTheCurvatureOfANoisyMeasuredRail) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.01);  // [mm]
  std::ostringstream text;
  text << "# smoothing_mm: 12\n";
  for (double y = -34; y <= 34; y += 0.2) {
    text << y << " " << 200 - std::sqrt(200.0 * 200 - y * y) + noise(random) << "\n";
  }
  const auto p = ParseProfile(text.str(), "worn", ProfileKind::kRail);
  ASSERT_TRUE(p.ok()) << p.error().Line();
  for (double y = -0.02; y <= 0.02; y += 1e-3) {
    const Profile::Sample s = p.value().At(y);
    EXPECT_NEAR(s.z, 0.2 - std::sqrt(0.04 - y * y), 10e-6);
    EXPECT_NEAR(s.second / std::pow(1 + s.slope * s.slope, 1.5), 5, 1.5) << y;
  }
}

TEST(Smoothing, AWrongWavelengthIsNamedWithItsLine) {
  const auto p = ParseProfile("1 2\n# smoothing_mm: x\n", "worn", ProfileKind::kRail);
  ASSERT_FALSE(p.ok());
  EXPECT_NE(p.error().Line().find("worn:2"), std::string::npos);
}

}  // namespace
}  // namespace phs::rail
