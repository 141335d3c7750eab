// One effect on two parts that the record does not tell apart: neither is taken for sure.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "identify/select/effect_search.h"
#include "phs_model/phs_model.h"
#include "tests/identify/search_record.h"

namespace phs::identify::search {
namespace {

using hydraulics::PhsParams;
using testing::ElementsAre;

constexpr int kRows = 600;
const char* const kAmount = "conductance_m3_per_Pas";

/// y = 100 friction.scale sin(0.03 i) + 1e13 times the leak's wave: of L1, and of L2 turned by
/// `apart` [rad].
class TwoLines final : public ForwardModel {
 public:
  explicit TwoLines(double apart) : apart_(apart) {
    PhsParams truth = phs_model::FindPhsParams("quarter_setup2").value();
    truth.effects = {Leak("L1", 4e-13)};
    Channels made;
    EXPECT_TRUE(Run(truth, Span::kEstimation, &made).ok());
    std::mt19937 random(2);
    std::normal_distribution<double> normal;
    for (double& y : made[0]) y += normal(random);
    measured_.push_back({"load_cell_N", made[0], 1.0});
  }
  const std::vector<MeasuredBlock>& Measured() const override { return measured_; }
  Status Run(const PhsParams& params, Span, Channels* out) const override {
    out->assign(1, {});
    for (int i = 0; i < kRows; ++i) {
      double y = 100 * params.friction.scale * std::sin(0.03 * i);
      for (const auto& e : params.effects) {
        y += 1e13 * e.values.at(kAmount) * std::sin(0.4 * i + (e.targets[0] == "L2" ? apart_ : 0));
      }
      out->front().push_back(y);
    }
    return {};
  }
  Status Uncertainty(const PhsParams&, Span, Channels* deviation) const override {
    deviation->assign(1, std::vector<double>(kRows, 0.0));
    return {};
  }
  FreeModel Declared(const PhsParams& declared) const override {
    return {declared, {{"friction.scale", 1, 0.1, 10, true, 1}}};
  }
  std::vector<Candidate> Candidates(const PhsParams& params) const override {
    std::vector<Candidate> out;
    if (!params.effects.empty()) return out;
    for (const char* line : {"L1", "L2"}) {
      Candidate c;
      c.effect = "external_leakage";
      c.params = Leak(line, 1e-13);
      c.free = {{std::string("effects.external_leakage.") + kAmount, 1e-13, 1e-15, 1e-11, true, 1}};
      c.starts = {{1e-13}}, c.none = {0}, c.mains = 1;
      out.push_back(c);
    }
    return out;
  }
  std::shared_ptr<const ForwardModel> Coarse(double) const override {
    return std::make_shared<const TwoLines>(*this);
  }

 private:
  static hydraulics::EffectParams Leak(const std::string& line, double amount) {
    return {"external_leakage", {line}, {{kAmount, amount}}};
  }
  double apart_;
  std::vector<MeasuredBlock> measured_;
};

Identification FoundWith(double apart) { return FoundBy(std::make_shared<const TwoLines>(apart)); }

// One of them was named, as if the record had told it.
TEST(Elsewhere, TheSameEffectOnAnotherPartIsARival) {
  const Identification found = FoundWith(0.02);
  ASSERT_EQ(found.effects.size(), 1u);
  const std::string here = found.effects[0].candidate.params.targets[0];
  EXPECT_THAT(found.effects[0].confusable_with,
              ElementsAre(here == "L1" ? "external_leakage on L2" : "external_leakage on L1"));
  EXPECT_EQ(NameBesideRivals(found.effects[0]), "external_leakage on " + here);
  ASSERT_EQ(found.effects[0].rivals.size(), 1u);
  EXPECT_NE(found.effects[0].rivals[0].form.params.targets[0], here);
}

TEST(Elsewhere, IsNoneWhereTheRecordTellsThem) {
  const Identification found = FoundWith(0.8);
  ASSERT_EQ(found.effects.size(), 1u);
  EXPECT_THAT(found.effects[0].candidate.params.targets, ElementsAre("L1"));
  EXPECT_TRUE(found.effects[0].confusable_with.empty());
  EXPECT_EQ(NameBesideRivals(found.effects[0]), "external_leakage");
  EXPECT_TRUE(found.effects[0].rivals.empty());
}

}  // namespace
}  // namespace phs::identify::search
