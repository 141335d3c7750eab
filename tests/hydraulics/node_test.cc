// The volume balance of one pressure: a few Newton steps lead to the solution by brackets.
#include <gtest/gtest.h>

#include <cmath>

#include "hydraulics/perfect_gas.h"
#include "hydraulics/solve_node.h"

namespace phs::hydraulics {
namespace {

// Oil that stiffens and a polytropic gas: no closed form.
Node StiffeningOilAndGas() {
  Node node;
  node.p0 = 2e6, node.oil_volume = 1.1e-3, node.oil = {1.4e9, 10};
  node.air = 1e-6 * node.oil_volume * kAtmosphere, node.temperature = 293.15;
  NodeGas gas;
  gas.gas.law = &kPolytropicGas;
  gas.gas.reference_volume = gas.static_volume = 1.8e-5;
  gas.gas.reference_pressure = 2e6, gas.gas.reference_temperature = 293.15;
  gas.gas.max_volume = 3e-4;
  gas.gas.SetMass();
  node.gases.push_back(gas);
  node.Prepare();
  return node;
}

TEST(Node, StepsLeadQuadraticallyToTheSolution) {
  const Node node = StiffeningOilAndGas();
  for (const double D : {-8e-6, -1e-6, 2e-6, 9e-6}) {
    const NodeState solved = SolveNode(node, D, 293.15, nullptr);
    NodeState at = SolveNode(node, D - 1e-6, 293.15, nullptr);
    double before = 1;
    for (int i = 0; i < 4; ++i) {
      const double moved = StepNode(node, D, 293.15, nullptr, &at);
      EXPECT_LE(moved, std::max(10 * before * before, 1e-14)) << D << " step " << i;
      EXPECT_EQ(at.pushed, D);
      before = moved;
    }
    EXPECT_NEAR(at.p / solved.p, 1, 1e-13) << D;
    EXPECT_NEAR(at.slope / solved.slope, 1, 2e-7) << D;  // that of the last step but one
  }
}

/// A hose that counts how often it is asked.
class CountedHose final : public VolumeLaw {
 public:
  void Add(double pressure, double, double* volume, double* slope) const noexcept override {
    ++asked;
    *volume += 3e-13 * (pressure - 2e6), *slope += 3e-13;
  }
  double Energy(double, double) const noexcept override { return 0; }
  mutable int asked = 0;
};

/// Where rounding puts the end of a step on the end of the bracket, the pressure had been thrown to a
/// sixteenth or to sixteen times itself, and was found again in thirty steps more.
TEST(Node, APressureThatIsFoundIsNotSoughtAgain) {
  Node node = StiffeningOilAndGas();
  const CountedHose hose;
  node.laws.push_back({&hose});
  node.Prepare();
  NodeState at = SolveNode(node, 0, 293.15, nullptr);
  int most = 0;
  for (int i = 0; i < 2000; ++i) {
    hose.asked = 0;
    at = SolveNode(node, 3e-6 * std::sin(0.01 * i), 293.15, nullptr, &at);
    at = SolveNode(node, at.pushed, 293.15, nullptr, &at);
    most = std::max(most, hose.asked);
  }
  EXPECT_LE(most, 5) << "for two solutions, the second of which is there";
}

TEST(Node, AStepThatWouldGoFarIsSolved) {
  const Node node = StiffeningOilAndGas();
  NodeState at = SolveNode(node, -1.5e-5, 293.15, nullptr);
  EXPECT_EQ(StepNode(node, 1.2e-5, 293.15, nullptr, &at), 0);
  EXPECT_NEAR(at.p / SolveNode(node, 1.2e-5, 293.15, nullptr).p, 1, 1e-9);
}

/// A closed form has two ways: with sums made once, at the static temperature, and gas by gas.
TEST(Node, SumsMadeOnceAreTheGasesOneByOne) {
  Node node;
  node.p0 = 2e6, node.oil_volume = 1.1e-3, node.oil = {1.4e9}, node.temperature = 293.15;
  node.air = kTraceAir * node.oil_volume * kAtmosphere;
  NodeGas reservoir, blow_off;
  reservoir.gas.reference_volume = reservoir.static_volume = 16e-6;
  reservoir.gas.reference_pressure = 2e6;
  reservoir.gas.max_volume = 3.2e-4;
  blow_off.gas.reference_volume = blow_off.gas.max_volume = blow_off.static_volume = 0.75e-3;
  blow_off.gas.reference_pressure = 5e6, blow_off.blow_off = true;
  for (NodeGas* gas : {&reservoir, &blow_off}) {
    gas->gas.reference_temperature = 293.15;
    gas->gas.SetMass();
    node.gases.push_back(*gas);
  }
  node.Prepare();
  ASSERT_TRUE(node.plain);
  Node other = node;
  other.plain = false;
  for (double D = -1e-5; D < 6e-5; D += 3e-6) {
    const NodeState one = SolveNode(node, D, 293.15, nullptr);
    const NodeState all = SolveNode(other, D, 293.15, nullptr);
    EXPECT_DOUBLE_EQ(one.p, all.p) << D;
    EXPECT_DOUBLE_EQ(one.slope, all.slope) << D;
    double slope;
    EXPECT_NEAR(CalcAbsorbed(node, one.p, 293.15, nullptr, &slope), D, 1e-15) << D;
    EXPECT_NEAR(slope / one.slope, 1, 1e-12) << D;
  }
}

}  // namespace
}  // namespace phs::hydraulics
