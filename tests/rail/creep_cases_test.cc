#include "rail/creep_cases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "creep_reference.h"
#include "tests/base/scratch_dir.h"

namespace phs::rail {
namespace {

const char kHeader[] = "label,a_mm,b_mm,FN_N,mu,G_MPa,nu,xi,eta,phi_rad_per_mm\n";

TEST(CreepCases, LinearCaseInReferenceUnitsAndSigns) {
  const auto t = ParseCsv(std::string(kHeader) + "one,6,6,100000,0.3,82000,0.25,1e-5,0,0\n", "c");
  ASSERT_TRUE(t.ok());
  const auto out = CalcCreepCases(t.value(), "linear");
  ASSERT_TRUE(out.ok());
  EXPECT_NEAR(Cell(out.value(), "Fx_N", 0), -82000 * 36 * 4.12 * 1e-5, 1e-3);  // Kalker 1990
  EXPECT_EQ(out.value().text[0][0], "one");
}

TEST(CreepCases, EveryReferenceRowIsTheLawItself) {
  const Table t = ReferenceTable("hertz_creep_table.csv");
  CreepLawParams params;
  params.use_disk_cache = false;
  for (const std::string& method : CreepLawNames()) {
    params.method = method;
    const auto out = CalcCreepCases(t, params);
    ASSERT_TRUE(out.ok()) << out.error().Line();
    const auto law = Law(method);
    for (int i = 0; i < t.num_rows(); i += 7) {
      const CreepForce f = law->Calc(HertzCase(t, i));
      EXPECT_NEAR(Cell(out.value(), "Fx_N", i), f.x, 1e-6);
      EXPECT_NEAR(Cell(out.value(), "Mz_Nmm", i), f.moment * 1e3, 1e-6);
    }
    EXPECT_EQ(out.value().num_columns(), t.num_columns() + 3);
  }
}

std::string CasesError(const std::string& text) {
  const auto t = ParseCsv(text, "cases.csv");
  if (!t.ok()) return t.error().Line();
  const auto out = CalcCreepCases(t.value(), "polach");
  return out.ok() ? "" : out.error().Line();
}

TEST(CreepCases, BadCellsAreNamedWithTheirLine) {
  const std::string good = "x,6,6,1e5,0.3,82000,0.28,0,0,0\n";
  EXPECT_EQ(CasesError(kHeader + good), "");
  std::string line = CasesError(kHeader + good + "y,-1,6,1e5,0.3,82000,0.28,0,0,0\n");
  EXPECT_NE(line.find("cases.csv:3"), std::string::npos) << line;
  EXPECT_NE(line.find("a_mm"), std::string::npos) << line;
  line = CasesError(kHeader + std::string("y,6,6,heavy,0.3,82000,0.28,0,0,0\n"));
  EXPECT_NE(line.find("'heavy'"), std::string::npos) << line;
  line = CasesError(kHeader + std::string("y,6,6,1e5,0.3,82e9,0.28,0,0,0\n"));
  EXPECT_NE(line.find("G_MPa"), std::string::npos) << line;
  line =
      CasesError("a_mm,b_mm,FN_N,mu,G_MPa,nu,xi,eta,phi_rad_per_m\n6,6,1e5,0.3,82000,0.28,0,0,0\n");
  EXPECT_NE(line.find("phi_rad_per_mm"), std::string::npos) << line;
}

TEST(CreepCases, WrittenTableReadsBack) {
  const auto t = ParseCsv(std::string(kHeader) + "\"a, b\",6,6,1e5,0.3,82000,0.28,1e-3,0,0\n", "c");
  ASSERT_TRUE(t.ok());
  const auto out = CalcCreepCases(t.value(), "fastsim");
  ASSERT_TRUE(out.ok());
  const std::string path = ScratchFile("creep_cases.csv");
  ASSERT_TRUE(WriteCaseTable(path, out.value()).ok());
  const auto back = ReadCsv(path);
  std::filesystem::remove(path);
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(back.value().text[0][0], "a, b");
  EXPECT_EQ(Cell(back.value(), "Fx_N", 0), Cell(out.value(), "Fx_N", 0));
}

}  // namespace
}  // namespace phs::rail
