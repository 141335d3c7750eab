// The books of energy, from powers whose works are known.
#include "vehicle/energy_book.h"

#include <gtest/gtest.h>

#include <cmath>

#include "vehicle/scenario_file.h"
#include "vehicle/simulation.h"

namespace phs::vehicle {
namespace {

using plugin::UserData;

EnergyBook Balanced() {
  EnergyBook book;
  book.work_in = 100;
  book.start_kinetic = 40;
  book.kinetic = 50;
  book.stored = 20;
  book.lost_creep = 31;
  book.lost_contact = 17;
  book.lost_dampers = 11;
  book.lost_phs = 7;
  book.lost_brakes = 4;
  return book;
}

TEST(EnergyBookTest, EveryEntryCounts) {
  EXPECT_DOUBLE_EQ(Balanced().Error(), 0);
  for (double EnergyBook::*lost :
       {&EnergyBook::kinetic, &EnergyBook::stored, &EnergyBook::lost_creep,
        &EnergyBook::lost_contact, &EnergyBook::lost_dampers, &EnergyBook::lost_phs,
        &EnergyBook::lost_brakes}) {
    EnergyBook book = Balanced();
    book.*lost += 1;
    EXPECT_DOUBLE_EQ(book.Error(), -1);
  }
}

TEST(EnergyBookTest, TheErrorIsComparedWithTheLargestThatFlowed) {
  EnergyBook book = Balanced();
  book.work_in = 99;
  EXPECT_DOUBLE_EQ(book.RelativeError(), -1 / 99.0);
  // Losses alone, of all kinds together: from potential energy.
  book = Balanced();
  book.stored -= 100;
  book.work_in = -1;
  EXPECT_DOUBLE_EQ(book.RelativeError(), -1 / 70.0);
  // A vehicle that slows down.
  book = EnergyBook();
  book.start_kinetic = 300;
  book.kinetic = 100;
  book.lost_brakes = 199;
  EXPECT_DOUBLE_EQ(book.RelativeError(), 1 / 200.0);
  book = EnergyBook();
  book.train = 50;
  book.stored = 2;
  EXPECT_DOUBLE_EQ(book.RelativeError(), -2 / 50.0);
  EXPECT_EQ(EnergyBook().RelativeError(), 0);
}

TEST(EnergyKeeperTest, EveryPowerGoesToItsOwnEntryByTheTrapezoid) {
  auto created = Simulation::Create(LoadScenario("curve_r300").value());
  ASSERT_TRUE(created.ok()) << created.error().Line();
  const Simulation& sim = created.value();
  EnergyKeeper keeper(sim.binding());
  std::vector<mjtNum> user(static_cast<size_t>(sim.model()->nuserdata));
  mjData d{};
  d.userdata = user.data();
  // Every power grows evenly from zero: after n steps of h its work is slope (n h)^2 / 2.
  const struct {
    int power;
    double slope;
    double EnergyBook::*entry;
  } kEntries[] = {{UserData::kDrivePower, 3, &EnergyBook::work_in},
                  {UserData::kAppliedPower, 11, &EnergyBook::work_in},
                  {UserData::kTrainPower, -5, &EnergyBook::work_in},
                  {UserData::kTrainPower, -5, &EnergyBook::train},
                  {UserData::kCreepPower, 7, &EnergyBook::lost_creep},
                  {UserData::kContactPower, 13, &EnergyBook::lost_contact},
                  {UserData::kDamperPower, 17, &EnergyBook::lost_dampers},
                  {UserData::kPhsPower, 19, &EnergyBook::lost_phs},
                  {UserData::kBrakePower, 23, &EnergyBook::lost_brakes}};
  for (int n = 0; n <= 40; ++n) {
    for (const auto& entry : kEntries) {
      user[static_cast<size_t>(entry.power)] = entry.slope * n * sim.model()->opt.timestep;
    }
    keeper.Step(sim.model(), &d);
  }
  const double half_square = 0.5 * std::pow(40 * sim.model()->opt.timestep, 2);
  EXPECT_NEAR(keeper.book().work_in / half_square, 3 + 11 - 5, 1e-9);
  EXPECT_NEAR(keeper.book().train / half_square, 5, 1e-9);
  for (const auto& entry : kEntries) {
    if (entry.entry == &EnergyBook::work_in || entry.entry == &EnergyBook::train) continue;
    EXPECT_NEAR(keeper.book().*entry.entry / half_square, entry.slope, 1e-9);
  }
}

}  // namespace
}  // namespace phs::vehicle
