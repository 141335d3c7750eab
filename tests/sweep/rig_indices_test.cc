// Sobol indices of a rig whose answer is known: oil shut into one chamber. A piston that moves in by a
// raises the pressure by
//   dp = beta A a / V
// but for the millionth of air that every line has (hydraulics/node.h): a product of independent factors. With c = variance / mean^2 of beta, a and 1/V, uniform beta, a, V:
//   S_i = c_i / (prod (1 + c_j) - 1),   ST_i = c_i prod_{j != i} (1 + c_j) / (prod (1 + c_j) - 1).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "hydraulics/node.h"
#include "sweep/run_case.h"
#include "sweep/sensitivity.h"
#include "sweep/study_file.h"
#include "tests/base/scratch_dir.h"

namespace phs::sweep {
namespace {

constexpr double kLeast[] = {1.0e9, 0.2e-3, 1.0e-3};  // beta, a, V
constexpr double kMost[] = {1.5e9, 0.6e-3, 2.0e-3};
constexpr double kRest_Pa = 5e6;

class RigIndices : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new ScratchDir;
    folder_->Write("chamber.yaml",
                   "name: chamber\ncylinders: [{name: \"1\", bore_line: oil, bore_m: 0.1}]\n"
                   "lines: [{name: oil, static_pressure_Pa: 5.0e+6, oil_volume_m3: 1.5e-3, "
                   "bulk_modulus_Pa: 1.2e+9}]\n");
    folder_->Write("rig.yaml",
                   "rig: cylinder\nmodel: chamber.yaml\nsignal: {duration_s: 1, sample_s: 0.1, "
                   "actuator_m: {kind: ramp, amplitude_m: 4.0e-4, speed_m_s: -1.0e-3}}\n");
    const auto study = LoadStudy(
        folder_->Write("study.yaml",
                       "rig: rig.yaml\ndesign: sobol_indices\nsamples: 256\nseed: 0\naxes:\n"
                       "  - {key: model.oil.bulk_modulus_Pa, min: 1.0e+9, max: 1.5e+9}\n"
                       "  - {key: rig.signal.actuator_m.amplitude_m, min: 0.2e-3, max: 0.6e-3}\n"
                       "  - {key: model.oil.oil_volume_m3, min: 1.0e-3, max: 2.0e-3}\n"
                       "  - {key: model.friction.scale, min: 0.5, max: 2}\n"
                       "outputs: [extremes.p_bore_Pa.most]\n"));
    ASSERT_TRUE(study.ok()) << study.error().Line();
    study_ = new Study(study.value());
    values_ = new std::vector<double>;
    for (int run = 0; run < study_->num_runs(); ++run) {
      const auto record = RunCase(*study_, run, folder_->File("scratch"));
      ASSERT_TRUE(record.ok() && record.value().status == "ok") << record.value().reason;
      values_->push_back(record.value().outputs[0]);
    }
  }
  static void TearDownTestSuite() {
    delete values_;
    delete study_;
    delete folder_;
  }
  static inline const ScratchDir* folder_ = nullptr;
  static inline const Study* study_ = nullptr;
  static inline std::vector<double>* values_ = nullptr;
};

TEST_F(RigIndices, EveryRunIsTheClosedForm) {
  const double area = std::numbers::pi / 4 * 0.1 * 0.1;
  for (std::size_t run = 0; run < values_->size(); ++run) {
    const auto& at = study_->runs[run];
    const double p = (*values_)[run], rise = p - kRest_Pa;
    const double pushed = area * ParseNumber(at[1]).value() / ParseNumber(at[2]).value();
    const double oil = rise / ParseNumber(at[0]).value();
    const double air = hydraulics::kTraceAir * 101325 * (1 / kRest_Pa - 1 / p);
    EXPECT_NEAR(oil + air, pushed, 1e-12) << run;
    EXPECT_LT(air, 1e-5 * oil) << run;
  }
}

TEST_F(RigIndices, AreTheAnalyticOnes) {
  double c[3];
  for (int i = 0; i < 3; ++i) {
    const double width = kMost[i] - kLeast[i];
    const double mean =
        i == 2 ? std::log(kMost[i] / kLeast[i]) / width : (kMost[i] + kLeast[i]) / 2;
    const double square = i == 2 ? 1 / (kMost[i] * kLeast[i]) : mean * mean + width * width / 12;
    c[i] = square / (mean * mean) - 1;
  }
  const double all = (1 + c[0]) * (1 + c[1]) * (1 + c[2]);
  const auto indices = SobolIndices(*values_, 4);
  ASSERT_EQ(indices.size(), 4u);
  for (int i = 0; i < 3; ++i) {
    const SobolIndex& s = indices[static_cast<std::size_t>(i)];
    EXPECT_NEAR(s.first, c[i] / (all - 1), 0.01) << i;
    EXPECT_NEAR(s.total, c[i] * all / (1 + c[i]) / (all - 1), 0.01) << i;
    EXPECT_LT(std::abs(s.first - c[i] / (all - 1)), 3 * s.first_error) << i;
  }
  EXPECT_EQ(indices[3].first, 0) << "friction does not act on the pressure";
  EXPECT_EQ(indices[3].total, 0);
}

}  // namespace
}  // namespace phs::sweep
