// What speaks for a model, on residuals written by hand, and the rule of acceptance.
#include "identify/fit/evidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

#include "identify/fit/accept.h"
#include "identify/fit/effect_variants.h"
#include "identify/result/result_json.h"
#include "identify/select/identification.h"

namespace phs::identify::search {
namespace {

constexpr int kEvidenceRows = 1024;

/// A model of which only the number of rows counts.
class NoModel : public ForwardModel {
 public:
  explicit NoModel(const std::vector<std::string>& channels = {"load_cell_N"}) {
    for (const std::string& channel : channels) {
      measured_.push_back({channel, std::vector<double>(kEvidenceRows, 0.0), 1.0});
    }
  }
  const std::vector<MeasuredBlock>& Measured() const override { return measured_; }
  Status Run(const hydraulics::PhsParams&, Span, Channels*) const override { return {}; }
  Status Uncertainty(const hydraulics::PhsParams&, Span, Channels* deviation) const override {
    deviation->assign(measured_.size(), std::vector<double>(kEvidenceRows, 0.0));
    return {};
  }
  FreeModel Declared(const hydraulics::PhsParams&) const override { return {}; }
  std::vector<Candidate> Candidates(const hydraulics::PhsParams&) const override { return {}; }
  std::shared_ptr<const ForwardModel> Coarse(double) const override { return nullptr; }

 private:
  std::vector<MeasuredBlock> measured_;
};

Eigen::VectorXd Noise(unsigned seed, double deviation) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, deviation);
  Eigen::VectorXd out(kEvidenceRows);
  for (double& x : out) x = normal(random);
  return out;
}

FitResult Fitted(const FitProblem& problem, const Eigen::VectorXd& residual, int numbers) {
  FitResult fit;
  fit.values.assign(static_cast<size_t>(numbers), 1.0);
  fit.residual = residual;
  fit.powers = problem.likelihood().Powers(problem.likelihood().Transform(residual));
  fit.score = problem.likelihood().MinusTwoLog(fit.powers);
  fit.slopes = Eigen::MatrixXd::Zero(problem.likelihood().size(), numbers);
  fit.channel_ms = {residual.squaredNorm() / kEvidenceRows};
  return fit;
}

FitProblem NoProblem() { return FitProblem::Create(std::make_shared<NoModel>(), {}).value(); }

// White residuals of deviation 3 and 1.5: each octave of m falls by m ln(9/2.25).
TEST(Evidence, HalfAResidualIsWorthTheLogOfFourInEveryOctave) {
  const FitProblem problem = NoProblem();
  const Eigen::VectorXd r = Noise(1, 1);
  const FitResult without = Fitted(problem, 3 * r, 2), with = Fitted(problem, 1.5 * r, 3);
  const double count = problem.likelihood().Count();
  const Evidence e = Compare(problem, without, with, 10);
  EXPECT_NEAR(e.delta_bic, count * std::log(4) - std::log(count) - 2 * std::log(10), 0.12 * count)
      << "an octave that is down at the noise has no more to give";
  EXPECT_NEAR(e.estimation_gain, 0.5, 1e-9);
  EXPECT_EQ(e.best_channel, "load_cell_N");
  // Mean square beyond the noise: 9 - 1.1 before, 2.25 - 1.1 after.
  EXPECT_NEAR(e.share, 1 - 1.15 / 7.9, 0.02);
}

/// Fits that leave so many times the noise in a load cell and in a pressure.
struct TwoChannels {
  const FitProblem problem =
      FitProblem::Create(
          std::make_shared<NoModel>(std::vector<std::string>{"load_cell_N", "p_bore_Pa"}), {})
          .value();
  FitResult operator()(double force, double pressure) const {
    Eigen::VectorXd residual(2 * kEvidenceRows);
    residual << force * Noise(1, 1), pressure * Noise(2, 1);
    FitResult fit = Fitted(problem, residual, 1);
    fit.channel_ms = {force * force, pressure * pressure};
    return fit;
  }
};

// One channel comes down to its noise, another is spoilt by as much: nothing is explained.
TEST(Evidence, WhatIsSpoiltCountsAgainstWhatIsMended) {
  const TwoChannels fitted;
  const FitResult before = fitted(4, 2);
  const Evidence mended = Compare(fitted.problem, before, fitted(1, 2), 1);
  EXPECT_NEAR(mended.share, 1, 0.03) << "of the channel that it mends, whatever else is wrong";
  EXPECT_EQ(mended.best_channel, "load_cell_N");
  EXPECT_NEAR(Compare(fitted.problem, before, fitted(1, 3), 1).share, 1 - (9 - 4) / 14.9, 0.05);
  EXPECT_LT(Compare(fitted.problem, before, fitted(1, 4.3), 1).share, 0.05);
}

