// The bogies of bogie_xml against what their drawings promise.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "analysis/axle_modes.h"
#include "plugin/active_steering.h"
#include "plugin/observer.h"
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
  EXPECT_EQ(three_axles, 5);
}

/// Stiffness of the modes at 2 mm [N m/rad or N/m], by name.
std::map<std::string, double> StiffnessesOf(const Simulation& sim) {
  analysis::AxleModeOptions options;
  options.frequency_Hz = 2;  // springs do not mind
  auto modes = analysis::MeasureAxleModes(sim, options);
  EXPECT_TRUE(modes.ok());
  std::map<std::string, double> stiffness;
  for (const auto& m : modes.value().large) stiffness[m.name] = m.stiffness;
  return stiffness;
}

std::map<std::string, double> Stiffnesses(const std::string& bogie) {
  auto sim = Simulation::Create(OnTrack(bogie, "straight", 20));
  EXPECT_TRUE(sim.ok()) << sim.error().Line();
  return StiffnessesOf(sim.value());
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

TEST(LinkageTest, LinkagesOfThreeAxlesAreAsStiffAsThoseOfTwo) {
  // They join the end axles; the frame is held, so the middle axle feels nothing.
  for (const auto& [three, two] : {std::pair{"ge_coupling_shaft_coco", "ge_coupling_shaft"},
                                   std::pair{"adtranz_shifting_coco", "adtranz_shifting"}}) {
    auto expected = Stiffnesses(two);
    for (const auto& [mode, stiffness] : Stiffnesses(three)) {
      EXPECT_NEAR(stiffness / expected[mode], 1, 1e-6) << three << " " << mode;
    }
  }
  EXPECT_NEAR(Stiffnesses("adtranz_shifting_coco")["shear"] / (2 * 1.62e6 + 4 * 1.0e7), 1, 1e-3);
}

TEST(LinkageTest, CrossAnchorsHoldShearAndAntiphaseAlone) {
  // An anchor of length c between (l/2, h) and (-l/2, -h) grows by 2 h/c of what the axles shear
  // and l/c of what they part: K_shear = 2 k (2 h/c)^2 L^2, K_antiphase = 2 k (l/c)^2 2^2.
  const double k = 9.6e6, l = 1.5, h = 0.4, c = std::hypot(l, 2 * h), wheelbase = 3.1;
  auto anchors = Stiffnesses("scheffel_cross_anchors");
  const double yaw = 2 * 1.62e6, x = 2 * 55.3e6;
  EXPECT_NEAR(anchors["bending"] / yaw, 1, 1e-3);
  EXPECT_NEAR(anchors["shear"] / (yaw + 2 * k * std::pow(2 * h / c * wheelbase, 2)), 1, 2e-3);
  EXPECT_NEAR(anchors["traction"] / x, 1, 1e-3);
  EXPECT_NEAR(anchors["antiphase"] / (x + 2 * k * std::pow(2 * l / c, 2)), 1, 1e-3);
}

/// How much a length in the model grows when the axles yaw by `lead`, `trail` [rad] and shift by
/// `aside` [m] times (1, -1): first order.
double Growth(const Simulation& sim, const char* tendon, double lead, double trail, double aside) {
  const mjModel* m = sim.model();
  const int id = mj_name2id(m, mjOBJ_TENDON, tendon);
  const std::pair<const char*, double> moved[] = {
      {"lead_yaw", lead}, {"trail_yaw", trail}, {"lead_y", aside}, {"trail_y", -aside}};
  double length[2] = {};
  const DataPtr d(mj_makeData(m));
  for (const int way : {0, 1}) {
    mju_copy(d->qpos, m->qpos0, m->nq);
    for (const auto& [joint, by] : moved) {
      d->qpos[m->jnt_qposadr[mj_name2id(m, mjOBJ_JOINT, joint)]] = way == 0 ? -by : by;
    }
    mj_kinematics(m, d.get());
    mj_comPos(m, d.get());
    mj_tendon(m, d.get());
    length[way] = d->ten_length[id];
  }
  return (length[1] - length[0]) / 2;
}

TEST(LinkageTest, CrossAnchorsKnowNothingOfTheFrame) {
  auto sim = Simulation::Create(OnTrack("scheffel_cross_anchors", "straight", 20));
  ASSERT_TRUE(sim.ok()) << sim.error().Line();
  const double u = 1e-3, half = 1.55;
  const double shear = Growth(sim.value(), "anchor_1", u, u, 0);
  EXPECT_NEAR(std::abs(shear), 2 * 0.4 / 1.7 * 2 * half * u, 1e-7);
  EXPECT_NEAR(Growth(sim.value(), "anchor_1", u, u, half * u), 0, 1e-8);  // both as one body
  EXPECT_NEAR(Growth(sim.value(), "anchor_1", u, -u, 0), 0, 1e-8);        // bending
  EXPECT_NEAR(Growth(sim.value(), "anchor_1", 0, 0, half * u), -shear, 1e-8);
}

TEST(LinkageTest, ServosAndLeversHoldEachAxle) {
  // Frame held, no curvature: the servo of active steering is a spring on each axle.
  auto active = Stiffnesses("active_steering");
  const double both = 2 * (1.62e6 + 2.04e7);
  EXPECT_NEAR(active["bending"] / both, 1, 1e-3);
  EXPECT_NEAR(active["shear"] / both, 1, 1e-3);
  EXPECT_NEAR(active["traction"] / (2 * 55.3e6), 1, 1e-3);
}

TEST(LinkageTest, LeversToTheBodyHoldEachAxle) {
  Scenario s = OnTrack("forced_steering", "straight", 20);
  s.vehicle = "locomotive";
  auto sim = Simulation::Create(s);
  ASSERT_TRUE(sim.ok()) << sim.error().Line();
  auto forced = StiffnessesOf(sim.value());  // frame and body held
  const double both = 2 * (1.62e6 + 2.04e7);
  EXPECT_NEAR(forced["bending"] / both, 1, 1e-3);
  EXPECT_NEAR(forced["shear"] / both, 1, 1e-3);
  // Its half body has no yaw of its own.
  s.vehicle = "bogie";
  const auto alone = Simulation::Create(s);
  ASSERT_FALSE(alone.ok());
  EXPECT_NE(alone.error().Line().find("vehicle: locomotive"), std::string::npos)
      << alone.error().Line();
}

/// Mean yaw against the frame and angle of attack of a wheelset in the arc [rad].
struct Steered {
  double yaw = 0;
  double attack = 0;
};
std::map<std::string, Steered> InCurve(const Scenario& s) {
  std::map<std::string, Steered> steered;
  auto sim = Simulation::Create(s);
  EXPECT_TRUE(sim.ok()) << sim.error().Line();
  if (!sim.ok()) return steered;
  auto run = sim.value().Run();
  EXPECT_TRUE(run.ok());
  EXPECT_EQ(run.value().status, "ok") << s.bogie << ": " << run.value().reason;
  const Json summary = SummaryJson(Summarise(sim.value(), run.value()));
  for (const Json& w : summary["steady_curve"]["wheelsets"]) {
    steered[w["name"]] = {w["yaw_rad"], w["angle_of_attack_rad"]};
  }
  return steered;
}

TEST(LinkageTest, AxlesOfSteeredBogiesTurnIntoTheCurve) {
  // Radial axles stand at +-(half the wheelbase)/R against their frame.
  const double radius = 400;
  const double rigid =
      std::abs(InCurve(OnTrack("rigid_link", "curve_r400", 65 / 3.6))["lead"].attack);
  for (const auto& [bogie, half] :
       {std::pair{"scheffel_cross_anchors", 1.55}, std::pair{"active_steering", 1.55},
        std::pair{"ge_coupling_shaft_coco", 2.1}, std::pair{"adtranz_shifting_coco", 2.1}}) {
    for (const auto& [track, hand] :
         {std::pair{"curve_r400", 1}, std::pair{"curve_r400_right", -1}}) {
      auto steered = InCurve(OnTrack(bogie, track, 65 / 3.6));
      const double bending = hand * (steered["lead"].yaw - steered["trail"].yaw);
      EXPECT_NEAR(bending / (2 * half / radius), 1, 0.2) << bogie << " " << track;
      EXPECT_LT(std::abs(steered["lead"].attack), rigid / 3) << bogie << " " << track;
    }
  }
}

TEST(LinkageTest, ForcedSteeringTurnsTheAxlesOfBothBogies) {
  Scenario s = OnTrack("forced_steering", "curve_r400", 65 / 3.6);
  s.vehicle = "locomotive";
  auto steered = InCurve(s);
  for (const std::string bogie : {"front_", "rear_"}) {
    const double bending = steered[bogie + "lead"].yaw - steered[bogie + "trail"].yaw;
    EXPECT_NEAR(bending / (3.1 / 400), 1, 0.2) << bogie;
  }
}

TEST(LinkageTest, ServosAreToldTheCurvature) {
  Scenario s = OnTrack("active_steering", "curve_r400", 65 / 3.6);
  s.duration_s = 11;
  auto sim = Simulation::Create(s);
  ASSERT_TRUE(sim.ok()) << sim.error().Line();
  ASSERT_TRUE(sim.value().Run().ok());
  const mjModel* m = sim.value().model();
  const mjData* d = sim.value().data();
  double ahead = 0;
  plugin::ForEachSteering(m, [&](const plugin::ActiveSteering& servo) {
    const double told = d->act[servo.actuator - (m->nu - m->na)];
    EXPECT_NEAR(told / (servo.ahead / 400), 1, 0.03) << servo.ahead;
    EXPECT_NEAR(std::abs(servo.ahead), 1.55, 1e-12);
    ahead += std::abs(servo.ahead);
  });
  EXPECT_NEAR(ahead, 3.1, 1e-12);  // there were two
}

TEST(LinkageTest, LinkagesKeepTheBooksOfEnergyAndMoments) {
  for (const char* bogie : {"ge_coupling_shaft", "adtranz_shifting", "phs_coco",
                            "scheffel_cross_anchors", "adtranz_shifting_coco", "active_steering"}) {
    auto sim = Simulation::Create(OnTrack(bogie, "curve_r400", 65 / 3.6));
    ASSERT_TRUE(sim.ok()) << sim.error().Line();
    auto run = sim.value().Run();
    ASSERT_TRUE(run.ok());
    EXPECT_EQ(run.value().status, "ok") << run.value().reason;
    EXPECT_LT(std::abs(run.value().energy.RelativeError()), 1e-3) << bogie;
  }
}

// What the channels call moments on a wheelset is all that turns it: their sum is its inertia, at every
// instant, also of bogies that do not run quietly there (adtranz_shifting: 5 kN m).
TEST(LinkageTest, MomentsOnAnAxleAreItsInertia) {
  for (const char* bogie : {"phs", "ge_coupling_shaft", "adtranz_shifting", "phs_coco",
                            "scheffel_cross_anchors", "active_steering"}) {
    Scenario scenario = OnTrack(bogie, "curve_r400", 65 / 3.6);
    scenario.duration_s = 12;
    auto sim = Simulation::Create(scenario);
    ASSERT_TRUE(sim.ok()) << sim.error().Line();
    ASSERT_TRUE(sim.value().Run().ok());
    const mjModel* m = sim.value().model();
    mjData* d = sim.value().data();
    const auto instant = sim.value().Instant();
    mj_forward(m, d);
    const plugin::Observer observer(m, sim.value().binding());
    std::vector<double> row(observer.channels().size()), inertia(static_cast<size_t>(m->nv));
    observer.Observe(m, d, row.data());
    mj_mulM(m, d, inertia.data(), d->qacc);
    for (const auto& w : sim.value().binding().wheelsets()) {
      double sum = 0, largest = 0;
      for (size_t i = 0; i < row.size(); ++i) {
        const std::string& name = observer.channels()[i].name;
        if (!name.starts_with(w.name + "_") || !name.ends_with("_moment_Nm")) continue;
        sum += row[i];
        largest = std::max(largest, std::abs(row[i]));
      }
      const int dof = m->jnt_dofadr[w.yaw_joint];
      EXPECT_GT(largest, 1e3) << bogie << " " << w.name;
      EXPECT_NEAR(sum, inertia[static_cast<size_t>(dof)] + d->qfrc_bias[dof], 1e-6 * largest)
          << bogie << " " << w.name << " of " << largest;
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
