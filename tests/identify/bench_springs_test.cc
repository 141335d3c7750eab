// A gas strut on a bench: gas spring, hardening spring and quadratic damping are declared numbers of the
// part like its mass. A record made here with equations of its own; the declared numbers are 15 to 20 % off.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "tests/identify/bench_record.h"

namespace phs::identify::element {
namespace {

constexpr double kGasForce_N = 600, kExponent = 1.3;
constexpr double kHardening_N_per_m3 = 2e6, kQuadratic_Ns2_per_m2 = 900, kCoulomb_N = 12;

/// Three sines of 70 mm together, force noise 0.5 N.
void WriteSpringRecord(const fs::path& folder) {
  std::mt19937 random(17);
  std::normal_distribution<double> normal;
  std::ofstream csv(folder / "run.csv");
  csv << "t_s,x_m,force_N\n";
  csv.precision(12);
  const double amplitude[] = {0.045, 0.018, 0.007}, w[] = {0.8, 2.9, 7.3};
  for (int i = 0; i < 8000; ++i) {
    const double t = 0.01 * i;
    double x = 0, v = 0;
    for (int k = 0; k < 3; ++k) {
      x += amplitude[k] * std::sin(w[k] * t + k);
      v += amplitude[k] * w[k] * std::cos(w[k] * t + k);
    }
    // The gas: pressure times volume^n stays; area 5 cm2, at rest 12 bar in 100 cm3.
    const double volume = 1e-4 - 5e-4 * x;
    const double gas = 5e-4 * (12e5 * std::pow(1e-4 / volume, kExponent) - 12e5);
    const double rubbing = kCoulomb_N * std::min(1.0, std::max(-1.0, v / 1e-3));
    csv << t << ',' << x + 2e-7 * normal(random) << ','
        << gas + kHardening_N_per_m3 * x * x * x + kQuadratic_Ns2_per_m2 * v * std::abs(v) +
               rubbing + 3 + 0.5 * normal(random)
        << '\n';
  }
  std::ofstream(folder / "part.yaml")
      << "name: strut\ncylinders: [{name: \"1\"}]\nfriction: {model: static, curve: coulomb, "
         "coulomb_extension_N: 10, coulomb_retraction_N: 10, breakaway_extension_N: 10, "
         "breakaway_retraction_N: 10, viscous_extension_Ns_per_m: 0, "
         "viscous_retraction_Ns_per_m: 0, ramp_speed_m_s: 1.0e-3}\n"
         "element: {gas_force_N: 720, gas_length_m: 0.2, gas_exponent: 1.3, "
         "hardening_N_per_m3: 1.7e6, quadratic_damping_Ns2_per_m2: 750}\n";
  std::ofstream(folder / "manifest.yaml")
      << "rig: element\nmodel: " << (folder / "part.yaml").string()
      << "\ndata: run.csv\nestimation: [0, 55]\nvalidation: [55, 80]\n";
}

TEST(BenchSprings, GasHardeningAndQuadraticDampingOfAStrutAreFittedWithin2Percent) {
  const fs::path folder = fs::temp_directory_path() / ("phs_strut_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  WriteSpringRecord(folder);
  const nlohmann::ordered_json r = IdentifiedIn(folder);
  EXPECT_TRUE(r["effects"].empty()) << r["effects"].dump(1);
  EXPECT_EQ(r["verdict"], "sufficient") << r["reasons"].dump();
  const auto expect_near = [&](const char* name, double truth) {
    EXPECT_NEAR(r["fitted"][name]["value"].get<double>(), truth, 0.02 * truth) << name;
  };
  expect_near("element.gas_force_N", kGasForce_N);
  expect_near("element.hardening_N_per_m3", kHardening_N_per_m3);
  expect_near("element.quadratic_damping_Ns2_per_m2", kQuadratic_Ns2_per_m2);
  EXPECT_EQ(r["fitted"].count("element.gas_length_m"), 0u) << "the geometry is known";
  fs::remove_all(folder);
}

/// A damper of 170 N s/m beside a seal of 15 N that gives 0.15 mm before it slides, steps of 0.1 ms.
void WriteDamperRecord(const fs::path& folder) {
  constexpr double kDamper_Ns_per_m = 170, kSeal_N = 15, kBristle_N_per_m = 1e5;
  std::mt19937 random(23);
  std::normal_distribution<double> normal;
  std::ofstream csv(folder / "run.csv");
  csv << "t_s,x_m,force_N\n";
  csv.precision(12);
  const double amplitude[] = {0.02, 0.009, 0.002}, w[] = {0.9, 3.1, 8.3};
  double z = 0;
  for (int i = 0; i < 600000; ++i) {
    const double t = 1e-4 * i;
    double x = 0, v = 0;
    for (int k = 0; k < 3; ++k) {
      x += amplitude[k] * std::sin(w[k] * t);
      v += amplitude[k] * w[k] * std::cos(w[k] * t);
    }
    z = std::clamp(z + 1e-4 * v, -kSeal_N / kBristle_N_per_m, kSeal_N / kBristle_N_per_m);
    if (i % 100 != 0) continue;
    csv << t << ',' << x + 2e-7 * normal(random) << ','
        << kBristle_N_per_m * z + kDamper_Ns_per_m * v + 0.2 * normal(random) << '\n';
  }
  std::ofstream(folder / "part.yaml")
      << "name: damper\ncylinders: [{name: \"1\"}]\nfriction: {model: presliding, curve: coulomb, "
         "coulomb_extension_N: 15, coulomb_retraction_N: 15, breakaway_extension_N: 15, "
         "breakaway_retraction_N: 15, viscous_extension_Ns_per_m: 0, "
         "viscous_retraction_Ns_per_m: 0, stiffness_N_per_m: 1.0e5, damping_Ns_per_m: 0, "
         "breakaway_ratio: 0.98}\nelement: {damping_Ns_per_m: 200}\n";
  std::ofstream(folder / "manifest.yaml")
      << "rig: element\nmodel: " << (folder / "part.yaml").string()
      << "\ndata: run.csv\nestimation: [0, 40]\nvalidation: [40, 60]\n";
}

// As the viscous level of its friction, behind the bristle, the damper was left to a formula.
TEST(BenchSprings, ADamperBesideASealThatGivesIsFittedAndNothingElse) {
  const fs::path folder = fs::temp_directory_path() / ("phs_damper_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  WriteDamperRecord(folder);
  const nlohmann::ordered_json r = IdentifiedIn(folder);
  EXPECT_TRUE(r["effects"].empty()) << r["effects"].dump(1);
  EXPECT_EQ(r["verdict"], "sufficient") << r["reasons"].dump();
  EXPECT_NEAR(r["fitted"]["element.damping_Ns_per_m"]["value"].get<double>(), 170, 0.02 * 170);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace phs::identify::element
