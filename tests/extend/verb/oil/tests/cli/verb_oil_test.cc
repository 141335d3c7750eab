// phs oil: the grade's own definition, and a temperature out of range.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/base/execute.h"

namespace phs {
namespace {

TEST(VerbOil, SaysTheViscosityThatTheGradeIsNamedAfter) {
  const Output out = ExecutePhs("oil --temperature 40,100");
  EXPECT_EQ(out.code, 0);
  EXPECT_THAT(out.text, testing::HasSubstr("\n40,68.00,"));  // ISO VG 68
  EXPECT_THAT(out.text, testing::HasSubstr("\n100,8.70,"));
  EXPECT_EQ(ExecutePhs("oil --temperature 400").code, 2);
}

}  // namespace
}  // namespace phs
