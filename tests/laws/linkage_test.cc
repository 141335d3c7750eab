// The bogies of bogie_xml against what their drawings promise.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "analysis/axle_modes.h"
#include "plugin/settle.h"
#include "vehicle/compose.h"
#include "vehicle/simulation.h"
#include "vehicle/summary.h"

namespace phs::vehicle {
namespace {

using Json = nlohmann::ordered_json;

Scenario OnTrack(const std::string& bogie, const std::string& track, double speed) {
  Scenario s;
  s.name = "linkage";
  s.track = track;
  s.bogie = bogie;
  s.speed_m_s = speed;
  s.friction.tread = 0.35;
  return s;
}

TEST(LinkageTest, EveryComparedBogieStandsWithItsWeightOnItsWheels) {
  int three_axles = 0;
  for (const ComparedBogie& bogie : ListComparedBogies()) {
    auto sim = Simulation::Create(OnTrack(bogie.name, "straight", 20));
    ASSERT_TRUE(sim.ok()) << bogie.name << ": " << sim.error().Line();
    const mjModel* m = sim.value().model();
    mjData* d = sim.value().data();
    plugin::ResetToStart(m, d);
    mj_forward(m, d);
    const auto& binding = sim.value().binding();
    const int axles = static_cast<int>(binding.wheelsets().size());
    three_axles += axles == 3;
    const double per_axle = 26000 * 9.81;
    for (int i = 0; i < axles; ++i) {
      EXPECT_NEAR(binding.CalcWheelset(m, d, i).force[2] / per_axle, 1, 0.01) << bogie.name;
    }
    EXPECT_NEAR(m->body_subtreemass[0], 26000 * axles, 1e-6) << bogie.name;
  }
  EXPECT_EQ(three_axles, 3);
}

/// Stiffness of the modes at 2 mm [N m/rad or N/m], by name.
std::map<std::string, double> Stiffnesses(const std::string& bogie) {
  auto sim = Simulation::Create(OnTrack(bogie, "straight", 20));
  EXPECT_TRUE(sim.ok()) << sim.error().Line();
  analysis::AxleModeOptions options;
  options.frequency_Hz = 2;  // springs do not mind
  auto modes = analysis::MeasureAxleModes(sim.value(), options);
  EXPECT_TRUE(modes.ok());
  std::map<std::string, double> stiffness;
  for (const auto& m : modes.value().large) stiffness[m.name] = m.stiffness;
  return stiffness;
}

TEST(LinkageTest, StiffnessOfTheLinkagesFollowsTheirClosedForm) {
  // Springs in shear: 2 k_yaw on opposite yaw; a spring K on psi_lead + psi_trail adds 4 K to the
  // same-sense yaw and nothing to the opposite one.
  const double springs = 2 * 1.62e6;
  auto emd = Stiffnesses("emd_radial");
  EXPECT_NEAR(emd["bending"] / springs, 1, 1e-3);
  EXPECT_NEAR(emd["shear"] / (springs + 4 * 9.97e6), 1, 1e-3);
  // GE: each side k on u_lead + u_trail: shear 4 * 2 k b^2, traction 4 * 2 k, spreading free.
  const double k = 6.3e6;
  auto ge = Stiffnesses("ge_coupling_shaft");
  EXPECT_NEAR(ge["bending"] / springs, 1, 1e-3);
  EXPECT_NEAR(ge["shear"] / (springs + 8 * k * 0.81), 1, 1e-3);
  EXPECT_NEAR(ge["traction"] / (2 * 2.0e6 + 8 * k), 1, 1e-3);
  EXPECT_NEAR(ge["antiphase"] / (2 * 2.0e6), 1, 1e-3);
}

TEST(LinkageTest, LinkagesKeepTheBooksOfEnergyAndMoments) {
  for (const char* bogie : {"ge_coupling_shaft", "adtranz_shifting", "phs_coco"}) {
    auto sim = Simulation::Create(OnTrack(bogie, "curve_r400", 65 / 3.6));
    ASSERT_TRUE(sim.ok()) << sim.error().Line();
    auto run = sim.value().Run();
    ASSERT_TRUE(run.ok());
    EXPECT_EQ(run.value().status, "ok") << run.value().reason;
    EXPECT_LT(std::abs(run.value().energy.RelativeError()), 1e-3) << bogie;
    const Json summary = Summarise(sim.value(), run.value());
    for (const char* axle : {"lead", "trail"}) {
      const Json& b = summary["budget"][axle];
      const double creep = b["creep_Nm"];
      const double sum = creep + b["primary_Nm"].get<double>() +
                         b["phs_pressure_Nm"].get<double>() + b["phs_friction_Nm"].get<double>();
      EXPECT_NEAR(sum, 0, 60) << bogie << " " << axle << " of " << creep;
    }
  }
}

TEST(LinkageTest, ThreeAxleBogiesMakeALocomotive) {
  Scenario s = OnTrack("phs_coco", "straight", 20);
  s.vehicle = "locomotive";
  auto sim = Simulation::Create(s);
  ASSERT_TRUE(sim.ok()) << sim.error().Line();
  const auto& binding = sim.value().binding();
  EXPECT_EQ(binding.wheelsets().size(), 6u);
  EXPECT_EQ(binding.phs().size(), 2u);
  EXPECT_NEAR(sim.value().model()->body_subtreemass[0], 6 * 26000, 1e-6);
  const mjModel* m = sim.value().model();
  mjData* d = sim.value().data();
  plugin::ResetToStart(m, d);
  mj_forward(m, d);
  double sum = 0;
  for (int i = 0; i < 6; ++i) sum += binding.CalcWheelset(m, d, i).force[2];
  EXPECT_NEAR(sum / (6 * 26000 * 9.81), 1, 1e-6);
}

}  // namespace
}  // namespace phs::vehicle
