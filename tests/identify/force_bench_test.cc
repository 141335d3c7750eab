// A bench that a force drives: the position is predicted and compared. The records are made by the
// classical Runge-Kutta method in steps of a tenth of a millisecond, with friction of their own.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "base/table.h"
#include "identify/run/rig_run.h"
#include "tests/base/scratch_dir.h"
#include "tests/identify/bench_record.h"

namespace phs::identify::element {
namespace {

struct Truth {
  double mass_kg = 4, stiffness_N_per_m = 3000, coulomb_N = 15, viscous_Ns_per_m = 60,
         slope_1_per_m = 0;
  double Acceleration(double t, double x, double v) const {
    const double friction = coulomb_N * (1 + slope_1_per_m * x) * std::tanh(v / 3e-4);
    return (Force(t) - stiffness_N_per_m * x - viscous_Ns_per_m * v - friction) / mass_kg;
  }
  static double Force(double t) {
    return 60 * std::sin(1.1 * t) + 40 * std::sin(2.9 * t + 1) + 25 * std::sin(7.3 * t);
  }
};

class ForceBench : public testing::Test {
 protected:
  void Write(const Truth& truth) {
    constexpr double h = 1e-4;
    std::mt19937 random(9);
    std::normal_distribution<double> normal;
    search::Channels columns(3);
    double x = 0, v = 0;
    for (int i = 0; i <= 250000; ++i) {
      const double t = i * h;
      if (i % 100 == 0) {
        columns[0].push_back(t), columns[1].push_back(x + 2e-6 * normal(random));
        columns[2].push_back(Truth::Force(t) + 0.1 * normal(random));
      }
      const auto a = [&](double s, double y, double w) { return truth.Acceleration(t + s, y, w); };
      const double v1 = v, a1 = a(0, x, v1);
      const double v2 = v + h / 2 * a1, a2 = a(h / 2, x + h / 2 * v1, v2);
      const double v3 = v + h / 2 * a2, a3 = a(h / 2, x + h / 2 * v2, v3);
      const double v4 = v + h * a3, a4 = a(h, x + h * v3, v4);
      x += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4), v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    ASSERT_TRUE(WriteCsv(folder_.File("run.csv"), {"t_s", "x_m", "force_N"}, columns).ok());
    folder_.Write("part.yaml",
                  "name: part\ncylinders: [{name: \"1\"}]\nfriction: {model: static, curve: "
                  "coulomb, coulomb_extension_N: 19, coulomb_retraction_N: 19, "
                  "breakaway_extension_N: 19, breakaway_retraction_N: 19, "
                  "viscous_extension_Ns_per_m: 75, viscous_retraction_Ns_per_m: 75, "
                  "ramp_speed_m_s: 5.0e-4}\nelement: {mass_kg: 4.6, stiffness_N_per_m: 3300}\n");
    folder_.Write("manifest.yaml",
                  "rig: element\ndriven_by: force\nmodel: part.yaml\ndata: run.csv\n"
                  "candidates: [position_friction, stribeck, presliding, asymmetric_friction, "
                  "backlash, viscous_friction]\n"
                  "estimation: [0, 16]\nvalidation: [16, 25]\n");
  }
  double Fitted(const nlohmann::ordered_json& result, const char* name) const {
    return result["fitted"][name]["value"].get<double>();
  }
  ScratchDir folder_;
};

TEST_F(ForceBench, ItsNumbersAreFoundAndNothingElse) {
  const Truth truth;
  Write(truth);
  const auto result = IdentifiedIn(folder_.path());
  EXPECT_TRUE(result["effects"].empty()) << result["effects"].dump(1);
  EXPECT_EQ(result["verdict"], "sufficient") << result["reasons"].dump(1);
  EXPECT_NEAR(Fitted(result, "element.mass_kg"), 4, 0.08);
  EXPECT_NEAR(Fitted(result, "element.stiffness_N_per_m"), 3000, 30);
  EXPECT_NEAR(Fitted(result, "friction.coulomb_N"), 15, 0.3);
  EXPECT_NEAR(Fitted(result, "friction.viscous_Ns_per_m"), 60, 1.5);
  EXPECT_TRUE(result["channels"].contains("x_m"));
}

TEST_F(ForceBench, AFrictionThatChangesAlongTheStrokeIsFound) {
  if (std::getenv("PHS_LONG_TESTS") == nullptr) GTEST_SKIP() << "PHS_LONG_TESTS is not set";
  Truth truth;
  truth.slope_1_per_m = 20;
  Write(truth);
  const auto result = IdentifiedIn(folder_.path());
  ASSERT_EQ(result["effects"].size(), 1u) << result["effects"].dump(1);
  EXPECT_EQ(result["effects"][0]["name"], "position_friction");
  EXPECT_EQ(result["verdict"], "explained") << result["reasons"].dump(1);
  EXPECT_LT(result["channels"]["x_m"]["after"]["rmse"].get<double>(),
            0.3 * result["channels"]["x_m"]["before"]["rmse"].get<double>());
}

}  // namespace
}  // namespace phs::identify::element
