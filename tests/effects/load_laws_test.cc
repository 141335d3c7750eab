// What hangs on the driven end, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

/// Force of the load on a bench whose end is accelerated by 1 m/s2 from t = 0 on, sample by sample.
std::vector<double> ForceUnderAcceleration(double mass, double frequency, double damping,
                                           double step, int samples) {
  PhsParams bench;
  bench.name = "part";
  bench.cylinders.push_back({});
  bench.cylinders[0].name = "1";
  bench.friction.model = FrictionModel::kNone;
  bench = With(bench, "load_flexibility",
               {{"mass_kg", mass}, {"frequency_Hz", frequency}, {"damping_ratio", damping}});
  const PhsSystem system = Compile(bench);
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

}  // namespace
}  // namespace phs::effects
