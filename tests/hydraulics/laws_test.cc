// What effects add to a PHS, with laws made up here: each law enters where the core says, with the
// right sign and size, and what is known of it in closed form comes out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "hydraulics/extension.h"
#include "hydraulics/mount.h"
#include "hydraulics/node.h"
#include "tests/hydraulics/test_systems.h"

namespace phs::hydraulics {
namespace {

/// A catalogue of one effect, `made_up`, that does what `install` says.
class MadeUp final : public EffectTable {
 public:
  explicit MadeUp(std::function<void(Extension*)> install) {
    Chosen() = std::move(install);
    EffectInfo info;
    info.name = "made_up";
    info.install = [](const EffectParams&, Extension* e) -> Status {
      Chosen()(e);
      return {};
    };
    effects_.push_back(info);
  }
  const std::vector<EffectInfo>& effects() const override { return effects_; }

 private:
  static std::function<void(Extension*)>& Chosen() {
    static std::function<void(Extension*)> chosen;
    return chosen;
  }
  std::vector<EffectInfo> effects_;
};

PhsSystem With(PhsParams params, std::function<void(Extension*)> install) {
  params.effects.push_back({"made_up", {}, {}, {}});
  const MadeUp table(std::move(install));
  return Make(params, &table);
}

int StateNamed(const PhsSystem& s, const std::string& end) {
  for (int i = 0; i < s.num_states(); ++i) {
    if (s.state_names()[static_cast<size_t>(i)].ends_with(end)) return i;
  }
  ADD_FAILURE() << "no state " << end;
  return 0;
}

/// q = c (dp + dp^3/p^2): rises, without an inverse of its own.
struct CubicFlow final : FlowLaw {
  double Flow(const FlowPlace&, double dp, double* slope) const noexcept override {
    const double part = dp / 1e6;
    *slope = 1e-12 * (1 + 3 * part * part);
    return 1e-12 * dp * (1 + part * part);
  }
};

TEST(FlowLaw, ItsInverseIsFoundWhereItGivesNone) {
  const CubicFlow law;
  for (const double dp : {-3e6, -40.0, 0.0, 5e5, 2e7}) {
    double slope, rise;
    const double flow = law.Flow({}, dp, &slope);
    EXPECT_NEAR(law.Drop({}, flow, &rise), dp, 1e-5);
    EXPECT_NEAR(rise * slope, 1, 1e-9);
  }
}

/// Holds up to 1 bar, then hardly resists; counts how often it is asked.
struct DryFlow final : FlowLaw {
  explicit DryFlow(int* asked) : asked_(*asked) {}
  double Flow(const FlowPlace&, double dp, double* slope) const noexcept override {
    ++asked_;
    const double beyond = std::abs(dp) - kHolds;
    *slope = beyond > 0 ? 1 / kResists : 0;
    return beyond > 0 ? std::copysign(beyond / kResists, dp) : 0;
  }
  double Drop(const FlowPlace&, double flow, double* slope) const noexcept override {
    ++asked_;
    *slope = kResists;
    return (flow != 0 ? std::copysign(kHolds, flow) : 0) + kResists * flow;
  }
  bool Sticks() const noexcept override { return true; }
  static constexpr double kHolds = 1e5, kResists = 1e7;
  int& asked_;
};

// To and fro between rest and the steep slope beyond, Newton's method took 30 iterations and did not
// end: the first flow compresses the gas a little more than enough to be held again.
TEST(FlowLaw, WhatSticksIsSolvedInAFewIterations) {
  PhsParams params = Quarter();
  params.friction.model = FrictionModel::kNone;
  int asked = 0;
  const PhsSystem s = With(params, [&asked](Extension* e) {
    for (const int line : {0, 1}) e->SplitReservoir(line, "dry", std::make_unique<DryFlow>(&asked));
  });
  std::vector<double> state(s.num_states(), 0.0), rate(state);
  const double h = 0.02;
  const int steps = 100;
  for (int i = 0; i < steps; ++i) {
    const auto at = [&](int k) { return 2e-3 * std::sin(3 * h * k); };
    const double x = at(i), v = (at(i + 1) - x) / h;
    s.CalcStateRate(i * h, h, &x, &v, state.data(), rate.data());
    for (size_t k = 0; k < state.size(); ++k) state[k] += h * rate[k];
  }
  EXPECT_LT(asked, 12 * 2 * steps) << "two stages, of six iterations at most on the mean";
}

struct TestSpring final : MountLaw {
  Play FreePlay() const override { return {3e-4, 1e-4}; }
  double Stiffness() const override { return 2e7; }
  Stiffening Stiffen(double e) const noexcept override {
    return {e > 0 ? 1.5 : 1.0, 1 + 1e5 * e * e, 1 + 3e5 * e * e};
  }
  std::vector<MaxwellBranch> Branches() const override { return {{"bush", 3e6, 2e4}}; }
};

Mount TwoSprings() {
  MountLaws laws;
  laws.push_back(std::make_unique<TestSpring>());
  laws.push_back(std::make_unique<TestSpring>());
  return Mount(std::move(laws));
}

TEST(MountLawsTest, PlaysOfTwoAdd) {
  const Mount mount = TwoSprings();
  EXPECT_DOUBLE_EQ(mount.play(), 6e-4);
  EXPECT_EQ(mount.PlayFree(1.9e-4), 0);
  EXPECT_NEAR(mount.PlayFree(3e-4), 1e-4, 1e-15);
  EXPECT_EQ(mount.PlayFree(-3.9e-4), 0);
  EXPECT_NEAR(mount.PlayFree(-5e-4), -1e-4, 1e-15);
}

TEST(MountLawsTest, SlopeAndEnergyBelongToTheForce) {
  const Mount mount = TwoSprings();
  const double q[] = {2e-5, -1e-5};
  const double step = 1e-9;
  for (const double u : {-9e-4, -5e-4, -4.2e-4, 2.1e-4, 3e-4, 8e-4}) {
    SCOPED_TRACE(u);
    double slope = 0, unused = 0;
    mount.Force(u, q, 0, &slope);
    const double high = mount.Force(u + step, q, 0, &unused);
    const double low = mount.Force(u - step, q, 0, &unused);
    EXPECT_NEAR((high - low) / (2 * step), slope, 1e-5 * slope + 1);
    // dE/du = F at branches held.
    const double energy = mount.Energy(u + 1e-7, q) - mount.Energy(u - 1e-7, q);
    EXPECT_NEAR(energy / 2e-7, mount.Force(u, q, 0, &unused), 1e-4 * std::abs(high) + 0.5);
  }
}

struct Warmer final : AmbientLaw {
  double Rise(double) const noexcept override { return 15; }
};

/// Pressure of one line at rest that is `warmer` by bisection of its own balance: oil that softens,
/// isothermal gas whose p V grows with the absolute temperature.
double WarmPressure(const LineParams& l, double T0, double warmer) {
  const double soft = std::exp(l.softening_1_per_K * warmer);
  const auto taken = [&](double p) {
    const double rise = p - l.static_pressure_Pa;
    const double beta = l.bulk_modulus_Pa + l.bulk_modulus_slope * rise;
    const double oil = l.bulk_modulus_slope > 0 ? l.oil_volume_m3 * soft / l.bulk_modulus_slope *
                                                      std::log(beta / l.bulk_modulus_Pa)
                                                : l.oil_volume_m3 * soft / l.bulk_modulus_Pa * rise;
    return oil + l.gas_volume_m3 - l.gas_volume_m3 * l.static_pressure_Pa / p * (T0 + warmer) / T0;
  };
  double low = 1e4, high = 1e8;
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2;
    (taken(middle) < l.oil_volume_m3 * l.expansion_1_per_K * warmer ? low : high) = middle;
  }
  return low;
}

TEST(AmbientLawsTest, ALineAtRestTakesThePressureOfItsWarmGasAndOil) {
  for (const double slope : {0.0, 8.0}) {
    for (const double softening : {0.0, 0.004}) {
      for (const double expansion : {0.0, 2e-5}) {
        PhsParams params = Quarter();
        for (LineParams& l : params.lines) {
          l.bulk_modulus_slope = slope;
          l.softening_1_per_K = softening;
          l.expansion_1_per_K = expansion;
        }
        const PhsSystem s =
            With(params, [](Extension* e) { e->AddAmbient(std::make_unique<Warmer>()); });
        const std::vector<double> state(static_cast<size_t>(s.num_states()), 0);
        const double zero[] = {0};
        Evaluation at(s);
        s.Calc(0, zero, zero, state.data(), &at.out);
        const double expected = WarmPressure(params.lines[0], params.temperature_K, 15);
        EXPECT_GT(expected, params.lines[0].static_pressure_Pa + 1e4);
        EXPECT_NEAR(at.pressure[0], expected,
                    1e-3 * (expected - params.lines[0].static_pressure_Pa))
            << slope << " " << softening << " " << expansion;
      }
    }
  }
}

/// Level: 1e-3 N per pascal of the rod's rise, 1 kN times its memory, 10 N per kelvin.
struct MadeUpLevel final : LevelLaw {
  void Add(const LevelPlace& place, LevelParts* level) const noexcept override {
    level->extra += 1e-3 * place.at.rod_rise + 1000 * place.memory + 10 * place.at.warmer;
  }
  bool DependsOnPressure() const override { return true; }
  std::string MemoryName() const override { return "wear"; }
  double MemoryRate(double v, double memory) const noexcept override { return v - 2 * memory; }
};

TEST(LevelLawsTest, ALevelKnowsPressureMemoryAndWarmth) {
  PhsParams params = Quarter();
  params.friction.model = FrictionModel::kStatic;
  const PhsSystem plain = Make(params);
  const PhsSystem s = With(params, [](Extension* e) {
    e->AddLevel(0, std::make_unique<MadeUpLevel>());
    e->AddAmbient(std::make_unique<Warmer>());
  });
  const int wear = StateNamed(s, "wear");
  std::vector<double> state(static_cast<size_t>(s.num_states()), 0);
  const double x[] = {1e-3}, v[] = {0.01};
  Evaluation before(plain), after(s);
  plain.Calc(0, x, v, state.data(), &before.out);
  for (const double memory : {0.0, 0.3}) {
    state[static_cast<size_t>(wear)] = memory;
    s.Calc(0, x, v, state.data(), &after.out);
    const double rise = after.p_rod[0] - params.lines[0].static_pressure_Pa;
    EXPECT_GT(std::abs(rise), 1e5);
    // Friction holds extension back: tension in the rod, F > 0.
    EXPECT_NEAR(after.friction[0] - before.friction[0], 1e-3 * rise + 1000 * memory + 150,
                1e-6 * std::abs(after.friction[0]));
  }
  std::vector<double> rate(state.size(), 0);
  s.CalcStateRate(0, 0, x, v, state.data(), rate.data());
  EXPECT_NEAR(rate[static_cast<size_t>(wear)], 0.01 - 2 * 0.3, 1e-12);
}

/// Two memories that move each in its own way, exactly over a step.
struct Remembers final : LevelLaw {
  Remembers(std::string of, double a_second) : name(std::move(of)), slope(a_second) {}
  void Add(const LevelPlace&, LevelParts*) const noexcept override {}
  std::string MemoryName() const override { return name; }
  double AdvanceMemory(double h, double, double memory) const noexcept override {
    return memory + slope * h;
  }
  std::string name;
  double slope;
};

TEST(LevelLawsTest, EveryMemoryOfACylinderHasItsOwnRate) {
  const PhsSystem s = With(Quarter(), [](Extension* e) {
    e->AddLevel(0, std::make_unique<Remembers>("first", 3));
    e->AddLevel(0, std::make_unique<Remembers>("second", -5));
  });
  std::vector<double> state(static_cast<size_t>(s.num_states()), 0), rate(state);
  const double x[] = {0}, v[] = {0.01};
  s.CalcStateRate(0, 0.1, x, v, state.data(), rate.data());
  EXPECT_DOUBLE_EQ(rate[static_cast<size_t>(StateNamed(s, "first"))], 3);
  EXPECT_DOUBLE_EQ(rate[static_cast<size_t>(StateNamed(s, "second"))], -5);
}

struct Column final : FlowLaw {
  Column(double resistance, double inertance) : R(resistance), I(inertance) {}
  double Flow(const FlowPlace&, double dp, double* slope) const noexcept override {
    *slope = 1 / R;
    return dp / R;
  }
  double Drop(const FlowPlace&, double flow, double* slope) const noexcept override {
    *slope = R;
    return R * flow;
  }
  double Inertance() const noexcept override { return I; }
  double R, I;
};

PhsSystem Split(const PhsParams& params, double R, double I) {
  return With(params, [=](Extension* e) {
    e->SplitChamber(Port::kBore, 0, 0.3, "hose", std::make_unique<Column>(R, I));
  });
}

TEST(FlowLawsTest, AColumnOfOilIsSlowedByItsResistanceOverItsInertance) {
  const double R = 2e9, I = 4e7;
  const PhsSystem s = Split(Quarter(), R, I);
  std::vector<double> state(static_cast<size_t>(s.num_states()), 0), rate(state);
  const int flow = StateNamed(s, "flow");
  state[static_cast<size_t>(flow)] = 1e-5;
  const double zero[] = {0};
  s.CalcStateRate(0, 0, zero, zero, state.data(), rate.data());
  EXPECT_NEAR(rate[static_cast<size_t>(flow)], -R * 1e-5 / I, 1e-9);
}

TEST(FlowLawsTest, ResistanceLowersTheFrequencyOfAColumn) {
  const double I = 4e7, R = 1e10;
  const double free = Split(Quarter(), 1, I).max_line_frequency();
  const double damped = Split(Quarter(), R, I).max_line_frequency();
  EXPECT_GT(free, 100);
  EXPECT_NEAR(damped * damped, free * free - std::pow(R / (2 * I), 2), 1e-6 * free * free);
}

/// Pressure of the bore at x in the line as it is, and with its oil split by a hose that equalises.
std::pair<double, double> WholeAndSplit(const PhsParams& params, double x) {
  const PhsSystem whole = Make(params), split = Split(params, 1e6, 0);
  const double v[] = {0};
  std::vector<double> none(static_cast<size_t>(whole.num_states()), 0);
  std::vector<double> state(static_cast<size_t>(split.num_states()), 0), rate(state);
  for (int i = 0; i < 200; ++i) {
    split.CalcStateRate(0, 0.5, &x, v, state.data(), rate.data());
    for (size_t k = 0; k < state.size(); ++k) state[k] += 0.5 * rate[k];
  }
  Evaluation one(whole), two(split);
  whole.Calc(0, &x, v, none.data(), &one.out);
  split.Calc(0, &x, v, state.data(), &two.out);
  return {one.p_bore[0], two.p_bore[0]};
}

TEST(FlowLawsTest, ASplitChamberHoldsTheOilAndAirOfItsLineOnce) {
  PhsParams params = Quarter();
  for (LineParams& l : params.lines) l.free_air_m3 = 2e-5;
  const auto [whole, split] = WholeAndSplit(params, -2e-3);
  EXPECT_NEAR(split, whole, 1e-5 * whole);
}

TEST(FlowLawsTest, AnEmptySplitLineHasThePressureOfItsTraceOfAir) {
  PhsParams params = Quarter();
  for (LineParams& l : params.lines) l.gas_volume_m3 = 0;
  const LineParams& l = params.lines[1];
  // Drawn 1e-7 m3 beyond where the oil stands without pressure; the trace alone fills it.
  const double drawn = l.oil_volume_m3 * l.static_pressure_Pa / l.bulk_modulus_Pa + 1e-7;
  const auto [whole, split] = WholeAndSplit(params, drawn / params.cylinders[0].BoreArea());
  EXPECT_NEAR(whole, kTraceAir * l.oil_volume_m3 * kAtmosphere / 1e-7, 0.05 * whole);
  EXPECT_NEAR(split, whole, 1e-3 * whole);
}

TEST(SequentialBalance, PressureIsContinuousWhereTheReservoirIsFull) {
  PhsParams params = Quarter();
  params.balance = BalanceMethod::kSequential;
  const PhsSystem s = Make(params);
  std::vector<double> state(static_cast<size_t>(s.num_states()), 0);
  Evaluation at(s);
  const double v[] = {0};
  double last = 0, steepest = 0;
  for (int i = 0; i <= 20000; ++i) {
    const double x[] = {4e-3 - i * 4e-7};
    s.Calc(0, x, v, state.data(), &at.out);
    const double p = at.p_bore[0];
    if (i > 0) {
      EXPECT_GE(p, last) << x[0];
      steepest = std::max(steepest, p - last);
    }
    last = p;
  }
  // No step is steeper than the oil alone: A dx beta/V.
  const LineParams& l = params.lines[1];
  const double oil = params.cylinders[0].BoreArea() * 4e-7 * l.bulk_modulus_Pa / l.oil_volume_m3;
  EXPECT_LT(steepest, 1.01 * oil);
  EXPECT_GT(steepest, 0.99 * oil);
}

TEST(StaticFriction, TheLargestDampingIsThatOfItsRamp) {
  PhsParams params = Quarter();
  params.friction.model = FrictionModel::kStatic;
  const PhsSystem s = Make(params);
  Evaluation slow(s), still(s);
  std::vector<double> state(static_cast<size_t>(s.num_states()), 0);
  const double x[] = {0}, rest[] = {0};
  const double speed[] = {0.5 * params.friction.ramp_speed_m_s};
  s.Calc(0, x, rest, state.data(), &still.out);
  s.Calc(0, x, speed, state.data(), &slow.out);
  EXPECT_GE(s.friction(0).MaxDamping() * 1.001, (slow.friction[0] - still.friction[0]) / speed[0]);
}

}  // namespace
}  // namespace phs::hydraulics
