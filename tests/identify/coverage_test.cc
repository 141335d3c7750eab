// Do the 95 % intervals of a part on a bench hold the truth as often as they say? Two hundred records, half of them
// with friction that rises with pressure; noise that remembers three samples, noise in the motion, and a friction
// that turns by tanh where the model has a ramp. Some minutes: PHS_LONG_TESTS.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <random>

#include "tests/identify/bench_record.h"

namespace phs::identify::element {
namespace {

constexpr int kRecords = 200;
constexpr double kSlope_N_per_Pa = 2.5e-5;

struct Count {
  int good = 0, of = 0;
  double Share() const { return static_cast<double>(good) / of; }
};

BenchTruth Drawn(std::mt19937* random) {
  std::uniform_real_distribution<double> by(0.8, 1.25);
  return {.coulomb_N = 28 * by(*random),
          .viscous_Ns_per_m = 70 * by(*random),
          .mass_kg = 4.5 * by(*random),
          .offset_N = 2 * by(*random)};
}

void CountIn(const nlohmann::ordered_json& fit, double truth, Count* count) {
  ++count->of;
  count->good += fit["low"].get<double>() <= truth && truth <= fit["high"].get<double>();
}

TEST(Coverage, IntervalsOfABenchHoldTheTruthIn90To98Percent) {
  if (std::getenv("PHS_LONG_TESTS") == nullptr) GTEST_SKIP() << "PHS_LONG_TESTS is not set";
  std::mt19937 random(20261125);
  std::map<std::string, Count> counts;
  Count all, found;
  for (int i = 0; i < kRecords; ++i) {
    const BenchTruth truth = Drawn(&random);
    const bool hides = i % 2 == 1;
    const BenchRecord record(
        "coverage", 5000 + static_cast<unsigned>(i),
        [&](const Sample& s) {
          return hides ? std::tanh(s.v / 2e-4) * kSlope_N_per_Pa * s.p : 0.0;
        },
        nullptr, 0, truth);
    const auto r = record.Identified();
    ++found.of;
    const bool right =
        hides ? r["effects"].size() == 1 && r["effects"][0]["name"] == "pressure_friction"
              : r["effects"].empty();
    if (!right) continue;  // an interval says nothing where the model is another
    ++found.good;
    const std::map<std::string, double> numbers = {
        {"element.mass_kg", truth.mass_kg},
        {"element.offset_N", truth.offset_N},
        {"friction.coulomb_N", truth.coulomb_N},
        {"friction.viscous_Ns_per_m", truth.viscous_Ns_per_m}};
    for (const auto& [name, value] : numbers) {
      ASSERT_TRUE(r["fitted"].contains(name)) << r["fitted"].dump(1);
      for (Count* count : {&counts[name], &all}) CountIn(r["fitted"][name], value, count);
    }
    if (!hides) continue;
    const auto& slope = r["effects"][0]["parameters"]["bore_N_per_Pa"];
    for (Count* count : {&counts["bore_N_per_Pa"], &all}) CountIn(slope, kSlope_N_per_Pa, count);
  }
  for (const auto& [name, count] : counts) {
    std::printf("%-28s %d of %d (%.0f %%)\n", name.c_str(), count.good, count.of,
                100 * count.Share());
  }
  std::printf("all %d of %d (%.1f %%), right model %d of %d\n", all.good, all.of, 100 * all.Share(),
              found.good, found.of);
  EXPECT_GE(found.Share(), 0.95);
  EXPECT_GE(all.Share(), 0.90);
  EXPECT_LE(all.Share(), 0.98);
}

}  // namespace
}  // namespace phs::identify::element
