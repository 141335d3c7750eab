// Axle modes measured on the multibody model against closed forms.
//
// PHS alone (cylinders at +-b, lines C = V_oil/beta + V_g/p at the precharge, isothermal):
//   bending 0, shear 8 b^2 A_bore^2/C_diagonal, traction 8 A_rod^2/C_cross,
//   antiphase 8 (A_rod^2/C_cross + A_bore^2/C_diagonal).
// Derivation: the volume each line loses per unit of a pattern is N^T u; force K u = N C^-1 N^T u.
//   shear      u (yaw both): x = b u (-1, 1, -1, 1) for cylinders 1 … 4 (leading left, right,
//              trailing right, left), so each diagonal line loses 2 A_bore b u, each cross line
//              nothing: K = 2 lines (2 A_bore b)^2/C
//   bending    u (yaw against each other): x = b u (-1, 1, 1, -1): no line loses anything
//   traction   x = u (1, 1, -1, -1): each cross line loses 2 A_rod u, diagonals nothing
//   antiphase  x = u (1, 1, 1, 1): every line loses twice
#include "analysis/axle_modes.h"

#include <gtest/gtest.h>

#include <fstream>

#include "phs_model/phs_model.h"
#include "tests/base/scratch_dir.h"
#include "vehicle/simulation.h"

