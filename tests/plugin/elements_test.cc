// Elements between bodies: the damper between two sites against closed formulas, MuJoCo's own
// tendon damper and the books of energy.
#include "plugin/elements.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <random>

#include "plugin/observer.h"
#include "plugin/site_damper.h"
#include "tests/plugin/attached_model.h"

namespace phs::plugin {
namespace {

using testing::HasSubstr;

class ElementsTest : public testing::Test {
 private:
  EngineGuard guard_;
};

constexpr double kMass = 100;  ///< [kg]

/// A damper from the world to `end`, and what its text says.
std::string Custom(const std::string& data, const std::string& end = "end") {
  return "<custom><tuple name='damper:d'><element objtype='site' objname='fixed'/>"
         "<element objtype='site' objname='" +
         end + "'/></tuple><text name='damper:d' data='" + data + "'/></custom>";
}

std::string Model(const std::string& options, const std::string& bodies,
                  const std::string& sections) {
  return "<mujoco><size nuserdata='96'/><compiler angle='radian'/><option " + options +
         "><flag contact='disable'/></option><worldbody>" + bodies + "</worldbody>" + sections +
         "</mujoco>";
}

/// A mass on a vertical slide under a fixed point.
std::string Hanging(double step, double stiffness, const std::string& data) {
  return Model(fmt::format("timestep='{}' gravity='0 0 -10'", step),
               fmt::format("<site name='fixed' pos='0 0 2'/><body name='mass'>"
                           "<joint name='z' type='slide' axis='0 0 1' stiffness='{}'/>"
                           "<inertial pos='0 0 0' mass='{}' diaginertia='1 1 1'/>"
                           "<site name='end'/></body>",
                           stiffness, kMass),
               Custom(data));
}

/// Two chains of three bodies each beside one another: what a line between their ends does couples
/// branches. `sections`: damper or tendon.
std::string TwoArms(const std::string& sections) {
  std::string bodies;
  for (const auto& [name, y] : {std::pair{"a", 0.0}, std::pair{"b", 0.7}}) {
    bodies += fmt::format(
        "<body name='{0}1' pos='0 {1} 2'><joint axis='0 1 0.2' damping='1'/>"
        "<inertial pos='0.2 0 0' mass='3' diaginertia='0.1 0.2 0.3'/>"
        "<body name='{0}2' pos='0.4 0 0'><joint axis='1 0.3 1'/><joint axis='0 0 1'/>"
        "<inertial pos='0.2 0.1 0' mass='2' diaginertia='0.1 0.1 0.2'/>"
        "<site name='{0}' pos='0.3 0.1 0.05'/></body></body>",
        name, y);
  }
  return Model("timestep='0.001'",
               "<site name='fixed' pos='1 1 1'/>" + bodies + "<site name='still' pos='1 2 1'/>",
               sections);
}

ModelPtr AttachedText(const std::string& xml) {
  ModelPtr m = LoadText(xml);
  const Status s = Attach(m.get(), {});
  EXPECT_TRUE(s.ok()) << s.error().Line();
  return m;
}

TEST_F(ElementsTest, ForceOfTheDamperFollowsItsTwoSlopes) {
  const SiteDamperParams p{2e5, 8e3, 5e3};  // the valve opens at 0.04 m/s
  EXPECT_EQ(CalcSiteDamper(p, 0).force, 0);
  EXPECT_EQ(CalcSiteDamper(p, 0).slope, 2e5);
  EXPECT_DOUBLE_EQ(CalcSiteDamper(p, 0.03).force, -6e3);
  EXPECT_DOUBLE_EQ(CalcSiteDamper(p, 0.04).force, -8e3);
  EXPECT_DOUBLE_EQ(CalcSiteDamper(p, 0.24).force, -9e3);
  EXPECT_EQ(CalcSiteDamper(p, 0.24).slope, 5e3);
  double before = 0;
  for (double v = 0.001; v < 0.2; v += 0.001) {
    const DamperForce at = CalcSiteDamper(p, v);
    EXPECT_EQ(at.force, -CalcSiteDamper(p, -v).force);
    EXPECT_LT(at.force, before) << v;
    const double h = 1e-7;
    if (std::abs(v - 0.04) > 2 * h) {
      const double slope =
          (CalcSiteDamper(p, v - h).force - CalcSiteDamper(p, v + h).force) / (2 * h);
      EXPECT_NEAR(slope, at.slope, 1e-3) << v;
    }
    before = at.force;
  }
}

TEST_F(ElementsTest, AFallingMassComesToTheSpeedAtWhichTheDamperCarriesIt) {
  const double weight = kMass * 10;
  struct Case {
    const char* data;
    double speed;
  };
  for (const Case& c : {Case{"damping_Ns_per_m=2000", weight / 2000},
                        Case{"damping_Ns_per_m=2000 relief_N=400 relief_damping_Ns_per_m=500",
                             0.2 + (weight - 400) / 500}}) {
    const ModelPtr m = AttachedText(Hanging(0.002, 0, c.data));
    const DataPtr d(mj_makeData(m.get()));
    while (d->time < 4) mj_step(m.get(), d.get());
    EXPECT_NEAR(-d->qvel[0], c.speed, 1e-6 * c.speed) << c.data;
    const Binding& binding = *Find(m.get());
    const ElementState state =
        binding.elements().back()->StateOf(m.get(), d.get(), binding.Speed(d.get()), 0);
    EXPECT_NEAR(state.force, -weight, 1e-5 * weight);  // pulls the mass up
    EXPECT_NEAR(state.speed, c.speed, 1e-5 * c.speed);
    EXPECT_NEAR(d->userdata[UserData::kDamperPower], weight * c.speed, 1e-4 * weight * c.speed);
  }
}

TEST_F(ElementsTest, WithoutReliefItIsMuJoCosOwnTendonDamper) {
  const std::string idle = "damping_Ns_per_m=0";
  const ModelPtr ours =
      AttachedText(TwoArms("<custom><tuple name='damper:d'><element objtype='site' objname='a'/>"
                           "<element objtype='site' objname='b'/></tuple><text name='damper:d' "
                           "data='damping_Ns_per_m=30'/></custom>"));
  const ModelPtr native =
      AttachedText(TwoArms(Custom(idle, "still") +
                           "<tendon><spatial damping='30'><site site='a'/><site site='b'/>"
                           "</spatial></tendon>"));
  const ModelPtr none = AttachedText(TwoArms(Custom(idle, "still")));
  const DataPtr a(mj_makeData(ours.get())), b(mj_makeData(native.get())),
      c(mj_makeData(none.get()));
  for (mjData* d : {a.get(), b.get(), c.get()}) {
    for (int i = 0; i < ours->nv; ++i) d->qvel[i] = 1 - 0.4 * i;
  }
  for (int step = 0; step < 1000; ++step) {
    mj_step(ours.get(), a.get());
    mj_step(native.get(), b.get());
    mj_step(none.get(), c.get());
    ASSERT_NEAR(a->userdata[UserData::kDamperPower], b->userdata[UserData::kDamperPower],
                1e-7 * (1 + b->userdata[UserData::kDamperPower]))
        << step;
  }
  double apart = 0;
  for (int i = 0; i < ours->nq; ++i) {
    EXPECT_NEAR(a->qpos[i], b->qpos[i], 1e-8) << i;
    apart = std::max(apart, std::abs(a->qpos[i] - c->qpos[i]));
  }
  EXPECT_GT(apart, 0.05);  // the damper does something
}

TEST_F(ElementsTest, StiffnessOfATendonIsItsOwnAlongTheChangeOfLength) {
  const ModelPtr m = AttachedText(TwoArms(
      Custom("damping_Ns_per_m=0", "still") +
      "<tendon><spatial stiffness='700'><site site='a'/><site site='b'/></spatial></tendon>"));
  const DataPtr d(mj_makeData(m.get()));
  mj_forward(m.get(), d.get());
  std::vector<double> along(static_cast<size_t>(m->nv));
  for (int i = 0; i < m->nv; ++i) along[static_cast<size_t>(i)] = 0.3 - 0.2 * i;
  double stiffness = 0;
  for (const auto& elements : Find(m.get())->elements()) {
    elements->AddStiffness(m.get(), d.get(), along.data(), &stiffness);
  }
  constexpr double kShift = 1e-6;
  double length[2];
  for (const int side : {0, 1}) {
    for (int i = 0; i < m->nq; ++i)
      d->qpos[i] = (2 * side - 1) * kShift * along[static_cast<size_t>(i)];
    mj_kinematics(m.get(), d.get());
    mj_comPos(m.get(), d.get());
    mj_tendon(m.get(), d.get());
    length[side] = d->ten_length[0];
  }
  const double rate = (length[1] - length[0]) / (2 * kShift);
  EXPECT_NEAR(stiffness / (700 * rate * rate), 1, 1e-6);
}

/// What is left over in the books after half a second [J], over the energy lost.
double EnergyLeftOver(double step) {
  const ModelPtr m = AttachedText(
      Hanging(step, 2e4, "damping_Ns_per_m=1500 relief_N=300 relief_damping_Ns_per_m=200"));
  m->opt.enableflags |= mjENBL_ENERGY;
  const DataPtr d(mj_makeData(m.get()));
  d->qpos[0] = 0.1;
  const Binding& binding = *Find(m.get());
  double lost = 0, power = 0, first = 0, last = 0;
  for (int i = 0; d->time < 0.5; ++i) {
    mj_step(m.get(), d.get());
    const double now = d->userdata[UserData::kDamperPower];
    if (i > 0) lost += 0.5 * step * (power + now);
    power = now;
    const double speed = binding.Speed(d.get())[0];
    last = d->energy[0] + 0.5 * kMass * speed * speed +
           binding.elements().back()->StoredEnergy(m.get(), d.get());
    if (i == 0) first = last;
  }
  EXPECT_GT(lost, 10);
  return (first - last - lost) / lost;
}

TEST_F(ElementsTest, WhatTheDamperLosesTheMotionLosesToSecondOrder) {
  const double coarse = std::abs(EnergyLeftOver(0.002));
  const double fine = std::abs(EnergyLeftOver(0.0005));
  EXPECT_LT(coarse, 1e-3);
  EXPECT_LT(fine, coarse / 8);  // 16 but for the kink where the valve opens
}

TEST_F(ElementsTest, NeverGivesPowerAndIsTheMirrorOfItsMotion) {
  const ModelPtr m = AttachedText(
      TwoArms("<custom><tuple name='damper:d'><element objtype='site' objname='a'/>"
              "<element objtype='site' objname='b'/></tuple><text name='damper:d' "
              "data='damping_Ns_per_m=30 relief_N=20 relief_damping_Ns_per_m=1'/></custom>"));
  const Elements& damper = *Find(m.get())->elements().back();
  ASSERT_FALSE(damper.InEngine());
  const DataPtr d(mj_makeData(m.get()));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1.5, 1.5);
  const auto nv = static_cast<size_t>(m->nv);
  for (int i = 0; i < 200; ++i) {
    for (int k = 0; k < m->nq; ++k) d->qpos[k] = any(random);
    mj_forward(m.get(), d.get());
    std::vector<double> speed(nv), back(nv), force(nv), mirrored(nv);
    for (size_t k = 0; k < nv; ++k) back[k] = -(speed[k] = any(random));
    damper.AddDampers(m.get(), d.get(), speed.data(), force.data());
    damper.AddDampers(m.get(), d.get(), back.data(), mirrored.data());
    double given = 0;
    for (size_t k = 0; k < nv; ++k) {
      given += force[k] * speed[k];
      EXPECT_EQ(force[k], -mirrored[k]);
      double on_dof = 0;
      damper.AddForceOnDof(m.get(), d.get(), {d->qpos, speed.data()}, static_cast<int>(k), &on_dof);
      EXPECT_EQ(on_dof, force[k]);
    }
    const double lost = damper.LostPower(m.get(), d.get(), speed.data());
    EXPECT_GT(lost, 0);
    EXPECT_NEAR(given, -lost, 1e-9 * (1 + lost));
  }
}

TEST_F(ElementsTest, AStiffDamperDoesNotLimitTheStep) {
  // c h / m = 20: an explicit step would diverge.
  const ModelPtr m = AttachedText(Hanging(0.002, 0, "damping_Ns_per_m=1e6"));
  const DataPtr d(mj_makeData(m.get()));
  d->qvel[0] = 1;
  for (int i = 0; i < 500; ++i) mj_step(m.get(), d.get());
  EXPECT_NEAR(d->qvel[0], -kMass * 10 / 1e6, 1e-6);
}

TEST_F(ElementsTest, ItsForceLengthAndSpeedAreOutputs) {
  const ModelPtr m = AttachedText(Hanging(0.002, 0, "damping_Ns_per_m=2000"));
  const DataPtr d(mj_makeData(m.get()));
  for (int i = 0; i < 10; ++i) mj_step(m.get(), d.get());
  const Observer observer(m.get(), *Find(m.get()));
  std::vector<double> row(observer.channels().size());
  observer.Observe(m.get(), d.get(), row.data());
  std::map<std::string, double> value;
  for (size_t i = 0; i < row.size(); ++i) value[observer.channels()[i].name] = row[i];
  EXPECT_LT(value.at("damper_d_force_N"), -1);
  EXPECT_DOUBLE_EQ(value.at("damper_d_force_N"), -2000 * value.at("damper_d_speed_m_s"));
  EXPECT_NEAR(value.at("damper_d_length_m"), 2 - d->qpos[0], 1e-3);
}

std::string ElementRefusal(const std::string& custom) {
  const ModelPtr m = LoadText(Model(
      "", "<site name='fixed'/><body><joint/><geom size='1'/><site name='end'/></body>", custom));
  const Status s = Attach(m.get(), {});
  return s.ok() ? "taken" : s.error().Line();
}

TEST_F(ElementsTest, WhatIsDeclaredWronglyIsRefusedInOneLine) {
  EXPECT_EQ(ElementRefusal(Custom("damping_Ns_per_m=1e3")), "taken");
  EXPECT_THAT(ElementRefusal(Custom("damping=1e3")), HasSubstr("did you mean 'damping_Ns_per_m'"));
  EXPECT_THAT(ElementRefusal(Custom("relief_N=8")), HasSubstr("lacks damping_Ns_per_m"));
  EXPECT_THAT(ElementRefusal(Custom("damping_Ns_per_m=-1")), HasSubstr("=0 … 1000000000"));
  EXPECT_THAT(ElementRefusal(Custom("damping_Ns_per_m=much")), HasSubstr("is no number"));
  EXPECT_THAT(ElementRefusal(Custom("damping_Ns_per_m=1 damping_Ns_per_m=2")), HasSubstr("twice"));
  EXPECT_THAT(ElementRefusal(Custom("damping_Ns_per_m=1 relief_damping_Ns_per_m=2")),
              HasSubstr("does not stiffen"));
  EXPECT_THAT(ElementRefusal(Custom("damping_Ns_per_m=1", "fixed")),
              HasSubstr("2 different sites"));
  EXPECT_THAT(
      ElementRefusal("<custom><tuple name='damper:d'><element objtype='site' objname='fixed'/>"
                     "<element objtype='site' objname='end'/></tuple></custom>"),
      HasSubstr("MJCF text 'damper:d': is missing"));
  EXPECT_THAT(ElementRefusal(Custom("damping_Ns_per_m=1") +
                             "<custom><text name='damper:e' data='damping_Ns_per_m=1'/></custom>"),
              HasSubstr("belongs to no tuple"));
}

}  // namespace
}  // namespace phs::plugin
