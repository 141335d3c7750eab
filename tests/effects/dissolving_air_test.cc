// Air that dissolves with a lag: slopes are those of its values, energy is what is put in less what is
// lost.
#include "effects/dissolving_air.h"

#include <gtest/gtest.h>

#include <cmath>

namespace phs::effects {
namespace {

constexpr double kRest = 1.2e6;

LaggingAir Air(double exponent) { return LaggingAir({2e-6, exponent}, {6e6}, {0.3, 4}, kRest); }

double VolumeAt(const LaggingAir& air, double pressure, double memory) {
  double volume = 0, slope = 0;
  air.Add(pressure, memory, &volume, &slope);
  return volume;
}

TEST(LaggingAir, SlopesAreThoseOfVolumeAndRate) {
  for (const double exponent : {1.0, 1.4}) {
    const LaggingAir air = Air(exponent);
    for (const double p : {0.7e6, 2e6, 5e6}) {
      for (const double m : {-0.3, 0.0, 0.15}) {
        const hydraulics::MemoryRate at = air.Memory(p, m);
        const double dp = 10, dm = 1e-6;
        const double by_memory =
            (air.Memory(p, m + dm).rate - air.Memory(p, m - dm).rate) / (2 * dm);
        const double by_pressure =
            (air.Memory(p + dp, m).rate - air.Memory(p - dp, m).rate) / (2 * dp);
        EXPECT_NEAR(at.rate_slope / by_memory, 1, 1e-6) << p << " " << m;
        EXPECT_NEAR(at.rate_rise / by_pressure, 1, 1e-6) << p << " " << m;
        const double volume_rise = (VolumeAt(air, p, m + dm) - VolumeAt(air, p, m - dm)) / (2 * dm);
        EXPECT_NEAR(at.volume_rise / volume_rise, 1, 1e-6) << p << " " << m;
        double volume = 0, slope = 0;
        air.Add(p, m, &volume, &slope);
        EXPECT_NEAR(slope * 2 * dp / (VolumeAt(air, p + dp, m) - VolumeAt(air, p - dp, m)), 1,
                    1e-6);
      }
    }
  }
}

// Bubbles grow where the pressure is below that at which so much is free, with the time of release.
TEST(LaggingAir, GoesTowardsEquilibriumWithTheTimeOfItsDirection) {
  const LaggingAir air = Air(1);
  EXPECT_EQ(air.Memory(kRest, 0).rate, 0);
  const double range = 6e6 - hydraulics::kAtmosphere;
  EXPECT_NEAR(air.Memory(kRest - 0.5e6, 0).rate, 0.5e6 / range / 0.3, 1e-12);
  EXPECT_NEAR(air.Memory(kRest + 0.5e6, 0).rate, -0.5e6 / range / 4, 1e-12);
}

// dE = p dV - Loss dt, for steps of pressure and of memory apart: dt = dm/rate.
TEST(LaggingAir, EnergyIsWhatIsPutInLessWhatIsLost) {
  for (const double exponent : {1.0, 1.4}) {
    const LaggingAir air = Air(exponent);
    EXPECT_NEAR(air.Energy(kRest, 0), 0, 1e-9);
    for (const double p : {0.7e6, 2e6, 5e6}) {
      for (const double m : {-0.3, 0.15}) {
        const double dp = 100, dm = 1e-5;
        const double into = p * (VolumeAt(air, p + dp, m) - VolumeAt(air, p - dp, m));
        EXPECT_NEAR((air.Energy(p + dp, m) - air.Energy(p - dp, m)) / into, 1, 1e-6)
            << p << " " << m;
        const double change = air.Energy(p, m + dm) - air.Energy(p, m - dm);
        const double put_in = p * (VolumeAt(air, p, m + dm) - VolumeAt(air, p, m - dm));
        const double lost = air.Loss(p, m) / air.Memory(p, m).rate * 2 * dm;
        EXPECT_NEAR(change, put_in - lost, 1e-6 * (std::abs(put_in) + std::abs(lost)))
            << p << " " << m << " " << exponent;
        EXPECT_GE(air.Loss(p, m), 0) << p << " " << m;
      }
    }
  }
}

}  // namespace
}  // namespace phs::effects
