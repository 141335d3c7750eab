// MJCF files that hold nothing.
#include "vehicle/mjcf_document.h"

#include <gmock/gmock.h>

#include "tests/base/scratch_dir.h"

namespace phs::vehicle {
namespace {

using testing::HasSubstr;

TEST(MjcfDocumentTest, AFileWithoutAnElementIsRefused) {
  const ScratchDir scratch;
  const std::string empty = scratch.Write("empty.xml", "<![CDATA[<mujoco/>]]>");
  EXPECT_EQ(ReadMjcf(empty).error().Line(),
            empty + ": has no element; allowed: a readable MJCF file");
  const std::string outer =
      scratch.Write("outer.xml", "<mujoco><include file=\"empty.xml\"/></mujoco>");
  EXPECT_THAT(ReadMjcf(outer).error().Line(), HasSubstr("empty.xml: has no element"));
}

}  // namespace
}  // namespace phs::vehicle
