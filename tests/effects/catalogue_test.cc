// The catalogue of effects: its names, its ranges, and wrong input to it.
#include "effects/catalogue.h"

#include <gtest/gtest.h>

#include "phs_model/phs_model.h"
#include "tests/effects/driven_cylinder.h"

namespace phs::effects {

using phs_model::CreatePhsSystem;
namespace {

TEST(Catalogue, HasEveryNameOfTheDocumentOnce) {
  for (const char* name : {"piston_leakage",    "external_leakage",  "line_resistance",
                           "line_inertance",    "check_restriction", "entrained_air",
                           "hose_expansion",    "gas_thermal",       "accumulator_precharge",
                           "cavitation",        "stribeck",          "presliding",
                           "pressure_friction", "position_friction", "dwell_friction",
                           "viscous_friction",  "backlash",          "mount_compliance",
                           "bush_viscoelastic", "sensor_offset",     "sensor_drift",
                           "sensor_delay",      "sensor_gain",       "temperature_drift"}) {
    int found = 0;
    for (const auto& info : Catalogue().effects()) found += info.name == name;
    EXPECT_EQ(found, 1) << name;
  }
  for (const auto& info : Catalogue().effects()) {
    for (const auto& p : info.parameters) {
      EXPECT_LE(p.min, p.low) << info.name << "." << p.name;
      EXPECT_LE(p.high, p.max) << info.name << "." << p.name;
      EXPECT_TRUE(p.otherwise >= p.min && p.otherwise <= p.max) << info.name << "." << p.name;
    }
  }
}

TEST(Catalogue, UnknownNamesAndKeysGiveTheNearest) {
  const auto wrong = CreatePhsSystem(With(Quarter(), "backlas"));
  ASSERT_FALSE(wrong.ok());
  EXPECT_NE(wrong.error().Line().find("did you mean backlash?"), std::string::npos);
  const auto key = CreatePhsSystem(With(Quarter(), "backlash", {{"gapp_m", 1}}));
  ASSERT_FALSE(key.ok());
  EXPECT_NE(key.error().Line().find("did you mean gap_m?"), std::string::npos);
  const auto range = CreatePhsSystem(With(Quarter(), "backlash", {{"gap_m", -1}}));
  ASSERT_FALSE(range.ok());
  EXPECT_NE(range.error().Line().find("effects.backlash.gap_m"), std::string::npos);
  const auto target = CreatePhsSystem(With(Quarter(), "backlash", {}, {"7"}));
  ASSERT_FALSE(target.ok());
}

}  // namespace
}  // namespace phs::effects
