// Lines of the generator against closed formulas: volume balance, heat, leaks, columns of oil.
#include <gtest/gtest.h>

#include <cmath>

#include "set_writer.h"

namespace rigdata {
namespace {

// Positive root of C p² + b p − c = 0.
double PositiveRoot(double a, double b, double c) {
  return (-b + std::sqrt(b * b + 4.0 * a * c)) / (2.0 * a);
}

// Isothermal volume balance of a line with gas, oil and (above its precharge) an accumulator is a
// quadratic in p:  C (p − p0) + Vg (1 − p0/p) + Va (1 − pp/p) = D.
double StaticPressure(const LineParams& q, double x, bool blow_off) {
  const double va = blow_off ? q.blow_off_volume : 0, d = q.area * x;
  return PositiveRoot(q.oil_compliance, q.gas_volume0 + va - q.oil_compliance * q.p0 - d,
                      q.gas_volume0 * q.p0 + va * q.blow_off_precharge);
}

double SolvedPressure(const LineParams& q, double x) {
  const LineTruth line(q);
  return line.Solve(line.Initial(), x, 1e-3, Surroundings{}).p_chamber;
}

TEST(LineTruth, StaticPointsAreTheRootsOfTheVolumeBalance) {
  const RigParams rig = NominalRig();
  for (const double x : {-3e-3, -1e-3, 0.0, 1e-3, 3e-3}) {
    const double bore = StaticPressure(rig.bore, x, false);
    const double rod = StaticPressure(rig.rod, x, false);
    EXPECT_NEAR(SolvedPressure(rig.bore, x), bore, 1e-6 * bore) << x;
    EXPECT_NEAR(SolvedPressure(rig.rod, x), rod, 1e-6 * rod) << x;
  }
  for (const double x : {4e-3, 6e-3, 9e-3}) {
    const double rod = StaticPressure(rig.rod, x, true);
    ASSERT_GT(rod, rig.rod.blow_off_precharge);
    EXPECT_NEAR(SolvedPressure(rig.rod, x), rod, 1e-6 * rod) << x;
  }
}

TEST(LineTruth, DerivativeOfTheVolumeMatchesDifferences) {
  LineParams q = NominalRig().rod;
  q.air_volume = 3e-6;
  q.hose_volume = 2e-6;
  q.vapour_pressure = 0.6e6;
  q.vapour_volume = 1e-6;
  q.oil_stiffening = 2e-8;
  q.gas_stop = 5e-6;
  for (const AirForm air :
       {AirForm::kDissolving, AirForm::kPolytropicDissolving, AirForm::kLaggingDissolution}) {
    for (const HoseForm hose : {HoseForm::kStiffening, HoseForm::kViscoelastic}) {
      for (const VapourForm vapour : {VapourForm::kRelease, VapourForm::kPlateau}) {
        q.air_form = air;
        q.air_exponent = 1.3;
        q.hose_form = hose;
        q.vapour_form = vapour;
        const LineTruth line(q);
        const LineState state = line.Initial();
        for (const double p : {0.3e6, 1e6, 4e6, 12e6, 16e6}) {
          double slope = 0;
          line.Volume(p, state, 1e-3, {}, &slope);
          const double d = 1e-4 * p;
          const double difference = (line.Volume(p + d, state, 1e-3, {}, nullptr) -
                                     line.Volume(p - d, state, 1e-3, {}, nullptr)) /
                                    (2 * d);
          EXPECT_NEAR(slope / difference, 1.0, 1e-5) << p;
        }
      }
    }
  }
}

RigParams OnlyBoreLine() {
  RigParams rig = NominalRig();
  rig.friction.scale = 0;
  return rig;
}

// Without heat exchange the gas follows p V^(1 + R/c_v) = const.
TEST(LineTruth, GasWithoutHeatExchangeIsAdiabatic) {
  RigParams rig = OnlyBoreLine();
  rig.bore.gas_tau = 1e9;
  const auto move = [](double t) { return -2e-3 * SmoothStep(t); };
  const RigSignals s = Simulate(rig, {move, {}}, {1e-5, 200, 1.2});
  const double p = s.p_bore.back();
  const double volume =
      rig.bore.gas_volume0 + rig.bore.oil_compliance * (p - rig.bore.p0) + rig.bore.area * 2e-3;
  const double kappa = 1.0 + rig.bore.gas_coupling;
  const double expected = rig.bore.p0 * std::pow(rig.bore.gas_volume0 / volume, kappa);
  EXPECT_NEAR(p, expected, 2e-4 * expected);
}

TEST(LineTruth, FastHeatExchangeIsIsothermal) {
  RigParams rig = OnlyBoreLine();
  rig.bore.gas_tau = 1e-5;
  const auto move = [](double t) { return -2e-3 * SmoothStep(t); };
  const RigSignals s = Simulate(rig, {move, {}}, {1e-4, 200, 1.5});
  const double expected = StaticPressure(rig.bore, -2e-3, false);
  EXPECT_NEAR(s.p_bore.back(), expected, 1e-3 * expected);
}

// Oil alone, laminar leak: p − p_a decays with the time constant C/g.
TEST(LineTruth, LeakOfAClosedOilVolumeDecaysExponentially) {
  RigParams rig = OnlyBoreLine();
  rig.bore.gas_volume0 = 1e-15;
  rig.bore.leak = {LeakForm::kLaminar, rig.bore.oil_compliance / 2.0};
  const RigSignals s = Simulate(rig, {[](double) { return 0.0; }, {}}, {1e-4, 200, 3});
  for (const size_t i : {100u, 300u, 500u}) {
    const double expected = 1e5 + (rig.bore.p0 - 1e5) * std::exp(-s.t[i] / 2.0);
    EXPECT_NEAR(s.p_bore[i], expected, 2e-4 * expected);
  }
}

// What leaves the bore line through the piston enters the rod line: at the end both pressures are
// equal and the displaced volumes balance.
TEST(LineTruth, PistonLeakageConservesOil) {
  RigParams rig = OnlyBoreLine();
  rig.piston_leak = {LeakForm::kLaminar, 1e-12};
  const auto move = [](double t) { return -1.5e-3 * SmoothStep(t); };
  const RigSignals s = Simulate(rig, {move, {}}, {1e-3, 200, 60});
  const double p = s.p_bore.back();
  EXPECT_NEAR(s.p_rod.back(), p, 1e-3 * p);
  const LineTruth bore(rig.bore), rod(rig.rod);
  const double held = bore.Volume(p, bore.Initial(), 1, {}, nullptr) +
                      rod.Volume(s.p_rod.back(), rod.Initial(), 1, {}, nullptr);
  EXPECT_NEAR(held, (rig.bore.area + rig.rod.area) * -1.5e-3, 1e-9);
}

// Chamber and reservoir with an oil column between them ring at √((1/C1 + 1/C2)/I).
TEST(LineTruth, OilColumnRingsAtItsNaturalFrequency) {
  RigParams rig = OnlyBoreLine();
  rig.bore.gas_volume0 = 1e-15;
  rig.bore.inertance = 5e7;
  rig.bore.chamber_share = 0.25;
  const auto move = [](double t) { return -1e-4 * SmoothStep(t / 0.002); };
  const RigSignals s = Simulate(rig, {move, {}}, {2e-6, 10000, 0.2});
  const double c = rig.bore.oil_compliance;
  const double frequency =
      std::sqrt((1 / (0.25 * c) + 1 / (0.75 * c)) / rig.bore.inertance) / kTwoPi;
  const double level = rig.bore.p0 + kBoreArea * 1e-4 / c;
  double first = 0, last = 0;
  int crossings = 0;
  for (size_t i = 100; i + 1 < s.size(); ++i) {
    const double a = s.p_bore[i] - level, b = s.p_bore[i + 1] - level;
    if (a < 0 && b >= 0) {
      last = s.t[i] + (s.t[i + 1] - s.t[i]) * a / (a - b);
      if (crossings++ == 0) first = last;
    }
  }
  ASSERT_GT(crossings, 5);
  EXPECT_NEAR((crossings - 1) / (last - first), frequency, 0.01 * frequency);
}

// Slow steady compression: pressure drop = R × the flow into the remote part.
TEST(LineTruth, SteadyFlowDropsTheResistanceTimesFlow) {
  RigParams rig = OnlyBoreLine();
  rig.bore.laminar = {4e8, 4e8};
  rig.bore.turbulent = {2e12, 2e12};
  LineTruth line(rig.bore);
  LineState state = line.Initial();
  const double h = 1e-4, v = -0.01;
  for (int i = 1; i <= 2000; ++i) {
    LineState next = line.Solve(state, v * h * i, h, {});
    line.Advance(next, state, h, 0, {});
    state = next;
  }
  const double drop = 4e8 * state.flow + 2e12 * state.flow * state.flow;
  EXPECT_GT(state.flow, 0.8 * kBoreArea * 0.01);
  EXPECT_NEAR(state.p_chamber - state.p_remote, drop, 1e-3 * drop);
}

}  // namespace
}  // namespace rigdata
