#include "base/table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <fstream>

#include "base/result_dir.h"
#include "scratch_dir.h"

namespace phs {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Csv, ReadsNamedColumns) {
  auto table =
      ParseCsv("# rig 2\nt_s, x_m ,note\n0,1e-3,start\n\n 0.5 ,+2.5,\"a, \"\"b\"\"\"\n", "d");
  ASSERT_TRUE(table.ok()) << table.error().Line();
  EXPECT_THAT(table.value().names, ElementsAre("t_s", "x_m", "note"));
  EXPECT_THAT(table.value().columns[0], ElementsAre(0, 0.5));
  EXPECT_THAT(table.value().Column("x_m").value(), ElementsAre(1e-3, 2.5));
  EXPECT_TRUE(std::isnan(table.value().columns[2][0]));
  EXPECT_THAT(table.value().text[2], ElementsAre("start", "a, \"b\""));
  EXPECT_THAT(table.value().line, ElementsAre(3, 5));
  EXPECT_EQ(table.value().num_rows(), 2);
  EXPECT_EQ(table.value().num_columns(), 3);
}

TEST(Csv, LineEndsOfAnySystemAndByteOrderMark) {
  for (const char* text : {"a,b\n1,2\n3,4", "a,b\r\n1,2\r\n3,4\r\n", "a,b\r1,2\r3,4\r",
                           "\xEF\xBB\xBF"
                           "a,b\n1,2\n3,4\n"}) {
    auto table = ParseCsv(text, "d");
    ASSERT_TRUE(table.ok()) << table.error().Line();
    EXPECT_THAT(table.value().names, ElementsAre("a", "b"));
    EXPECT_THAT(table.value().columns[1], ElementsAre(2, 4));
    EXPECT_THAT(table.value().line, ElementsAre(2, 3));
  }
}

TEST(Csv, WhatIsNoFiniteNumberIsNaNAndKeptAsText) {
  auto table = ParseCsv("a\nnan\ninf\nx\n\"\"\n1e999\n-1e308\n", "d");
  ASSERT_TRUE(table.ok());
  for (double value : table.value().columns[0]) EXPECT_TRUE(std::isnan(value));
  EXPECT_THAT(table.value().text[0], ElementsAre("nan", "inf", "x", "", "1e999", "-1e308"));
}

TEST(Csv, HundredsOfThousandsOfColumns) {
  std::string text;
  for (int i = 0; i < 400000; ++i) text += (i == 0 ? "c" : ",c") + std::to_string(i);
  const std::string twice = text + ",c7\n1\n";
  text += "\n" + std::string(799999, ',');
  for (size_t i = text.size() - 799999; i < text.size(); i += 2) text[i] = '1';
  const auto table = ParseCsv(text + "\n", "wide.csv");
  ASSERT_TRUE(table.ok()) << table.error().Line();
  EXPECT_EQ(table.value().num_columns(), 400000);
  EXPECT_THAT(ParseCsv(twice, "wide.csv").error().Line(), HasSubstr("'c7' is given twice"));
}

std::string CsvError(const std::string& text) {
  auto table = ParseCsv(text, "d.csv");
  return table.ok() ? "no error" : table.error().Line();
}

TEST(Csv, Messages) {
  EXPECT_EQ(CsvError(""), "d.csv: is empty; allowed: a header row and rows of numbers");
  EXPECT_EQ(CsvError("# only\n"), "d.csv: is empty; allowed: a header row and rows of numbers");
  EXPECT_EQ(CsvError("a,b\n"), "d.csv: has a header but no rows; allowed: at least one row");
  EXPECT_EQ(CsvError("a,b\n1,2\n3\n"), "d.csv:3: has 1 cells; allowed: 2 as in the header");
  EXPECT_EQ(CsvError("a,,b\n1,2,3\n"),
            "d.csv:1: a column has no name; allowed: a header row of names");
  EXPECT_EQ(CsvError("a,a\n1,2\n"), "d.csv:1: column 'a' is given twice; allowed: each name once");
  EXPECT_EQ(
      CsvError("a;b\n1;2\n"),
      "d.csv:1: is separated by semicolons or tabs; allowed: commas, and '.' as decimal mark; "
      "save it as comma separated values");
  EXPECT_EQ(CsvError("0,1.5\n1,2\n"),
            "d.csv:1: holds numbers, where the names of the columns belong; allowed: a header row "
            "of names with their units, as t_s,load_cell_N; add one");
  for (const std::string& utf16 : {std::string("\xFF\xFE") + "a,b", std::string("a\0,\0b\0", 6)}) {
    EXPECT_THAT(CsvError(utf16), HasSubstr("d.csv: is no plain text (UTF-16, or binary)"));
  }
  EXPECT_THAT(CsvError("a,b\n1,\"2\n"), HasSubstr("d.csv:2: broken CSV"));
  EXPECT_THAT(CsvError("a,b\n1,2\"3\n"), HasSubstr("quotes closed on the same line"));
  EXPECT_EQ(ParseCsv("piston_m,t_s\n1,2\n", "d.csv").value().Column("piston").error().Line(),
            "d.csv: has no column 'piston'; allowed: piston_m, t_s; did you mean 'piston_m'?");
  EXPECT_THAT(ReadTable("/nonexistent/d.csv").error().Line(),
              HasSubstr("cannot be read (No such file or directory)"));
}

RC_GTEST_PROP(Csv, WrittenNumbersReadBackToTheBit, (std::vector<double> values)) {
  RC_PRE(!values.empty());
  for (double value : values) RC_PRE(std::isfinite(value));
  const ScratchDir scratch;
  std::vector<double> reversed(values.rbegin(), values.rend());
  RC_ASSERT(WriteCsv(scratch.File("d.csv"), {"a", "b"}, {values, reversed}).ok());
  auto table = ReadTable(scratch.File("d.csv"));
  RC_ASSERT(table.ok());
  RC_ASSERT(table.value().columns[0] == values);
  RC_ASSERT(table.value().columns[1] == reversed);
}

RC_GTEST_PROP(Csv, AnyTextIsReadOrRefused, (const std::string& text)) {
  auto table = ParseCsv("a,b\n" + text, "d.csv");
  if (!table.ok()) return;
  for (const auto& column : table.value().columns) {
    RC_ASSERT(static_cast<int>(column.size()) == table.value().num_rows());
  }
}

TEST(Csv, UnequalColumnsAreABrokenPromise) {
  EXPECT_THROW((void)WriteCsv("never", {"a", "b"}, {{1}, {1, 2}}), std::logic_error);
  EXPECT_THROW((void)WriteCsv("never", {"a"}, {}), std::logic_error);
}

}  // namespace
}  // namespace phs
