// Case of the Manchester contact benchmark against CONTACT's printed result (Apache-2.0,
// github eve70a/CONTACT): S1002 on UIC60, 10 kN per wheel, y 0 … 10 mm with yaw 0 … 24 mrad. The
// left wheel runs away from its flange (21 positions), the right one climbs (every second one).
#include "rail/wheelset_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "contact_pair.h"
#include "creep_reference.h"
#include "phs_places.h"
#include "rail/contact_reference.h"

namespace phs::rail {
namespace {

/// Input of CONTACT's case with the product's profiles (the same files by other names).
WheelsetCases Cases(const std::string& method, const std::string& side = "left") {
  auto read = ReadContactInput(std::string(PHS_TEST_DATA) + "/mbench_a22_" + side + ".inp");
  if (!read.ok()) ADD_FAILURE() << read.error().Line();
  WheelsetCases cases = std::move(read).value();
  cases.wheel_rail.wheel_profile = ProfilePath("S1002.prw");
  cases.wheel_rail.rail_profile = ProfilePath("UIC60.prr");
  cases.wheel_rail.creep.method = method;
  cases.wheel_rail.creep.use_disk_cache = false;
  return cases;
}

TEST(ManchesterA22, InputFileIsRead) {
  const WheelsetCases c = Cases("fastsim");
  EXPECT_EQ(c.side, Side::kLeft);
  EXPECT_EQ(c.table.num_rows(), 21);
  EXPECT_DOUBLE_EQ(c.wheel_rail.gauge, 1.435);
  EXPECT_DOUBLE_EQ(c.wheel_rail.wheel_radius, 0.46);
  EXPECT_DOUBLE_EQ(c.wheel_rail.creep.material.shear_modulus_Pa, 82e9);
  EXPECT_DOUBLE_EQ(Cell(c.table, "yaw_rad", 20), 0.024);
  EXPECT_DOUBLE_EQ(Cell(c.table, "Fz_N", 20), 10000);
}

/// What CONTACT prints of a wheel, of ours.
struct Position {
  double place = 0, angle = 0, radius = 0;  ///< of CONTACT's reference point [mm, rad, mm]
  double normal = 0, pressure = 0, z = 0, fx = 0, fy = 0, fz = 0;
};
std::vector<Position> Positions(const WheelsetCases& cases) {
  const auto result = CalcWheelsetCases(cases);
  EXPECT_TRUE(result.ok());
  const Table& t = result.value();
  const auto references = CalcContactReferences(cases, t);
  EXPECT_TRUE(references.ok());
  std::vector<Position> all;
  for (int row = 0; row < t.num_rows(); ++row) {
    const auto k = static_cast<size_t>(Cell(t, "case", row)) - 1;
    all.resize(std::max(all.size(), k + 1));
    Position& p = all[k];
    p.normal += Cell(t, "FN_N", row);
    p.pressure = std::max(p.pressure, Cell(t, "pmax_MPa", row));
    p.z = Cell(t, "z_solved_mm", row);
    p.fx = Cell(t, "FX_N", row);
    p.fy = Cell(t, "FY_N", row);
    p.fz = Cell(t, "FZ_N", row);
    p.place = references.value()[k].rail_y_mm;
    p.angle = references.value()[k].angle_rad;
    p.radius = references.value()[k].radius_mm;
  }
  return all;
}

class ManchesterA22Wheel : public testing::TestWithParam<const char*> {};

// CONTACT's place and angle are those of its reference point, the centre of the undeformed overlap
// weighted with its square; ours at our height are compared with them. At y = 5 mm of the right
// wheel, between two places 11 mm apart in CONTACT's own table, a micrometre of height moves it.
TEST_P(ManchesterA22Wheel, AgreesWithContact) {
  WheelsetCases cases = Cases("fastsim", GetParam());
  cases.wheel_rail.creep.blended_flexibility = true;  // as CONTACT slides: along the slip
  const std::vector<Position> ours = Positions(cases);
  const Table ref = ReferenceTable("mbench_a22_" + std::string(GetParam()) + "_ref.csv");
  ASSERT_EQ(static_cast<int>(ours.size()), ref.num_rows());
  double squares = 0;
  for (size_t k = 0; k < ours.size(); ++k) {
    const Position& p = ours[k];
    const auto theirs = [&](const char* name) { return Cell(ref, name, static_cast<int>(k)); };
    SCOPED_TRACE("y = " + std::to_string(theirs("Y_WS")));
    const bool jumps = std::string(GetParam()) == "right" && theirs("Y_WS") == 5;
    EXPECT_NEAR(p.place, theirs("YCP(R)"), jumps ? 0.4 : 0.15);
    EXPECT_NEAR(p.angle, theirs("DELTCP(TR)"), jumps ? 7e-3 : 1.5e-3);
    EXPECT_NEAR(p.normal / theirs("FN"), 1, 2e-3);
    EXPECT_NEAR(p.pressure / theirs("PMAX"), 1, 0.08);
    // The height tells the sink of the wheel, along the normal a share of CONTACT's approach.
    EXPECT_NEAR((p.z - theirs("Z_WS")) * std::cos(theirs("DELTCP(TR)")) / theirs("APPROACH"), 0,
                0.15);
    EXPECT_NEAR(p.fz, 10000, 1);
    const double limit = 0.3 * theirs("FN");
    const double force = std::hypot(p.fx - theirs("FX(TR)"), p.fy - theirs("FY(TR)")) / limit;
    EXPECT_LT(force, 0.055);
    squares += force * force;
  }
  EXPECT_LT(std::sqrt(squares / static_cast<double>(ours.size())), 0.025);
}
INSTANTIATE_TEST_SUITE_P(BothWheels, ManchesterA22Wheel, testing::Values("left", "right"));

// Conicity r0 (xi_right - xi_left)/(2 y) of CONTACT's creepages, which are those of its reference
// points: of the radii there.
TEST(ManchesterA22, ConicityIsThatOfContactsCreepages) {
  WheelsetCases cases = Cases("polach");
  const std::vector<Position> left = Positions(cases);
  cases.side = Side::kRight;
  const std::vector<Position> right = Positions(cases);
  const Table ref = ReferenceTable("conicity_s1002_uic60.csv");
  ASSERT_EQ(ref.num_rows(), 6);
  for (int row = 0; row < ref.num_rows(); ++row) {
    const double y = Cell(ref, "y_mm", row);
    const auto k = static_cast<size_t>(std::lround(y / 0.5));
    const double conicity = (right[k].radius - left[k].radius) / (2 * y);
    EXPECT_NEAR(conicity / Cell(ref, "conicity", row), 1, 0.03) << y;
  }
}

// CONTACT finds one patch of 1291 elements of 0.04 mm^2.
TEST(ManchesterA22, ConformalPositionOneHasTheRightHeightAreaPressureAndForces) {
  const auto result = CalcWheelsetCases(Cases("fastsim"));
  ASSERT_TRUE(result.ok());
  const Table& t = result.value();
  double normal = 0, y = 0, area = 0, pressure = 0;
  for (int row = 0; row < t.num_rows() && Cell(t, "case", row) == 1; ++row) {
    normal += Cell(t, "FN_N", row);
    y += Cell(t, "FN_N", row) * Cell(t, "ycp_rail_mm", row);
    area += Cell(t, "weight", row) * 3.14159 * Cell(t, "a_mm", row) * Cell(t, "b_mm", row);
    pressure = std::max(pressure, Cell(t, "pmax_MPa", row));
  }
  EXPECT_NEAR(normal, 9997, 10);
  EXPECT_NEAR(y / normal, 8.66, 1);
  EXPECT_NEAR(area / (1291 * 0.04), 1, 0.2);
  EXPECT_NEAR(pressure / 338.3, 1, 0.05);
  EXPECT_NEAR(Cell(t, "z_solved_mm", 0), 0.1981, 1e-3);
  // The load's centre lies half a millimetre nearer to the middle of the patch than on half-spaces.
  EXPECT_NEAR(Cell(t, "FX_N", 0), 0.28, 0.05 * 3000);
  EXPECT_NEAR(Cell(t, "FY_N", 0), -36.2, 0.03 * 3000);
}

TEST(ManchesterA22, TheTableAgreesWithFastsim) {
  const auto slow = CalcWheelsetCases(Cases("fastsim"));
  const auto fast = CalcWheelsetCases(Cases("kalker_table"));
  ASSERT_TRUE(slow.ok() && fast.ok());
  ASSERT_EQ(slow.value().num_rows(), fast.value().num_rows());
  for (int row = 0; row < slow.value().num_rows(); ++row) {
    EXPECT_NEAR(Cell(slow.value(), "FX_N", row), Cell(fast.value(), "FX_N", row), 0.02 * 3000);
    EXPECT_NEAR(Cell(slow.value(), "FY_N", row), Cell(fast.value(), "FY_N", row), 0.02 * 3000);
  }
}

TEST(ManchesterA22, TheRightWheelOfTheMirroredWheelsetIsTheSame) {
  WheelsetCases cases = Cases("polach");
  const auto left = CalcWheelsetCases(cases);
  for (const char* name : {"y_mm", "roll_rad", "yaw_rad", "vy_mm_s", "vroll_rad_s", "vyaw_rad_s"}) {
    for (double& v : cases.table.columns[static_cast<size_t>(cases.table.Find(name))]) v = -v;
  }
  cases.side = Side::kRight;
  const auto right = CalcWheelsetCases(cases);
  ASSERT_TRUE(left.ok() && right.ok());
  for (int row = 0; row < left.value().num_rows(); ++row) {
    EXPECT_EQ(Cell(left.value(), "FX_N", row), Cell(right.value(), "FX_N", row));
    EXPECT_EQ(Cell(left.value(), "FY_N", row), -Cell(right.value(), "FY_N", row));
    EXPECT_EQ(Cell(left.value(), "contact_angle_rad", row),
              -Cell(right.value(), "contact_angle_rad", row));
  }
}

std::string ErrorOf(const std::string& csv) {
  const auto t = ParseCsv(csv, "cases.csv");
  if (!t.ok()) return t.error().Line();
  WheelsetCases cases = Cases("polach");
  cases.table = t.value();
  const auto out = CalcWheelsetCases(cases);
  return out.ok() ? "" : out.error().Line();
}

TEST(WheelsetCases, MessagesNameLineAndColumn) {
  EXPECT_NE(ErrorOf("y_mm,vs_mm_s,Fz_N\n0,1,1\n").find("vpitch_rad_s"), std::string::npos);
  EXPECT_NE(ErrorOf("y_mm,vs_mm_s,vpitch_rad_s\n0,1,1\n").find("neither Fz_N nor z_mm"),
            std::string::npos);
  const std::string head = "y_mm,vs_mm_s,vpitch_rad_s,Fz_N,side\n";
  EXPECT_NE(ErrorOf(head + "0,2000,-4,x,left\n").find("cases.csv:2: Fz_N is 'x'"),
            std::string::npos);
  EXPECT_NE(ErrorOf(head + "0,2000,-4,10,up\n").find("side is 'up'"), std::string::npos);
  EXPECT_NE(ErrorOf(head + "0,2000,-4,-10,left\n").find("0 … 1e7 N"), std::string::npos);
  EXPECT_NE(ErrorOf(head + "0,2000,-4,1e6,left\n0,2000,-4,-1,left\n").find("cases.csv:3"),
            std::string::npos);
  EXPECT_EQ(ErrorOf(head + "0,2000,-4,10000,left\n"), "");
}

TEST(WheelsetCases, OneTableUnderThreeSetsOfNames) {
  WheelsetCases cases = Cases("polach");
  const char* tables[] = {
      "y_mm,Fz_N,roll_rad,yaw_rad,vs_mm_s,vpitch_rad_s\n5,10000,-0.00035540,0.012,2000,-4."
      "3353637\n",
      "S,Y,FZ,ROLL,YAW,VS,VPITCH\n0,5,10000,-0.00035540,0.012,2000,-4.3353637\n",
      "side,Y_WS,FZ,ROLL_WS,YAW_WS,VX_WS,VPITCH_WS\n"
      "\"LEFT WHEEL\",5,10000,-0.00035540,0.012,2000.,-4.3353637\n"};
  for (const char* text : tables) {
    cases.table = ParseCsv(text, "c").value();
    const auto out = CalcWheelsetCases(cases);
    ASSERT_TRUE(out.ok()) << out.error().Line();
    EXPECT_NEAR(Cell(out.value(), "pmax_MPa", 0), 552.8, 6);
  }
}

TEST(WheelsetCases, ResultsThatTheInputHoldsAreReplaced) {
  WheelsetCases cases = Cases("polach");
  cases.table =
      ParseCsv("case,patch,y_mm,z_mm,vs_mm_s,vpitch_rad_s\n9,7,0,0.2,2000,-4.3\n", "c").value();
  const auto out = CalcWheelsetCases(cases);
  ASSERT_TRUE(out.ok());
  EXPECT_EQ(std::count(out.value().names.begin(), out.value().names.end(), "patch"), 1);
  EXPECT_EQ(Cell(out.value(), "case", 0), 1);
}

TEST(WheelsetCases, AGivenHeightAboveTouchLeavesTheWheelLifted) {
  WheelsetCases cases = Cases("polach");
  cases.table = ParseCsv("note,y_mm,z_mm,vs_mm_s,vpitch_rad_s\nup,0,-5,2000,-4.3\n", "c").value();
  const auto out = CalcWheelsetCases(cases);
  ASSERT_TRUE(out.ok());
  EXPECT_EQ(out.value().num_rows(), 1);
  EXPECT_EQ(Cell(out.value(), "patch", 0), 0);
  EXPECT_EQ(Cell(out.value(), "FZ_N", 0), 0);
  EXPECT_EQ(out.value().text[0][0], "up");
}

}  // namespace
}  // namespace phs::rail
