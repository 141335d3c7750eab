// A part on a bench that a force moves, against closed formulas and against the bench driven by the
// motion that comes out.
#include "rigs/element_drive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "phs_model/phs_model.h"
#include "rigs/element_bench.h"

namespace phs::rigs {
namespace {

using hydraulics::PhsParams;

PhsParams Part(double coulomb_N, double viscous_Ns_per_m) {
  PhsParams params;
  params.name = "part";
  params.cylinders.resize(1);
  params.cylinders[0].name = "1";
  auto& f = params.friction;
  f.model = hydraulics::FrictionModel::kStatic;
  f.curve = hydraulics::FrictionCurve::kCoulomb;
  f.coulomb_extension_N = f.coulomb_retraction_N = coulomb_N;
  f.breakaway_extension_N = f.breakaway_retraction_N = coulomb_N;
  f.viscous_extension_Ns_per_m = f.viscous_retraction_Ns_per_m = viscous_Ns_per_m;
  f.ramp_speed_m_s = 1e-4;
  params.element.mass_kg = 4;
  params.element.stiffness_N_per_m = 3000;
  return params;
}

RigMotion Force(double step_s, double end_s, const std::function<double(double)>& force) {
  RigMotion motion;
  motion.step_s = step_s;
  motion.position_m.emplace_back();
  for (int i = 0; i * step_s < end_s; ++i) motion.position_m[0].push_back(force(i * step_s));
  return motion;
}

std::vector<double> Moved(const PhsParams& params, const RigMotion& motion, ElementStart start = {},
                          int substeps = 1) {
  const auto system = phs_model::CreatePhsSystem(params);
  EXPECT_TRUE(system.ok());
  std::vector<double> x;
  const Status done = RunElementByForce(system.value(), motion, start, substeps, &x);
  EXPECT_TRUE(done.ok()) << (done.ok() ? "" : done.error().Line());
  return x;
}

// x = P/(k - m w² + i w d), closed; the error falls with the square of the step.
TEST(ElementDrive, SwingsAsAForcedOscillatorInSecondOrder) {
  const PhsParams params = Part(0, 50);
  const double w = 25;
  const std::complex<double> answer = 10.0 / std::complex<double>(3000 - 4 * w * w, 50 * w);
  const auto error = [&](double step) {
    // Begun on the closed answer, so that nothing dies away.
    const ElementStart start{answer.real(), -w * answer.imag()};
    const auto x =
        Moved(params, Force(step, 3, [&](double t) { return 10 * std::cos(w * t); }), start);
    double most = 0;
    for (size_t i = 0; i < x.size(); ++i) {
      const double t = static_cast<double>(i) * step;
      const double exact = (answer * std::exp(std::complex<double>(0, w * t))).real();
      most = std::max(most, std::abs(x[i] - exact) / std::abs(answer));
    }
    return most;
  };
  EXPECT_LT(error(0.003), 0.005);
  EXPECT_NEAR(error(0.003) / error(0.0015), 4, 0.5);
}

TEST(ElementDrive, SticksBelowItsFrictionAndSlidesAtItsPaceBeyond) {
  PhsParams params = Part(20, 60);
  params.element.stiffness_N_per_m = 0;
  const auto held = Moved(params, Force(0.01, 2, [](double) { return 15.0; }));
  EXPECT_LT(held.back(), 1e-4 * 2) << "creeps below the speed of the ramp";
  const auto slid = Moved(params, Force(0.01, 2, [](double) { return 50.0; }));
  EXPECT_NEAR((slid.back() - slid[slid.size() - 51]) / 0.5, 30.0 / 60, 1e-3) << "(P - F)/d";
}

// Both doors are one equation: the bench moved as this run moves asks for the force that moved it.
TEST(ElementDrive, TheBenchAsksForTheForceThatMovedIt) {
  PhsParams params = Part(12, 40);
  params.element.hardening_N_per_m3 = 4e5;
  params.effects.push_back({"backlash", {}, {{"gap_m", 1e-3}, {"stiffness_N_per_m", 2e5}}});
  for (const bool mounted : {false, true}) {
    if (!mounted) params.effects.clear();
    const double step = 1e-3;
    RigMotion motion =
        Force(step, 4, [](double t) { return 60 * std::sin(3 * t) + 25 * std::sin(11 * t); });
    const std::vector<double> force = motion.position_m[0];
    motion.position_m[0] = Moved(params, motion);
    const auto system = phs_model::CreatePhsSystem(params);
    std::vector<double> asked(force.size());
    RunElementBench(system.value(), motion, DifferentiateMotion(motion.position_m[0], step), &asked,
                    nullptr);
    double square = 0, all = 0;
    for (size_t i = 20; i + 20 < force.size(); ++i) {
      square += std::pow(asked[i] - force[i], 2), all += force[i] * force[i];
    }
    EXPECT_LT(std::sqrt(square / all), 0.03) << mounted;
  }
}

TEST(ElementDrive, AsksForAMass) {
  PhsParams params = Part(12, 40);
  params.element.mass_kg = 0;
  const auto system = phs_model::CreatePhsSystem(params);
  std::vector<double> x;
  const RigMotion motion = Force(0.01, 1, [](double) { return 1.0; });
  EXPECT_FALSE(RunElementByForce(system.value(), motion, {}, 1, &x).ok());
}

}  // namespace
}  // namespace phs::rigs
