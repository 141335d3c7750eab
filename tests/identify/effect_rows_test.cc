// What the rows of effects say of how they are looked for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "effects/catalogue.h"
#include "effects/unlisted.h"
#include "identify/fit/effect_variants.h"
#include "identify/fit/form_starts.h"
#include "phs_model/phs_model.h"
#include "vehicle/running_effects.h"

namespace phs::identify::search {

using hydraulics::EffectForm;
using hydraulics::EffectInfo;
using hydraulics::FormNumber;
using hydraulics::Walk;
using testing::ElementsAre;
namespace {

std::vector<EffectInfo> AllRows() {
  std::vector<EffectInfo> rows = effects::Catalogue().effects();
  for (const auto& running : vehicle::RunningEffects()) rows.push_back(running.info);
  return rows;
}

const hydraulics::EffectParameter* ParameterOf(const EffectInfo& info, const std::string& name) {
  for (const auto& p : info.parameters) {
    if (p.name == name) return &p;
  }
  return nullptr;
}

TEST(GridTest, EachWithEachInStepAndEitherWay) {
  EXPECT_THAT(Between(1, 100, 3), ElementsAre(1, testing::DoubleEq(10), testing::DoubleEq(100)));
  EXPECT_THAT(Between(-1, 1, 3), ElementsAre(-1, 0, 1));
  const std::vector<NumberScale> plain(3);
  EXPECT_THAT(
      GridOf({{"a", 1, 2, 2}, {"b", 3, 5, 2}}, {{}, {10}}),
      ElementsAre(ElementsAre(1, 30), ElementsAre(1, 50), ElementsAre(2, 30), ElementsAre(2, 50)));
  EXPECT_THAT(GridOf({{"a", 1, 2, 2}, {"b", 5, 3, 2, Walk::kInStep}, {"c", 7}}, plain),
              ElementsAre(ElementsAre(1, 5, 7), ElementsAre(2, 3, 7)));
  EXPECT_THAT(
      GridOf({{"a", 1, 2, 2, Walk::kEitherWay}, {"b", 5, 3, 2, Walk::kInStep}}, plain),
      ElementsAre(ElementsAre(-1, 5), ElementsAre(1, 5), ElementsAre(-2, 3), ElementsAre(2, 3)));
  EXPECT_THAT(GridOf({{"a", 0.1, 0.1, 1, Walk::kEitherWay}}, {{1, 50, true}}),
              ElementsAre(ElementsAre(45), ElementsAre(testing::DoubleEq(55))));
}

/// A formula comes from the residual; a throttle is a part that somebody has built in, and a hidden
/// one is a resistance of its line.
TEST(RowsTest, EveryEffectThatMayHideIsLookedForSomewhere) {
  for (const EffectInfo& info : AllRows()) {
    const auto& s = info.search;
    const bool nowhere = s.rig.empty() && s.bench.empty() && s.bogie.empty();
    EXPECT_EQ(nowhere, info.name == effects::UnlistedInfo().name || info.name == "throttle")
        << info.name << ": its row needs a form after `Install` (hydraulics/effect_forms.h)";
  }
}

TEST(RowsTest, FormsNameNumbersOfTheirEffectInsideWhatIsAllowed) {
  for (const EffectInfo& info : AllRows()) {
    for (const auto* forms : {&info.search.rig, &info.search.bench, &info.search.bogie}) {
      for (const EffectForm& form : *forms) {
        ASSERT_FALSE(form.free.empty()) << info.name;
        EXPECT_LE(form.amounts, static_cast<int>(form.free.size())) << info.name;
        for (const auto& [name, value] : form.held) {
          const auto* p = ParameterOf(info, name);
          ASSERT_NE(p, nullptr) << info.name << "." << name;
          if (forms == &info.search.bench) continue;
          EXPECT_TRUE(value >= p->min && value <= p->max) << info.name << "." << name;
        }
        for (const FormNumber& number : form.free) {
          EXPECT_NE(ParameterOf(info, number.name), nullptr) << info.name << "." << number.name;
        }
      }
    }
    for (const auto& option : info.search.options) {
      for (const FormNumber& number : option.free) {
        EXPECT_NE(ParameterOf(info, number.name), nullptr) << info.name << "." << number.name;
      }
      for (const std::string& name : {option.with, option.without}) {
        EXPECT_TRUE(name.empty() || ParameterOf(info, name) != nullptr) << info.name << name;
      }
    }
  }
}

/// A start outside its range would be moved to its end, where no fit finds the way back.
TEST(RowsTest, GridsOnARigLieInsideThePlausibleRange) {
  for (const EffectInfo& info : AllRows()) {
    for (const auto* forms : {&info.search.rig, &info.search.bogie}) {
      for (const EffectForm& form : *forms) {
        for (const FormNumber& number : form.free) {
          if (number.walk == Walk::kEitherWay) continue;
          const auto* p = ParameterOf(info, number.name);
          ASSERT_NE(p, nullptr);
          for (const double x : Between(number.from, number.to, number.count)) {
            EXPECT_TRUE(x >= p->low && x <= p->high) << info.name << "." << p->name << " " << x;
          }
        }
      }
    }
  }
}

// A conductance is that of a laminar gap or of an orifice: who reads it must see which.
TEST(RowsTest, WhatAFormHoldsIsNamed) {
  const auto quarter = phs_model::FindPhsParams("quarter_setup2").value();
  std::set<std::pair<std::string, double>> held;
  for (const Candidate& c : ListCandidates(quarter, rigs::RigKind::kQuarter)) {
    if (c.effect != "piston_leakage") continue;
    for (const auto& number : HeldNumbers(c)) held.insert(number);
    const bool orifice = HeldNumbers(c).contains("exponent");
    EXPECT_EQ(VariantName(c).find("exponent=0.5") != std::string::npos, orifice);
  }
  EXPECT_THAT(held, ElementsAre(std::pair{"exponent", 0.5}, std::pair{"return_ratio", 0.02},
                                std::pair{"return_ratio", 50.0}));
}

TEST(RowsTest, AnAmountIsComparedWithWhereItDoesNothing) {
  const auto quarter = phs_model::FindPhsParams("quarter_setup2").value();
  for (const Candidate& c : ListCandidates(quarter, rigs::RigKind::kQuarter)) {
    ASSERT_EQ(c.none.size(), c.free.size()) << c.effect;
    const bool gain = c.effect == "sensor_gain", precharge = c.effect == "accumulator_precharge";
    for (int k = 0; k < c.mains; ++k) {
      const double none = c.none[static_cast<size_t>(k)];
      if (precharge) {
        EXPECT_NEAR(none, 15e6, 3e6);
      } else {
        EXPECT_EQ(none, gain ? 1 : 0) << c.effect << " " << VariantName(c);
      }
    }
    for (const auto& start : c.starts) {
      for (size_t i = 0; i < start.size(); ++i) {
        EXPECT_TRUE(start[i] >= c.free[i].low && start[i] <= c.free[i].high)
            << c.effect << " " << c.free[i].name << " " << start[i];
      }
    }
  }
}

TEST(RowsTest, WhatIsNotThereIsNotOtherwise) {
  auto quarter = phs_model::FindPhsParams("quarter_setup2").value();
  for (auto& line : quarter.lines) line.accumulator.volume_m3 = 0;
  for (const Candidate& c : ListCandidates(quarter, rigs::RigKind::kQuarter)) {
    EXPECT_NE(c.effect, "accumulator_precharge") << "no line has an accumulator";
  }
}

}  // namespace
}  // namespace phs::identify::search
