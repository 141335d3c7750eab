#include "rail/creep_table.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include "creep_reference.h"
#include "rail/creep_table_cache.h"
#include "tests/base/scratch_dir.h"

namespace phs::rail {
namespace {

const FastsimParams kGrid{40, 40, false};

/// Built once for all tests of this file.
const CreepTable& Built() {
  static const CreepTable table = CreepTable::Build(kGrid, 2);
  return table;
}

NormalisedCreepage Random(std::mt19937* random, double chi_low, double chi_high) {
  std::uniform_real_distribution<> one(0, 1);
  const double p = 0.02 * std::exp(one(*random) * std::log(2000.0));  // 0.02 … 40
  double d[3];
  for (double& value : d) value = 2 * one(*random) - 1;
  d[static_cast<int>(3 * one(*random))] = one(*random) < 0.5 ? -1 : 1;
  return {p * d[0], p * d[1], 2 * p * d[2], chi_low + (chi_high - chi_low) * one(*random)};
}

struct Errors {
  double rms = 0, max = 0, moment_max = 0;
};
Errors Compare(double chi_low, double chi_high, int count) {
  const Fastsim fastsim(kGrid);
  std::mt19937 random(7);
  Errors e;
  for (int i = 0; i < count; ++i) {
    const NormalisedCreepage c = Random(&random, chi_low, chi_high);
    const NormalisedForce p = fastsim.Calc(c);
    const NormalisedForce q = Built().At(c);
    const double error = std::hypot(p.x - q.x, p.y - q.y);
    e.rms += error * error / count;
    e.max = std::max(e.max, error);
    e.moment_max = std::max(e.moment_max, std::abs(p.moment - q.moment));
  }
  e.rms = std::sqrt(e.rms);
  std::printf("  chi %.1f-%.1f: rms %.5f max %.5f, moment max %.5f\n", chi_low, chi_high, e.rms,
              e.max, e.moment_max);
  return e;
}

TEST(CreepTable, CloseToItsSourceForUsualPatches) {
  const Errors e = Compare(0.3, 0.7, 20000);
  EXPECT_LT(e.rms, 0.001);
  EXPECT_LT(e.max, 0.012);
  EXPECT_LT(e.moment_max, 0.003);
}
TEST(CreepTable, CloseToItsSourceForSlenderPatches) {
  const Errors e = Compare(0.1, 0.9, 20000);
  EXPECT_LT(e.rms, 0.0015);
  EXPECT_LT(e.max, 0.015);
}
TEST(CreepTable, BoundedErrorInTheLimitOfASlit) { EXPECT_LT(Compare(0.0, 1.0, 5000).max, 0.04); }

// A flange on a 1250 mm wheel: contact angles up to 75 degrees, spin sin(angle)/r, all loads.
TEST(CreepTable, FlangeContactsWithin1p5PercentOfMuN) {
  const auto table = Law("kalker_table");
  const auto fastsim = Law("fastsim");
  std::mt19937 random(3);
  std::uniform_real_distribution<> one(0, 1);
  double rms = 0, largest = 0;
  const int count = 4000;
  for (int i = 0; i < count; ++i) {
    CreepInput in;
    in.normal = 5e3 * std::exp(one(random) * std::log(40.0));
    const double scale = 6e-3 * std::cbrt(in.normal / 1e5);
    const double ratio = 0.15 * std::exp(one(random) * std::log(40.0));  // a/b 0.15 … 6
    in.a = scale * std::sqrt(ratio);
    in.b = scale / std::sqrt(ratio);
    in.friction = 0.1 + 0.4 * one(random);
    in.xi = 0.02 * (2 * one(random) - 1) * one(random);
    in.eta = 0.02 * (2 * one(random) - 1) * one(random);
    in.phi = std::sin(1.3 * one(random)) / 0.625;
    const CreepForce p = fastsim->Calc(in);
    const CreepForce q = table->Calc(in);
    const double error = std::hypot(p.x - q.x, p.y - q.y) / (in.friction * in.normal);
    rms += error * error / count;
    largest = std::max(largest, error);
  }
  std::printf("  flange: rms %.5f max %.5f of mu N\n", std::sqrt(rms), largest);
  EXPECT_LT(std::sqrt(rms), 0.005);
  EXPECT_LT(largest, 0.015);
}

TEST(CreepTable, RmsErrorAgainstContactOn141CasesBelow0p04) {
  const Table t = ReferenceTable("hertz_creep_table.csv");
  const auto law = Law("kalker_table");
  double rms = 0;
  for (int i = 0; i < t.num_rows(); ++i) {
    const CreepInput in = HertzCase(t, i);
    const CreepForce f = law->Calc(in);
    const double error =
        std::hypot(f.x - Cell(t, "Fx_CONTACT_N", i), f.y - Cell(t, "Fy_CONTACT_N", i));
    rms += std::pow(error / (in.friction * in.normal), 2) / t.num_rows();
  }
  EXPECT_LT(std::sqrt(rms), 0.04) << std::sqrt(rms);
}

TEST(CreepTable, LinearLimitIsExact) {
  const Fastsim fastsim(kGrid);
  std::mt19937 random(5);
  for (int i = 0; i < 500; ++i) {
    NormalisedCreepage c = Random(&random, 0.05, 0.95);
    const double p = std::max({std::abs(c.u), std::abs(c.v), std::abs(0.5 * c.w)});
    const double to = 1e-9 / p;
    c = {c.u * to, c.v * to, c.w * to, c.chi};
    const NormalisedForce table = Built().At(c);
    const NormalisedForce linear = fastsim.CalcAdhesion(c);
    // In chi the linear law is not a polynomial of second order: 1e-4 of the size remains.
    EXPECT_NEAR(table.x, linear.x, 1e-8 * 1e-9);
    EXPECT_NEAR(table.y, linear.y, 2e-4 * 1e-9);
    EXPECT_NEAR(table.moment, linear.moment, 2e-4 * 1e-9);
  }
}

TEST(CreepTable, MirrorsToTheLastBitAndStaysWithinFriction) {
  std::mt19937 random(9);
  for (int i = 0; i < 5000; ++i) {
    NormalisedCreepage c = Random(&random, 0, 1);
    if (i % 10 == 0) c.w = 0;
    if (i % 10 == 1) c.v = 0;
    const NormalisedForce f = Built().At(c);
    const NormalisedForce mirrored = Built().At({c.u, -c.v, -c.w, c.chi});
    const NormalisedForce backwards = Built().At({-c.u, c.v, c.w, c.chi});
    EXPECT_EQ(f.x, mirrored.x);
    EXPECT_EQ(f.y, -mirrored.y);
    EXPECT_EQ(f.moment, -mirrored.moment);
    EXPECT_EQ(f.x, -backwards.x);
    EXPECT_EQ(f.y, backwards.y);
    EXPECT_LE(std::hypot(f.x, f.y), 1 + 1e-12);
  }
}

// Along straight lines through the arguments: no jumps at nodes, faces and mirrors, and a force
// that grows with the creepage of a line through the origin up to saturation.
TEST(CreepTable, ContinuousAlongLines) {
  std::mt19937 random(11);
  for (int line = 0; line < 200; ++line) {
    const NormalisedCreepage p = Random(&random, 0.1, 0.9);
    const NormalisedCreepage q = Random(&random, 0.1, 0.9);
    NormalisedForce last = Built().At(p);
    const int steps = 2000;
    const double length = std::hypot(p.u - q.u, p.v - q.v, p.w - q.w);
    for (int i = 1; i <= steps; ++i) {
      const double s = i / static_cast<double>(steps);
      const NormalisedForce f = Built().At({p.u + s * (q.u - p.u), p.v + s * (q.v - p.v),
                                            p.w + s * (q.w - p.w), p.chi + s * (q.chi - p.chi)});
      const double step = length / steps + std::abs(q.chi - p.chi) / steps;
      EXPECT_LT(std::hypot(f.x - last.x, f.y - last.y), 2.5 * step + 1e-6);
      last = f;
    }
  }
}

// Quadratic splines: the slope is continuous within a face of the cube and nearly so across its
// edges (there only the force is continuous by construction).
TEST(CreepTable, SlopeHasNoNotableJumps) {
  std::mt19937 random(17);
  std::uniform_real_distribution<> one(-1, 1);
  double largest = 0;
  for (int line = 0; line < 400; ++line) {
    const NormalisedCreepage p{2 * one(random), 2 * one(random), 3 * one(random),
                               0.5 + 0.3 * one(random)};
    const double du = one(random), dv = one(random), dw = 2 * one(random);
    const double h = 1e-4;
    const auto at = [&](double s) {
      return Built().At({p.u + s * du, p.v + s * dv, p.w + s * dw, p.chi});
    };
    for (double s = 0; s < 1; s += 0.0013) {
      const NormalisedForce a = at(s - h), b = at(s), c = at(s + h);
      largest = std::max(largest, std::hypot(a.x - 2 * b.x + c.x, a.y - 2 * b.y + c.y) / h);
    }
  }
  std::printf("  largest change of slope over %g: %.4f\n", 1e-4, largest);
  EXPECT_LT(largest, 0.05);
}

TEST(CreepTable, SlopeAtSmallCreepageHasNoDeadZone) {
  const auto law = Law("kalker_table");
  const auto linear = Law("linear");
  CreepInput in{6e-3, 5e-3, 8e4, 0, 0, 0, 10, 0.3};
  for (double eta : {1e-12, 1e-9, 1e-6}) {
    in.eta = eta;
    EXPECT_NEAR(law->Calc(in).y, linear->Calc(in).y, 3e-3 * std::abs(linear->Calc(in).y));
  }
  EXPECT_EQ(Law("kalker_table")->Calc({6e-3, 5e-3, 8e4, 0, 0, 0, 10, 0.3}).y, 0);
}

TEST(CreepLaw, NeverDeliversPowerAnyMethod) {
  std::mt19937 random(13);
  std::uniform_real_distribution<> one(-1, 1);
  for (const std::string& name : CreepLawNames()) {
    const auto law = Law(name);
    EXPECT_EQ(law->name(), name);
    for (int i = 0; i < 3000; ++i) {
      const double scale = std::pow(10.0, 2 * one(random) - 3);
      CreepInput in{
          6e-3 * std::exp(one(random)), 6e-3 * std::exp(one(random)), 1e5, scale * one(random),
          scale * one(random),          100 * scale * one(random),    20,  0.3};
      const CreepForce f = law->Calc(in);
      const double power = -(f.x * in.xi + f.y * in.eta + f.moment * in.phi);
      EXPECT_GE(power, -1e-9 * in.friction * in.normal * scale) << name;
      if (name != "linear") {
        EXPECT_LE(std::hypot(f.x, f.y), in.friction * in.normal * (1 + 1e-9)) << name;
      }
    }
  }
}

TEST(CreepLaw, NothingWithoutContact) {
  for (const std::string& name : CreepLawNames()) {
    const auto law = Law(name);
    for (const CreepInput& in : {CreepInput{}, CreepInput{1e-3, 1e-3, 0, 0.1, 0.1, 1, 1, 0.3},
                                 CreepInput{1e-3, 1e-3, 1e4, 0.1, 0.1, 1, 1, 0},
                                 CreepInput{1e-3, 1e-3, 1e4, 0, 0, 0, 1, 0.3}}) {
      const CreepForce f = law->Calc(in);
      EXPECT_EQ(f.x, 0);
      EXPECT_EQ(f.y, 0);
      EXPECT_EQ(f.moment, 0);
    }
  }
}

TEST(CreepLaw, BadParametersAreNamed) {
  CreepLawParams p;
  p.method = "kalkr";
  auto law = CreateCreepLaw(p);
  ASSERT_FALSE(law.ok());
  EXPECT_NE(law.error().Line().find("kalker_table"), std::string::npos);
  p.method = "fastsim";
  p.fastsim_strips = 1;
  law = CreateCreepLaw(p);
  ASSERT_FALSE(law.ok());
  EXPECT_NE(law.error().Line().find("fastsim_strips"), std::string::npos);
  p.fastsim_strips = 40;
  p.material.poisson_ratio = 0.7;
  EXPECT_FALSE(CreateCreepLaw(p).ok());
}

class CreepTableCache : public testing::Test {
 protected:
  std::filesystem::path File() const { return folder_ / "creep_table_40x40_parabolic.bin"; }
  ScratchDir scratch_;
  const std::filesystem::path folder_ = scratch_.File("cache");  ///< not there yet
};

TEST_F(CreepTableCache, ComesBackWithTheSameBits) {
  EXPECT_TRUE(ReadCreepTable(folder_, kGrid).empty());
  ASSERT_TRUE(WriteCreepTable(folder_, kGrid, Built()));
  const CreepTable read = ReadCreepTable(folder_, kGrid);
  ASSERT_FALSE(read.empty());
  EXPECT_TRUE(std::equal(read.data().begin(), read.data().end(), Built().data().begin()));
  // Another grid or bound is another table.
  EXPECT_TRUE(ReadCreepTable(folder_, {40, 40, true}).empty());
  EXPECT_TRUE(ReadCreepTable(folder_, {20, 40, false}).empty());
  // Nothing is left beside it.
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(CreepTableCache, DamagedFilesAreIgnored) {
  ASSERT_TRUE(WriteCreepTable(folder_, kGrid, Built()));
  const auto size = std::filesystem::file_size(File());
  {
    std::fstream file(File(), std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(size / 2));
    file.put('x');
  }
  EXPECT_TRUE(ReadCreepTable(folder_, kGrid).empty());
  std::filesystem::resize_file(File(), size / 2);
  EXPECT_TRUE(ReadCreepTable(folder_, kGrid).empty());
  std::filesystem::resize_file(File(), 3);
  EXPECT_TRUE(ReadCreepTable(folder_, kGrid).empty());
  // A table with a right checksum and wrong numbers.
  std::vector<double> wrong(Built().data().begin(), Built().data().end());
  for (double& value : wrong) value *= 1.015;
  ASSERT_TRUE(WriteCreepTable(folder_, kGrid, CreepTable::FromData(wrong)));
  EXPECT_TRUE(ReadCreepTable(folder_, kGrid).empty());
  for (double& value : wrong) value *= (1 + 1e-7) / 1.015;
  ASSERT_TRUE(WriteCreepTable(folder_, kGrid, CreepTable::FromData(std::move(wrong))));
  EXPECT_TRUE(ReadCreepTable(folder_, kGrid).empty());
}

TEST_F(CreepTableCache, AFolderThatCannotBeIsNoFault) {
  std::ofstream(folder_.string()) << "a file, not a folder";
  EXPECT_FALSE(WriteCreepTable(folder_ / "phs", kGrid, Built()));
  EXPECT_TRUE(ReadCreepTable(folder_ / "phs", kGrid).empty());
}

TEST(CreepTable, ResultDoesNotDependOnThreads) {
  const FastsimParams small{6, 6, false};
  const CreepTable one = CreepTable::Build(small, 1);
  const CreepTable three = CreepTable::Build(small, 3);
  EXPECT_TRUE(std::equal(one.data().begin(), one.data().end(), three.data().begin()));
}

}  // namespace
}  // namespace phs::rail