// Another cause rules a channel, and leaves 28 times its noise there: with the cause that mends the load cell
// it is left with 29 times. A gain of a load cell beside a seal in another cylinder is so.
TEST(Evidence, ALittleMoreOfWhatIsLargeIsLittle) {
  const TwoChannels fitted;
  const Evidence seal = Compare(fitted.problem, fitted(7, 28), fitted(1, 29), 1);
  EXPECT_EQ(seal.best_channel, "load_cell_N");
  EXPECT_NEAR(seal.share, 1 - (29. * 29 - 28 * 28) / (28 * 28), 0.05);
}

TEST(Evidence, BelowTheNoiseNothingIsGained) {
  const FitProblem problem = NoProblem();
  const Eigen::VectorXd r = Noise(2, 0.8);
  const Evidence e = Compare(problem, Fitted(problem, r, 2), Fitted(problem, 0.9 * r, 3), 1);
  EXPECT_LT(e.delta_bic, 60);
  EXPECT_LT(e.delta_bic, 0.25 * problem.likelihood().Count());
}

// A number that each part of the record would set anew: what it gains in the fit it loses on the
// parts left out.
TEST(Evidence, ANumberThatEveryPartSetsAnewLosesInCrossValidation) {
  const FitProblem problem = NoProblem();
  Eigen::VectorXd bump = Eigen::VectorXd::Zero(kEvidenceRows), other = bump;
  for (int i = 0; i < kEvidenceRows / 6; ++i) {
    bump[i] = 0.05 * std::sin(0.3 * i), other[i + kEvidenceRows / 6] = 0.05 * std::sin(0.3 * i);
  }
  // Two parts ask for +1 and -1 times the same column: the fit takes half of one and none of it.
  const FitResult without = Fitted(problem, 100 * (bump - other), 1);
  FitResult with = Fitted(problem, 100 * (bump - other), 1);
  with.slopes.col(0) = problem.likelihood().Transform(Eigen::VectorXd(1000 * (bump + other)));
  EXPECT_LT(Compare(problem, without, with, 1).cross_validation_gain, 0);
  // Where both ask for the same, nothing is lost by leaving either out.
  FitResult same = Fitted(problem, Eigen::VectorXd::Zero(kEvidenceRows), 1);
  same.slopes = with.slopes;
  EXPECT_GT(Compare(problem, without, same, 1).cross_validation_gain, 0);
}

TEST(Accept, ChanceIsPaidForByTheNumberTried) {
  const double alone = -2 * std::log(Acceptance().false_alarms);
  EXPECT_TRUE(IsBeyondChance({}, alone + 0.1, 1));
  EXPECT_FALSE(IsBeyondChance({}, alone - 0.1, 1));
  EXPECT_FALSE(IsBeyondChance({}, alone + 0.1, 20));
}

/// Mean share that the strongest of k lines has of the power of noise without a period: 20 000 draws.
double StrongestOf(int lines) {
  std::mt19937 random(5);
  std::exponential_distribution<double> power;
  double mean = 0;
  constexpr int kDraws = 20000;
  for (int draw = 0; draw < kDraws; ++draw) {
    double sum = 0, most = 0;
    for (int k = 0; k < lines; ++k) {
      const double p = power(random);
      sum += p, most = std::max(most, p);
    }
    mean += most / sum / kDraws;
  }
  return mean;
}

TEST(Accept, AWaveShowsSoManyPeriodsThatNoiseWithoutOneWouldTakeTooLittle) {
  EXPECT_EQ(LeastPeriods({}), 9);
  for (const double least_share : {0.33, 0.2}) {
    Acceptance accept;
    accept.least_share = least_share;
    const int k = LeastPeriods(accept);
    EXPECT_LT(StrongestOf(k), least_share);
    EXPECT_GT(StrongestOf(k - 1), least_share - 0.003);
  }
  Acceptance none;
  none.least_share = 0;
  EXPECT_GT(LeastPeriods(none), 100) << "an end, though no share is below none";
}

