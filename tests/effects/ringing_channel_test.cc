// A channel that rings: T² y'' + 2 D T y' + y = u against what oscillators are known for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

std::vector<double> Rung(double time_s, double damping, double step_s, std::vector<double> signal,
                         double share = 1) {
  const PhsSystem s = Compile(With(Quarter(), "sensor_delay",
                                   {{"load_s", time_s}, {"damping", damping}, {"share", share}}));
  for (const auto& law : s.readings(0, hydraulics::Sensor::kLoad)) law->Lag(step_s, &signal);
  return signal;
}

/// Largest of the last tenth.
double Amplitude(const std::vector<double>& y) {
  const auto begin = y.begin() + static_cast<long>(y.size() - y.size() / 10);
  return *std::max_element(begin, y.end());
}

// At its own frequency a sine comes out 1/(2 D) times as large, at √2 times that as
// 1/√(1 + 8 D²), far below as it is.
TEST(RingingChannel, ASineComesOutAsOfAnOscillator) {
  const double T = 0.01, step = 2e-4;
  for (const double D : {0.05, 0.3, 0.9}) {
    for (const auto& [ratio, gain] : {std::pair(1.0, 1 / (2 * D)),
                                      {std::sqrt(2.0), 1 / std::sqrt(1 + 8 * D * D)},
                                      {0.01, 1.0}}) {
      std::vector<double> u(400000);  // its last tenth holds a swing of the slowest
      for (size_t i = 0; i < u.size(); ++i) {
        u[i] = std::sin(ratio / T * step * static_cast<double>(i));
      }
      EXPECT_NEAR(Amplitude(Rung(T, D, step, u)) / gain, 1, 2e-3) << D << " " << ratio;
    }
  }
}

// A step rings at √(1 - D²)/T and overshoots by exp(-pi D/√(1 - D²)).
TEST(RingingChannel, AStepOvershootsByItsDamping) {
  const double T = 0.02, D = 0.2, step = 1e-4;
  std::vector<double> u(4000, 1.0);
  u[0] = 0;
  const auto y = Rung(T, D, step, u);
  const auto most = std::max_element(y.begin(), y.end());
  const double w = std::sqrt(1 - D * D);
  EXPECT_NEAR(*most, 1 + std::exp(-M_PI * D / w), 1e-3);
  EXPECT_NEAR(static_cast<double>(most - y.begin()) * step, M_PI * T / w, 2 * step);
}

// Of a step the share overshoots; the rest is there at once. A share below zero undershoots.
TEST(RingingChannel, AFrameRingsInPart) {
  const double T = 0.02, D = 0.2, step = 1e-4;
  std::vector<double> u(4000, 1.0);
  u[0] = 0;
  const double beyond = std::exp(-M_PI * D / std::sqrt(1 - D * D));
  for (const double share : {0.3, -0.2}) {
    const auto y = Rung(T, D, step, u, share);
    EXPECT_NEAR(y[1], 1 - share, 1e-3);
    const auto [least, most] = std::minmax_element(y.begin() + 200, y.end());
    EXPECT_NEAR(share > 0 ? *most : *least, 1 + share * beyond, 1e-3) << share;
    EXPECT_NEAR(y.back(), 1, std::abs(share) * std::exp(-D / T * 0.39)) << "it rings out";
  }
}

// A ramp comes 2 D T late at last, in however few samples.
TEST(RingingChannel, ARampComesLate) {
  const double T = 0.02, D = 0.4;
  for (const double step : {1e-3, 5e-3, 2e-2}) {
    std::vector<double> ramp(static_cast<size_t>(1 / step));
    for (size_t i = 0; i < ramp.size(); ++i) ramp[i] = 1e3 * step * static_cast<double>(i);
    EXPECT_NEAR(Rung(T, D, step, ramp).back(), ramp.back() - 1e3 * 2 * D * T, 1e-3) << step;
  }
}

// Small steps about a pressure: behind a bubble with n = 1 the frequency goes with the pressure.
TEST(RingingChannel, ABubbleRingsAsItsPressureSays) {
  const double T = 0.02, D = 0.1, step = 1e-4;
  for (const double pressure : {1e6, 2e6, 6e6}) {
    std::vector<double> u(8000, pressure + 1e3);
    u[0] = pressure;
    const PhsSystem s =
        Compile(With(Quarter(), "sensor_delay", {{"p_bore_s", T}, {"damping", D}, {"bubble", 1}}));
    for (const auto& law : s.readings(0, hydraulics::Sensor::kBorePressure)) law->Lag(step, &u);
    const auto most = std::max_element(u.begin(), u.end());
    const double half_swing = M_PI * T * 2e6 / pressure / std::sqrt(1 - D * D);
    EXPECT_NEAR(static_cast<double>(most - u.begin()) * step / half_swing, 1, 0.01) << pressure;
  }
}

TEST(RingingChannel, IsNoFilterToo) {
  const auto both = hydraulics::PhsSystem::Create(
      With(Quarter(), "sensor_delay", {{"load_s", 0.01}, {"damping", 0.3}, {"poles", 2}}),
      &Catalogue());
  ASSERT_FALSE(both.ok());
  EXPECT_NE(both.error().Line().find("poles and damping"), std::string::npos);
}

}  // namespace
}  // namespace phs::effects
