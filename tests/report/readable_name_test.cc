#include "report/readable_name.h"

#include <gtest/gtest.h>

namespace phs::report {
namespace {

void Expect(const std::string& column, const std::string& words, const std::string& unit,
            double factor) {
  const ReadableName name = Readable(column);
  EXPECT_EQ(name.words, words) << column;
  EXPECT_EQ(name.unit, unit) << column;
  EXPECT_DOUBLE_EQ(name.factor, factor) << column;
}

TEST(Readable, ChannelsAndParameters) {
  Expect("load_cell_N", "load cell force", "kN", 1e-3);
  Expect("pL1_Pa", "pL1", "MPa", 1e-6);
  Expect("gap_m", "gap", "mm", 1e3);
  Expect("track_radius_m", "track radius", "m", 1);
  Expect("speed_m_s", "speed", "m/s", 1);
  Expect("stribeck_speed_m_s", "stribeck speed", "m/s", 1);
  Expect("acceleration_m_s2", "acceleration", "m/s²", 1);
  Expect("lead_outer_T_gamma_N", "lead outer T gamma", "N", 1);
  Expect("free_air_m3", "free air", "cm³", 1e6);
  Expect("friction", "friction", "–", 1);
  Expect("hour_h", "hour", "h", 1);
  Expect("speed_km_h", "speed", "km/h", 1);
  Expect("worst_Y_qst_N_value", "worst Y qst", "kN", 1e-3);
}

TEST(Readable, QuotientsKeepTheirUnit) {
  Expect("stiffness_N_per_m", "stiffness", "N/m", 1);
  Expect("bending_Nm_per_rad", "bending", "N m/rad", 1);
  Expect("turbulent_Pas2_per_m6", "turbulent", "Pa s²/m⁶", 1);
  Expect("conductance_m3_per_Pas", "conductance", "m³/(Pa s)", 1);
  Expect("slope_1_per_m", "slope", "1/m", 1);
}

}  // namespace
}  // namespace phs::report
