#include "report/shown_paths.h"

#include <gtest/gtest.h>

namespace phs::report {
namespace {

TEST(ShownPaths, FoldersOfTheMachineAreLeftAway) {
  const struct {
    const char* text;
    const char* shown;
  } kTexts[] = {
      {"/home/ann/phs/models/profiles/S1002.prw", "models/profiles/S1002.prw"},
      {"phs simulate /home/ann/s.yaml --out=/tmp/out", "phs simulate s.yaml --out=out"},
      {"\"rail\": \"/usr/share/phs/bogie_xml/phs.xml\",", "\"rail\": \"bogie_xml/phs.xml\","},
      {"There is no replay: /tmp/r/summary.json:3: broken",
       "There is no replay: summary.json:3: broken"},
      {"phs.run('/home/ann/s.yaml', out='/tmp/r/')", "phs.run('s.yaml', out='r/')"},
      {"runs/s.yaml and ../models/a.yaml", "runs/s.yaml and ../models/a.yaml"},
      {"Y/Q [kN/m], conventional / own, 1/2", "Y/Q [kN/m], conventional / own, 1/2"}};
  for (const auto& [text, shown] : kTexts) EXPECT_EQ(WithoutFolders(text), shown);
}

}  // namespace
}  // namespace phs::report
