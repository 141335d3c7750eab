// What the instrument effects do to the predicted channels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "rigs/rig_model.h"
#include "tests/effects/driven_cylinder.h"

namespace phs::effects {

using rigs::RigKind;
using rigs::RigModel;
using rigs::RigMotion;
using rigs::RigPrediction;
namespace {

std::vector<std::vector<double>> Shown(const PhsParams& params) {
  RigMotion motion;
  motion.step_s = 0.01;
  motion.position_m.resize(1);
  for (int i = 0; i < 400; ++i) motion.position_m[0].push_back(1e-3 * std::sin(0.02 * i));
  Result<RigModel> rig = RigModel::Create(RigKind::kQuarter, params);
  EXPECT_TRUE(rig.ok()) << rig.error().Line();
  RigPrediction out;
  EXPECT_TRUE(rig.value().Run(motion, &out).ok());
  return out.channels;
}

TEST(Instruments, GainOffsetDriftDelayOnPredictedChannels) {
  const PhsParams p = Quarter();
  const auto plain = Shown(p);
  const auto offset = Shown(With(p, "sensor_offset", {{"load_N", 120}, {"p_rod_Pa", -3e4}}));
  const auto drift = Shown(With(p, "sensor_drift", {{"p_bore_Pa_per_s", 500}}));
  const auto gain = Shown(With(p, "sensor_gain", {{"load", 1.05}}));
  const auto delay = Shown(With(p, "sensor_delay", {{"load_s", 0.025}}));
  EXPECT_DOUBLE_EQ(offset[1][200], plain[1][200] + 120);
  EXPECT_DOUBLE_EQ(offset[3][200], plain[3][200] - 3e4);
  EXPECT_DOUBLE_EQ(drift[2][200], plain[2][200] + 1000);
  const auto later = Shown(
      With(p, "sensor_drift", {{"p_bore_Pa_per_s", 500}, {"start_s", 1.5}, {"settling_s", 0.5}}));
  EXPECT_DOUBLE_EQ(later[2][140], plain[2][140]);
  EXPECT_NEAR(later[2][200], plain[2][200] + 500 * 0.5 * (1 - std::exp(-1)), 1e-6);
  EXPECT_DOUBLE_EQ(gain[1][200], 1.05 * plain[1][200]);
  EXPECT_NEAR(delay[1][200], 0.5 * (plain[1][197] + plain[1][198]), 1e-6);
}

TEST(Instruments, AnOffsetMayComeInTheRecord) {
  const PhsParams p = Quarter();
  const auto plain = Shown(p);
  const auto knocked = Shown(With(p, "sensor_offset", {{"p_bore_Pa", 5e4}, {"start_s", 1.5}}));
  EXPECT_DOUBLE_EQ(knocked[2][149], plain[2][149]);
  EXPECT_DOUBLE_EQ(knocked[2][151], plain[2][151] + 5e4);
  const auto slides =
      Shown(With(p, "sensor_offset", {{"load_N", 100}, {"start_s", 1.5}, {"within_s", 0.4}}));
  for (const size_t i : {0u, 150u, 160u, 300u}) {
    const double t = 0.01 * static_cast<double>(i);
    EXPECT_NEAR(slides[1][i] - plain[1][i], 50 * (1 + std::tanh(2 * (t - 1.5) / 0.4)), 1e-6) << t;
  }
}

TEST(Instruments, ALoadCellMayHaveAnotherGainInCompression) {
  const PhsParams p = Quarter();
  const auto plain = Shown(p);
  const auto shown = Shown(With(p, "sensor_gain", {{"load", 1.05}, {"load_compression", 0.9}}));
  const auto alone = Shown(With(p, "sensor_gain", {{"load_compression", 0.9}}));
  int tension = 0, compression = 0;
  for (size_t i = 0; i < plain[1].size(); ++i) {
    ++(plain[1][i] > 0 ? tension : compression);
    const double side = plain[1][i] > 0 ? 1 : 0.9;
    EXPECT_NEAR(shown[1][i], 1.05 * side * plain[1][i], 1e-9);
    EXPECT_NEAR(alone[1][i], side * plain[1][i], 1e-9);
  }
  EXPECT_GT(tension, 50);
  EXPECT_GT(compression, 50);
  EXPECT_EQ(shown[2], plain[2]);
}

TEST(Instruments, TheHalvesOfAnLvdtMayDiffer) {
  const PhsParams p = Quarter();
  const auto plain = Shown(p);
  const auto shown = Shown(With(p, "sensor_gain", {{"piston", 1.02}, {"piston_retraction", 0.97}}));
  for (size_t i = 0; i < plain[0].size(); ++i) {
    EXPECT_NEAR(shown[0][i], 1.02 * (plain[0][i] > 0 ? 1 : 0.97) * plain[0][i], 1e-15);
  }
  EXPECT_LT(*std::min_element(plain[0].begin(), plain[0].end()), -1e-4);
  EXPECT_EQ(shown[1], plain[1]);
}

/// What a filter in the channel of the load cell makes of a signal sampled every 5 ms.
std::vector<double> Filtered(double delay_s, double poles, std::vector<double> signal) {
  const PhsSystem s =
      Compile(With(Quarter(), "sensor_delay", {{"load_s", delay_s}, {"poles", poles}}));
  for (const auto& law : s.readings(0, hydraulics::Sensor::kLoad)) law->Lag(0.005, &signal);
  return signal;
}

// Of n lags of T one behind the other a ramp comes n T late; a kink is followed as
// t - n T + e^(-t/T) (T sum_k (n - k) (t/T)^k/k!), k from 0 to n - 1.
TEST(Instruments, AFilterLeftInTheChannelComesLate) {
  const double delay = 0.03;
  std::vector<double> ramp(200);
  for (size_t i = 0; i < ramp.size(); ++i) ramp[i] = 1e3 * 0.005 * static_cast<double>(i);
  const auto at = [](double n, double t, double T) {
    const double u = t / T;
    const double fades = n == 1 ? 1 : 2 + u;
    return 1e3 * (t - n * T + T * std::exp(-u) * fades);
  };
  for (const double n : {1.0, 2.0}) {
    const auto shown = Filtered(delay, n, ramp);
    for (const size_t i : {1u, 6u, 20u}) {
      EXPECT_NEAR(shown[i], at(n, 0.005 * static_cast<double>(i), delay / n), 0.05)
          << n << " " << i;
    }
    EXPECT_NEAR(shown.back(), ramp.back() - 1e3 * delay, 1e-6) << n;
  }
  const auto between = Filtered(delay, 1.25, ramp);
  EXPECT_NEAR(between[6], 0.75 * at(1, 0.03, delay) + 0.25 * at(2, 0.03, delay / 2), 0.02);
}

TEST(Instruments, AGaugeThatWasZeroedAtRestIsWrongAboutIt) {
  const PhsParams p = Quarter();
  const auto plain = Shown(p);
  const auto shown = Shown(With(p, "sensor_gain", {{"p_bore", 1.1}, {"zeroed_at_rest", 1}}));
  const double rest = p.lines[1].static_pressure_Pa;
  ASSERT_EQ(p.cylinders[0].bore_line, p.lines[1].name);
  for (const size_t i : {0u, 70u, 200u}) {
    EXPECT_NEAR(shown[2][i], rest + 1.1 * (plain[2][i] - rest), 1e-6);
  }
  EXPECT_EQ(shown[3], plain[3]);
}

TEST(Instruments, AGaugeMayBeRightUpToAPressure) {
  const PhsParams p = Quarter();
  const auto plain = Shown(p);
  const double from = p.lines[1].static_pressure_Pa + 2e5;
  const auto shown = Shown(With(p, "sensor_gain", {{"p_bore", 0.8}, {"from_Pa", from}}));
  int beyond = 0;
  for (size_t i = 0; i < plain[2].size(); ++i) {
    const double above = std::max(plain[2][i] - from, 0.0);
    beyond += above > 0;
    EXPECT_NEAR(shown[2][i], plain[2][i] - 0.2 * above, 1e-6);
  }
  EXPECT_GT(beyond, 20);
  EXPECT_LT(beyond, 380);
}

/// A plug of grease in the tap: the reading stands until the difference moves the plug.
TEST(Instruments, AGaugeBehindAPlugStandsStillAfterEveryReversal) {
  const PhsParams p = Quarter();
  const auto plain = Shown(p);
  const double width = 1e5;
  const auto shown = Shown(With(p, "sensor_hysteresis", {{"p_rod", 1}, {"width_Pa", width}}));
  const auto seeping =
      Shown(With(p, "sensor_hysteresis", {{"p_rod", 1}, {"width_Pa", width}, {"seeps_s", 0.05}}));
  double behind = 0, whole = 0, whole_seeping = 0;
  for (size_t i = 0; i + 1 < plain[3].size(); ++i) {
    behind = std::max(behind, std::abs(plain[3][i] - shown[3][i]));
    whole += std::abs(plain[3][i] - shown[3][i]);
    whole_seeping += std::abs(plain[3][i] - seeping[3][i]);
    if (std::abs(plain[3][i] - plain[3][0]) > width / 6) continue;
    if (i < 20) {
      EXPECT_NEAR(shown[3][i], plain[3][0], 1e-6) << "no element has slipped yet";
    }
  }
  EXPECT_NEAR(behind, width * 7 / 12, 1e-6 * width);
  EXPECT_LT(whole_seeping, 0.9 * whole);
  EXPECT_GT(whole_seeping, 0.1 * whole);
  EXPECT_EQ(shown[2], plain[2]);
}

// Nowhere faster than R; where the truth was slow for long enough it is shown.
TEST(Instruments, AnAmplifierFollowsNoFasterThanItsRate) {
  const PhsParams p = Quarter();
  const auto plain = Shown(p);
  double fastest = 0;
  for (size_t i = 1; i < plain[1].size(); ++i) {
    fastest = std::max(fastest, std::abs(plain[1][i] - plain[1][i - 1]) / 0.01);
  }
  const double R = 0.5 * fastest;
  const auto shown = Shown(With(p, "sensor_slew", {{"load_N_per_s", R}}));
  size_t late = 0;
  for (size_t i = 1; i < plain[1].size(); ++i) {
    EXPECT_LE(std::abs(shown[1][i] - shown[1][i - 1]) / 0.01, R * (1 + 1e-9)) << i;
    // It goes towards the truth, and reaches it or goes at its rate.
    const double left = plain[1][i] - shown[1][i];
    late += left != 0;
    if (left != 0) {
      EXPECT_NEAR((shown[1][i] - shown[1][i - 1]) / 0.01, std::copysign(R, left), 1e-6 * R) << i;
    }
  }
  EXPECT_GT(late, 0u);
  EXPECT_LT(late, plain[1].size() / 2);
  EXPECT_EQ(shown[2], plain[2]) << "the gauges follow";
  const auto quick = Shown(With(p, "sensor_slew", {{"load_N_per_s", 1.01 * fastest}}));
  EXPECT_EQ(quick[1], plain[1]);
}

TEST(Instruments, AGaugeThatCreepsShowsAShareLate) {
  const PhsParams p = Quarter();
  const auto plain = Shown(p);
  const auto shown = Shown(With(p, "sensor_creep",
                                {{"load", 0.05},
                                 {"time_s", 0.7},
                                 {"slow_part", 0.25},
                                 {"slow_time_s", 3},
                                 {"p_rod", -0.02}}));
  double quick = 0, slow = 0;
  for (size_t i = 0; i + 1 < plain[1].size(); ++i) {
    const double from = plain[1][i] - plain[1][0], to = plain[1][i + 1] - plain[1][0];
    for (int k = 0; k < 1000; ++k) {
      const double u = from + (to - from) * (k + 0.5) / 1000;
      quick += 0.01 / 1000 * (u - quick) / 0.7, slow += 0.01 / 1000 * (u - slow) / 3;
    }
    EXPECT_NEAR(shown[1][i + 1] - plain[1][i + 1], 0.05 * (0.75 * quick + 0.25 * slow), 0.05)
        << i << ": of some kN";
  }
  // A third each with tau/4, tau, 4 tau is as much as three gauges, each with its own time.
  const auto wide =
      Shown(With(p, "sensor_creep", {{"load", 0.06}, {"time_s", 0.7}, {"spread", 4}}));
  std::vector<double> sum(plain[1].size(), 0.0);
  for (const double own : {0.7 / 4, 0.7, 0.7 * 4}) {
    const auto one = Shown(With(p, "sensor_creep", {{"load", 0.02}, {"time_s", own}}));
    for (size_t i = 0; i < sum.size(); ++i) sum[i] += one[1][i] - plain[1][i];
  }
  for (size_t i = 0; i < sum.size(); i += 13) {
    EXPECT_NEAR(wide[1][i] - plain[1][i], sum[i], 1e-6) << i;
  }
  const auto settled = Shown(With(
      p, "sensor_creep",
      {{"load", 0.05}, {"time_s", 0.7}, {"slow_part", 0.25}, {"slow_time_s", 3}, {"settled", 1}}));
  for (size_t i = 0; i < plain[1].size(); i += 17) {
    EXPECT_NEAR(settled[1][i], shown[1][i] - 0.05 * (plain[1][i] - plain[1][0]), 1e-9);
  }
  EXPECT_DOUBLE_EQ(shown[3][0], plain[3][0]);
  EXPECT_NE(shown[3][300], plain[3][300]);
  EXPECT_EQ(shown[2], plain[2]);
}

/// Up and down again: the loop does not know how fast, it closes, and it lags.
TEST(Instruments, ALoadCellWithHysteresisGoesAnotherWayBack) {
  const PhsParams p = Quarter();
  const auto plain = Shown(p);
  const double share = 0.1, width = 6000;
  const auto shown = Shown(With(p, "sensor_hysteresis", {{"load", share}, {"width_N", width}}));
  double most = 0, loop = 0;
  for (size_t i = 0; i + 1 < plain[1].size(); ++i) {
    most = std::max(most, std::abs(plain[1][i] - shown[1][i]));
    loop += 0.5 * (plain[1][i] + plain[1][i + 1] - shown[1][i] - shown[1][i + 1]) *
            (plain[1][i + 1] - plain[1][i]);
  }
  EXPECT_GT(loop, 0) << "what the part beside takes up it does not give back";
  // All six elements slip: mean of W/6 … W.
  EXPECT_NEAR(most, share * width * 7 / 12, 1e-9 * width);
}

TEST(Instruments, ADriftMayComeAndGoWithAPeriod) {
  const PhsParams p = Quarter();
  const auto plain = Shown(p);
  const auto wave = Shown(With(p, "sensor_drift",
                               {{"p_bore_Pa_per_s", 0},
                                {"p_bore_sine_Pa", 300},
                                {"p_bore_cosine_Pa", 80},
                                {"period_s", 3}}));
  for (const size_t i : {0u, 70u, 200u}) {
    const double phase = 2 * M_PI * 0.01 * static_cast<double>(i) / 3;
    EXPECT_NEAR(wave[2][i] - plain[2][i], 300 * std::sin(phase) + 80 * (std::cos(phase) - 1), 1e-6);
  }
}

TEST(Instruments, LagsAndGainsComeBeforeErrorsWhateverTheirOrder) {
  const auto plain = Shown(Quarter());
  PhsParams p = With(Quarter(), "sensor_offset", {{"load_N", 120}});
  p = With(p, "sensor_gain", {{"load", 1.05}});
  p = With(p, "sensor_drift", {{"load_N_per_s", 50}});
  p = With(p, "sensor_delay", {{"load_s", 0.02}});
  p = With(p, "sensor_gain", {{"load", 0.9}});
  const auto shown = Shown(p);
  EXPECT_NEAR(shown[1][200], 1.05 * 0.9 * plain[1][198] + 120 + 50 * 2, 1e-9);
  EXPECT_EQ(shown[2], plain[2]);
}

/// Solomon 1974: between two samples the mean of R tanh(behind/(R tau)) at both, to (h/tau)²/12.
TEST(Instruments, AnAmplifierRunsIntoItsRateLittleByLittle) {
  const PhsParams p = Quarter();
  const auto plain = Shown(p);
  double fastest = 0;
  for (size_t i = 1; i < plain[1].size(); ++i) {
    fastest = std::max(fastest, std::abs(plain[1][i] - plain[1][i - 1]) / 0.01);
  }
  for (const double R : {0.5 * fastest, 5 * fastest}) {
    const double tau = 0.1;
    const auto shown = Shown(With(p, "sensor_slew", {{"load_N_per_s", R}, {"time_s", tau}}));
    const auto rate = [&](size_t i) {
      return R * std::tanh((plain[1][i] - shown[1][i]) / (R * tau));
    };
    for (size_t i = 1; i < plain[1].size(); ++i) {
      EXPECT_NEAR((shown[1][i] - shown[1][i - 1]) / 0.01, 0.5 * (rate(i - 1) + rate(i)), 3e-3 * R);
    }
  }
  const auto lag = Shown(With(p, "sensor_slew", {{"load_N_per_s", 1e11}, {"time_s", 0.02}}));
  const auto filter = Shown(With(p, "sensor_delay", {{"load_s", 0.02}, {"poles", 1}}));
  for (size_t i = 0; i < lag[1].size(); ++i) EXPECT_NEAR(lag[1][i], filter[1][i], 10);  // N
  const std::map<std::string, double> hard = {{"load_N_per_s", 0.5 * fastest}};
  auto soft = hard;
  soft["time_s"] = 1e-6;
  const auto at_once = Shown(With(p, "sensor_slew", hard))[1];
  const auto nearly = Shown(With(p, "sensor_slew", soft))[1];
  for (size_t i = 0; i < at_once.size(); ++i) {
    EXPECT_NEAR(nearly[i], at_once[i], 0.25 * 0.01 * fastest) << i << ": a part of a step";
  }
}

/// Rapp 1991: at L itself 2^(-1/n) of it; small signals as they are, large ones L, either way.
TEST(Instruments, AnAmplifierSaturatesAtTheEndOfItsRange) {
  const PhsParams p = Quarter();
  const auto plain = Shown(p);
  const double L = 0.5 * *std::max_element(plain[1].begin(), plain[1].end()), n = 6;
  const auto shown = Shown(With(p, "sensor_saturation", {{"load_N", L}, {"sharpness", n}}));
  size_t beyond = 0;
  for (size_t i = 0; i < plain[1].size(); ++i) {
    const double x = plain[1][i];
    EXPECT_NEAR(shown[1][i], x / std::pow(1 + std::pow(std::abs(x) / L, n), 1 / n), 1e-9 * L) << i;
    EXPECT_LT(std::abs(shown[1][i]), L);
    beyond += std::abs(x) > L;
  }
  EXPECT_GT(beyond, 0u);
  EXPECT_EQ(shown[2], plain[2]);
  const auto hard = Shown(With(p, "sensor_saturation", {{"p_rod_Pa", 2.1e6}, {"sharpness", 900}}));
  for (size_t i = 0; i < plain[3].size(); ++i) {
    EXPECT_NEAR(hard[3][i], std::min(plain[3][i], 2.1e6), 2e3) << "a converter that clips";
  }
}

/// A clock that runs too fast by a hundredth: after i samples it shows what was i/100 samples ago.
TEST(Instruments, ACardWithAClockOfItsOwnComesEverLater) {
  const PhsParams p = Quarter();
  const auto plain = Shown(p);
  const auto fast = Shown(With(p, "sensor_clock", {{"p_rod", 0.01}}));
  EXPECT_NEAR(fast[3][100], plain[3][99], 1e-6);
  EXPECT_NEAR(fast[3][350], 0.5 * (plain[3][346] + plain[3][347]), 1e-6);
  EXPECT_EQ(fast[1], plain[1]);
  const auto slow = Shown(With(p, "sensor_clock", {{"all", -0.02}, {"load", 0.02}}));
  EXPECT_NEAR(slow[0][200], plain[0][204], 1e-15);
  EXPECT_NEAR(slow[2][100], plain[2][102], 1e-6);
  EXPECT_EQ(slow[2].back(), plain[2].back()) << "nothing is known beyond the record";
  EXPECT_EQ(slow[1], plain[1]) << "the load cell's card is right";
}

}  // namespace
}  // namespace phs::effects
