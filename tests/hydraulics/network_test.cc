// The Bo-Bo network: null space, stiffness of the axle modes, statics, pressures of one line.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "hydraulics/end_stop.h"
#include "hydraulics/perfect_gas.h"
#include "test_systems.h"

namespace phs::hydraulics {
namespace {

// Stiffness matrix by finite difference of the pressure force about rest.
std::vector<std::vector<double>> Stiffness(const PhsSystem& s, double dx) {
  const int n = s.num_cylinders();
  std::vector<std::vector<double>> K(n, std::vector<double>(n));
  std::vector<double> v(n, 0.0), state(s.num_states(), 0.0);
  for (int j = 0; j < n; ++j) {
    std::vector<double> plus(n, 0.0), minus(n, 0.0);
    plus[j] = dx;
    minus[j] = -dx;
    Evaluation a(s), b(s);
    s.Calc(0, plus.data(), v.data(), state.data(), &a.out);
    s.Calc(0, minus.data(), v.data(), state.data(), &b.out);
    for (int i = 0; i < n; ++i) K[i][j] = (a.pressure_force[i] - b.pressure_force[i]) / (2 * dx);
  }
  return K;
}

double ModeStiffness(const PhsSystem& s, const std::vector<double>& mode) {
  const auto K = Stiffness(s, 1e-9);
  double sum = 0;
  for (size_t i = 0; i < 4; ++i) {
    for (size_t j = 0; j < 4; ++j) sum += mode[i] * K[i][j] * mode[j];
  }
  return sum;
}

// dp/dV of a line at rest: 1/(V_oil/beta + V_g0/p0 + trace air).
double LineStiffness(const LineParams& l) {
  return 1 / (l.oil_volume_m3 / l.bulk_modulus_Pa + l.gas_volume_m3 / l.static_pressure_Pa +
              1e-6 * l.oil_volume_m3 * kAtmosphere / (l.static_pressure_Pa * l.static_pressure_Pa));
}

TEST(BoBoNetwork, AtRestNoNetForceAndStaticPressures) {
  const PhsParams params = BoBo();
  const PhsSystem s = Make(params);
  const std::vector<double> x(4, 0.0), v(4, 0.0), state(s.num_states(), 0.0);
  Evaluation e(s);
  s.Calc(0, x.data(), v.data(), state.data(), &e.out);
  for (double F : e.force) EXPECT_NEAR(F, 0, 1e-8);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(e.pressure[i], params.lines[i].static_pressure_Pa);
  EXPECT_EQ(e.out.stored_energy, 0);
  EXPECT_EQ(e.out.lost_power, 0);
}

TEST(BoBoNetwork, BendingIsFreeToRounding) {
  const PhsParams params = BoBo();
  const PhsSystem s = Make(params);
  const std::vector<double> v(4, 0.0), state(s.num_states(), 0.0);
  for (double a : {-0.02, -1e-3, 1e-6, 4e-3, 0.025}) {
    const std::vector<double> x = {a, -a, -a, a};
    Evaluation e(s);
    s.Calc(0, x.data(), v.data(), state.data(), &e.out);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(e.pressure[i], params.lines[i].static_pressure_Pa);
  }
}

// Closed formula: F_i = p_rod A_rod - p_bore A_bore with every line loaded by the mode's volume.
TEST(BoBoNetwork, ShearTractionAntiphaseMatchClosedFormula) {
  const PhsParams params = BoBo();
  const PhsSystem s = Make(params);
  const double Ab = params.cylinders[0].BoreArea(), Ar = params.cylinders[0].RodArea();
  const double cross = LineStiffness(params.lines[0]), diagonal = LineStiffness(params.lines[1]);
  // Shear (both axles yaw the same way) loads the diagonals only: each sees +-2 A_bore x.
  EXPECT_NEAR(ModeStiffness(s, {1, -1, 1, -1}) / (2 * 4 * Ab * Ab * diagonal), 1, 1e-6);
  // Antiphase (both axles move out) loads everything.
  EXPECT_NEAR(ModeStiffness(s, {1, 1, 1, 1}) / (2 * 4 * (Ab * Ab * diagonal + Ar * Ar * cross)), 1,
              1e-6);
  // Traction (leading axle out, trailing in) loads the cross lines only.
  EXPECT_NEAR(ModeStiffness(s, {1, 1, -1, -1}) / (2 * 4 * Ar * Ar * cross), 1, 1e-6);
  EXPECT_NEAR(ModeStiffness(s, {1, -1, -1, 1}), 0, 1e-3);
}

RC_GTEST_PROP(BoBoNetwork, StiffnessIsSymmetricAndPositive, ()) {
  const PhsSystem s = Make(BoBo());
  const auto K = Stiffness(s, 1e-8);
  const auto mode = *rc::gen::container<std::vector<double>>(
      4, rc::gen::map(rc::gen::inRange(-1000, 1000), [](int i) { return i / 1000.0; }));
  double energy = 0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      RC_ASSERT(std::abs(K[i][j] - K[j][i]) < 1e-3 * std::abs(K[0][0]));
      energy += mode[i] * K[i][j] * mode[j];
    }
  }
  RC_ASSERT(energy > -1e-2);
}

