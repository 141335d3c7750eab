// Controls and forces of the caller's own in a run: they act as physics says, and where they are
// zero nothing changes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "vehicle/scenario_file.h"
#include "vehicle/simulation.h"

namespace phs::vehicle {
namespace {

Scenario Straight(double duration_s) {
  Scenario s;
  s.track = "straight";
  s.speed_m_s = 20;
  s.duration_s = duration_s;
  return s;
}

RunOutcome RunOf(const Scenario& scenario, const OwnInputs& own) {
  auto sim = Simulation::Create(scenario);
  EXPECT_TRUE(sim.ok()) << sim.error().Line();
  auto run = sim.value().Run({}, own);
  EXPECT_TRUE(run.ok());
  return std::move(run).value();
}

const std::vector<double>& ColumnOf(const RunOutcome& run, const std::string& name) {
  return run.columns.at(static_cast<size_t>(run.Find(name)));
}

int Body(const OwnView& view, const char* name) { return mj_name2id(view.m, mjOBJ_BODY, name); }

TEST(OwnInputs, ZeroChangesNoBit) {
  Scenario s = Straight(0.3);
  s.track = "curve_r250";
  s.speed_m_s = 12;
  s.start_s_m = 70;
  const RunOutcome plain = RunOf(s, {});
  long asked = 0;
  const RunOutcome zero = RunOf(s, [&](const OwnView& view, OwnValues* values) {
    ++asked;
    values->wrenches.push_back({.body = Body(view, "frame")});
    return true;
  });
  EXPECT_EQ(asked, zero.steps);
  EXPECT_EQ(plain.columns, zero.columns);
}

TEST(OwnInputs, AForceOnTheFrameIsCarriedByTheRails) {
  for (const double force : {-30e3, 15e3}) {
    const RunOutcome run = RunOf(Straight(4), [&](const OwnView& view, OwnValues* values) {
      const double share = std::min(1.0, view.d->time);
      values->wrenches.push_back({.body = Body(view, "frame"), .force = {0, 0, share * force}});
      return true;
    });
    double change = 0;
    for (const char* wheel : {"lead_left", "lead_right", "trail_left", "trail_right"}) {
      const std::vector<double>& load = ColumnOf(run, wheel + std::string("_Q_N"));
      change += load.back() - load.front();
    }
    EXPECT_NEAR(change, -force, 0.01 * std::abs(force)) << force;
    EXPECT_LT(std::abs(run.energy.RelativeError()), 1e-3);
  }
}

TEST(OwnInputs, TheirWorkIsInTheBookOfEnergy) {
  const double force = 8e3;
  const RunOutcome run = RunOf(Straight(2), [&](const OwnView& view, OwnValues* values) {
    values->wrenches.push_back({.body = Body(view, "frame"), .force = {force, 0, 0}});
    for (int i = 0; i < view.m->nu; ++i) {
      if (view.m->actuator_dyntype[i] == mjDYN_NONE) values->controls.emplace_back(i, 0.0);
    }
    return true;
  });
  const std::vector<double>& way = ColumnOf(run, "s_m");
  const double work = force * (way.back() - way.front());
  EXPECT_NEAR(run.energy.work_in, work, 1e-3 * work);
  EXPECT_LT(std::abs(run.energy.RelativeError()), 1e-3);
  EXPECT_GT(ColumnOf(run, "speed_m_s").back(), 20.1);  // pulled, nobody holds the speed
}

TEST(OwnInputs, WhatTheyDoNotNameStaysWithTheSpeedHold) {
  const RunOutcome run = RunOf(Straight(3), [&](const OwnView& view, OwnValues* values) {
    values->wrenches.push_back({.body = Body(view, "frame"), .force = {-8e3, 0, 0}});
    return true;
  });
  EXPECT_NEAR(ColumnOf(run, "speed_m_s").back(), 20, 0.1);
}

TEST(OwnInputs, ChannelsAreThoseOfTheInstantBefore) {
  Scenario s = Straight(0.02);
  s.record_interval_s = 0.001;
  std::vector<double> seen;
  int at = -1;
  const RunOutcome run = RunOf(s, [&](const OwnView& view, OwnValues*) {
    if (at < 0) {
      const auto sim = Simulation::Create(Straight(1));
      const plugin::Observer observer(sim.value().model(), sim.value().binding());
      while (observer.channels()[static_cast<size_t>(++at)].name != "s_m") continue;
    }
    seen.push_back(view.channels[at]);
    return true;
  });
  const std::vector<double>& recorded = ColumnOf(run, "s_m");
  ASSERT_EQ(seen.size(), recorded.size());
  EXPECT_EQ(std::vector<double>(seen.begin() + 1, seen.end()),
            std::vector<double>(recorded.begin(), recorded.end() - 1));
}

TEST(OwnInputs, RungeKuttaAsksInEachOfItsFourEvaluations) {
  auto sim = Simulation::Create(Straight(0.02));
  ASSERT_TRUE(sim.ok()) << sim.error().Line();
  sim.value().mutable_model()->opt.integrator = mjINT_RK4;
  long asked = 0;
  const auto run = sim.value().Run({}, [&](const OwnView&, OwnValues*) { return ++asked > 0; });
  ASSERT_TRUE(run.ok());
  EXPECT_EQ(run.value().status, "ok");
  EXPECT_EQ(asked, 4 * run.value().steps);
}

TEST(OwnInputs, FalseEndsTheRun) {
  long asked = 0;
  const RunOutcome run =
      RunOf(Straight(1), [&](const OwnView&, OwnValues*) { return ++asked < 20; });
  EXPECT_EQ(run.status, "stopped");
  EXPECT_EQ(asked, 20);
  EXPECT_EQ(run.steps, 19);
}

TEST(ScenarioWith, KeysAreReplacedAndSpeedHasOneUnit) {
  const auto changed = ScenarioWith("curve_r550", "{speed_m_s: 15, friction: {condition: wet}}");
  ASSERT_TRUE(changed.ok()) << changed.error().Line();
  EXPECT_EQ(changed.value().speed_m_s, 15);
  EXPECT_EQ(changed.value().friction.condition, "wet");
  EXPECT_EQ(changed.value().wheel, "S1002");
  EXPECT_EQ(changed.value().name, "curve_r550");
  const auto whole = ScenarioWith("", "{\"track\": \"straight\", \"speed_km_h\": 36}");
  ASSERT_TRUE(whole.ok()) << whole.error().Line();
  EXPECT_EQ(whole.value().speed_m_s, 10);
}

TEST(ScenarioWith, ErrorsNameTheKeyAndNoLine) {
  using testing::HasSubstr;
  using testing::StartsWith;
  const auto line = [](const char* name, const char* changes) {
    const auto scenario = ScenarioWith(name, changes);
    return scenario.ok() ? std::string() : scenario.error().Line();
  };
  EXPECT_THAT(line("curve_r550", "{frction: 0.2}"), StartsWith("scenario: frction: unknown key"));
  EXPECT_THAT(line("curve_r550", "{friction: 7}"), StartsWith("scenario: friction: 7"));
  EXPECT_THAT(line("curve_r550", "{friction: {tread: 7}}"), HasSubstr("friction.tread"));
  EXPECT_THAT(line("curve_r551", "{}"), HasSubstr("did you mean 'curve_r550'"));
  EXPECT_THAT(line("", "{speed_m_s: 20}"), HasSubstr("track: is missing"));
  EXPECT_THAT(line("", "[1, 2"), StartsWith("scenario"));
}

}  // namespace
}  // namespace phs::vehicle
