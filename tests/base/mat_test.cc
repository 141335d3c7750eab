// MATLAB files written here by matio in both formats.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <matio.h>

#include <fstream>
#include <memory>

#include "base/table.h"
#include "scratch_dir.h"

namespace phs {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

using VarPtr = std::unique_ptr<matvar_t, void (*)(matvar_t*)>;

VarPtr Vector(const char* name, std::vector<double> values, bool as_row = false) {
  size_t dims[2] = {as_row ? 1 : values.size(), as_row ? values.size() : 1};
  return {Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims, values.data(), 0), &Mat_VarFree};
}

class MatFile : public ::testing::TestWithParam<mat_ft> {
 protected:
  void Write(const std::vector<matvar_t*>& variables) {
    mat_t* file = Mat_CreateVer(path().c_str(), nullptr, GetParam());
    ASSERT_NE(file, nullptr);
    for (matvar_t* variable : variables) {
      ASSERT_EQ(Mat_VarWrite(file, variable, MAT_COMPRESSION_ZLIB), 0);
    }
    Mat_Close(file);
  }
  std::string path() const { return scratch_.File("rig.mat"); }
  ScratchDir scratch_;
};

TEST_P(MatFile, VectorsAndStructFieldsAreChannels) {
  const VarPtr t = Vector("t_s", {0, 0.5, 1});
  const VarPtr x = Vector("x_m", {3, 2, 1}, true);
  const VarPtr scalar = Vector("sample_rate_Hz", {1000});
  size_t one[2] = {1, 1};
  const char* fields[] = {"x_m", "force_N"};
  const VarPtr record(Mat_VarCreateStruct("run", 2, one, fields, 2), &Mat_VarFree);
  Mat_VarSetStructFieldByName(record.get(), "x_m", 0, Vector("x_m", {7, 8, 9}).release());
  Mat_VarSetStructFieldByName(record.get(), "force_N", 0, Vector("force_N", {4, 5, 6}).release());
  char words[] = "abc";
  size_t text_dims[2] = {1, 3};
  const VarPtr text(Mat_VarCreate("note", MAT_C_CHAR, MAT_T_UTF8, 2, text_dims, words, 0),
                    &Mat_VarFree);
  Write({t.get(), x.get(), scalar.get(), record.get(), text.get()});
  auto table = ReadTable(path());
  ASSERT_TRUE(table.ok()) << table.error().Line();
  // The formats keep variables in different orders; the struct's x_m carries the struct's name.
  EXPECT_THAT(table.value().names, UnorderedElementsAre("t_s", "x_m", "run.x_m", "force_N"));
  EXPECT_THAT(table.value().Column("t_s").value(), ElementsAre(0, 0.5, 1));
  EXPECT_THAT(table.value().Column("force_N").value(), ElementsAre(4, 5, 6));
  EXPECT_EQ(table.value().num_rows(), 3);
  EXPECT_EQ(table.value().line.size(), 3u);
}

TEST_P(MatFile, IntegersAndSinglesAreConverted) {
  int16_t counts[] = {-3, 0, 32767};
  float forces[] = {0.5f, -1.25f, 3.0f};
  int64_t big[] = {1, 2, 1LL << 40};
  size_t dims[2] = {3, 1};
  const VarPtr a(Mat_VarCreate("a", MAT_C_INT16, MAT_T_INT16, 2, dims, counts, 0), &Mat_VarFree);
  const VarPtr b(Mat_VarCreate("b", MAT_C_SINGLE, MAT_T_SINGLE, 2, dims, forces, 0), &Mat_VarFree);
  const VarPtr c(Mat_VarCreate("c", MAT_C_INT64, MAT_T_INT64, 2, dims, big, 0), &Mat_VarFree);
  Write({a.get(), b.get(), c.get()});
  auto table = ReadMat(path());
  ASSERT_TRUE(table.ok()) << table.error().Line();
  EXPECT_THAT(table.value().Column("a").value(), ElementsAre(-3, 0, 32767));
  EXPECT_THAT(table.value().Column("b").value(), ElementsAre(0.5, -1.25, 3));
  EXPECT_THAT(table.value().Column("c").value(), ElementsAre(1, 2, 1099511627776.0));
}

TEST_P(MatFile, Messages) {
  Write({Vector("t_s", {0, 1, 2}).get(), Vector("x_m", {0, 1}).get()});
  EXPECT_THAT(ReadMat(path()).error().Line(), HasSubstr("' has "));
  EXPECT_THAT(ReadMat(path()).error().Line(), HasSubstr("allowed: channels of equal length"));
  Write({Vector("rate_Hz", {5}).get()});
  EXPECT_EQ(ReadMat(path()).error().Line(),
            path() + ": holds no numeric vectors; allowed: one per channel");
  std::ofstream(path(), std::ios::trunc) << "no MATLAB file at all";
  EXPECT_EQ(ReadMat(path()).error().Line(),
            path() + ": cannot be read; allowed: a MATLAB file (v5 or v7.3)");
}

TEST(MatFileSize, ADamagedSizeEndsBeforeMemoryIsAskedFor) {
  const ScratchDir scratch;
  const std::string path = scratch.File("rig.mat");
  {
    const std::unique_ptr<mat_t, int (*)(mat_t*)> file(
        Mat_CreateVer(path.c_str(), nullptr, MAT_FT_MAT5), &Mat_Close);
    Mat_VarWrite(file.get(), Vector("x_m", {1, 2, 3}).get(), MAT_COMPRESSION_NONE);
  }
  std::fstream bytes(path, std::ios::in | std::ios::out | std::ios::binary);
  bytes.seekp(128 + 8 + 16 + 8);  // header, tag, array flags, tag of the dimensions
  const int32_t rows = 2000000000;
  bytes.write(reinterpret_cast<const char*>(&rows), sizeof rows);
  bytes.close();
  EXPECT_THAT(ReadMat(path).error().Line(), HasSubstr("holds a variable that is longer than"));
}

// Every length in the file, one after the other: of the variable, its flags, dimensions, name, values.
TEST(MatFileSize, ADamagedLengthEndsBeforeMemoryIsAskedFor) {
  const ScratchDir scratch;
  for (const int at : {132, 140, 156, 172}) {
    const std::string path = scratch.File("rig.mat");
    {
      const std::unique_ptr<mat_t, int (*)(mat_t*)> file(
          Mat_CreateVer(path.c_str(), nullptr, MAT_FT_MAT5), &Mat_Close);
      Mat_VarWrite(file.get(), Vector("x_of_the_piston_m", {1, 2, 3}).get(), MAT_COMPRESSION_NONE);
    }
    ASSERT_TRUE(ReadMat(path).ok());
    std::fstream bytes(path, std::ios::in | std::ios::out | std::ios::binary);
    bytes.seekp(at);
    const int32_t length = 2000000000;
    bytes.write(reinterpret_cast<const char*>(&length), sizeof length);
    bytes.close();
    EXPECT_EQ(ReadMat(path).error().Line(),
              path +
                  ": holds a variable that is longer than the file; allowed: a MATLAB file (v5 or "
                  "v7.3); the file is damaged: save it again")
        << at;
  }
}

INSTANTIATE_TEST_SUITE_P(Versions, MatFile, ::testing::Values(MAT_FT_MAT5, MAT_FT_MAT73));

}  // namespace
}  // namespace phs