// Mirror image left/right swaps 1<->2, 3<->4 and with them L2<->L3.
RC_GTEST_PROP(BoBoNetwork, MirrorSymmetric, ()) {
  const PhsSystem s = Make(BoBo());
  std::vector<double> x(4), v(4), m(4), mv(4);
  for (int i = 0; i < 4; ++i) {
    x[i] = *rc::gen::inRange(-20000, 20000) * 1e-6;
    v[i] = *rc::gen::inRange(-1000, 1000) * 1e-5;
  }
  const int swap[] = {1, 0, 3, 2};
  for (int i = 0; i < 4; ++i) {
    m[i] = x[swap[i]];
    mv[i] = v[swap[i]];
  }
  const std::vector<double> state(s.num_states(), 0.0);
  Evaluation a(s), b(s);
  s.Calc(0, x.data(), v.data(), state.data(), &a.out);
  s.Calc(0, m.data(), mv.data(), state.data(), &b.out);
  for (int i = 0; i < 4; ++i) RC_ASSERT(std::abs(a.force[i] - b.force[swap[i]]) < 1e-6);
}

TEST(Line, BlowOffLimitsTensionOnTheRodSide) {
  const PhsSystem s = Make(Quarter());
  const std::vector<double> state(s.num_states(), 0.0);
  const double v = 0;
  double x = 0.012;
  Evaluation e(s);
  s.Calc(0, &x, &v, state.data(), &e.out);
  EXPECT_GT(e.p_rod[0], 15.0e6);
  EXPECT_LT(e.p_rod[0], 16.5e6);
  x = -0.012;  // the bore side has none
  s.Calc(0, &x, &v, state.data(), &e.out);
  EXPECT_GT(e.p_bore[0], 60e6);
}

RC_GTEST_PROP(Line, PressureIsPositiveFiniteAndRisesWithVolume, ()) {
  PhsParams params = Quarter();
  params.lines[0].reservoir.law = *rc::gen::elementOf(GasLaws());
  params.lines[0].bulk_modulus_slope = *rc::gen::inRange(0, 2) * 8.0;
  params.lines[0].reservoir.min_gas_volume_m3 = *rc::gen::inRange(0, 3) * 4e-6;
  const PhsSystem s = Make(params);
  const std::vector<double> state(s.num_states(), 0.0);
  const double v = 0, x1 = *rc::gen::inRange(-28000, 28000) * 1e-6;
  const double x2 = x1 + *rc::gen::inRange(1, 1000) * 1e-6;
  Evaluation a(s), b(s);
  s.Calc(0, &x1, &v, state.data(), &a.out);
  s.Calc(0, &x2, &v, state.data(), &b.out);
  RC_ASSERT(std::isfinite(a.p_rod[0]) && a.p_rod[0] > 0);
  RC_ASSERT(b.p_rod[0] > a.p_rod[0]);
  RC_ASSERT(b.p_bore[0] < a.p_bore[0]);
}

// Energy is the integral of force over travel, for every gas law without a state.
TEST(Line, StoredEnergyIsTheWorkDone) {
  for (const GasLaw* law : {&kIsothermalGas, &kPolytropicGas}) {
    for (double slope : {0.0, 8.0}) {
      PhsParams params = Quarter();
      params.friction.model = FrictionModel::kNone;
      for (LineParams& l : params.lines) {
        l.reservoir.law = l.accumulator.law = law;
        l.bulk_modulus_slope = slope;
        l.reservoir.min_gas_volume_m3 = 3e-6;
      }
      const PhsSystem s = Make(params);
      Evaluation e(s);
      const double v = 0;
      for (double end : {0.011, -0.009}) {
        double work = 0, previous = 0;
        const int n = 20000;
        for (int i = 0; i <= n; ++i) {
          const double x = end * i / n;
          s.Calc(0, &x, &v, nullptr, &e.out);
          if (i > 0) work += 0.5 * (e.force[0] + previous) * end / n;
          previous = e.force[0];
        }
        EXPECT_NEAR(e.out.stored_energy / work, 1, 1e-6) << "slope " << slope << " end " << end;
      }
    }
  }
}

TEST(EndStop, HoldsBeyondTheStrokeAndIsSmooth) {
  const EndStopParams p;
  EXPECT_EQ(CalcEndStop(p, 0.03, 1).force, 0);
  EXPECT_GT(CalcEndStop(p, 0.0305, 0).force, 0);
  EXPECT_LT(CalcEndStop(p, -0.0305, 0).force, 0);
  EXPECT_GE(CalcEndStop(p, 0.0305, -100).force, 0) << "a stop never pulls";
  for (double y : {0.0301, 0.0309, 0.031, 0.033}) {
    const double h = 1e-8;
    const double slope =
        (CalcEndStop(p, y + h, 0).force - CalcEndStop(p, y - h, 0).force) / (2 * h);
    const double rate =
        (CalcEndStop(p, y + h, 0).energy - CalcEndStop(p, y - h, 0).energy) / (2 * h);
    EXPECT_NEAR(slope / CalcEndStop(p, y, 0).slope, 1, 1e-4);
    EXPECT_NEAR(rate / CalcEndStop(p, y, 0).force, 1, 1e-5);
  }
}

}  // namespace
}  // namespace phs::hydraulics
