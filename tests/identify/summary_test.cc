#include <gtest/gtest.h>

#include "identify/result/result_json.h"

namespace phs::identify::search {
namespace {

TEST(SummaryTest, AnEffectOnNoListIsPrintedWithPlaceFormulaAndInterval) {
  const Json result = Json::parse(R"json({"data_findings":[],"effects":[{"name":"unlisted",
    "on":["L2"],"formula":"c1*(max(p-2e+06[Pa],0[Pa])/1e+06[Pa])",
    "parameters":{"c1_m3_per_s":{"value":2e-8,"low":1e-8,"high":3e-8}},
    "evidence":{"delta_bic":321.4},"confusable_with":[]}],
    "channels":{"p_bore_Pa":{"before":{"rmse":9000,"nrmse":0.02},
                             "after":{"rmse":4000,"nrmse":0.01}}},
    "unexplained":{"channel":"p_bore_Pa","residual_over_noise":1.04,"depends_on":["time"]}})json");
  EXPECT_EQ(Summary(result),
            "effect unlisted on L2  c1*(max(p-2e+06[Pa],0[Pa])/1e+06[Pa])  "
            "c1_m3_per_s 2e-08 [1e-08, 3e-08]  delta BIC 321\n"
            "p_bore_Pa      validation rmse 9000 -> 4000  (nrmse 0.0200 -> 0.0100)\n"
            "unexplained: p_bore_Pa 1.04 times its noise and uncertainty, depends on time\n");
}

// A conductance of 1e-16 of a leak that passes fifty times as much the other way.
TEST(SummaryTest, WhatAFormHoldsStandsBesideItsNumbers) {
  const Json effect = Json::parse(R"json({"name":"piston_leakage",
    "parameters":{"conductance_m3_per_Pas":{"value":1e-16,"low":9e-17,"high":1.1e-16}},
    "held":{"return_ratio":50},"evidence":{"delta_bic":100},"confusable_with":[]})json");
  EXPECT_EQ(EffectLine(effect),
            "effect piston_leakage  conductance_m3_per_Pas 1e-16 [9e-17, 1.1e-16]  "
            "return_ratio 50 (held)  delta BIC 100\n");
}

}  // namespace
}  // namespace phs::identify::search
