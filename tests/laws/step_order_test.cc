// The order of the half step (plugin/half_step.h) where nothing sticks or jumps, against closed
// forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "analysis/stability.h"
#include "plugin/registry.h"
#include "plugin/settle.h"
#include "tests/base/scratch_dir.h"
#include "tests/laws/law_models.h"
#include "vehicle/engine.h"
#include "vehicle/simulation.h"
#include "vehicle/stable_step.h"

namespace phs::vehicle {
namespace {

constexpr double kMass = 1500, kYawInertia = 800, kCreep = 1e7, kHalfBase = 0.75, kRadius = 0.46;
constexpr double kConicity = 0.1, kSpeed = 20;

/// A wheelset free to shift and yaw, on contacts given by numbers.
std::string LinearWheelset() {
  return fmt::format(
      "<mujoco model='linear_wheelset'><size nuserdata='96'/>"
      "<option timestep='0.001' gravity='0 0 0'><flag contact='disable' constraint='disable'/>"
      "</option><worldbody><body name='boxes' pos='0 0 {1}'>"
      "<joint name='x' type='slide' axis='1 0 0'/><joint name='y' type='slide' axis='0 1 0'/>"
      "<joint name='yaw' type='hinge' axis='0 0 1'/>"
      "<inertial pos='0 0 0' mass='1e-3' diaginertia='1e-3 1e-3 1e-3'/><body name='wheelset'>"
      "<joint name='spin' axis='0 1 0'/>"
      "<inertial pos='0 0 0' mass='{0}' diaginertia='{2} 100 {2}'/></body></body></worldbody>"
      "<custom><numeric name='phs_wheel_radius_m' data='{1}'/><text name='phs_contact' "
      "data='linear'/><numeric name='phs_linear_conicity' data='{3}'/>"
      "<numeric name='phs_linear_half_base_m' data='{4}'/><numeric name='phs_linear_f11_N' "
      "data='{5}'/><numeric name='phs_linear_f22_N' data='{5}'/>"
      "<tuple name='wheelset:lead'><element objtype='body' objname='wheelset'/>"
      "<element objtype='joint' objname='spin'/></tuple></custom>"
      "<keyframe><key name='test'/></keyframe></mujoco>",
      kMass, kRadius, kYawInertia, kConicity, kHalfBase, kCreep);
}

/// Growth of the slowest motion, by Wickens' two equations of a free wheelset:
///   m y'' = -2 f (y'/V - psi),   I psi'' = -2 f a (a psi'/V + lambda y/r0).
double GrowthByWickens() {
  Eigen::Matrix4d a = Eigen::Matrix4d::Zero();
  a(0, 2) = a(1, 3) = 1;
  a(2, 1) = 2 * kCreep / kMass;
  a(2, 2) = -2 * kCreep / (kMass * kSpeed);
  a(3, 0) = -2 * kCreep * kHalfBase * kConicity / (kYawInertia * kRadius);
  a(3, 3) = -2 * kCreep * kHalfBase * kHalfBase / (kYawInertia * kSpeed);
  return a.eigenvalues().real().maxCoeff();
}

/// Growth of the fastest growing motion that steps of `h` make [1/s].
double GrowthByStep(mjModel* m, const mjData* d, double h) {
  return std::log(StepSpectralRadius(m, d, h)) / h;
}

TEST(StepOrderTest, AFreeWheelsetGrowsAsWickensSaysToSecondOrder) {
  const ScratchDir folder;
  ModelPtr m = std::move(LoadMjcf(folder.Write("w.xml", LinearWheelset()))).value();
  plugin::AttachOptions options;
  options.track = folder.Write("t.yaml", laws::StraightTrack(200));
  options.speed_m_s = kSpeed;
  ASSERT_TRUE(plugin::Attach(m.get(), options).ok());
  const DataPtr d(mj_makeData(m.get()));
  plugin::ResetToStart(m.get(), d.get());
  mj_forward(m.get(), d.get());
  const double exact = GrowthByWickens();
  EXPECT_GT(exact, 0.1);  // a free wheelset is unstable
  double last = 0;
  for (const double h : {4e-3, 2e-3, 1e-3}) {
    const double error = std::abs(GrowthByStep(m.get(), d.get(), h) - exact);
    if (last > 0) {
      EXPECT_GT(std::log2(last / error), 1.8) << h;
    }
    last = error;
  }
  EXPECT_LT(last / exact, 2e-3);
  plugin::Detach(m.get());
}

TEST(StepOrderTest, ABogieHuntsAtTheLinearGrowthToSecondOrder) {
  Scenario scenario;
  scenario.track = "straight";
  scenario.bogie = "phs";
  scenario.speed_m_s = 75;
  auto sim = Simulation::Create(scenario);
  ASSERT_TRUE(sim.ok()) << sim.error().Line();
  mjModel* m = sim.value().mutable_model();
  const auto spectrum = analysis::SpectrumAt(&sim.value(), 75);
  ASSERT_TRUE(spectrum.ok());
  mjData* d = sim.value().data();
  plugin::ResetToStart(m, d);
  mj_forward(m, d);
  const double coarse = GrowthByStep(m, d, 2e-3);
  const double middle = GrowthByStep(m, d, 1e-3);
  const double fine = GrowthByStep(m, d, 5e-4);
  const double finest = GrowthByStep(m, d, 2.5e-4);
  EXPECT_GT(std::log2((coarse - middle) / (middle - fine)), 1.9);
  EXPECT_GT(std::log2((middle - fine) / (fine - finest)), 1.9);
  EXPECT_NEAR(middle / spectrum.value().growth, 1, 2e-3);
}

}  // namespace
}  // namespace phs::vehicle
