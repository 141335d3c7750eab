// A cylinder of the quarter rig with effects, driven along a given motion: what the laws of the
// effects are judged on.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "effects/catalogue.h"
#include "rigs/rig_model.h"
#include "tests/hydraulics/test_systems.h"

namespace phs::effects {

using hydraulics::Evaluation;
using hydraulics::FrictionModel;
using hydraulics::kAtmosphere;
using hydraulics::PhsParams;
using hydraulics::PhsSystem;
using hydraulics::Quarter;

/// The parameters with one more effect.
inline PhsParams With(PhsParams params, const std::string& effect,
                      std::map<std::string, double> values = {},
                      std::vector<std::string> targets = {}) {
  params.effects.push_back({effect, std::move(targets), std::move(values)});
  return params;
}

inline PhsSystem Compile(const PhsParams& params) { return hydraulics::Make(params, &Catalogue()); }

/// The last evaluation of a drive; extension and tension positive, SI.
struct Held {
  double force, pressure_force, friction, piston, p_bore, p_rod;
  std::vector<double> state;
};
/// Follows x = motion(t) from t = 0 for `duration` with explicit steps h, from a state of zeros.
template <typename Motion>
Held Drive(const PhsSystem& s, double duration, double h, Motion motion) {
  std::vector<double> state(s.num_states(), 0.0), rate(state);
  Evaluation e(s);
  const int n = static_cast<int>(std::lround(duration / h));
  double v = 0;
  for (int i = 0; i < n; ++i) {
    const double x = motion(i * h);
    v = (motion((i + 1) * h) - x) / h;
    s.CalcStateRate(i * h, h, &x, &v, state.data(), rate.data());
    for (size_t k = 0; k < state.size(); ++k) state[k] += h * rate[k];
  }
  const double x = motion(duration);
  s.Calc(duration, &x, &v, state.data(), &e.out);
  return {e.force[0],  e.pressure_force[0], e.friction[0], e.piston[0],
          e.p_bore[0], e.p_rod[0],          state};
}
/// Channels of a quarter rig that makes a sine of 1 mm and 4 rad/s.
inline std::vector<std::vector<double>> ChannelsOfASine(const PhsParams& params, double step_s,
                                                        int samples) {
  rigs::RigMotion motion;
  motion.step_s = step_s;
  motion.position_m.resize(1);
  for (int i = 0; i < samples; ++i) {
    motion.position_m[0].push_back(1e-3 * std::sin(4 * step_s * i));
  }
  const auto rig = rigs::RigModel::Create(rigs::RigKind::kQuarter, params);
  rigs::RigPrediction out;
  EXPECT_TRUE(rig.ok() && rig.value().Run(motion, &out).ok());
  return out.channels;
}
/// Holds x from the start.
inline Held Hold(const PhsSystem& s, double x, double duration, double h = 1e-3) {
  return Drive(s, duration, h, [x](double) { return x; });
}

inline PhsParams Frictionless() {
  PhsParams p = Quarter();
  p.friction.model = FrictionModel::kNone;
  return p;
}

/// Oil alone in the lines, no friction, and one effect.
inline PhsParams OilWith(const std::string& effect, std::map<std::string, double> values) {
  PhsParams params = Frictionless();
  for (auto& l : params.lines) l.gas_volume_m3 = 0;
  return With(params, effect, std::move(values));
}

}  // namespace phs::effects
