// Gas laws against the reference equation of state of nitrogen, and their limits.
#include "hydraulics/gas_law.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "hydraulics/bwr_nitrogen.h"
#include "phs_places.h"
#include "test_systems.h"

namespace phs::hydraulics {
namespace {

// Density [kg/m3] and isochoric heat capacity [J/(kg K)] from the reference equation of Span,
// Lemmon, Jacobsen, Wagner and Yokozeki (J. Phys. Chem. Ref. Data 29 (2000) 1361; uncertainty of
// density 0.02 %), evaluated from its published coefficients; the evaluation meets the paper's own
// table at 350 K, 20 MPa (6.3552 mol/l, 21.64 J/(mol K)).
struct Reference {
  double T, p_MPa, rho, cv;
};
constexpr Reference kSpan2000[] = {
    {250, 0.1, 1.3488, 742.80},  {250, 1, 13.5801, 746.38},   {250, 5, 69.5435, 761.32},
    {250, 10, 140.5924, 777.14}, {250, 15, 208.0798, 789.44}, {250, 20, 268.0960, 798.88},
    {275, 0.1, 1.2257, 742.89},  {275, 1, 12.3015, 745.66},   {275, 5, 62.1614, 757.19},
    {275, 10, 124.1912, 769.66}, {275, 15, 183.0749, 779.94}, {275, 20, 236.5820, 788.43},
    {300, 0.1, 1.1233, 743.16},  {300, 1, 11.2488, 745.38},   {300, 5, 56.3445, 754.66},
    {300, 10, 111.7254, 764.86}, {300, 15, 164.2394, 773.60}, {300, 20, 212.5372, 781.13},
    {325, 0.1, 1.0367, 743.68},  {325, 1, 10.3657, 745.51},   {325, 5, 51.6117, 753.20},
    {325, 10, 101.8343, 761.80}, {325, 15, 149.4196, 769.36}, {325, 20, 193.5177, 776.06},
    {350, 0.1, 0.9625, 744.53},  {350, 1, 9.6136, 746.07},    {350, 5, 47.6684, 752.60},
    {350, 10, 93.7410, 760.00},  {350, 15, 137.3781, 766.64}, {350, 20, 178.0313, 772.64},
};

double WorstPressureError(const BwrConstants& k) {
  double worst = 0;
  for (const Reference& r : kSpan2000) {
    const double p = CalcBwrPressure(r.rho, r.T, k).p;
    worst = std::max(worst, std::abs(p / (r.p_MPa * 1e6) - 1));
  }
  return worst;
}

TEST(BwrNitrogen, PressureAgainstSpan2000Within0p6Percent) {
  for (const Reference& r : kSpan2000) {
    EXPECT_NEAR(CalcBwrPressure(r.rho, r.T).p / (r.p_MPa * 1e6), 1, 6e-3)
        << r.T << " K, " << r.p_MPa << " MPa";
  }
}

TEST(BwrNitrogen, ThreeHundredKelvinFifteenMegapascal) {
  const double rho = 164.2394, T = 300;
  EXPECT_NEAR(CalcBwrPressure(rho, T).p / 15e6 - 1, -0.0021, 2e-4);
  EXPECT_NEAR(rho * kNitrogenR * T / 15e6 - 1, -0.0251, 2e-4) << "ideal gas";
  BwrConstants printed;
  printed.C0 = 1.0405873e-6;
  printed.c = 7.3806143e-5;
  EXPECT_NEAR(CalcBwrPressure(rho, T, printed).p / 15e6 - 1, 0.0078, 3e-4) << "as printed";
}

TEST(BwrNitrogen, MisprintedConstantsFailTheReference) {
  EXPECT_LT(WorstPressureError({}), 6e-3);
  BwrConstants C0, c;
  C0.C0 = 1.0405873e-6;
  c.c = 7.3806143e-5;
  EXPECT_GT(WorstPressureError(C0), 8e-3);
  EXPECT_GT(WorstPressureError(c), 8e-3);
}

TEST(BwrNitrogen, HeatCapacityOfTheIdealGas) {
  EXPECT_NEAR(CalcNitrogenCv0(300), 742.2, 0.1);
  // Without the square in eq. 18 the vibration term is far too large.
  const double y = 3353.4061 / 300, e = std::exp(y);
  const double wrong =
      CalcNitrogenCv0(300) + 296.797 * 1.0054 * y * y * (e / (e - 1) - e / ((e - 1) * (e - 1)));
  EXPECT_GT(wrong, 890);
}

TEST(BwrNitrogen, HeatCapacityAgainstSpan2000Within1p5Percent) {
  for (const Reference& r : kSpan2000) {
    EXPECT_NEAR(CalcBwrCv(r.rho, r.T) / r.cv, 1, 0.015) << r.T << " K, " << r.p_MPa << " MPa";
  }
}

// c_v - c_v0 = -T integral of d²p/dT² dv from infinity: the sign that eq. 19 misprints.
TEST(BwrNitrogen, ResidualHeatCapacityIsTheIntegralOfThePressureCurvature) {
  const double T = 300, rho = 1 / 0.0061, dT = 0.5;
  double integral = 0;
  const int n = 4000;
  for (int i = 0; i < n; ++i) {
    const double r = rho * (i + 0.5) / n;
    const double curvature =
        (CalcBwrPressure(r, T + dT).dp_dT - CalcBwrPressure(r, T - dT).dp_dT) / (2 * dT);
    integral += -T * curvature / (r * r) * rho / n;
  }
  const double residual = CalcBwrCv(rho, T) - CalcNitrogenCv0(T);
  EXPECT_NEAR(residual, integral, 1e-3 * integral);
  EXPECT_NEAR(residual, 27.93, 0.02);
  const BwrConstants k;
  const double as_printed =
      residual - 6 * k.c / (T * T * T) * rho * rho * std::exp(-k.gamma * rho * rho);
  EXPECT_NEAR(as_printed, 11.2, 0.2);
}

RC_GTEST_PROP(BwrNitrogen, DerivativesAndPotentialsAreConsistent, ()) {
  const double T = *rc::gen::inRange(220, 450), rho = *rc::gen::inRange(1, 300);
  const double d = 1e-4 * rho, t = 1e-2;
  const BwrPressure at = CalcBwrPressure(rho, T);
  const double p_rho = (CalcBwrPressure(rho + d, T).p - CalcBwrPressure(rho - d, T).p) / (2 * d);
  const double p_T = (CalcBwrPressure(rho, T + t).p - CalcBwrPressure(rho, T - t).p) / (2 * t);
  RC_ASSERT(std::abs(p_rho / at.dp_drho - 1) < 1e-5);
  RC_ASSERT(std::abs(p_T / at.dp_dT - 1) < 1e-5);
  const double cv = (CalcBwrEnergy(rho, T + t) - CalcBwrEnergy(rho, T - t)) / (2 * t);
  RC_ASSERT(std::abs(cv / CalcBwrCv(rho, T) - 1) < 1e-5);
  const double Ts_T = T * (CalcBwrEntropy(rho, T + t) - CalcBwrEntropy(rho, T - t)) / (2 * t);
  RC_ASSERT(std::abs(Ts_T / cv - 1) < 1e-5);
  // Maxwell: (ds/drho)_T = -(dp/dT)_rho / rho².
  const double s_rho = (CalcBwrEntropy(rho + d, T) - CalcBwrEntropy(rho - d, T)) / (2 * d);
  RC_ASSERT(std::abs(-s_rho * rho * rho / at.dp_dT - 1) < 1e-4);
  RC_ASSERT(std::abs(CalcBwrDensity(at.p, T) / rho - 1) < 1e-9);
}

// p(V) of each law and its inverse, with analytic slopes.
RC_GTEST_PROP(GasLaw, VolumeAndPressureAreInverse, ()) {
  GasVolume g;
  g.law = *rc::gen::elementOf(GasLaws());
  g.reference_volume = 16e-6;
  g.reference_pressure = 2e6;
  g.reference_temperature = 293.15;
  g.exponent = 1.3;
  g.max_volume = 1;
  g.SetMass();
  const double p = 1e5 * *rc::gen::inRange(1, 300), T = *rc::gen::inRange(240, 400);
  const GasState at = CalcGas(g, p, T);
  RC_ASSERT(std::abs(CalcGasPressure(g, at.volume, T) / p - 1) < 1e-9);
  const double dp = 1e-5 * p, dT = 1e-3;
  const double V_p = (CalcGas(g, p + dp, T).volume - CalcGas(g, p - dp, T).volume) / (2 * dp);
  const double V_T = (CalcGas(g, p, T + dT).volume - CalcGas(g, p, T - dT).volume) / (2 * dT);
  RC_ASSERT(std::abs(V_p / at.dV_dp - 1) < 1e-4);
  RC_ASSERT(std::abs(V_T / at.dV_dT - 1) < 1e-4);
  RC_ASSERT(at.dV_dp < 0 && at.dV_dT > 0);
}

TEST(GasLaw, TheDocsListEveryOne) {
  std::ifstream file(PHS_SOURCE_DIR "/docs/gas_laws.md");
  const std::string docs{std::istreambuf_iterator<char>(file), {}};
  for (const GasLaw* law : GasLaws()) {
    EXPECT_EQ(FindGasLaw(law->name), law);
    const std::string row = std::string("| `") + law->name + "` | " + law->text + " |";
    EXPECT_NE(docs.find(row), std::string::npos) << row;
  }
}

TEST(GasLaw, DiaphragmStopsClampTheVolume) {
  GasVolume g;
  g.reference_volume = 16e-6;
  g.reference_pressure = 2e6;
  g.reference_temperature = 293.15;
  g.min_volume = 4e-6;
  g.max_volume = 320e-6;
  for (const GasLaw* law : GasLaws()) {
    g.law = law;
    g.SetMass();
    EXPECT_EQ(CalcGas(g, 60e6, 293.15).volume, 4e-6);
    EXPECT_EQ(CalcGas(g, 1e4, 293.15).volume, 320e-6);
    EXPECT_TRUE(CalcGas(g, 60e6, 293.15).stopped);
  }
}

// Convergence of the heat balance over the step: second order.
TEST(GasLaw, HeatBalanceConvergesWithOrderTwo) {
  PhsParams params = Quarter();
  params.friction.model = FrictionModel::kNone;
  int with_temperature = 0;
  for (const GasLaw* law : GasLaws()) {
    if (law->capacity == nullptr) continue;
    ++with_temperature;
    for (LineParams& l : params.lines) {
      l.reservoir.law = l.accumulator.law = law;
      l.reservoir.thermal_time_s = 0.4;
    }
    const PhsSystem s = Make(params);
    auto run = [&s](int n) {
      std::vector<double> state(s.num_states(), 0.0), rate(state);
      const double h = 1.0 / n;
      for (int i = 0; i < n; ++i) {
        const double t = i * h, x = 1e-3 * std::sin(3 * t);
        const double v = (1e-3 * std::sin(3 * (t + h)) - x) / h;
        s.CalcStateRate(t, h, &x, &v, state.data(), rate.data());
        for (size_t k = 0; k < state.size(); ++k) state[k] += h * rate[k];
      }
      return state[0];
    };
    const double exact = run(12800);
    const double order = std::log2(std::abs((run(100) - exact) / (run(200) - exact)));
    EXPECT_NEAR(order, 2, 0.25) << law->name;
  }
  EXPECT_GE(with_temperature, 2);
}

TEST(SequentialBalance, IsContinuousAndStifferThanTheUnifiedBalance) {
  PhsParams params = Quarter();
  const PhsSystem unified = Make(params);
  params.balance = BalanceMethod::kSequential;
  const PhsSystem sequential = Make(params);
  const double v = 0;
  double before = 0;
  std::vector<double> state(4, 0.0);
  Evaluation a(unified), b(sequential);
  for (double x = 0; x < 0.012; x += 1e-6) {
    unified.Calc(0, &x, &v, state.data(), &a.out);
    sequential.Calc(0, &x, &v, state.data(), &b.out);
    if (x > 0) {
      EXPECT_GT(b.p_rod[0], before);
      EXPECT_LT(b.p_rod[0] - before, 2e4) << x;
    }
    EXPECT_GE(b.p_rod[0], a.p_rod[0] - 1e-3) << x;
    before = b.p_rod[0];
  }
}

}  // namespace
}  // namespace phs::hydraulics
