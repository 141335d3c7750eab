// Screening: an effect is tried for the shape of what it does, however far off its starts are.
#include "identify/select/screening.h"

#include <gtest/gtest.h>

#include <cmath>

#include "identify/fit/near_fit.h"
#include "identify/select/points.h"
#include "phs_model/phs_model.h"

namespace phs::identify::search {
namespace {

using hydraulics::PhsParams;

constexpr int kScreenRows = 400;
constexpr int kDecoys = 12;
const char* const kNumber = "conductance_m3_per_Pas";

/// y = friction.scale sin(w t) + f(amount) sin(w_k t): each candidate has its own wave k, by its target.
class Waves final : public ForwardModel {
 public:
  Waves(double power, int true_wave, double true_amount) : power_(power) {
    PhsParams truth = phs_model::FindPhsParams("quarter_setup2").value();
    truth.friction.scale = 1.3;
    truth.effects = {Effect(true_wave, true_amount)};
    Channels made;
    EXPECT_TRUE(Run(truth, Span::kEstimation, &made).ok());
    for (int i = 0; i < kScreenRows; ++i) {  // every decoy does a little
      for (int k = 0; k < kDecoys; ++k) made[0][Row(i)] += 0.1 * Wave(k, i);
    }
    measured_.push_back({"load_cell_N", made[0], 1.0});
  }
  const std::vector<MeasuredBlock>& Measured() const override { return measured_; }
  Status Run(const PhsParams& params, Span, Channels* out) const override {
    out->assign(1, std::vector<double>(kScreenRows, 0.0));
    for (int i = 0; i < kScreenRows; ++i) {
      double& y = (*out)[0][Row(i)];
      y = 100 * params.friction.scale * std::sin(0.03 * i);
      for (const auto& e : params.effects) {
        y +=
            1e3 * std::pow(e.values.at(kNumber) / 1e-13, power_) * Wave(std::stoi(e.targets[0]), i);
      }
    }
    return {};
  }
  Status Uncertainty(const PhsParams&, Span, Channels* deviation) const override {
    deviation->assign(1, std::vector<double>(kScreenRows, 0.0));
    return {};
  }
  FreeModel Declared(const PhsParams& declared) const override {
    return {declared, {{"friction.scale", 1, 0.1, 10, true, 1}}};
  }
  std::vector<Candidate> Candidates(const PhsParams&) const override { return {}; }
  std::shared_ptr<const ForwardModel> Coarse(double) const override { return nullptr; }

  static hydraulics::EffectParams Effect(int wave, double amount) {
    return {"external_leakage", {std::to_string(wave)}, {{kNumber, amount}}};
  }

