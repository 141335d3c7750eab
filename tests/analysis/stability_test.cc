// The linearised multibody model against published and independent results.
#include "analysis/stability.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "analysis/limit_cycle.h"
#include "vehicle/simulation.h"
#include "vehicle/tangent_state.h"

namespace phs::analysis {
namespace {

vehicle::Scenario Straight(const std::string& bogie, double speed) {
  vehicle::Scenario s;
  s.name = "stability";
  s.track = "straight";
  s.bogie = bogie;
  s.speed_m_s = speed;
  s.timestep_s = 1e-4;
  return s;
}

/// The seven published equations as a 14 x 14 system, written down apart from the multibody model:
/// (y1, psi1, y2, psi2, yf, psif, th) and their rates. Sources: see bogie_xml/cooperrider.xml.
Eigen::MatrixXd CooperriderMatrix(double speed) {
  constexpr double kMassW = 1022, kYawW = 678, kMassF = 2918, kYawF = 6780, kRollF = 6780;
  constexpr double k1 = 1.823e6, k2 = 3.646e6, k3 = 3.646e6, k4 = 0.1823e6, k5 = 0.3333e6;
  constexpr double k6 = 2.710e6, D1 = 20000, D2 = 29200, D6 = 500;
  constexpr double d1 = 0.620, d2 = 0.680, h1 = 0.0762, h2 = 0.6584, a = 0.7163, b = 1.074;
  constexpr double r0 = 0.4572, lambda = 0.05, fx = 6.563e6 / 0.60252, fy = 6.563e6 / 0.54219;
  using Row = Eigen::Matrix<double, 1, 14>;
  const auto unit = [](int i) { return Row(Row::Unit(i)); };
  const Row y[2] = {unit(0), unit(2)}, psi[2] = {unit(1), unit(3)};
  const Row yf = unit(4), psif = unit(5), th = unit(6);
  const auto rate = [](const Row& x) {  // x holds positions only
    Row out = Row::Zero();
    out.tail(7) = x.head(7);
    return out;
  };
  const Row A1 = 2 * k1 * (y[0] - yf - b * psif - h1 * th);
  const Row A2 = 2 * k1 * (y[1] - yf + b * psif - h1 * th);
  const Row A3 = 2 * k2 * d1 * d1 * (psi[0] - psif);
  const Row A4 = 2 * k2 * d1 * d1 * (psi[1] - psif);
  const Row A5 = 2 * D2 * (rate(yf) - h2 * rate(th)) + 2 * k4 * (yf - h2 * th);
  const Row A6 = k6 * psif + D6 * rate(psif);
  const Row A7 = 2 * D1 * d2 * d2 * rate(th) + (2 * k5 * d2 * d2 + 4 * k3 * d1 * d1) * th;
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(14, 14);
  m.topRightCorner(7, 7).setIdentity();
  for (int i = 0; i < 2; ++i) {
    const Row creep = 2 * fy * (rate(y[i]) / speed - psi[i]);
    const Row moment = 2 * fx * a * (a * rate(psi[i]) / speed + lambda / r0 * y[i]);
    m.row(7 + 2 * i) = (-(i == 0 ? A1 : A2) - creep) / kMassW;
    m.row(8 + 2 * i) = (-(i == 0 ? A3 : A4) - moment) / kYawW;
  }
  m.row(11) = (A1 + A2 - A5) / kMassF;
  m.row(12) = (b * (A1 - A2) + A3 + A4 - A6) / kYawF;
  m.row(13) = (h1 * (A1 + A2) + h2 * A5 - A7) / kRollF;
  return m;
}

double MatrixGrowth(double speed) {
  return CooperriderMatrix(speed).eigenvalues().real().maxCoeff();
}

TEST(StabilityTest, CooperriderBogieHasThePublishedCriticalSpeedWithinAThousandth) {
  // v0 = 68.66 m/s (B. Hassard, bifurcation.de, after Kaas-Petersen, Acta Mechanica 61 (1986) 89).
  auto simulation = vehicle::Simulation::Create(Straight("cooperrider", 60));
  ASSERT_TRUE(simulation.ok()) << simulation.error().Line();
  const auto result = AnalyseStability(&simulation.value(), {50, 90, 9});
  ASSERT_TRUE(result.ok()) << result.error().Line();
  EXPECT_NEAR(result.value().critical_speed / 68.66, 1, 1e-3);
  EXPECT_NEAR(std::abs(result.value().mode.eigenvalue.imag()) / (2 * std::numbers::pi), 4.0, 0.1);
}

TEST(StabilityTest, CooperriderMultibodyEigenvaluesAreThoseOfTheSevenEquations) {
  auto simulation = vehicle::Simulation::Create(Straight("cooperrider", 60));
  ASSERT_TRUE(simulation.ok()) << simulation.error().Line();
  for (const double speed : {20.0, 60.0, 68.66, 90.0}) {
    const auto spectrum = SpectrumAt(&simulation.value(), speed);
    ASSERT_TRUE(spectrum.ok());
    for (const std::complex<double> expected : CooperriderMatrix(speed).eigenvalues()) {
      double nearest = 1e300;
      for (const std::complex<double> ours : spectrum.value().eigenvalues) {
        nearest = std::min(nearest, std::abs(ours - expected));
      }
      // The wheels' vertical springs, which the equations do not have, are felt by the fastest
      // modes: creep against a wheelset's own mass, up to 1200 1/s.
      const double tolerance = std::abs(expected) > 100 ? 3e-2 : 1e-3;
      EXPECT_LT(nearest / std::abs(expected), tolerance) << speed << " m/s, " << expected;
    }
    EXPECT_NEAR(spectrum.value().growth, MatrixGrowth(speed), 0.01) << speed;
  }
}

TEST(StabilityTest, HuntingOfTheCooperriderBogieLivesBelowTheLinearCriticalSpeed) {
  // Flange contact and saturating creep make the bifurcation subcritical: the limit cycle reaches
  // below 68.66 m/s, and swings at the flange clearance of 9.1 mm or wider.
  vehicle::Scenario scenario = Straight("cooperrider", 60);
  scenario.timestep_s = 2.5e-4;
  auto simulation = vehicle::Simulation::Create(scenario);
  ASSERT_TRUE(simulation.ok()) << simulation.error().Line();
  VibrationMode mode;
  ASSERT_TRUE(SpectrumAt(&simulation.value(), 68.66, &mode).ok());
  LimitCycleOptions options;
  options.high_speed_m_s = 72;
  options.low_speed_m_s = 40;
  options.rate_m_s2 = 1;
  options.settling_s = 6;
  options.resolution_m_s = 1;
  const auto cycle = FindLimitCycle(&simulation.value(), mode, options);
  ASSERT_TRUE(cycle.ok()) << cycle.error().Line();
  EXPECT_FALSE(cycle.value().derailed);
  EXPECT_LT(cycle.value().critical_speed, 68.66);
  EXPECT_GT(cycle.value().critical_speed, 60);
  EXPECT_GT(cycle.value().amplitude, 9.0e-3);
  // On the way up with a small disturbance nothing happens before the linear limit.
  for (const RampPoint& p : cycle.value().up) {
    if (p.speed < 68) {
      EXPECT_LT(p.amplitude, 5e-4) << p.speed;
    }
  }
}

TEST(StabilityTest, TheRealBogieIsLinearisedTheSameWhateverTheStep) {
  // Half steps are MuJoCo's business; continuous time must not see them.
  std::vector<std::complex<double>> reference;
  for (const double step : {1e-4, 8e-4}) {
    vehicle::Scenario scenario = Straight("phs", 8);
    scenario.timestep_s = step;
    auto simulation = vehicle::Simulation::Create(scenario);
    ASSERT_TRUE(simulation.ok()) << simulation.error().Line();
    const auto spectrum = SpectrumAt(&simulation.value(), 8);
    ASSERT_TRUE(spectrum.ok());
    if (reference.empty()) reference = spectrum.value().eigenvalues;
    ASSERT_EQ(reference.size(), spectrum.value().eigenvalues.size());
    for (const std::complex<double>& value : spectrum.value().eigenvalues) {
      double nearest = 1e300;
      for (const auto& r : reference) nearest = std::min(nearest, std::abs(value - r));
      EXPECT_LT(nearest / std::abs(value), 1e-3) << "step " << step << ", " << value;
    }
  }
}

TEST(StabilityTest, GrowthOfASmallDisturbanceInTimeIsTheRealPart) {
  // The linear model against the time run it stands for: 75 m/s, above the limit of the PHS bogie.
  vehicle::Scenario scenario = Straight("phs", 75);
  scenario.timestep_s = 1e-4;
  auto simulation = vehicle::Simulation::Create(scenario);
  ASSERT_TRUE(simulation.ok()) << simulation.error().Line();
  VibrationMode mode;
  const auto spectrum = SpectrumAt(&simulation.value(), 75, &mode);
  ASSERT_TRUE(spectrum.ok());
  mjModel* m = simulation.value().mutable_model();
  const vehicle::DataPtr d(mj_makeData(m));
  ASSERT_TRUE(StartAtSpeed(simulation.value(), 75, d.get()).ok());
  vehicle::AddToState(m, 1e-6 * mode.state.real(), d.get());
  const int body = simulation.value().binding().wheelsets()[0].body;
  std::vector<double> peaks, times;
  double before = 0, last = 0;
  while (d->time < 2.0) {
    mj_step(m, d.get());
    const double y = d->xpos[3 * body + 1];
    if (last > before && last > y && last > 0) {
      peaks.push_back(last);
      times.push_back(d->time);
    }
    before = last;
    last = y;
  }
  ASSERT_GE(peaks.size(), 4u);
  const double span = times.back() - times.front();
  EXPECT_NEAR(std::log(peaks.back() / peaks.front()) / span, mode.eigenvalue.real(), 0.05);
  const double omega = 2 * std::numbers::pi * static_cast<double>(peaks.size() - 1) / span;
  EXPECT_NEAR(omega / std::abs(mode.eigenvalue.imag()), 1, 2e-3);
}

}  // namespace
}  // namespace phs::analysis
