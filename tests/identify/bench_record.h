// A record of a part on a bench made with equations of its own, and what `phs identify` says of it.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "identify/run/element_run.h"
#include "measurement/manifest.h"
#include "phs_model/phs_model.h"
#include "rigs/rig_model.h"

namespace phs::identify::element {

namespace fs = std::filesystem;

struct Sample {
  double t, x, v, a, p;
};
/// The part itself.
struct BenchTruth {
  double coulomb_N = 30, viscous_Ns_per_m = 60, mass_kg = 4, offset_N = 2;
};
/// Force beside that of the part itself.
using Hidden = std::function<double(const Sample&)>;

/// What is written of a sample.
struct Row {
  double t, x, force, p;
};
/// Done to a record before it is written.
using Tamper = std::function<void(std::vector<Row>*)>;

/// What `phs identify` says of FOLDER/manifest.yaml; empty, and a failure noted, where it says nothing.
inline nlohmann::ordered_json IdentifiedIn(const fs::path& folder) {
  const auto manifest = measurement::LoadManifest((folder / "manifest.yaml").string());
  EXPECT_TRUE(manifest.ok()) << (manifest.ok() ? "" : manifest.error().Line());
  if (!manifest.ok()) return {};
  auto dir = ResultDir::Create((folder / "out").string(), true);
  EXPECT_TRUE(dir.ok());
  const auto outcome = RunElementIdentify(manifest.value(), {}, nullptr, dir.value());
  EXPECT_TRUE(outcome.ok()) << (outcome.ok() ? "" : outcome.error().Line());
  if (!outcome.ok()) return {};
  // The corrected model is a model file like any other.
  const auto params = phs_model::LoadPhsParams(dir.value().File("model.yaml"));
  EXPECT_TRUE(params.ok()) << (params.ok() ? "" : params.error().Line());
  EXPECT_TRUE(rigs::RigModel::Create(rigs::RigKind::kElement, params.value()).ok());
  EXPECT_EQ(params.value().effects.size(), outcome.value().result["effects"].size());
  return outcome.value().result;
}

/// A bench record: mixed sines, pressure that wanders, noise of 0.3 N, correlated over 3 samples.
class BenchRecord {
 public:
  BenchRecord(const std::string& name, unsigned seed, const Hidden& hidden,
              const Tamper& tamper = nullptr, double jitter_s = 0, const BenchTruth& truth = {})
      : folder_(fs::temp_directory_path() /
                ("phs_element_" + name + "_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::ofstream csv(folder_ / "run.csv");
    csv << "t_s,x_m,force_N,p_Pa\n";
    csv.precision(12);
    double noise = 0;
    std::vector<Row> rows;
    for (int i = 0; i < 4000; ++i) {
      const Sample s = At(0.01 * i + jitter_s * std::sin(2.4 * i * i));
      noise = 0.7 * noise + 0.3 * std::sqrt(1 - 0.49) * normal(random);
      const double friction =
          std::tanh(s.v / 2e-4) * truth.coulomb_N + truth.viscous_Ns_per_m * s.v;
      const double x = s.x + 2e-7 * normal(random);
      const double force = truth.mass_kg * s.a + friction + truth.offset_N + hidden(s);
      rows.push_back({s.t, x, force + noise, s.p});
    }
    if (tamper) tamper(&rows);
    for (const Row& row : rows) {
      csv << row.t << ',' << row.x << ',' << row.force << ',' << row.p << '\n';
    }
    std::ofstream(folder_ / "manifest.yaml")
        << "rig: element\nmodel: " << (folder_ / "part.yaml").string()
        << "\ndata: run.csv\nestimation: [0, 27]\nvalidation: [27, 40]\n";
    std::ofstream(folder_ / "part.yaml")
        << "name: part\ncylinders: [{name: \"1\"}]\nfriction: {model: static, curve: coulomb, "
           "coulomb_extension_N: 22, coulomb_retraction_N: 22, breakaway_extension_N: 22, "
           "breakaway_retraction_N: 22, viscous_extension_Ns_per_m: 80, "
           "viscous_retraction_Ns_per_m: 80, ramp_speed_m_s: 5.0e-4}\n"
           "element: {mass_kg: 5}\n";
  }
  ~BenchRecord() { fs::remove_all(folder_); }

  nlohmann::ordered_json Identified() const { return IdentifiedIn(folder_); }
  const fs::path& folder() const { return folder_; }

 private:
  static Sample At(double t) {
    Sample s{t, 0, 0, 0, 0};
    const double amplitude[] = {0.03, 0.012, 0.004}, w[] = {0.9, 2.3, 5.9};
    for (int k = 0; k < 3; ++k) {
      s.x += amplitude[k] * std::sin(w[k] * t + k);
      s.v += amplitude[k] * w[k] * std::cos(w[k] * t + k);
      s.a -= amplitude[k] * w[k] * w[k] * std::sin(w[k] * t + k);
    }
    s.p = 3e5 + 2e5 * std::sin(0.37 * t) + 5e4 * std::sin(1.7 * t);
    return s;
  }
  fs::path folder_;
};

}  // namespace phs::identify::element
