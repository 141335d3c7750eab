// Numbers of a model that needs no effect: where the likelihood has its least, also where theory
// leaves something open.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "identify/select/effect_search.h"
#include "phs_model/phs_model.h"
#include "tests/identify/search_record.h"

namespace phs::identify::search {
namespace {

using hydraulics::PhsParams;

constexpr int kSettledRows = 600;
constexpr double kSettledAmplitude = 100;

/// Slow, where theory is open, and fast, where it is not.
double SealWaves(int i) {
  return kSettledAmplitude * (std::sin(0.03 * i) + 0.3 * std::sin(0.9 * i));
}
double OpenTheory(int i) { return 20 * std::sin(0.05 * i + 1); }
/// An error of another shape and no larger.
double OfItsSize(int i) { return 15 * std::sin(0.046 * i + 3); }

/// y = friction.scale times a sum of two waves + `open` times what theory leaves open, noise 1.
class SettledModel final : public ForwardModel {
 public:
  SettledModel(double scale, double open) : open_(open) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    std::vector<double> y;
    for (int i = 0; i < kSettledRows; ++i) {
      y.push_back(scale * SealWaves(i) + open * (OpenTheory(i) + OfItsSize(i)) + normal(random));
    }
    measured_.push_back({"load_cell_N", y, 1.0});
  }
  const std::vector<MeasuredBlock>& Measured() const override { return measured_; }
  Status Run(const PhsParams& params, Span, Channels* out) const override {
    out->assign(1, {});
    for (int i = 0; i < kSettledRows; ++i) {
      out->front().push_back(params.friction.scale * SealWaves(i));
    }
    return {};
  }
  Status Uncertainty(const PhsParams&, Span, Channels* deviation) const override {
    deviation->assign(1, std::vector<double>(kSettledRows, 0.0));
    return {};
  }
  Status TheoryDifferences(const PhsParams&, Span, std::vector<Channels>* out) const override {
    out->clear();
    if (open_ == 0) return {};
    std::vector<double>& row = out->emplace_back(1).front();
    for (int i = 0; i < kSettledRows; ++i) row.push_back(OpenTheory(i));
    return {};
  }
  FreeModel Declared(const PhsParams& declared) const override {
    return {declared, {{"friction.scale", 1, 0.1, 10, true, 1}}};
  }
  std::vector<Candidate> Candidates(const PhsParams&) const override { return {}; }
  std::shared_ptr<const ForwardModel> Coarse(double) const override {
    return std::make_shared<const SettledModel>(*this);
  }

 private:
  double open_;
  std::vector<MeasuredBlock> measured_;
};

Identification SettledIn(double scale, double open) {
  return FoundBy(std::make_shared<const SettledModel>(scale, open));
}

// The fit ended where half a unit of -2 ln L was left to be had: 0.7 deviations off, or where it
// began.
TEST(SettledFit, FollowsTheTruthByAThirdOfItsInterval) {
  const Identification at = SettledIn(1, 0);
  const double half = at.after.half_95[0];
  for (const double part : {-0.3, 0.15, 0.3}) {
    const Identification moved = SettledIn(std::exp(part * half), 0);
    EXPECT_NEAR(std::log(moved.after.values[0] / at.after.values[0]), part * half, 0.1 * half);
  }
}

// What theory leaves open is nothing that the numbers must take: they were those of the fit that
// follows what is large, at every clean record of a bogie.
TEST(SettledFit, IsThatOfTheLikelihoodWhereTheoryIsOpen) {
  const Identification found = SettledIn(1.1, 1);
  EXPECT_GT(found.before.channel_ms[0], 10);
  EXPECT_NE(found.before.values, found.base.values);
  EXPECT_EQ(found.after.values, found.base.values);
}

}  // namespace
}  // namespace phs::identify::search
