// Linear laws of running gear: coned wheels, linear creep. Formulas: notes in docs/physics_rail.md.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <vector>

#include "plugin/registry.h"
#include "plugin/settle.h"
#include "tests/base/scratch_dir.h"
#include "tests/laws/law_models.h"
#include "vehicle/engine.h"
#include "vehicle/simulation.h"

namespace phs::vehicle {
namespace {

constexpr double kRailRadius = 0.3;  ///< of the rail head [m]

/// What the linear formulas need, read from the contact itself at rest.
struct LinearContact {
  double b0 = 0;   ///< half distance of the contact points [m]
  double r0 = 0;   ///< rolling radius [m]
  double f11 = 0;  ///< longitudinal creep coefficient per wheel [N]
  double f22 = 0;  ///< lateral [N]
  double f23 = 0;  ///< lateral to spin [N m]
  double f33 = 0;  ///< spin [N m2]
};

LinearContact ReadContact(const mjModel* m, const mjData* d, const plugin::Binding& binding) {
  const plugin::WheelsetState state = binding.CalcWheelset(m, d, 0);
  const rail::ContactPatch& patch = state.wheel[1].patch[0];
  constexpr double kSmall = 1e-6;
  const auto force = [&](double xi, double eta, double phi) {
    return binding.wheel_rail().creep_law().Calc(
        {patch.a, patch.b, patch.normal, xi, eta, phi, 20, patch.friction});
  };
  return {std::abs(patch.point[1]),
          patch.rolling_radius,
          -force(kSmall, 0, 0).x / kSmall,
          -force(0, kSmall, 0).y / kSmall,
          std::abs(force(0, 0, kSmall).y) / kSmall,
          std::abs(force(0, 0, kSmall).moment) / kSmall};
}

plugin::AttachOptions ConedLinear(const std::string& track, double cone, double speed) {
  plugin::AttachOptions options;
  options.track = track;
  options.wheel_profile = fmt::format("cone:{}", cone);
  options.rail_profile = fmt::format("arc:{}", kRailRadius);
  options.creep_law = "linear";
  options.speed_m_s = speed;
  return options;
}

TEST(LinearLawsTest, KlingelWavelengthOfAFreeConedWheelsetWithinOnePercent) {
  // L = 2 pi sqrt(r0 b0 / lambda) (Klingel 1883). Slow enough for the motion to be kinematic.
  // True cones deviate from the formula in proportion to the cone (2 % at 0.05; Antali, Stepan,
  // Hogan 2015), so that slight cones are the test.
  for (const double cone : {0.01, 0.02}) {
    const ScratchDir folder;
    ModelPtr m = std::move(LoadMjcf(folder.Write("w.xml", laws::FreeWheelset(2000, 0.46)))).value();
    const auto options = ConedLinear(folder.Write("t.yaml", laws::StraightTrack(200)), cone, 5.0);
    ASSERT_TRUE(plugin::Attach(m.get(), options).ok());
    const DataPtr d(mj_makeData(m.get()));
    plugin::ResetToStart(m.get(), d.get());
    mj_forward(m.get(), d.get());
    const LinearContact c = ReadContact(m.get(), d.get(), *plugin::Find(m.get()));
    d->qpos[1] += 0.5e-3;  // released half a millimetre off the centre
    std::vector<double> crossings;
    double last = d->qpos[1];
    while (crossings.size() < 5 && d->time < 60) {
      mj_step(m.get(), d.get());
      if (last * d->qpos[1] < 0) {
        crossings.push_back(d->qpos[0] -
                            d->qpos[1] / (d->qpos[1] - last) * (m->opt.timestep * d->qvel[0]));
      }
      last = d->qpos[1];
    }
    ASSERT_EQ(crossings.size(), 5u);
    const double wavelength = (crossings[4] - crossings[0]) / 2;
    const double conicity = laws::ConicityOnArc(cone, c.b0, c.r0, kRailRadius);
    const double klingel = 2 * std::numbers::pi * std::sqrt(c.r0 * c.b0 / conicity);
    EXPECT_NEAR(wavelength / klingel, 1, 0.01) << "cone " << cone;
    plugin::Detach(m.get());
  }
}

TEST(LinearLawsTest, FreeWheelsetInACurveRollsOnTheEquilibriumLineWithinOnePercent) {
  // y = r0 b0 / (R lambda), outwards, with the track canted for the speed.
  const double radius = 2000;
  const double cone = 0.1;
  const double speed = 10;
  const ScratchDir folder;
  ModelPtr m = std::move(LoadMjcf(folder.Write("w.xml", laws::FreeWheelset(2000, 0.46)))).value();
  const auto options =
      ConedLinear(folder.Write("t.yaml", laws::CurvedTrack(radius, speed)), cone, speed);
  ASSERT_TRUE(plugin::Attach(m.get(), options).ok());
  const plugin::Binding& binding = *plugin::Find(m.get());
  const DataPtr d(mj_makeData(m.get()));
  plugin::ResetToStart(m.get(), d.get());
  mj_forward(m.get(), d.get());
  const LinearContact c = ReadContact(m.get(), d.get(), binding);
  const double expected =
      c.r0 * c.b0 / (radius * laws::ConicityOnArc(cone, c.b0, c.r0, kRailRadius));
  // The kinematic motion is hardly damped: average over whole waves.
  double sum = 0;
  long count = 0;
  const double wave = 2 * std::numbers::pi * std::sqrt(c.r0 * c.b0 / cone);
  while (d->time < 60) {
    mj_step(m.get(), d.get());
    const plugin::WheelsetState w = binding.CalcWheelset(m.get(), d.get(), 0);
    if (w.frame.s > 380 - 15 * wave && w.frame.s < 380) {
      sum += w.lateral;
      ++count;
    }
    if (w.frame.s >= 380) break;
  }
  ASSERT_GT(count, 0);
  // Curve to the left: outwards is to the right, y_T < 0.
  EXPECT_NEAR(-sum / static_cast<double>(count) / expected, 1, 0.01);
  plugin::Detach(m.get());
}

/// The linear two-axle bogie in a curve to the left, on track canted for the speed. Unknowns
/// q = (y1, psi1, y2, psi2) against the track, to the left and counter-clockwise, psi against the
/// radial direction; potential of the springs
///   E = Kb/2 (psi1 - psi2 + 2 a/R)^2 + Ks/2 (y1 - y2 - a (psi1 + psi2))^2
/// (structure after Boocock and Wickens). Each wheelset feels, beside the springs,
///   F = 2 f22 psi - 2 f23/R - W y dphi/dy
///   M = -2 f11 b0 (b0/R + lambda y/r0) - 2 f23 psi - 2 f33/R + W b0 cone psi
/// with W the load of the wheelset: rolling difference of radii and of paths, lateral creep,
/// Kalker's spin terms (both wheels turn about the vertical at 1/R; the spin of the cones cancels),
/// and gravitational stiffness: the wheelset rolls by dphi/dy = cone/(b0 - r0 cone) as it shifts,
/// which turns both normals, and yaw moves the contact points of the lateral normal forces apart.
struct TwoAxleBogie {
  LinearContact contact;
  double cone = 0, conicity = 0, a = 0, radius = 0, load = 0;
  double k_psi = 0, k_y = 0;  ///< springs of an axle to the frame
  bool load_terms = true;     ///< spin and gravity

