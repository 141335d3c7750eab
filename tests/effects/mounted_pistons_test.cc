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

// Where oil flows all pistons are moved at once, where none does one at a time: by a leak of nothing
// the same comes out.
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

}  // namespace
}  // namespace phs::effects
