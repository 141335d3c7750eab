// What becomes of oil and gas, found in small records made with the rig model itself.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/identify/search_record.h"

namespace phs::identify::search {
namespace {

using Targets = std::vector<std::string>;

// A lip that lifts: it was a formula, as a leak was open at any pressure.
TEST(OilSearchTest, ALeakThatOpensAtAPressureIsALeak) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back(
      {"external_leakage", {"L1"}, {{"conductance_m3_per_Pas", 3e-14}, {"opening_Pa", 5e6}}});
  const Identification found = FindAmong(
      {"external_leakage", "piston_leakage", "hose_expansion", "diaphragm_stop"}, Record(truth));
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "external_leakage");
  EXPECT_EQ(found.effects[0].candidate.params.targets, Targets{"L1"});
  EXPECT_NEAR(ValueOf(found, "effects.external_leakage.opening_Pa") / 5e6, 1, 0.03) << Said(found);
}

// The rod carries a film out and does not bring it back: beside a leak, a drift and air.
TEST(OilSearchTest, FindsAFilmThatTheRodCarriesOut) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back(
      {"external_leakage", {"L1"}, {{"conductance_m3_per_Pas", 0}, {"film_out_m2", 1.5e-6}}});
  const Identification found =
      FindAmong({"external_leakage", "gas_loss", "sensor_drift", "entrained_air"}, Record(truth));
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "external_leakage");
  EXPECT_NEAR(ValueOf(found, "effects.external_leakage.film_out_m2") / 1.5e-6, 1, 0.05)
      << Said(found);
}

// A bore that is scored beyond a place.
TEST(OilSearchTest, FindsWhereABoreIsScored) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back(
      {"piston_leakage",
       {},
       {{"conductance_m3_per_Pas", 4e-14}, {"from_m", 8e-4}, {"edge_m", 1.5e-4}}});
  const Identification found = FindAmong(
      {"piston_leakage", "external_leakage", "seal_shuttle", "entrained_air"}, Record(truth));
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "piston_leakage");
  EXPECT_NEAR(ValueOf(found, "effects.piston_leakage.from_m"), 8e-4, 3e-4) << Said(found);
}

// Beside oil that is lost, and gauges that drift.
TEST(OilSearchTest, FindsGasThatLeavesItsReservoir) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back({"gas_loss", {"L2"}, {{"loss_1_per_s", 1.5e-3}}});
  const Identification found = FindAmong(
      {"gas_loss", "external_leakage", "sensor_drift", "temperature_drift", "entrained_air"},
      Record(truth));
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "gas_loss");
  EXPECT_EQ(found.effects[0].candidate.params.targets, Targets{"L2"});
  EXPECT_NEAR(ValueOf(found, "effects.gas_loss.loss_1_per_s") / 1.5e-3, 1, 0.05);
}

// One time is not enough: gas that warms or a second cause took what it left.
TEST(OilSearchTest, FindsAHoseThatCreepsOverDecades) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back({"hose_expansion",
                           {"L1"},
                           {{"compliance_m3_per_Pa", 0},
                            {"creep_m3_per_Pa", 9e-13},
                            {"creep_time_s", 1.2},
                            {"creep_spread", 8}}});
  const Identification found = FindAmong(
      {"hose_expansion", "gas_thermal", "external_leakage", "entrained_air"}, Record(truth));
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "hose_expansion");
  EXPECT_NEAR(ValueOf(found, "effects.hose_expansion.creep_spread") / 8, 1, 0.2);
}

// A braid that locks near the static pressure: stated at no pressure its compliance was so large,
// and so uncertain, that it was never told.
TEST(OilSearchTest, FindsABraidThatLocksNearTheStaticPressure) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back({"hose_expansion",
                           {"L2"},
                           {{"compliance_m3_per_Pa", 2e-12},
                            {"stiffening_Pa", 1.5e6},
                            {"stiffening_order", 4},
                            {"stated_at_Pa", 2e6}}});
  const Identification found =
      FindAmong({"hose_expansion", "entrained_air", "cavitation", "oil_stiffening"}, Record(truth));
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "hose_expansion") << Said(found);
}

// Gas whose surface shrinks with its volume holds its heat longer when it is dense.
TEST(OilSearchTest, FindsGasThatHoldsItsHeatLongerWhenItIsDense) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back(
      {"gas_thermal", {"L1"}, {{"thermal_time_s", 1.2}, {"density_exponent", -0.67}}});
  const Identification found = FindAmong(
      {"gas_thermal", "entrained_air", "external_leakage", "hose_expansion"}, Record(truth));
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "gas_thermal");
  EXPECT_NEAR(ValueOf(found, "effects.gas_thermal.density_exponent"), -0.67, 0.15);
}

}  // namespace
}  // namespace phs::identify::search
