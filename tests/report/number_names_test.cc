#include "report/number_names.h"

#include <gtest/gtest.h>

namespace phs::report {
namespace {

TEST(NumberNames, AreThoseOfTheOtherTables) {
  const struct {
    const char* path;
    const char* words;
    const char* unit;
  } kNumbers[] = {
      {"steady_curve.wheelsets.lead.angle_of_attack_rad", "Angle of attack, leading axle", "mrad"},
      {"steady_curve.wheelsets.rear_trail.sum_Y_N",
       "Track-shifting force ΣY, rear bogie, trailing axle", "kN"},
      {"steady_curve.wheels.lead_outer.T_gamma_N", "Wear number Tγ, leading outer wheel", "N"},
      {"steady_curve.cylinders.2.force_N", "Cylinder force, cylinder 2", "kN"},
      {"steady_curve.lines.L1.pressure_Pa", "Line pressure, line L1", "MPa"},
      {"steady_curve.front_bending_rad", "Bending (steering) of the bogie, front bogie", "mrad"},
      {"steady_curve.T_gamma_N", "Wear number Tγ, all wheels", "N"},
      {"run.lost_creep_J", "Lost in creep between wheel and rail", "kJ"},
      {"budget.mid.creep_Nm", "Yaw moment of the creep forces, middle axle", "kN m"}};
  for (const auto& number : kNumbers) {
    const NumberName name = NameOfNumber(number.path);
    EXPECT_EQ(name.words, number.words) << number.path;
    EXPECT_EQ(name.unit, number.unit) << number.path;
  }
  EXPECT_DOUBLE_EQ(NameOfNumber("run.max_sum_Y_N").factor, 1e-3);
  EXPECT_EQ(NameOfNumber("run.new_thing_N").words, "new thing");
}

TEST(NumberNames, Places) {
  EXPECT_EQ(PlaceWords("lead_left", "wheel"), "leading left wheel");
  EXPECT_EQ(PlaceWords("front_trail", "axle"), "front bogie, trailing axle");
  EXPECT_EQ(PlaceWords("L1", "axle"), "L1");
}

}  // namespace
}  // namespace phs::report
