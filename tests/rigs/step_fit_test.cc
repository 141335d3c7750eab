// Fit of settled pressures: found again from their own prediction; Table B-1 with steps left out.
#include <gtest/gtest.h>

#include <cmath>

#include "phs_model/phs_model.h"
#include "rigs/step_table.h"

namespace phs::effects {

using phs_model::FindPhsParams;
using rigs::CompareSteps;
using rigs::FitSteps;
using rigs::PredictSettled;
using rigs::ReadStepTable;
using rigs::StepComparison;
using rigs::StepFit;
using rigs::StepRow;
namespace {

std::vector<StepRow> Rows(int setup) {
  const auto rows = ReadStepTable(PHS_TEST_DATA "/../rigs/lowe_table_b1.csv");
  EXPECT_TRUE(rows.ok());
  std::vector<StepRow> own;
  for (const StepRow& row : rows.value()) {
    if (row.setup == setup) own.push_back(row);
  }
  return own;
}

hydraulics::PhsParams Declared(int setup) {
  return FindPhsParams("quarter_setup" + std::to_string(setup)).value();
}

TEST(StepFit, FindsWhatMadeThePressures) {
  hydraulics::PhsParams truth = Declared(4);
  for (auto& line : truth.lines) {
    line.static_pressure_Pa *= 1.2;
    line.gas_volume_m3 *= 0.7;
  }
  std::vector<StepRow> rows = Rows(4);
  const std::vector<double> p = PredictSettled(truth, rows).value();
  for (size_t i = 0; i < rows.size(); ++i) rows[i].end_Pa = p[i];
  const StepFit fit = FitSteps(Declared(4), rows, {.filling = true}).value();
  EXPECT_NEAR(fit.static_bore_Pa / truth.lines[1].static_pressure_Pa, 1, 0.01);
  EXPECT_NEAR(fit.static_rod_Pa / truth.lines[0].static_pressure_Pa, 1, 0.01);
  EXPECT_NEAR(fit.gas_bore_m3 / truth.lines[1].gas_volume_m3, 1, 0.03);
  EXPECT_NEAR(fit.gas_rod_m3 / truth.lines[0].gas_volume_m3, 1, 0.03);
}

TEST(StepFit, TableB1LeavingStepsOut) {
  for (const auto& [setup, most] : {std::pair{3, 0.05}, {4, 0.015}}) {
    const StepComparison with =
        CompareSteps(Declared(setup), Rows(setup), {.filling = true}).value();
    const StepComparison without = CompareSteps(Declared(setup), Rows(setup), {}).value();
    EXPECT_LT(with.error_left_out, most) << setup;
    EXPECT_GT(without.error_left_out, 0.2) << setup;
    // The seals hold the piston against the net force of the fillings.
    const hydraulics::CylinderParams c = Declared(setup).cylinders[0];
    const double force =
        with.fit.static_rod_Pa * c.RodArea() - with.fit.static_bore_Pa * c.BoreArea();
    EXPECT_LT(std::abs(force), 2000) << setup;
  }
}

}  // namespace
}  // namespace phs::effects
