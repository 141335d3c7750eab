// The table of creep laws: names that cannot be mistaken, one make per name, and docs that list
// them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "phs_places.h"
#include "rail/creep_law.h"

namespace phs::rail {
namespace {

TEST(CreepLaws, EachIsMadeByItsName) {
  std::set<std::string> names;
  for (const CreepLawRow& row : CreepLaws()) {
    CreepLawParams params;
    params.method = row.name;
    params.use_disk_cache = false;
    const auto law = CreateCreepLaw(params);
    ASSERT_TRUE(law.ok()) << row.name;
    EXPECT_EQ(law.value()->name(), row.name);
    EXPECT_TRUE(names.insert(row.name).second) << row.name << " stands twice";
    EXPECT_EQ(row.name.find(':'), std::string::npos);
  }
}

TEST(CreepLaws, AnOptionIsReadOrRefusedAsItsRowSays) {
  int with_option = 0;
  for (const CreepLawRow& row : CreepLaws()) {
    CreepLawParams before;
    before.method = "none of them";
    CreepLawParams params = before;
    const Status empty = ChooseCreepLaw(row.name + ":", &params);
    ASSERT_FALSE(empty.ok());
    EXPECT_EQ(params.method, before.method) << "changed by a refused option";
    EXPECT_THAT(empty.error().Line(), testing::HasSubstr("fastsim:N or kalker_table:N with N"));
    ASSERT_TRUE(ChooseCreepLaw(row.name, &params).ok());
    EXPECT_EQ(params.method, row.name);
    with_option += row.option.read != nullptr;
  }
  EXPECT_GE(with_option, 2);
  CreepLawParams params;
  ASSERT_TRUE(ChooseCreepLaw("fastsim:20", &params).ok());
  EXPECT_EQ(params.fastsim_strips, 20);
  EXPECT_EQ(params.fastsim_slices, 20);
}

TEST(CreepLaws, TheDocsListEveryOne) {
  std::ifstream file(PHS_SOURCE_DIR "/docs/physics_rail.md");
  std::stringstream docs;
  docs << file.rdbuf();
  for (const CreepLawRow& row : CreepLaws()) {
    EXPECT_THAT(docs.str(), testing::HasSubstr("**" + row.name + "** (" + row.text + ")"));
  }
}

}  // namespace
}  // namespace phs::rail