namespace phs::analysis {
namespace {

constexpr double kLever = 0.9;
constexpr double kBore = 3.14159265358979 / 4 * 0.1 * 0.1;
constexpr double kRod = kBore - 3.14159265358979 / 4 * 0.032 * 0.032;
/// models/phs/bo_bo.yaml: 1.1 l of oil at 1.4 GPa, 16.16 ml of gas at the precharge.
double Compliance(double pressure) { return 1.1e-3 / 1.4e9 + 16.16e-6 / pressure; }

/// With another PHS model than the bogie's if `phs` names one.
AxleModes MeasureOn(const std::string& bogie, const AxleModeOptions& options = {},
                    const std::string& phs = "") {
  vehicle::Scenario s;
  s.name = "modes";
  s.track = "straight";
  s.bogie = bogie;
  s.speed_m_s = 20;
  s.phs = phs;
  auto simulation = vehicle::Simulation::Create(s);
  EXPECT_TRUE(simulation.ok()) << simulation.error().Line();
  auto modes = MeasureAxleModes(simulation.value(), options);
  EXPECT_TRUE(modes.ok()) << modes.error().Line();
  return modes.value();
}

TEST(AxleModesTest, PrimarySpringsOfTheRigidBogieAreMeasuredExactly) {
  // Both axles together: 2 k of the guidance joints in bogie_xml/rigid_link.xml, 2 c of damping.
  const AxleModes modes = MeasureOn("rigid_link");
  for (const auto& list : {modes.small, modes.large}) {
    EXPECT_NEAR(list[0].stiffness / (2 * 66.42e6), 1, 1e-6);
    EXPECT_NEAR(list[1].stiffness / (2 * 66.42e6), 1, 1e-6);
    EXPECT_NEAR(list[2].stiffness / (2 * 82.0e6), 1, 1e-6);
    EXPECT_NEAR(list[3].stiffness / (2 * 82.0e6), 1, 1e-6);
    EXPECT_NEAR(list[0].damping / (2 * 1.053e5), 1, 1e-3);
    EXPECT_NEAR(list[2].damping / (2 * 1.3e5), 1, 1e-3);
  }
}

TEST(AxleModesTest, NetworkOfThePhsHasItsClosedFormsOnTopOfThePrimarySprings) {
  // Small motion (0.02 mm): the gas springs are linear and the seals stick, each a spring of its
  // own beside the oil. Bending shows the seals alone, and every cylinder makes the same stroke in
  // every mode.
  const AxleModes modes = MeasureOn("phs_declared");
  const double diagonal = Compliance(1.8e6);
  const double cross = Compliance(1.8e6 * kBore / kRod);
  const double shear = 8 * kLever * kLever * kBore * kBore / diagonal;
  const double traction = 8 * kRod * kRod / cross;
  const double antiphase = 8 * (kRod * kRod / cross + kBore * kBore / diagonal);
  const double springs_yaw = 2 * 1.62e6;
  const double springs_x = 2 * 2.0e6;
  const double seals_yaw = modes.small[0].stiffness - springs_yaw;
  const double seals_x = seals_yaw / (kLever * kLever);
  EXPECT_NEAR(seals_yaw / (4 * 3.6e7 * kLever * kLever), 1, 1e-3);
  EXPECT_NEAR((modes.small[1].stiffness - springs_yaw - seals_yaw) / shear, 1, 2e-3);
  EXPECT_NEAR((modes.small[2].stiffness - springs_x - seals_x) / traction, 1, 2e-3);
  EXPECT_NEAR((modes.small[3].stiffness - springs_x - seals_x) / antiphase, 1, 2e-3);
  // Large motion (2 mm) compresses the gas: shear and traction become stiffer, bending does not.
  EXPECT_GT(modes.large[1].stiffness - springs_yaw, 2 * shear);
  EXPECT_GT(modes.large[2].stiffness - springs_x, 1.5 * traction);
}

TEST(AxleModesTest, SealsThatStickMakeBendingStiffAtSmallAmplitudeOnly) {
  const AxleModes modes = MeasureOn("phs");
  EXPECT_LT(modes.large[0].stiffness, 0.1 * modes.small[0].stiffness);
  EXPECT_GT(modes.large[1].stiffness, 4 * modes.large[0].stiffness);
  // Large motion loses 4 F x (travel 4 u b) per cycle in the seals, friction 1.5 … 2.1 kN each.
  const double travel = 4 * 2e-3;
  EXPECT_GT(modes.large[0].loss_per_cycle, 4 * 1500 * travel);
  EXPECT_LT(modes.large[0].loss_per_cycle, 1.2 * 4 * 2100 * travel + 1000);
}

TEST(AxleModesTest, EveryBogieFollowsTheClosedFormInSmallMotion) {
  for (const char* bogie :
       {"phs", "phs_declared", "rigid_link", "soft_link", "emd_radial", "ge_coupling_shaft",
        "adtranz_shifting", "phs_coco", "rigid_link_coco", "scheffel_cross_anchors",
        "ge_coupling_shaft_coco", "adtranz_shifting_coco", "active_steering"}) {
    AxleModeOptions faster;
    faster.frequency_Hz = 2;
    for (const AxleMode& mode : MeasureOn(bogie, faster).small) {
      EXPECT_NEAR(mode.stiffness / mode.closed_form.total(), 1, 3e-3) << bogie << " " << mode.name;
    }
  }
}

TEST(AxleModesTest, ClosedFormOfTheBoBoHasTheTermsOfItsNetwork) {
  const AxleModes modes = MeasureOn("phs_declared");
  const double diagonal = Compliance(1.8e6);
  const double cross = Compliance(1.8e6 * kBore / kRod);
  EXPECT_NEAR(modes.small[0].closed_form.lines, 0, 1);
  EXPECT_NEAR(modes.small[1].closed_form.lines, 8 * kLever * kLever * kBore * kBore / diagonal,
              1e-4 * modes.small[1].closed_form.lines);
  EXPECT_NEAR(modes.small[2].closed_form.lines, 8 * kRod * kRod / cross,
              1e-4 * modes.small[2].closed_form.lines);
  EXPECT_NEAR(modes.small[0].closed_form.springs, 2 * 1.62e6, 1);
  EXPECT_NEAR(modes.small[2].closed_form.seals, 4 * 3.6e7, 1e4);
}

TEST(AxleModesTest, ALineOfABoreAndARodChamberCountsThemWithOppositeSigns) {
  // Each line joins the rod chamber at one axle with the bore chamber at the opposite corner: 1-3
  // and 2-4. It loses A_rod s_i - A_bore s_j, so with the strokes at the top of this file bending
  // and traction feel (A_bore + A_rod)^2, shear and antiphase (A_bore - A_rod)^2.
  hydraulics::PhsParams params = phs_model::FindPhsParams("bo_bo").value();
  const char* bore[] = {"L2", "L3", "L1", "L4"};
  const char* rod[] = {"L1", "L4", "L2", "L3"};
  for (size_t i = 0; i < 4; ++i) {
    params.cylinders[i].bore_line = bore[i];
    params.cylinders[i].rod_line = rod[i];
    params.lines[i].static_pressure_Pa = 1.8e6;
  }
  const std::string file = ScratchFile("crossed.yaml");
  std::ofstream(file) << phs_model::ToYaml(params);
  const AxleModes modes = MeasureOn("phs", {}, file);
  const double sum = 4 * (kBore + kRod) * (kBore + kRod) / Compliance(1.8e6);
  const double difference = 4 * (kBore - kRod) * (kBore - kRod) / Compliance(1.8e6);
  const double lever = kLever * kLever;
  const double expected[] = {lever * sum, lever * difference, sum, difference};
  for (size_t k = 0; k < 4; ++k) {
    const AxleMode& mode = modes.small[k];
    EXPECT_NEAR(mode.closed_form.lines / expected[k], 1, 2e-3) << mode.name;
    EXPECT_NEAR(mode.stiffness / mode.closed_form.total(), 1, 1e-2) << mode.name;
  }
}

TEST(AxleModesTest, PictureShowsWhichCylindersExtend) {
  const AxleModes modes = MeasureOn("phs");
  ASSERT_EQ(modes.plan.cylinders.size(), 4u);
  EXPECT_NEAR(modes.plan.axles[0].x, 1.55, 1e-6);
  EXPECT_NEAR(modes.plan.axles[1].x, -1.55, 1e-6);
  // Traction, both axles forward: 1, 2 (lead) extend, 3, 4 (trail) shorten. Anti-phase: all extend.
  const double u = 2e-3;
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(modes.large[2].cylinder_stroke_m[static_cast<size_t>(i)], i < 2 ? u : -u, 1e-5);
    EXPECT_NEAR(modes.large[3].cylinder_stroke_m[static_cast<size_t>(i)], u, 1e-5);
  }
  EXPECT_EQ(modes.large[0].loop_displacement.size(), modes.large[0].loop_force.size());
}

}  // namespace
}  // namespace phs::analysis
