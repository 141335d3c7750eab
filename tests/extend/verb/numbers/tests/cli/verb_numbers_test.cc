// phs numbers: each number by name with its value, and a model that is not there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/base/execute.h"

namespace phs {
namespace {

using testing::HasSubstr;

TEST(VerbNumbers, NamesEachNumberWithItsValueAndUnit) {
  const Output out = ExecutePhs("numbers bo_bo");
  EXPECT_EQ(out.code, 0);
  EXPECT_THAT(out.text, HasSubstr("\n1.bore_m = 0.1 m\n"));
  EXPECT_THAT(out.text, HasSubstr("\nL4.reservoir.volume_m3 = "));
  const Output none = ExecutePhs("numbers bo_bb");
  EXPECT_EQ(none.code, 3);
  EXPECT_THAT(none.text, HasSubstr("did you mean"));
}

}  // namespace
}  // namespace phs