// Each part alone refuses, and no longer does where it is left out; the others go on.
TEST(Accept, APartOfTheRuleThatIsLeftOutRefusesNothing) {
  Candidate offset;
  offset.effect = offset.params.name = "sensor_offset";
  offset.mains = 1;
  offset.free = {{"load_N", 0, -100, 100, false, 1}};
  offset.none = {0};
  FitResult fit;
  fit.values = {30}, fit.half_95 = {2};
  Evidence good;
  good.delta_bic = 100, good.share = 0.9, good.cross_validation_gain = 0.1;
  const SearchRule whole;
  EXPECT_EQ(Refusal(whole, good, offset, fit), "");
  Evidence elsewhere = good, small = good;
  elsewhere.cross_validation_gain = -0.1, small.share = 0.1;
  FitResult vague = fit;
  vague.half_95 = {40};
  SearchRule without = whole;
  without.cross_validation = false;
  EXPECT_NE(Refusal(whole, elsewhere, offset, fit), "");
  EXPECT_EQ(Refusal(without, elsewhere, offset, fit), "");
  EXPECT_NE(Refusal(without, good, offset, vague), "");
  without = whole, without.beyond_zero = false;
  EXPECT_NE(Refusal(whole, good, offset, vague), "");
  EXPECT_EQ(Refusal(without, good, offset, vague), "");
  without = whole, without.accept.least_share = 0;
  EXPECT_NE(Refusal(whole, small, offset, fit), "");
  EXPECT_EQ(Refusal(without, small, offset, fit), "");
  without = whole, without.structures = false;
  const double alone = -2 * std::log(whole.accept.false_alarms) + 0.1;
  EXPECT_FALSE(IsBeyondChance(whole, alone, 20));
  EXPECT_TRUE(IsBeyondChance(without, alone, 20));
}

// A resistance alike in both directions is a special case of one for either direction.
TEST(Accept, ASpecialCaseGivesWayOnlyToWhatIsAheadBeyondChance) {
  const auto named = [](const char* effect) {
    Candidate form;
    form.effect = form.params.name = effect;
    return form;
  };
  const Candidate special = named("line_resistance"), whole = named("check_restriction");
  ASSERT_TRUE(Contains(whole, special));
  const auto scored = [](double score) {
    FitResult fit;
    fit.values = {1, 1}, fit.score = score;
    return fit;
  };
  const double chance = -2 * std::log(Acceptance().false_alarms);
  const FitResult behind = scored(0), little = scored(0.1 - chance), far = scored(-0.1 - chance);
  const FitProblem own = FitProblem::Create(std::make_shared<NoModel>(), {}).value();
  EXPECT_TRUE(Beats(own, special, behind, whole, little));
  EXPECT_FALSE(Beats(own, whole, little, special, behind));
  EXPECT_TRUE(Beats(own, whole, far, special, behind));
  SearchRule rule;
  rule.plain_first = false;
  const FitProblem without = FitProblem::Create(std::make_shared<NoModel>(), {}, rule).value();
  EXPECT_FALSE(Beats(without, special, behind, whole, little));
  EXPECT_TRUE(Beats(without, whole, little, special, behind));
}

TEST(Accept, TheRuleSaysInTheResultWhereItIsNotTheProductsOwn) {
  SearchRule rule;
  Json result = Json::object();
  PutRule(rule, &result);
  EXPECT_TRUE(result.empty());
  rule.accept.false_alarms = 0.05, rule.names = false;
  PutRule(rule, &result);
  EXPECT_EQ(result["rule"].dump(), R"({"changed":{"false_alarms":0.05},"without":["names"]})");
  for (const RulePart& part : RuleParts()) EXPECT_TRUE(SearchRule().*part.holds) << part.name;
}

// Two declared numbers, then the effects' own: each looks at its own, and only at the end of its range.
TEST(Accept, InTheEndEachEffectIsJudgedByItsOwnNumbers) {
  Identification found;
  found.declared.free.resize(2);
  AcceptedEffect leak, offset;
  leak.candidate.effect = "piston_leakage";
  leak.candidate.mains = 1;
  leak.candidate.free = {{"conductance", 1e-14, 1e-17, 1e-11, true}, {"start", 0, 0, 60, false, 1}};
  leak.candidate.none = {0, 0};
  offset.candidate.effect = "sensor_offset";
  offset.candidate.mains = 1;
  offset.candidate.free = {{"load_N", 0, -100, 100, false, 1}};
  offset.candidate.none = {0};
  found.effects = {leak, offset};
  found.after.half_95 = {1, 1, 0.3, 50, 2};
  found.after.values = {100, 1e-11, 1e-14, 60, 30};
  EXPECT_TRUE(IsToldInTheEnd(found, 0));
  EXPECT_TRUE(IsToldInTheEnd(found, 1));
  found.after.values = {100, 1e-11, 1e-11, 60, 30};
  EXPECT_FALSE(IsToldInTheEnd(found, 0)) << "moved to the end by the offset";
  EXPECT_TRUE(IsToldInTheEnd(found, 1));
  found.after.values = {100, 1e-11, 1e-14, 60, -100};
  EXPECT_TRUE(IsToldInTheEnd(found, 0));
  EXPECT_FALSE(IsToldInTheEnd(found, 1));
}

