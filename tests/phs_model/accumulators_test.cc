// Accumulators made cheaper (docs/gas_laws.md): the spring-damper and the relief valve of the
// shipped models against the gas of the full one.
#include <gtest/gtest.h>

#include <vector>

#include "phs_model/phs_model.h"

namespace phs::phs_model {
namespace {

using hydraulics::PhsSystem;

PhsSystem Load(const std::string& name) {
  auto params = FindPhsParams(name);
  EXPECT_TRUE(params.ok());
  auto system = CreatePhsSystem(params.value());
  EXPECT_TRUE(system.ok()) << (system.ok() ? "" : system.error().Line());
  return std::move(system).value();
}

/// Pressures of the lines with all four pistons moved by x, at once or after a long while.
std::vector<double> Pressures(const PhsSystem& system, double x, bool settled) {
  const std::vector<double> place(4, x), speed(4, 0.0);
  std::vector<double> state(static_cast<size_t>(system.num_states())), rate = state;
  constexpr double kLong = 10;
  for (int i = 0; settled && i < 50; ++i) {
    system.CalcStateRate(0, kLong, place.data(), speed.data(), state.data(), rate.data());
    for (size_t k = 0; k < state.size(); ++k) state[k] += kLong * rate[k];
  }
  std::vector<double> cylinders[6], pressure(4);
  for (auto& c : cylinders) c.resize(4);
  hydraulics::PhsOutputs out{cylinders[0].data(),
                             cylinders[1].data(),
                             cylinders[2].data(),
                             cylinders[3].data(),
                             cylinders[4].data(),
                             cylinders[5].data(),
                             nullptr,
                             pressure.data()};
  system.Calc(0, place.data(), speed.data(), state.data(), &out);
  return pressure;
}

/// dp/dx of each line at rest.
std::vector<double> Slopes(const PhsSystem& system, bool settled) {
  constexpr double kSmall = 1e-6;
  std::vector<double> slope = Pressures(system, kSmall, settled);
  const std::vector<double> back = Pressures(system, -kSmall, settled);
  for (size_t i = 0; i < slope.size(); ++i) slope[i] = (slope[i] - back[i]) / (2 * kSmall);
  return slope;
}

TEST(Accumulators, TheSettledSpringIsTheTangentOfTheGas) {
  const auto gas = Slopes(Load("bo_bo_measured"), true);
  const auto spring = Slopes(Load("bo_bo_spring"), true);
  for (size_t i = 0; i < gas.size(); ++i) EXPECT_NEAR(spring[i] / gas[i], 1, 1e-4) << i;
}

TEST(Accumulators, TheQuickSpringIsTheTangentOfAnAdiabaticGas) {
  hydraulics::PhsParams params = FindPhsParams("bo_bo_measured").value();
  for (auto& line : params.lines) {
    line.reservoir.law = hydraulics::FindGasLaw("polytropic");
    line.reservoir.polytropic_exponent = 1.4;
  }
  const auto gas = Slopes(CreatePhsSystem(params).value(), false);
  const auto spring = Slopes(Load("bo_bo_spring"), false);
  for (size_t i = 0; i < gas.size(); ++i) EXPECT_NEAR(spring[i] / gas[i], 1, 1e-4) << i;
}

TEST(Accumulators, TheBlowOffSpringOpensWhereTheGasDoes) {
  // Rod lines L1 and L4: extension presses them. Just beyond the precharge both give way alike.
  const PhsSystem gas = Load("bo_bo_measured"), spring = Load("bo_bo_spring");
  const double precharge = gas.params().lines[0].accumulator_precharge_Pa;
  const auto at = [](const PhsSystem& s, double x) { return Pressures(s, x, true)[0]; };
  const auto opens = [&](const PhsSystem& s) {
    double low = 0, high = 0.02;
    for (int i = 0; i < 60; ++i)
      (at(s, (low + high) / 2) > precharge ? high : low) = (low + high) / 2;
    return low;
  };
  constexpr double kFar = 1e-3;
  const double of_gas = opens(gas), of_spring = opens(spring);
  const double rise_gas = at(gas, of_gas + kFar) - precharge;
  EXPECT_NEAR((at(spring, of_spring + kFar) - precharge) / rise_gas, 1, 0.1);
  EXPECT_GT(of_spring, of_gas) << "a spring does not stiffen on the way up";
}

TEST(Accumulators, TheReliefValveHoldsItsPressure) {
  const PhsSystem relief = Load("bo_bo_relief"), gas = Load("bo_bo_measured");
  const double precharge = gas.params().lines[0].accumulator_precharge_Pa;
  for (const double x : {0.010, 0.020, 0.028}) {
    const double held = Pressures(relief, x, false)[0], full = Pressures(gas, x, false)[0];
    EXPECT_NEAR(held / precharge, 1, 1e-3) << x;
    EXPECT_GT(full, held + 0.5e6) << x;
  }
  // Closed, it is not there.
  EXPECT_EQ(Pressures(relief, 1e-3, false), Pressures(gas, 1e-3, false));
}

}  // namespace
}  // namespace phs::phs_model
