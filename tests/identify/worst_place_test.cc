// On the full rig: in which of four cylinders something is tried alone, and whether it is found there.
#include "identify/select/worst_place.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string>

#include "identify/fit/near_fit.h"
#include "identify/select/screening.h"
#include "tests/identify/search_record.h"

namespace phs::identify::search {
namespace {

using hydraulics::PhsParams;
using measurement::FitData;

PhsParams FourCylinders() { return phs_model::FindPhsParams("bo_bo").value(); }

/// 20 s at 100 Hz of two actuators against each other, with the noise of sensors.
FitData FullRecord(const PhsParams& truth) {
  FitData data;
  data.kind = rigs::RigKind::kFull;
  data.options.beam.damping_Nms_per_rad = 2000;
  data.step_s = 0.01, data.estimation = {0, 20}, data.validation = {0, 20};
  rigs::RigMotion motion{0, data.step_s, {{}, {}}, {}, {}, {}, {}};
  for (int i = 0; i < 2000; ++i) {
    const double t = i * data.step_s;
    data.time_s.push_back(t);
    motion.position_m[0].push_back(3e-3 * std::sin(1.3 * t) + 1e-3 * std::sin(4.1 * t));
    motion.position_m[1].push_back(-2e-3 * std::sin(0.9 * t) + 1e-3 * std::sin(3.3 * t));
  }
  const auto rig = rigs::RigModel::Create(rigs::RigKind::kFull, truth, data.options);
  rigs::RigPrediction clean;
  EXPECT_TRUE(rig.value().Run(motion, &clean).ok());
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  for (size_t a = 0; a < 2; ++a) {
    const std::string name = "actuator" + std::to_string(a + 1) + "_m";
    data.inputs.push_back({name, motion.position_m[a], 5e-7});
    for (double& x : data.inputs[a].values) x += 5e-7 * normal(random);
    data.motion.push_back(
        measurement::SmoothPosition(data.inputs[a].values, {}, data.step_s, 5e-7));
  }
  for (size_t c = 0; c < clean.channels.size(); ++c) {
    const double noise = c < 4 ? 1.5e-6 : c < 8 ? 40 : 1e4;
    data.outputs.push_back({rig.value().output_names()[c], clean.channels[c], noise});
    for (double& y : data.outputs.back().values) y += noise * normal(random);
  }
  return data;
}

/// The declared model fitted to a record.
struct Fitted {
  explicit Fitted(const FitData& data) : problem(ProblemOf(data, FourCylinders()).value()) {
    model = problem.forward().Declared(FourCylinders());
    std::vector<double> start;
    for (const FreeParameter& p : model.free) start.push_back(p.start);
    fit = FitNear(problem, model, start, {}, {.max_steps = 10, .final_slopes = true});
    EXPECT_TRUE(fit.ok);
  }
  FitProblem problem;
  FreeModel model;
  FitResult fit;
};

/// Where an effect is tried, "all" for all cylinders alike.
std::set<std::string> PlacesOf(const std::string& effect, const Fitted& fitted) {
  auto list = fitted.problem.forward().Candidates(FourCylinders());
  KeepWorstPlace(fitted.problem, fitted.model, fitted.fit, &list);
  std::set<std::string> places;
  for (const Candidate& c : list) {
    if (c.effect != effect) continue;
    places.insert(c.params.targets.empty() ? "all" : c.params.targets[0]);
  }
  return places;
}

PhsParams WithSeal(const std::string& cylinder) {
  PhsParams truth = FourCylinders();
  truth.effects.push_back({"seal_friction", {cylinder}, {{"factor", 1.4}}});
  return truth;
}

// The scale of friction, common to all, is fitted to what one cylinder shows: all load cells are left
// with as much. Which one is loudest is chance.
TEST(WorstPlace, FrictionIsTriedWhereASealHoldsOtherwise) {
  for (const std::string cylinder : {"3", "1"}) {
    const FitData data = FullRecord(WithSeal(cylinder));
    EXPECT_EQ(PlacesOf("viscous_friction", Fitted(data)), (std::set<std::string>{"all", cylinder}));
  }
}

TEST(WorstPlace, AnInstrumentIsTriedAtItsCylinder) {
  PhsParams truth = FourCylinders();
  truth.effects.push_back({"sensor_gain", {"4"}, {{"load", 1.05}}});
  const FitData data = FullRecord(truth);
  EXPECT_TRUE(PlacesOf("sensor_delay", Fitted(data)).contains("4"));
  EXPECT_FALSE(PlacesOf("sensor_delay", Fitted(data)).contains("1"));
}

TEST(WorstPlace, NoCylinderIsTriedAloneWhereAllLoadCellsAreAtTheirNoise) {
  const FitData data = FullRecord(FourCylinders());
  EXPECT_EQ(PlacesOf("viscous_friction", Fitted(data)), std::set<std::string>{"all"});
}

// Linearised from a factor of 0.6 or 1.6 alone, the sliding of the beam promised less than nothing, and
// a spot of friction in another cylinder took the name.
TEST(WorstPlace, TheSealThatHoldsOtherwiseComesFirstOfAllFriction) {
  const FitData data = FullRecord(WithSeal("3"));
  Fitted on(data);
  auto list = on.problem.forward().Candidates(FourCylinders());
  KeepWorstPlace(on.problem, on.model, on.fit, &list);
  std::erase_if(list,
                [](const Candidate& c) { return c.effect.find("friction") == std::string::npos; });
  Effort effort;
  effort.stepped = 12, effort.coarse_fits = 4;
  const auto trials =
      ScreenCandidates(on.problem, on.model, {on.fit}, list, effort, [](double) { return true; });
  ASSERT_FALSE(trials.empty());
  EXPECT_EQ(trials.front().candidate->effect, "seal_friction");
  EXPECT_EQ(trials.front().candidate->params.targets, std::vector<std::string>{"3"});
}

}  // namespace
}  // namespace phs::identify::search
