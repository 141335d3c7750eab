#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "analysis/running_assessment_json.h"
#include "vehicle/scenario_file.h"
#include "vehicle/simulation.h"
#include "vehicle/summary.h"

namespace phs::analysis {
namespace {

using Json = nlohmann::ordered_json;

struct Assessed {
  Json assessment;
  Json summary;
};

Assessed Execute(const std::string& scenario, const std::string& bogie, double record_interval_s) {
  auto loaded = vehicle::LoadScenario(scenario);
  EXPECT_TRUE(loaded.ok()) << loaded.error().Line();
  vehicle::Scenario s = loaded.value();
  s.bogie = bogie;
  s.record_interval_s = record_interval_s;
  auto simulation = vehicle::Simulation::Create(s);
  EXPECT_TRUE(simulation.ok()) << simulation.error().Line();
  auto run = simulation.value().Run();
  EXPECT_TRUE(run.ok());
  return {AssessmentJson(AssessRun(simulation.value(), run.value())),
          vehicle::SummaryJson(vehicle::Summarise(simulation.value(), run.value()))};
}

const Json& Named(const Json& list, const std::string& name) {
  for (const Json& entry : list) {
    if (entry["name"] == name) return entry;
  }
  static const Json none;
  return none;
}

const Json& Arc(const Json& assessment) {
  for (const Json& section : assessment["sections"]) {
    if (section["kind"] == "curve") return section;
  }
  static const Json none;
  return none;
}

TEST(RunningAssessment, QuasiStaticValuesOfAnArcAreItsSteadyMeans) {
  const Assessed a = Execute("curve_r300", "rigid_link", 0.01);
  ASSERT_EQ(a.assessment["status"], "ok");
  const Json& lead = Named(Arc(a.assessment)["wheelsets"], "lead");
  const Json& outer = Named(a.summary["steady_curve"]["wheels"], "lead_outer");
  EXPECT_NEAR(lead["Y_qst_N"]["value"].get<double>() / outer["Y_N"].get<double>(), 1, 0.01);
  EXPECT_NEAR(lead["Q_qst_N"]["value"].get<double>() / outer["Q_N"].get<double>(), 1, 0.01);
  // Both wheels push outwards, so their sum is less than either.
  const double sum =
      std::abs(Named(a.summary["steady_curve"]["wheelsets"], "lead")["sum_Y_N"].get<double>());
  EXPECT_NEAR(lead["sum_Y_N"]["value"].get<double>() / sum, 1, 0.05);
  // 26 t: 127.5 kN; Prud'homme 10 kN + 2/3 Q0; below 400 m radius 30 kN + 10500 kN m/R.
  EXPECT_NEAR(a.assessment["static_wheel_load_N"].get<double>(), 127.53e3, 20);
  EXPECT_NEAR(lead["sum_Y_N"]["limit"].get<double>(), 95.02e3, 20);
  EXPECT_NEAR(lead["Y_qst_N"]["limit"].get<double>(), 65e3, 1);
  EXPECT_TRUE(a.assessment["limits_are_orientation"].get<bool>());
  // 160 kN on the outer wheel is beyond 145 kN, and the worst of all says so.
  EXPECT_FALSE(a.assessment["worst"]["Q_qst_N"]["kept"].get<bool>());
  EXPECT_EQ(a.assessment["worst"]["Q_qst_N"]["wheelset"], "lead");
}

TEST(RunningAssessment, WearRegimesFollowTGammaOfEveryWheel) {
  const Assessed a = Execute("curve_r300", "rigid_link", 0.01);
  for (const Json& wheel : a.summary["steady_curve"]["wheels"]) {
    const std::string side = wheel["side"];
    const std::string own =
        wheel["name"].get<std::string>().substr(0, 4) == "lead" ? "lead_" + side : "trail_" + side;
    const Json& assessed = Named(a.assessment["wheels"], own);
    const double t_gamma = wheel["T_gamma_N"];
    EXPECT_NEAR(assessed["steady_T_gamma_N"].get<double>(), t_gamma, 1e-6 * t_gamma + 1e-9);
    EXPECT_EQ(assessed["steady_wear_regime"], t_gamma > 200   ? "catastrophic"
                                              : t_gamma > 100 ? "severe"
                                                              : "mild");
    EXPECT_EQ(assessed["steady_rcf_damage_per_pass"].get<double>() > 0,
              t_gamma > 20 && t_gamma < 175);
  }
  // Pearce and Sherratt with 1250 mm: the leading outer wheel wears (1.19 T - 154)/D on the arc.
  const Json& worst = Named(a.assessment["wheels"], "lead_right");
  const double on_arc = (1.19 * worst["steady_T_gamma_N"].get<double>() - 154) / 1250;
  EXPECT_GT(worst["worn_area_mm2_per_km"].get<double>(), 0.3 * on_arc);
  EXPECT_LT(worst["worn_area_mm2_per_km"].get<double>(), on_arc);
}

TEST(RunningAssessment, HuntingIsFoundOnStraightTrack) {
  // Once its seals slide the PHS bogie hunts on rough track; rigid links run quietly there.
  const Assessed rigid = Execute("straight_rough", "rigid_link", 0.01);
  const Assessed steered = Execute("straight_rough", "phs", 0.01);
  const auto rms = [](const Assessed& a) {
    return a.assessment["worst"]["sum_Y_rms_N"]["value"].get<double>();
  };
  EXPECT_TRUE(rigid.assessment["worst"]["sum_Y_rms_N"]["kept"].get<bool>());
  EXPECT_GT(rms(steered), 5 * rms(rigid));
  EXPECT_FALSE(rigid.assessment["worst"].contains("Y_qst_N"));
  for (const Assessed* a : {&rigid, &steered}) {
    const Json& ride = a->assessment["sections"][0]["ride"]["lateral"];
    EXPECT_LT(ride["low_m_s2"].get<double>(), 0);
    EXPECT_GT(ride["high_m_s2"].get<double>(), ride["rms_m_s2"].get<double>());
  }
}

TEST(RunningAssessment, TooSeldomARecordIsNotAssessed) {
  const Assessed a = Execute("curve_r300", "rigid_link", 0.05);
  EXPECT_EQ(a.assessment["status"], "not assessed");
  EXPECT_NE(a.assessment["reason"].get<std::string>().find("shorter intervals"), std::string::npos);
}

}  // namespace
}  // namespace phs::analysis
