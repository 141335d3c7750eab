// Evidence on residuals and Jacobians written by hand: the blocks left out are judged by a fit that
// has not seen them.
#include "identify/evidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "identify/effect_search.h"

namespace phs::identify::search {

using measurement::FitData;
namespace {

constexpr int kBlocks = 6, kRows = 50;  // of a block

/// A model of which only the number of samples and channels counts.
class NoModel : public ForwardModel {
 public:
  Status Run(const hydraulics::PhsParams&, Span, Channels*) const override { return {}; }
  Status Uncertainty(const hydraulics::PhsParams&, Span, Channels* deviation) const override {
    deviation->assign(1, std::vector<double>(kBlocks * kRows, 0.0));
    return {};
  }
  FreeModel Declared(const hydraulics::PhsParams&) const override { return {}; }
  std::vector<Candidate> Candidates(const hydraulics::PhsParams&) const override { return {}; }
  std::shared_ptr<const ForwardModel> Thinned(int) const override { return nullptr; }
};

FitData Samples(const std::string& channel) {
  FitData data;
  for (int i = 0; i < kBlocks * kRows; ++i) data.time_s.push_back(0.01 * i);
  data.step_s = 0.01;
  data.estimation = {0, 1e3};
  data.outputs = {{channel, data.time_s, 1.0}};
  return data;
}

/// A fit whose residual and derivative over one coordinate are even in every block.
FitResult Fitted(const double (&residual)[kBlocks], const double (&slope)[kBlocks]) {
  FitResult fit;
  fit.values = {0};
  fit.residual.resize(kBlocks * kRows);
  fit.jacobian.resize(kBlocks * kRows, 1);
  for (int i = 0; i < kBlocks * kRows; ++i) {
    fit.residual[i] = residual[i / kRows];
    fit.jacobian(i, 0) = slope[i / kRows];
  }
  fit.channel_ms = {fit.residual.squaredNorm() / (kBlocks * kRows)};
  return fit;
}

Evidence Judge(const FitResult& without, const FitResult& with,
               const std::string& channel = "load_cell_N") {
  const FitData data = Samples(channel);
  const auto problem = FitProblem::Create(data, std::make_shared<NoModel>(), {});
  EXPECT_TRUE(problem.ok());
  return Compare(problem.value(), without, with);
}

// Two blocks ask for opposite values of the new parameter, the others for none: half the misfit
// goes in the fit, but each of the two, left out, is foretold from the other and missed by twice as
// much. Residuals (-2d, 0) without, (-d, d) with, (-2d, 2d) left out.
TEST(Evidence, AParameterThatFitsEachBlockOnItsOwnLosesInCrossValidation) {
  constexpr double d = 0.05;  // coordinates: within what a linear refit may move
  const FitResult without = Fitted({-2 * d, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0});
  const FitResult with = Fitted({-d, d, 0, 0, 0, 0}, {1, 1, 0, 0, 0, 0});
  const Evidence e = Judge(without, with);
  EXPECT_NEAR(e.estimation_gain, 1 - std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(e.cross_validation_gain, 1 - std::sqrt(2), 5e-3);
}

// The same slope everywhere and a misfit of +-e from block to block: the fit without one block has
// the mean of the other five, r_b - sum/5 of the rest = 6/5 r_b.
TEST(Evidence, AParameterThatEveryBlockAsksForLosesOnlyWhatABlockWeighs) {
  constexpr double e = 0.02, m = 0.5;
  const FitResult without = Fitted({m + e, m - e, m + e, m - e, m + e, m - e}, {0, 0, 0, 0, 0, 0});
  const FitResult with = Fitted({e, -e, e, -e, e, -e}, {1, 1, 1, 1, 1, 1});
  const Evidence found = Judge(without, with);
  const double before = std::sqrt(m * m + e * e);
  EXPECT_NEAR(found.estimation_gain, 1 - e / before, 1e-9);
  EXPECT_NEAR(found.cross_validation_gain, 1 - 1.2 * e / before, 1e-4);
}

// A residual of 2 everywhere (mean square 4, noise 1) of which the new parameter takes half (mean
// square 1, all of the excess) where every block asks for it; where two blocks disagree, those left
// out say that nothing is gained.
TEST(Evidence, WhatAPressureShowsBeyondItsNoiseIsWhatLeftOutBlocksSayToo) {
  const FitResult without = Fitted({2, 2, 2, 2, 2, 2}, {0, 0, 0, 0, 0, 0});
  const FitResult with = Fitted({1, 1, 1, 1, 1, 1}, {0, 0, 0, 0, 0, 0});
  EXPECT_NEAR(Judge(without, with, "p_bore_Pa").pressure_removed, 1, 1e-9);
  EXPECT_EQ(Judge(without, with, "load_cell_N").pressure_removed, 0);
  const FitResult half = Fitted({1.5, 1.5, 1.5, 1.5, 1.5, 1.5}, {0, 0, 0, 0, 0, 0});
  EXPECT_NEAR(Judge(without, half, "p_rod_Pa").pressure_removed, (4 - 2.25) / 3, 1e-9);
  const double d = 1.5;
  const FitResult torn = Fitted({-d, d, 1, 1, 1, 1}, {1, 1, 0, 0, 0, 0});
  EXPECT_LT(Judge(without, torn, "p_rod_Pa").pressure_removed, 0.84) << "0.861 of those in the fit";
  const FitResult quiet = Fitted({1.01, 1.01, 1.01, 1.01, 1.01, 1.01}, {0, 0, 0, 0, 0, 0});
  EXPECT_EQ(Judge(quiet, with, "p_rod_Pa").pressure_removed, 0) << "nothing beyond the noise";
}

}  // namespace
}  // namespace phs::identify::search
