// What hangs on the driven end, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "rigs/rig_model.h"
#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

/// A part without friction.
PhsParams Bench() {
  PhsParams bench;
  bench.name = "part";
  bench.cylinders.push_back({});
  bench.cylinders[0].name = "1";
  bench.friction.model = FrictionModel::kNone;
  return bench;
}

/// Force of the load on a bench whose end is accelerated by 1 m/s2 from t = 0 on, sample by sample.
std::vector<double> ForceUnderAcceleration(double mass, double frequency, double damping,
                                           double step, int samples) {
  const PhsSystem system =
      Compile(With(Bench(), "load_flexibility",
                   {{"mass_kg", mass}, {"frequency_Hz", frequency}, {"damping_ratio", damping}}));
  const auto n = static_cast<size_t>(samples);
  const std::vector<double> acceleration(n, 1.0), none, still(n, 0.0);
  std::vector<double> force(n, 0.0);
  for (const auto& law : system.loads()) {
    law->Add({step, acceleration, none, still, still, 0, nullptr}, &force);
  }
  return force;
}

// d" + 2 zeta w d' + w^2 d = -a, F = m (-(w^2 d + 2 zeta w d') - a), from rest:
//   F = -m a exp(-zeta w t) (cos(wd t) - zeta/sqrt(1 - zeta^2) sin(wd t)),  wd = w sqrt(1 - zeta^2).
TEST(LoadFlexibility, RingsAsAMassBehindASpring) {
  const double mass = 3, frequency = 20, w = 2 * M_PI * frequency;
  for (const double zeta : {0.02, 0.4}) {
    for (const double step : {1e-4, 4e-3}) {
      const auto force = ForceUnderAcceleration(mass, frequency, zeta, step, 40);
      const double root = std::sqrt(1 - zeta * zeta);
      for (size_t i = 0; i < force.size(); ++i) {
        const double t = step * static_cast<double>(i);
        const double expected = -mass * std::exp(-zeta * w * t) *
                                (std::cos(root * w * t) - zeta / root * std::sin(root * w * t));
        ASSERT_NEAR(force[i], expected, 1e-6 * mass) << i << " " << step << " " << zeta;
      }
    }
  }
}

// Behind a ramp of r, T dp'/dt = p - p' stays r (t - T (1 - exp(-t/T))).
TEST(PressureArea, OnABenchTrappedPressureThrustsLate) {
  const PhsSystem system =
      Compile(With(Bench(), "pressure_area", {{"area_m2", 2e-4}, {"late_s", 0.3}}));
  std::vector<double> pressure, force(400, 0.0);
  for (int i = 0; i < 400; ++i) pressure.push_back(1e6 * 0.005 * i);
  const std::vector<double> still(400, 0.0);
  ASSERT_EQ(system.loads().size(), 1u);
  system.loads()[0]->Add({0.005, still, pressure, still, still, 0, nullptr}, &force);
  for (const int i : {20, 60, 399}) {
    const double t = 0.005 * i, behind = 1e6 * (t - 0.3 * (1 - std::exp(-t / 0.3)));
    EXPECT_NEAR(force[i], 2e-4 * behind, 5e-3);
  }
}

/// F = A g(p - z p0), g = p (|p|/10 MPa)^0.4: where the load cell was set to zero with empty lines,
/// and with full ones.
TEST(PressureArea, OfAChamberAThrustIsThatBeyondWhereTheLoadCellWasZeroed) {
  const PhsParams p = Quarter();
  const auto plain = ChannelsOfASine(p, 0.001, 4000);
  const std::string line = p.cylinders[0].rod_line;
  double p0 = 0;
  for (const auto& l : p.lines) p0 = l.name == line ? l.static_pressure_Pa : p0;
  const auto g = [](double above) { return above * std::pow(std::abs(above) / 1e7, 0.4); };
  for (const double zeroed : {0.0, 1.0}) {
    PhsParams with = With(p, "pressure_area",
                          {{"area_m2", 3e-4}, {"exponent", 1.4}, {"zeroed_over_static", zeroed}});
    with.effects.back().targets = {line};
    const auto shown = ChannelsOfASine(with, 0.001, 4000);
    EXPECT_NEAR(shown[1][0] - plain[1][0], zeroed == 1 ? 0 : 3e-4 * g(p0), 1e-6);
    for (size_t i = 0; i < plain[3].size(); i += 50) {
      EXPECT_NEAR(shown[1][i] - plain[1][i], 3e-4 * g(plain[3][i] - zeroed * p0), 1e-6) << i;
    }
    EXPECT_EQ(shown[3], plain[3]) << "a force alone";
  }
}

/// Of a chamber, against the same equation in steps fifty times finer. In a rig's step the pressure
/// is that of its begin, so the thrust is half a step late.
TEST(PressureArea, OfAChamberTrappedPressureThrustsLate) {
  const PhsParams p = Quarter();
  PhsParams with = With(p, "pressure_area", {{"area_m2", 3e-4}, {"late_s", 0.1}});
  with.effects.back().targets = {p.cylinders[0].bore_line};
  const auto plain = ChannelsOfASine(p, 0.001, 4000), late = ChannelsOfASine(with, 0.001, 4000);
  double behind = 0, most = 0;
  for (size_t i = 0; i + 1 < plain[2].size(); ++i) {
    const double before = behind;
    for (int k = 0; k < 50; ++k) {
      const double now = plain[2][i] + (plain[2][i + 1] - plain[2][i]) * (k + 0.5) / 50;
      behind += 0.001 / 50 / 0.1 * (now - plain[2][0] - behind);
    }
    EXPECT_NEAR(late[1][i + 1] - plain[1][i + 1], 1.5e-4 * (before + behind), 0.05) << i;
    most = std::max(most, std::abs(3e-4 * behind));
  }
  EXPECT_GT(most, 100) << "so 0.05 N is small";
  EXPECT_EQ(late[2], plain[2]) << "a force alone";
}

}  // namespace
}  // namespace phs::effects