  Eigen::Vector4d Solve() const {
    const LinearContact& c = contact;
    const double kb = k_psi / 2;
    const double ks = 1 / (2 * (1 / k_y + a * a / k_psi));
    const Eigen::Vector4d bend(0, 1, 0, -1);
    const Eigen::Vector4d shear(1, -a, -1, -a);
    Eigen::Matrix4d K = kb * bend * bend.transpose() + ks * shear * shear.transpose();
    Eigen::Vector4d f = -kb * bend * (2 * a / radius);
    const double on = load_terms ? 1 : 0;
    for (const int i : {0, 2}) {
      K(i, i + 1) -= 2 * c.f22;
      K(i, i) += on * load * cone / (c.b0 - c.r0 * cone);
      f(i) -= on * 2 * c.f23 / radius;
      K(i + 1, i) += 2 * c.f11 * c.b0 * conicity / c.r0;
      K(i + 1, i + 1) += on * (2 * c.f23 - load * c.b0 * cone);
      f(i + 1) -= 2 * c.f11 * c.b0 * c.b0 / radius + on * 2 * c.f33 / radius;
    }
    return K.partialPivLu().solve(f);
  }
};

TEST(LinearLawsTest, TwoAxleBogieWithoutLoadTermsIsTheClosedForm) {
  // psi1 = -psi2 = (a/R) / (1 + f11 f22 b0 lambda / (r0 Kb Ks)), y1 - y2 = 2 f22 psi1 / Ks,
  // (y1 + y2)/2 = y0 + a f22 psi1 r0 / (f11 b0 lambda), outward: the 4 x 4 solution above, with
  // f11 8e6, f22 7e6 N, b0 .5685, lambda .1, r0 .625, a 1.55, R 550, Kb 2e6, Ks 1e7 gives
  // psi1 2.246122 mrad, y1 41.52308, y2 38.37851 mm (solved independently).
  TwoAxleBogie bogie;
  bogie.contact = {.b0 = 0.5685, .r0 = 0.625, .f11 = 8e6, .f22 = 7e6};
  bogie.cone = bogie.conicity = 0.1;
  bogie.a = 1.55;
  bogie.radius = 550;
  bogie.k_psi = 2 * 2e6;
  bogie.k_y = 1 / (1 / (2 * 1e7) - 1.55 * 1.55 / 4e6);  // negative: only Ks matters
  bogie.load_terms = false;
  const Eigen::Vector4d q = bogie.Solve();
  EXPECT_NEAR(-q(1), 2.246122e-3, 1e-9);
  EXPECT_NEAR(q(3), 2.246122e-3, 1e-9);
  EXPECT_NEAR(-q(0), 41.52308e-3, 1e-8);
  EXPECT_NEAR(-q(2), 38.37851e-3, 1e-8);
}

TEST(LinearLawsTest, TwoAxleBogieInACurveMeetsTheClosedFormWithinOnePercent) {
  const double speed = 10;
  TwoAxleBogie bogie;
  bogie.cone = 0.05;
  bogie.a = 1.55;
  bogie.radius = 12000;  // small shifts: the conicity on an arc changes with them
  bogie.k_psi = 2e6;
  bogie.k_y = 1e7;
  const ScratchDir folder;
  const std::string file = folder.Write("b.xml", laws::LightBogie(bogie.k_psi, bogie.k_y));
  ModelPtr m = std::move(LoadMjcf(file)).value();
  const auto options = ConedLinear(folder.Write("t.yaml", laws::CurvedTrack(bogie.radius, speed)),
                                   bogie.cone, speed);
  const Status attached = plugin::Attach(m.get(), options);
  ASSERT_TRUE(attached.ok()) << attached.error().Line();
  const plugin::Binding& binding = *plugin::Find(m.get());
  const DataPtr d(mj_makeData(m.get()));
  plugin::ResetToStart(m.get(), d.get());
  mj_forward(m.get(), d.get());
  bogie.contact = ReadContact(m.get(), d.get(), binding);
  bogie.conicity = laws::ConicityOnArc(bogie.cone, bogie.contact.b0, bogie.contact.r0, kRailRadius);
  bogie.load = 9.81 * mj_getTotalmass(m.get()) / 2;

  Eigen::Vector4d mean = Eigen::Vector4d::Zero();
  int count = 0;
  while (d->time < 45) {
    mj_step(m.get(), d.get());
    const double x = d->qpos[0];
    if (x > 385) break;
    if (x < 300) continue;
    for (int i = 0; i < 2; ++i) {
      const plugin::WheelsetState w = binding.CalcWheelset(m.get(), d.get(), i);
      mean(2 * i) += w.lateral;
      mean(2 * i + 1) += w.yaw;
    }
    ++count;
  }
  plugin::Detach(m.get());
  ASSERT_GT(count, 0);
  mean /= count;
  const Eigen::Vector4d q = bogie.Solve();
  EXPECT_NEAR(mean(1) / q(1), 1, 0.01) << "yaw of the leading axle";
  EXPECT_NEAR(mean(3) / q(3), 1, 0.01) << "yaw of the trailing axle";
  EXPECT_NEAR((mean(0) + mean(2)) / (q(0) + q(2)), 1, 0.01) << "mean shift";
  EXPECT_NEAR((mean(0) - mean(2)) / (q(0) - q(2)), 1, 0.01) << "difference of the shifts";
}

}  // namespace
}  // namespace phs::vehicle
