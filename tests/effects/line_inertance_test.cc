// Oil with inertia in a line: its ringing, and the friction of a flow that changes.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "hydraulics/pipe.h"
#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

TEST(LineInertance, RingsAtItsFrequency) {
  // Chamber oil C1 against line C2 through I: w² = (1/C1 + 1/C2)/I.
  PhsParams params = Frictionless();
  const double I = 1.6e7, share = 0.2;
  const PhsSystem s = Compile(
      With(params, "line_inertance",
           {{"inertance_kg_per_m4", I}, {"laminar_Pas_per_m3", 1e6}, {"oil_share", share}}));
  const auto& l = params.lines[0];
  const double C1 = share * l.oil_volume_m3 / l.bulk_modulus_Pa;
  const double C2 =
      (1 - share) * l.oil_volume_m3 / l.bulk_modulus_Pa + l.gas_volume_m3 / l.static_pressure_Pa;
  const double period = 2 * M_PI / std::sqrt((1 / C1 + 1 / C2) / I);
  const double x = 1e-7;
  const double start = Hold(s, x, 0).p_rod, half = Hold(s, x, period / 2, period / 4000).p_rod;
  const double full = Hold(s, x, period, period / 4000).p_rod;
  const double settled = l.static_pressure_Pa + x * params.cylinders[0].RodArea() / (C1 + C2);
  EXPECT_NEAR((full - settled) / (start - settled), 1, 2e-2);
  EXPECT_NEAR((half - settled) / (start - settled), -1, 2e-2);
}

std::complex<double> ModifiedBessel(int order, std::complex<double> z) {
  std::complex<double> term = std::pow(z / 2.0, order), sum = 0;
  for (int k = 1; k <= order; ++k) term /= k;
  for (int k = 1; k < 200; ++k) {
    sum += term;
    term *= z * z / 4.0 / (1.0 * k * (k + order));
  }
  return sum;
}

// Steps that know how the stages before them converged end after one iteration; lags of the flow
// are those of the flow that is found then.
TEST(LineInertance, StepsThatKnowHowOthersConvergedAreTheSame) {
  const PhsSystem s = Compile(
      With(Frictionless(), "line_inertance",
           {{"inertance_kg_per_m4", 1e8}, {"laminar_Pas_per_m3", 4e8}, {"unsteady_share", 1}}));
  const auto states = static_cast<size_t>(s.num_states());
  std::vector<double> kept_state(states, 0.0), state(states, 0.0), rate(states, 0.0);
  hydraulics::Instant kept;
  double p[2], other[2], most = 0, least = 1e9;
  const double h = 5e-4;
  for (int i = 0; i < 4000; ++i) {
    const auto at = [&](int k) { return 1e-3 * std::sin(2 * M_PI * 3 * h * k); };
    const double t = i * h, x = at(i), v = (at(i + 1) - x) / h;
    const double end = 1e-3 * 2 * M_PI * 3 * std::cos(2 * M_PI * 3 * h * (i + 1));
    s.CalcHydraulics(t, h, &x, {&v, &end}, kept_state.data(), &kept, rate.data(), p, p + 1);
    for (size_t j = 0; j < states; ++j) kept_state[j] += h * rate[j];
    hydraulics::Instant fresh;
    s.CalcHydraulics(t, h, &x, {&v, &end}, state.data(), &fresh, rate.data(), other, other + 1);
    for (size_t j = 0; j < states; ++j) state[j] += h * rate[j];
    EXPECT_NEAR(p[0], other[0], 0.1) << i;
    EXPECT_NEAR(p[1], other[1], 0.1) << i;
    most = std::max(most, p[1]), least = std::min(least, p[1]);
  }
  EXPECT_GT(most - least, 1e6);
}

// Laminar oil that swings in a round pipe: Z = s I I0(z)/I2(z), z² = s r²/nu (Zielke 1968, from the
// equations of Navier and Stokes), R/I = 8 nu/r². From a tenth to 700 of w r²/nu.
TEST(LineInertance, UnsteadyFrictionIsThatOfZielkeWithin02Percent) {
  const double I = 1.6e7, R = 4e8, nu = R / (8 * I);  // over r²
  const hydraulics::PipeFlow pipe({R, 0}, {R, 0}, I, 1);
  for (double omega = 0.1; omega < 700; omega *= 3) {
    const std::complex<double> s(0, omega * nu), z = std::sqrt(s / nu);
    const std::complex<double> exact = s * I * ModifiedBessel(0, z) / ModifiedBessel(2, z);
    double slope;
    pipe.Drop({}, 0, &slope);
    std::complex<double> own = s * pipe.Inertance() + slope;
    for (int k = 0; k < pipe.num_lags(); ++k) {
      const hydraulics::FlowLag lag = pipe.Lag({}, k);
      own += lag.resistance * s / (s + lag.rate);
    }
    EXPECT_LT(std::abs(own / exact - 1.0), 2e-3) << omega;
    EXPECT_NEAR(own.real() / exact.real(), 1, 6e-3) << omega;
  }
}