TEST(Identification, AFurtherNumberThatALaterFitMovesToTheEndOfItsRangeGoes) {
  const FreeParameter volume{"L1.oil_volume_m3", 1e-3, 4e-4, 2.5e-3, true};
  const FreeParameter gap{"effects.backlash.gap_m", 1e-4, 1e-6, 1e-3, true};
  const FreeParameter contact{"effects.backlash.contact_N_per_m", 1e8, 1e6, 1e11, true};
  const FreeParameter hardening{"effects.backlash.hardening_1_per_m2", 1e6, 1e3, 1e9, true};
  const FreeParameter load{"effects.sensor_offset.load_N", 0, -100, 100, false, 1};
  Identification found;
  found.declared.free = {volume};
  found.corrected.free = {volume, gap, contact, hardening, load};
  AcceptedEffect play, offset;
  play.candidate.effect = "backlash", offset.candidate.effect = "sensor_offset";
  play.candidate.free = {gap, contact, hardening}, offset.candidate.free = {load};
  play.candidate.none = {0, 0};  // hardening is no number of its own form
  offset.candidate.none = {0};
  found.effects = {play, offset};
  found.after.values = {1e-3, 1e-4, 1e11, 1e7, 30};
  found.after.half_95 = {1, 2, 3, 4, 5};
  found.after.slopes = Eigen::MatrixXd::Identity(5, 5);
  EXPECT_FALSE(TakeOutEdges(&found)) << "the contact is of the form itself: the verdict says it";
  found.after.values[3] = 1e9;
  EXPECT_TRUE(TakeOutEdges(&found));
  EXPECT_EQ(found.after.values, (std::vector<double>{1e-3, 1e-4, 1e11, 30}));
  EXPECT_EQ(found.after.half_95, (std::vector<double>{1, 2, 3, 5}));
  EXPECT_EQ(found.after.slopes.cols(), 4);
  EXPECT_EQ(found.after.slopes(4, 3), 1) << "the offset's column has moved up";
  ASSERT_EQ(found.corrected.free.size(), 4u);
  EXPECT_EQ(found.corrected.free[3].name, load.name);
  EXPECT_EQ(found.effects[0].candidate.free.size(), 2u);
  EXPECT_EQ(found.effects[1].candidate.free.size(), 1u);
  EXPECT_FALSE(TakeOutEdges(&found));
}

TEST(Accept, AnAmountMustBeBeyondZeroAndInsideItsRange) {
  Candidate linear;
  linear.free = {{"effects.sensor_offset.load_N", 0, -100, 100, false, 1}};
  linear.none = {0};
  FitResult fit;
  const auto there = [&](const Candidate& c, double value, double half) {
    // Beside others, before and after it.
    fit.values = {100, value, 0}, fit.half_95 = {50, half, 50};
    return IsThere(c, fit, 1);
  };
  EXPECT_TRUE(there(linear, 3, 2));
  EXPECT_TRUE(there(linear, -3, 2));
  EXPECT_FALSE(there(linear, 3, 4)) << "zero is in its interval";
  EXPECT_FALSE(there(linear, 100, 2)) << "at the end of its range";
  Candidate logarithmic;
  logarithmic.free = {{"effects.piston_leakage.conductance_m3_per_Pas", 1e-14, 1e-17, 1e-11, true}};
  logarithmic.none = {0};
  EXPECT_TRUE(there(logarithmic, 1e-14, 0.3));
  EXPECT_FALSE(there(logarithmic, 1e-14, 1.5)) << "its deviation is as large as itself";
  EXPECT_FALSE(there(logarithmic, 1e-17, 0.3)) << "none of it";
  logarithmic.none = {0.9e-14};  // known beforehand: differs from that by less than its interval
  EXPECT_FALSE(there(logarithmic, 1e-14, 0.3));
}

}  // namespace
}  // namespace phs::identify::search
