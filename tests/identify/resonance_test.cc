// A mass on a spring and a damper driven through its resonance at a ninth of the sampling rate: the
// acceleration is that of the smoothed motion. A central difference takes sin(wT)/(wT) = 0.92 of it there,
// and near the resonance, where mass and spring nearly cancel, the rest is put on other numbers.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "rigs/rig.h"
#include "tests/identify/bench_record.h"

namespace phs::identify::element {
namespace {

constexpr double kRate_Hz = 500, kEnd_s = 40;
constexpr double kMass_kg = 4, kViscous_Ns_per_m = 60;
const double kStiffness_N_per_m = kMass_kg * std::pow(2 * M_PI * kRate_Hz / 9, 2);

/// A sine of 0.1 mm whose frequency rises evenly from 2 to 75 Hz.
void WriteResonance(const fs::path& folder) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::ofstream csv(folder / "run.csv");
  csv << "t_s,x_m,force_N\n";
  csv.precision(12);
  constexpr double kBegin_Hz = 2, kLast_Hz = 75, kSize_m = 1e-4;
  const double rise = 2 * M_PI * (kLast_Hz - kBegin_Hz) / kEnd_s;  // rad/s2
  for (int i = 0; i < kRate_Hz * kEnd_s; ++i) {
    const double t = i / kRate_Hz;
    const double phase = 2 * M_PI * kBegin_Hz * t + 0.5 * rise * t * t;
    const double w = 2 * M_PI * kBegin_Hz + rise * t;
    const double x = kSize_m * std::sin(phase), v = kSize_m * w * std::cos(phase);
    const double a = kSize_m * (rise * std::cos(phase) - w * w * std::sin(phase));
    csv << t << ',' << x + 1e-8 * normal(random) << ','
        << kMass_kg * a + kViscous_Ns_per_m * v + kStiffness_N_per_m * x + 0.05 * normal(random)
        << '\n';
  }
  std::ofstream(folder / "part.yaml")
      << "name: part\ncylinders: [{name: \"1\"}]\nfriction: {model: static, curve: coulomb, "
         "coulomb_extension_N: 0, coulomb_retraction_N: 0, breakaway_extension_N: 0, "
         "breakaway_retraction_N: 0, viscous_extension_Ns_per_m: 50, "
         "viscous_retraction_Ns_per_m: 50, ramp_speed_m_s: 1.0e-3}\n"
         "element: {mass_kg: 4.5, stiffness_N_per_m: "
      << 1.1 * kStiffness_N_per_m << "}\n";
  std::ofstream(folder / "manifest.yaml")
      << "rig: element\nmodel: " << (folder / "part.yaml").string()
      << "\ndata: run.csv\nestimation: [0, 39]\nvalidation: [39, 40]\n";
}

TEST(Resonance, AtANinthOfTheSamplingRateIsIdentifiedWithin2Percent) {
  const fs::path folder =
      fs::temp_directory_path() / ("phs_resonance_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  WriteResonance(folder);
  const nlohmann::ordered_json r = IdentifiedIn(folder);
  EXPECT_TRUE(r["effects"].empty()) << r["effects"].dump(1);
  const auto value = [&](const char* name) { return r["fitted"][name]["value"].get<double>(); };
  EXPECT_NEAR(value("element.mass_kg"), kMass_kg, 0.02 * kMass_kg) << r["fitted"].dump(1);
  EXPECT_NEAR(value("element.stiffness_N_per_m"), kStiffness_N_per_m, 0.02 * kStiffness_N_per_m);
  const double resonance =
      std::sqrt(value("element.stiffness_N_per_m") / value("element.mass_kg")) / (2 * M_PI);
  EXPECT_NEAR(resonance, kRate_Hz / 9, 0.02 * kRate_Hz / 9);
  fs::remove_all(folder);
}

TEST(Resonance, AnAccelerationThatIsGivenIsTaken) {
  rigs::RigMotion motion;
  motion.step_s = 0.1;
  motion.position_m = {{0, 1, 2}};
  EXPECT_EQ(rigs::AccelerationOf(motion, {0, 1, 2})[1], 10);
  motion.acceleration_m_s2 = {{7, 8, 9}};
  EXPECT_EQ(rigs::AccelerationOf(motion, {0, 1, 2})[1], 8);
}

}  // namespace
}  // namespace phs::identify::element