// The same circuit as in RingsAtItsFrequency. Its complex frequency s is the root of
// s Z(s) + 1/C1 + 1/C2 = 0, with the closed Z of the test above.
TEST(LineInertance, RingsDownByUnsteadyFriction) {
  PhsParams params = Frictionless();
  const double I = 1.6e7, R = 2e8, share = 0.2, nu = R / (8 * I);
  const PhsSystem s = Compile(With(params, "line_inertance",
                                   {{"inertance_kg_per_m4", I},
                                    {"laminar_Pas_per_m3", R},
                                    {"oil_share", share},
                                    {"unsteady_share", 1}}));
  const auto& l = params.lines[0];
  const double C1 = share * l.oil_volume_m3 / l.bulk_modulus_Pa;
  const double C2 =
      (1 - share) * l.oil_volume_m3 / l.bulk_modulus_Pa + l.gas_volume_m3 / l.static_pressure_Pa;
  std::complex<double> root(0, std::sqrt((1 / C1 + 1 / C2) / I));
  for (int i = 0; i < 50; ++i) {  // s² = -(1/C1 + 1/C2) I2/(I I0)
    const std::complex<double> z = std::sqrt(root / nu);
    root = std::complex<double>(0, 1) *
           std::sqrt((1 / C1 + 1 / C2) / I * ModifiedBessel(2, z) / ModifiedBessel(0, z));
  }
  const double period = 2 * M_PI / root.imag(), x = 1e-7;
  const double settled = l.static_pressure_Pa + x * params.cylinders[0].RodArea() / (C1 + C2);
  const auto swing = [&](int periods) {
    return Hold(s, x, periods * period, period / 2000).p_rod - settled;
  };
  EXPECT_LT(root.real(), -1.5 * R / (2 * I)) << "or friction that changes says nothing here";
  EXPECT_NEAR(std::log(swing(12) / swing(4)) / (8 * period * root.real()), 1, 2e-2);
}

// What flows at a steady rate rubs as ever: each lag has caught up.
TEST(LineInertance, UnsteadyFrictionLeavesSteadyFlowAlone) {
  PhsParams plain = Frictionless();
  const std::map<std::string, double> values = {{"inertance_kg_per_m4", 1.6e7},
                                                {"laminar_Pas_per_m3", 4e9}};
  auto unsteady = values;
  unsteady["unsteady_share"] = 1;
  const auto drop = [&](const std::map<std::string, double>& of) {
    const PhsSystem s = Compile(With(plain, "line_inertance", of));
    return Drive(s, 2.0, 1e-4, [](double t) { return 1e-3 * t; }).p_rod;
  };
  EXPECT_NEAR(drop(unsteady) / drop(values), 1, 1e-6);
}

TEST(LineInertance, MayBeInOneChamberAlone) {
  const double I = 2e7, share = 0.2;
  for (const double ratio : {0.02, 50.0}) {
    const double own = ratio < 1 ? I : I / ratio;
    PhsParams params =
        With(Frictionless(), "line_inertance",
             {{"inertance_kg_per_m4", own}, {"oil_share", share}, {"rod_ratio", ratio}});
    const PhsSystem s = Compile(params);
    EXPECT_EQ(s.num_states(), 2) << "volume and flow of one chamber";
    const double volume = params.lines[0].oil_volume_m3;
    const double stiffness = 1.4e9 / volume * (1 / share + 1 / (1 - share));
    const double decay = 0.5 * 4e8 * (ratio < 1 ? 1 : ratio) / I;
    EXPECT_NEAR(s.max_line_frequency() / std::sqrt(stiffness / I - decay * decay), 1, 1e-6)
        << ratio;
  }
}

TEST(LineInertance, DoesNotRingBeyondCriticalDamping) {
  const double I = 2e7, share = 0.2;
  const PhsParams plain = Frictionless();
  const double stiffness = 1.4e9 / plain.lines[0].oil_volume_m3 * (1 / share + 1 / (1 - share));
  const double critical = 2 * std::sqrt(stiffness * I);
  for (const double damping : {0.6, 1.01}) {
    const PhsSystem s = Compile(With(plain, "line_inertance",
                                     {{"inertance_kg_per_m4", I},
                                      {"laminar_Pas_per_m3", damping * critical},
                                      {"oil_share", share},
                                      {"rod_ratio", 0.02}}));
    const double rings = damping < 1 ? 0.8 * std::sqrt(stiffness / I) : 0;
    EXPECT_NEAR(s.max_line_frequency(), rings, 1e-4 * std::sqrt(stiffness / I)) << damping;
  }
}

}  // namespace
}  // namespace phs::effects
