// phs effects: the catalogue, one effect, and one that is not there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/base/execute.h"

namespace phs {
namespace {

using testing::HasSubstr;

TEST(VerbEffects, ListsTheCatalogueAndOneEffectWithItsNumbers) {
  const Output all = ExecutePhs("effects");
  EXPECT_EQ(all.code, 0);
  EXPECT_GT(std::count(all.text.begin(), all.text.end(), '\n'), 30);
  EXPECT_THAT(ExecutePhs("effects backlash").text, HasSubstr("  gap_m = "));
  const Output none = ExecutePhs("effects backlas");
  EXPECT_EQ(none.code, 3);
  EXPECT_THAT(none.text, HasSubstr("did you mean 'backlash'?"));
}

}  // namespace
}  // namespace phs
