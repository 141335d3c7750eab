// Means and totals of a run, from columns whose means and totals are known.
#include "vehicle/run_summary.h"

#include <gtest/gtest.h>

#include "vehicle/radius_table.h"
#include "vehicle/scenario_file.h"

namespace phs::vehicle {
namespace {

class RunSummaryTest : public ::testing::Test {
 protected:
  /// A short run, whose columns are then written anew: 1 m apart over the whole track.
  static Simulation Create() {
    Scenario scenario = LoadScenario("curve_r300").value();
    scenario.bogie = "rigid_link";
    scenario.duration_s = 0.05;
    auto created = Simulation::Create(scenario);
    EXPECT_TRUE(created.ok()) << created.error().Line();
    return std::move(created).value();
  }
  RunSummaryTest() : sim_(Create()), run_(sim_.Run().value()) {
    const auto rows = static_cast<size_t>(sim_.binding().track().length()) + 1;
    for (auto& column : run_.columns) column.assign(rows, 0.0);
    for (size_t i = 0; i < rows; ++i) Column("s_m")[i] = static_cast<double>(i);
  }
  std::vector<double>& Column(const std::string& name) {
    return run_.columns.at(static_cast<size_t>(run_.Find(name)));
  }
  const rail::TrackSection& Curve() const {
    for (const rail::TrackSection& section : sim_.binding().track().sections()) {
      if (section.kind == "curve") return section;
    }
    throw std::runtime_error("no curve");
  }

  Simulation sim_;
  RunOutcome run_;
};

TEST_F(RunSummaryTest, SteadyMeansAreOverTheLastThirdOfTheCurve) {
  const rail::TrackSection& curve = Curve();
  const double begin = curve.end_s - (curve.end_s - curve.begin_s) / 3;
  for (const double s : Column("s_m")) {
    const auto row = static_cast<size_t>(s);
    Column("lead_sum_Y_N")[row] = s < begin || s > curve.end_s ? 1e6 : s;
  }
  const SteadyMeans means = CalcSteadyMeans(sim_, run_);
  EXPECT_NEAR(means.FindWheelset("lead")->sum_Y_N, 0.5 * (begin + curve.end_s), 1);
  EXPECT_NEAR(means.curvature_1_m, 1 / 300.0, 1e-12);
}

TEST_F(RunSummaryTest, TGammaOverTheRunIsItsIntegralOverTheWay) {
  // Between rows 0.2 s the speed rises as 10 m/s + t (m/s2), T-gamma is 7 N on each of four wheels.
  const auto rows = Column("t_s").size();
  for (size_t i = 0; i < rows; ++i) {
    Column("t_s")[i] = 0.2 * static_cast<double>(i);
    Column("speed_m_s")[i] = 10 + Column("t_s")[i];
    for (const char* wheel : {"lead_left", "lead_right", "trail_left", "trail_right"}) {
      Column(std::string(wheel) + "_T_gamma_N")[i] = 7;
    }
  }
  const double end = Column("t_s").back();
  const double way = 10 * end + 0.5 * end * end;
  EXPECT_NEAR(Summarise(sim_, run_).numbers->run.T_gamma_total_J / (4 * 7 * way), 1, 1e-12);
}

TEST_F(RunSummaryTest, TheLargestOfARunIsAMagnitudeTheLeastLoadIsNot) {
  Column("trail_left_Y_over_Q")[30] = -0.7;
  Column("lead_right_Y_over_Q")[31] = 0.3;
  Column("lead_sum_Y_N")[5] = -21e3;
  Column("trail_angle_of_attack_rad")[5] = -4e-3;
  for (auto* column : {&Column("lead_left_Q_N"), &Column("lead_right_Q_N"),
                       &Column("trail_left_Q_N"), &Column("trail_right_Q_N")}) {
    column->assign(column->size(), 80e3);
  }
  Column("trail_right_Q_N")[9] = 12e3;
  const WholeRun run = Summarise(sim_, run_).numbers->run;
  EXPECT_EQ(run.max_Y_over_Q, 0.7);
  EXPECT_EQ(run.max_sum_Y_N, 21e3);
  EXPECT_EQ(run.max_angle_of_attack_rad, 4e-3);
  EXPECT_EQ(run.min_Q_N, 12e3);
}

TEST(RadiusTableTest, ARowKnowsItsRadius) {
  Scenario curve = LoadScenario("curve_r300").value();
  const auto rows = RunRadii({curve}, {"rigid_link"}, {});
  ASSERT_TRUE(rows.ok()) << rows.error().Line();
  ASSERT_EQ(rows.value().size(), 1u);
  EXPECT_NEAR(rows.value()[0].radius_m, 300, 1e-9);
  EXPECT_EQ(rows.value()[0].hand, 1);
}

}  // namespace
}  // namespace phs::vehicle
