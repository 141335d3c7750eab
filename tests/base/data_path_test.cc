#include "base/data_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "scratch_dir.h"

namespace phs {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::HasSubstr;

/// Works in a scratch directory and gives the old place back.
class DataPath : public ::testing::Test {
 protected:
  void SetUp() override { fs::current_path(scratch_.path()); }
  void TearDown() override {
    fs::current_path(before_);
    unsetenv("PHS_DATA");
  }
  void Make(const std::string& file) {
    fs::create_directories(fs::path(scratch_.File(file)).parent_path());
    std::ofstream(scratch_.File(file)) << "x";
  }
  ScratchDir scratch_;
  fs::path before_ = fs::current_path();
};

TEST_F(DataPath, FindsTheProductsOwnDataFromAnywhere) {
  auto bogie = FindData("bogie", "bogie_xml", "phs", {".xml"});
  ASSERT_TRUE(bogie.ok()) << bogie.error().Line();
  EXPECT_TRUE(fs::exists(bogie.value()));
  EXPECT_THAT(ListData("bogie_xml", {".xml"}), Contains("rigid_link"));
}

TEST_F(DataPath, CurrentDirectoryThenPhsDataThenTheProduct) {
  Make("own/bogie_xml/phs.xml");
  setenv("PHS_DATA", scratch_.File("own").c_str(), 1);
  EXPECT_EQ(FindData("bogie", "bogie_xml", "phs", {".xml"}).value(),
            scratch_.File("own/bogie_xml/phs.xml"));
  Make("bogie_xml/phs.xml");
  EXPECT_EQ(FindData("bogie", "bogie_xml", "phs", {".xml"}).value(), "bogie_xml/phs.xml");
  Make("mine.xml");
  EXPECT_EQ(FindData("bogie", "bogie_xml", "mine.xml", {".xml"}).value(), "mine.xml");
  EXPECT_EQ(FindData("bogie", "bogie_xml", scratch_.File("mine.xml"), {".xml"}).value(),
            scratch_.File("mine.xml"));
  EXPECT_EQ(FindData("bogie", "bogie_xml", "phs.xml", {".xml"}).value(), "bogie_xml/phs.xml");
}

TEST_F(DataPath, AFileCalledAsAModelDoesNotHideTheModel) {
  Make("phs");  // the program itself, say
  EXPECT_TRUE(FindData("bogie", "bogie_xml", "phs", {".xml"}).value().ends_with("phs.xml"));
  EXPECT_EQ(FindData("bogie", "bogie_xml", "./phs", {".xml"}).value(), "./phs");
  Make("unknown_name");
  EXPECT_EQ(FindData("bogie", "bogie_xml", "unknown_name", {".xml"}).value(), "unknown_name");
}

TEST_F(DataPath, MessageListsNamesAndTheNearest) {
  const std::string line = FindData("bogie", "bogie_xml", "rigit_link", {".xml"}).error().Line();
  EXPECT_THAT(line, HasSubstr("bogie 'rigit_link': was not found; allowed: a path, or one of: "));
  EXPECT_THAT(line, HasSubstr("soft_link"));
  EXPECT_THAT(line, HasSubstr("did you mean 'rigid_link'?"));
  EXPECT_THAT(FindData("bogie", "bogie_xml", "", {".xml"}).error().Line(),
              HasSubstr("bogie '': was not found"));
  EXPECT_EQ(FindData("thing", "no_such_folder", "abc", {".x"}).error().Line(),
            "thing 'abc': was not found; allowed: a path, or one of: (none installed); check the "
            "name");
  EXPECT_FALSE(FindData("bogie", "bogie_xml", scratch_.path(), {".xml"}).ok()) << "a directory";
}

}  // namespace
}  // namespace phs