 private:
  static size_t Row(int i) { return static_cast<size_t>(i); }
  static double Wave(int k, int i) { return std::sin((0.2 + 0.11 * k) * i); }
  double power_;
  std::vector<MeasuredBlock> measured_;
};

Candidate OfWave(int wave, double start) {
  Candidate c;
  c.effect = "wave " + std::to_string(wave);
  c.params = Waves::Effect(wave, start);
  c.free = {{std::string("effects.external_leakage.") + kNumber, start, 1e-19, 1e-7, true, 1}};
  c.starts = {{start}};
  c.none = {0};
  return c;
}

/// A candidate that was tried, and the amount that its coarse fit found.
struct Screened {
  std::string effect;
  double fitted = 0;
};

/// What is tried of `list`, best first, of a record with a wave of 12 that does `amount`^`power`.
std::vector<Screened> TriedOf(double power, double amount, const std::vector<Candidate>& list,
                              const Effort& effort) {
  const auto forward = std::make_shared<const Waves>(power, kDecoys, amount);
  const PhsParams declared = phs_model::FindPhsParams("quarter_setup2").value();
  const auto problem = FitProblem::Create(forward, declared);
  const FreeModel model = forward->Declared(declared);
  const FitResult fit =
      FitNear(problem.value(), model, {1.0}, {}, {.max_steps = 10, .final_slopes = true});
  const auto points = PointsAbout(problem.value(), model, fit, 1, false);
  std::vector<Screened> out;
  for (const Trial& trial : ScreenCandidates(problem.value(), model, points, list, effort,
                                             [](double) { return true; })) {
    out.push_back({trial.candidate->effect, trial.coarse.values.back()});
  }
  return out;
}

/// What is fitted first of twelve decoys whose starts are right and one whose start is not.
std::string FirstOf(double power, double amount, double start, double* fitted) {
  std::vector<Candidate> list;
  const double as_decoys_are = 1e-13 * std::pow(1e-4, 1 / power);  // 0.1 N
  for (int k = 0; k < kDecoys; ++k) list.push_back(OfWave(k, as_decoys_are));
  list.push_back(OfWave(kDecoys, start));
  Effort effort;
  effort.stepped = 3, effort.coarse_fits = 1;
  const Screened first = TriedOf(power, amount, list, effort).front();
  *fitted = first.fitted;
  return first.effect;
}

/// The declared model fitted to a record with a wave of 12.
struct FittedWaves {
  std::shared_ptr<const Waves> forward = std::make_shared<const Waves>(1.0, kDecoys, 1e-13);
  PhsParams declared = phs_model::FindPhsParams("quarter_setup2").value();
  FitProblem problem = FitProblem::Create(forward, declared).value();
  FreeModel model = forward->Declared(declared);
  FitResult fit = FitNear(problem, model, {1.0}, {}, {.max_steps = 10, .final_slopes = true});
};

// Stopped in any of its runs it ends with what it has.
TEST(Points, MayBeStoppedAtAnyTime) {
  FittedWaves on;
  const auto points_after = [&](int runs) {
    on.problem.SetGoOn([left = std::make_shared<int>(runs)] { return --*left >= 0; });
    return PointsAbout(on.problem, on.model, on.fit, 1, true).size();
  };
  const size_t all = points_after(1000);
  EXPECT_GE(all, 2u) << "the declared number held, too";
  for (int runs = 0; runs < 100; ++runs) EXPECT_LE(points_after(runs), all) << runs;
}

// What starts do is asked of the model once: a second round takes it from the first, and says the same.
TEST(Screening, AnswersOfStartsAreKeptFromRoundToRound) {
  FittedWaves on;
  const auto points = PointsAbout(on.problem, on.model, on.fit, 1, false);
  std::vector<Candidate> list;
  for (int k = 0; k <= kDecoys; ++k) list.push_back(OfWave(k, 2e-14));
  list.push_back(OfWave(kDecoys, 5e-13));  // of the same name, from elsewhere
  KnownAnswers known;
  std::vector<double> promises[2];
  int runs[2] = {};  // as often as the search asks whether to go on
  for (const int round : {0, 1}) {
    on.problem.SetGoOn([&] { return ++runs[round] > 0; });
    for (const Trial& trial : ScreenCandidates(
             on.problem, on.model, points, list, {}, [](double) { return true; }, &known)) {
      promises[round].push_back(trial.promise);
    }
  }
  // Of each start a run and one for its slope; it is asked once more after the slopes.
  EXPECT_EQ(runs[0] - runs[1], 3 * (kDecoys + 2));
  ASSERT_EQ(promises[0].size(), promises[1].size());
  for (size_t i = 0; i < promises[0].size(); ++i) {
    EXPECT_NEAR(promises[1][i], promises[0][i], 1e-3 * std::abs(promises[0][i])) << i;
  }
}

TEST(Screening, AnEffectWhoseStartIsAThousandTimesTooLargeIsTried) {
  double fitted = 0;
  EXPECT_EQ(FirstOf(1, 1e-15, 1e-12, &fitted), "wave 12");
  EXPECT_NEAR(fitted, 1e-15, 5e-17);
}

TEST(Screening, OneWhoseStartIsTooSmallToShowIsTried) {
  double fitted = 0;
  EXPECT_EQ(FirstOf(1, 1e-15, 1e-17, &fitted), "wave 12");
  EXPECT_NEAR(fitted, 1e-15, 5e-17);
}

TEST(Screening, AStiffnessIsMovedTheOtherWay) {  // what it does falls with its amount
  double fitted = 0;
  EXPECT_EQ(FirstOf(-1, 1e-11, 1e-14, &fitted), "wave 12");
  EXPECT_NEAR(fitted, 1e-11, 5e-13);
}

// Waves that are not in the record: none is worth the ln N that its number costs.
TEST(Screening, WhatCannotPayForItsNumberIsNotTried) {
  std::vector<Candidate> list = {OfWave(kDecoys, 1e-16)};
  for (int k = 1; k <= 5; ++k) list.push_back(OfWave(kDecoys + k, 1e-16));
  const std::vector<Screened> tried = TriedOf(1, 2e-16, list, {});
  ASSERT_EQ(tried.size(), 1u);
  EXPECT_EQ(tried[0].effect, "wave 12");
  EXPECT_NEAR(tried[0].fitted, 2e-16, 1e-17);
  Effort whatever;
  whatever.unpromising = true;
  EXPECT_EQ(TriedOf(1, 2e-16, list, whatever).size(), list.size());
}

}  // namespace
}  // namespace phs::identify::search
