// Several pistons behind mountings that yield, on lines that they share.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

using hydraulics::BoBo;

constexpr int kCylinders = 4;

/// Pistons and pressures after 2 s of four motions that have nothing in common.
std::vector<double> After(const PhsSystem& s) {
  std::vector<double> state(s.num_states(), 0.0), rate(state);
  Evaluation e(s);
  const double h = 2e-3;
  double x[kCylinders], v[kCylinders];
  const auto at = [](int c, double t) {
    return 1e-3 * std::sin((2.0 + 0.7 * c) * t) * std::cos(0.9 * c * t);
  };
  for (int i = 0; i < 1000; ++i) {
    for (int c = 0; c < kCylinders; ++c) {
      x[c] = at(c, i * h), v[c] = (at(c, (i + 1) * h) - x[c]) / h;
    }
    s.CalcStateRate(i * h, h, x, v, state.data(), rate.data());
    for (size_t k = 0; k < state.size(); ++k) state[k] += h * rate[k];
  }
  for (int c = 0; c < kCylinders; ++c) x[c] = at(c, 1000 * h);
  s.Calc(1000 * h, x, v, state.data(), &e.out);
  std::vector<double> out;
  for (int c = 0; c < kCylinders; ++c) {
    out.insert(out.end(), {e.piston[c], e.p_bore[c], e.p_rod[c]});
  }
  return out;
}

// Pressures of closed chambers and of stages in which oil flows: by a leak of nothing the same
// comes out.
TEST(MountedPistons, ALeakOfNothingChangesNothing) {
  for (const auto& [mount, values] :
       {std::pair("backlash", std::map<std::string, double>{{"gap_m", 2e-4}}),
        {"mount_compliance", {{"stiffness_N_per_m", 2e7}}}}) {
    const PhsParams mounted = With(BoBo(), mount, values);
    const auto closed = After(Compile(mounted));
    const auto leaking =
        After(Compile(With(mounted, "piston_leakage", {{"conductance_m3_per_Pas", 1e-22}})));
    for (size_t i = 0; i < closed.size(); ++i) {
      EXPECT_NEAR(leaking[i], closed[i], i % 3 == 0 ? 2e-9 : 20) << mount << " " << i;
    }
  }
}

/// A mass of 2 t that a force pulls, between two cylinders.
class Mass final : public hydraulics::CarriedBody {
 public:
  Mass(double h, double force) : inertia_(2000 / (h * h)), force_(force) {
    arm[2] = 1, arm[3] = -1;
  }
  double Hold(double way, double* slope) const override {
    *slope = inertia_;
    return inertia_ * way - force_;
  }

 private:
  double inertia_, force_;
};

// What the body and the pistons are said to go balances: the forces of the cylinders by another
// way, the state rates of a step along it.
TEST(MountedPistons, ABodyAndItsPistonsBalanceTogether) {
  for (const auto& mount : {"backlash", "mount_compliance", "bush_viscoelastic"}) {
    for (const double force : {3e4, -8e4}) {
      const PhsSystem s = Compile(With(BoBo(), mount));
      const double h = 5e-3, x[kCylinders] = {}, given[kCylinders] = {0.02, -0.01, 0, 0};
      std::vector<double> state(s.num_states(), 0.0), rate(state);
      hydraulics::Instant at, end;
      s.Solve(0, x, state.data(), &at);
      const Mass mass(h, force);
      double piston_way[kCylinders] = {}, way = 0;
      ASSERT_TRUE(s.BalanceBody(at, h, x, given, state.data(), mass, piston_way, &way));
      double v[kCylinders] = {given[0], given[1], way / h, -way / h}, to[kCylinders];
      s.CalcStateRateAt(at, h, x, v, state.data(), rate.data());
      for (size_t k = 0; k < state.size(); ++k) state[k] = h * rate[k];
      for (int c = 0; c < kCylinders; ++c) to[c] = h * v[c];
      s.Solve(h, to, state.data(), &end);
      Evaluation e(s);
      s.CalcAt(end, to, v, state.data(), &e.out);
      double slope;
      EXPECT_NEAR(mass.Hold(way, &slope) + e.force[2] - e.force[3], 0, 1e-3 * std::abs(force))
          << mount << ", N";
      for (int c = 0; c < kCylinders; ++c) EXPECT_NEAR(e.piston[c], piston_way[c], 1e-10) << mount;
      EXPECT_GT(std::abs(e.force[2]), 0.05 * std::abs(force)) << mount;
    }
  }
}

}  // namespace
}  // namespace phs::effects
