// The steady state found directly against the same curve run through in time.
#include "analysis/steady_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "analysis/curve_family.h"
#include "phs_places.h"
#include "tests/base/scratch_dir.h"
#include "vehicle/run_summary.h"
#include "vehicle/simulation.h"

namespace phs::analysis {
namespace {

using vehicle::SteadyMeans;
using vehicle::WheelMeans;
using vehicle::WheelsetMeans;

vehicle::Scenario CurveScenario(const std::string& bogie, const std::string& track, double speed) {
  vehicle::Scenario s;
  s.name = "steady";
  s.track = track;
  s.bogie = bogie;
  s.speed_m_s = speed;
  s.friction.tread = 0.35;
  return s;
}

template <typename Part>
void ExpectNear(const std::vector<Part>& steady, const std::vector<Part>& timed,
                double Part::*number, double tolerance) {
  ASSERT_EQ(steady.size(), timed.size());
  for (size_t i = 0; i < steady.size(); ++i) {
    EXPECT_NEAR(steady[i].*number, timed[i].*number, tolerance) << steady[i].name;
  }
}

TEST(SteadyCurveTest, AgreesWithTheTimeRunWithinOnePercentForATenthOfItsSteps) {
  // The seals of the PHS remember the way: in time the end of the transition shakes them, here they
  // keep the force they slid with. That is the second percent.
  for (const auto& [bogie, tolerance] : {std::pair{"rigid_link", 0.01}, {"phs", 0.02}}) {
    auto simulation = vehicle::Simulation::Create(CurveScenario(bogie, "curve_r300", 55 / 3.6));
    ASSERT_TRUE(simulation.ok()) << simulation.error().Line();
    const auto solved = SolveSteadyCurve(&simulation.value());
    ASSERT_TRUE(solved.ok()) << solved.error().Line();
    auto run = simulation.value().Run();
    ASSERT_TRUE(run.ok());
    const SteadyMeans timed = vehicle::CalcSteadyMeans(simulation.value(), run.value());
    const SteadyMeans& steady = solved.value().steady;
    // Shares of the wheel load, of half the wheelbase over the radius, of 10 mm.
    ExpectNear(steady.wheels, timed.wheels, &WheelMeans::Y_N, tolerance * 127500);
    ExpectNear(steady.wheels, timed.wheels, &WheelMeans::Q_N, tolerance * 127500);
    ExpectNear(steady.wheelsets, timed.wheelsets, &WheelsetMeans::angle_of_attack_rad,
               tolerance * 1.55 / 300);
    ExpectNear(steady.wheelsets, timed.wheelsets, &WheelsetMeans::lateral_m, tolerance * 0.01);
    const double steps = run.value().end_time_s / simulation.value().scenario().timestep_s;
    EXPECT_LT(10 * static_cast<double>(solved.value().evaluations), steps) << bogie;
  }
}

/// The test bogie of standard gauge on stiff guidance instead of cylinders, with one driven axle or
/// none.
std::string WithDrives(bool any) {
  const std::string folder = PHS_SOURCE_DIR "/tests/vehicle/bogies/";
  std::ifstream file(folder + "standard_gauge.xml");
  std::stringstream text;
  text << file.rdbuf();
  std::string xml = text.str();
  const auto replace = [&](const std::string& from, const std::string& to) {
    const size_t at = xml.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    xml.replace(at, from.size(), to);
  };
  replace("<include file=\"shared/phs_cylinders.xml\"/>", "");
  replace("<text name=\"phs:bogie\" data=\"bo_bo\"/>", "");
  for (int i = 0; i < 2; ++i) replace("2.0e6\" damping=\"2.0e4", "4.0e7\" damping=\"1.0e5");
  if (!any) {
    replace("<element objtype=\"actuator\" objname=\"lead_drive\"/>", "");
    replace("<motor name=\"lead_drive\" joint=\"lead_spin\"/>", "");
  }
  const std::string path = ScratchFile(any ? "one_drive.xml" : "no_drive.xml");
  std::ofstream(path) << xml;
  return path;
}

TEST(SteadyCurveTest, AxlesWithoutDriveSettleAtTheSpinThatLeavesThemNoMoment) {
  const std::string track = PHS_SOURCE_DIR "/tests/vehicle/bogies/standard_r400.yaml";
  for (const bool any : {true, false}) {
    auto simulation = vehicle::Simulation::Create(CurveScenario(WithDrives(any), track, 20));
    ASSERT_TRUE(simulation.ok()) << simulation.error().Line();
    const auto solved = SolveSteadyCurve(&simulation.value());
    ASSERT_TRUE(solved.ok()) << solved.error().Line();
    auto run = simulation.value().Run();
    ASSERT_TRUE(run.ok());
    const SteadyMeans timed = vehicle::CalcSteadyMeans(simulation.value(), run.value());
    const SteadyMeans& steady = solved.value().steady;
    // A coasting vehicle has lost half a per cent of its speed on the way.
    const double tolerance = any ? 0.006 : 0.012;
    ExpectNear(steady.wheels, timed.wheels, &WheelMeans::Y_N, tolerance * 83900);
    ExpectNear(steady.wheels, timed.wheels, &WheelMeans::Q_N, tolerance * 83900);
    ExpectNear(steady.wheelsets, timed.wheelsets, &WheelsetMeans::angle_of_attack_rad,
               tolerance * 1.25 / 400);
    if (any) {
      EXPECT_EQ(solved.value().coasting_m_s2, 0);
    } else {
      EXPECT_LT(solved.value().coasting_m_s2, -2e-3) << "creep slows it down";
      EXPECT_GT(solved.value().coasting_m_s2, -5e-2);
    }
  }
}

TEST(SteadyCurveTest, StraightTrackAndVehiclesWithoutAFreeRootAreRefused) {
  auto straight = vehicle::Simulation::Create(CurveScenario("phs", "straight", 20));
  ASSERT_TRUE(straight.ok());
  const auto no_arc = SolveSteadyCurve(&straight.value());
  ASSERT_FALSE(no_arc.ok());
  EXPECT_NE(no_arc.error().Line().find("has no circular arc"), std::string::npos);
  vehicle::Scenario undriven = CurveScenario("cooperrider", "straight", 20);
  undriven.timestep_s = 1e-4;
  auto coasting = vehicle::Simulation::Create(undriven);
  ASSERT_TRUE(coasting.ok());
  const auto guided = SolveSteadyCurve(&coasting.value());
  ASSERT_FALSE(guided.ok());
  EXPECT_NE(guided.error().Line().find("no free joint at its root"), std::string::npos);
}

TEST(CurveFamilyTest, SpeedAndCantFollowTheRadius) {
  // R = 550 m at 80 km/h on e = 1.139 m: equilibrium cant e V^2/(g R) = 104.2 mm.
  const auto wide = CurveOfRadius({}, 550);
  ASSERT_TRUE(wide.ok());
  EXPECT_NEAR(wide.value().speed_m_s, 80 / 3.6, 1e-9);
  EXPECT_NEAR(wide.value().cant_m, 0.1042 - 0.045, 1e-4);
  const auto tight = CurveOfRadius({}, 150);
  ASSERT_TRUE(tight.ok());
  EXPECT_NEAR(tight.value().cant_m, 0.060, 1e-9);
  EXPECT_NEAR(tight.value().speed_m_s, std::sqrt(9.81 * 150 * 0.105 / 1.139), 1e-9);
  EXPECT_EQ(CurveOfRadius({}, 3000).value().cant_m, 0);
  EXPECT_FALSE(CurveOfRadius({}, 20).ok());
}

TEST(CurveFamilyTest, OnAnotherGaugeTheSpeedStaysAndTheCantGrowsWithTheBase) {
  const auto base = ReadTrackBase(PHS_SOURCE_DIR "/tests/vehicle/bogies/standard_straight.yaml");
  ASSERT_TRUE(base.ok()) << base.error().Line();
  EXPECT_EQ(base.value().gauge_m, 1.435);
  EXPECT_NEAR(base.value().cant_base_m, 1.507, 1e-12);
  EXPECT_EQ(base.value().friction, 0.35);
  const auto narrow = CurveOfRadius({}, 300);
  const auto wide = CurveOfRadius(FamilyOn(base.value()), 300);
  ASSERT_TRUE(wide.ok());
  EXPECT_NEAR(wide.value().speed_m_s, narrow.value().speed_m_s, 1e-9);
  EXPECT_NEAR(wide.value().cant_m / narrow.value().cant_m, 1.507 / 1.139, 1e-9);
  const auto arc =
      FirstArc(FamilyOn(base.value()), PHS_SOURCE_DIR "/tests/vehicle/bogies/standard_r400.yaml");
  ASSERT_TRUE(arc.ok()) << arc.error().Line();
  EXPECT_NEAR(arc.value().radius_m, 400, 1e-9);
  EXPECT_NEAR(arc.value().cant_m, 0.1, 1e-6);
}

TEST(TemporaryTrackTest, HasANameOfItsOwnAndIsGoneWithTheObject) {
  std::string path;
  {
    const auto a = TemporaryTrack::Straight({});
    const auto b = TemporaryTrack::Straight({});
    ASSERT_TRUE(a.ok() && b.ok());
    path = a.value().path();
    EXPECT_NE(path, b.value().path());
    EXPECT_TRUE(std::filesystem::exists(path));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace phs::analysis
