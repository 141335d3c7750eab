#include "base/words.h"

#include <gtest/gtest.h>

#include "base/numbers.h"

namespace phs {
namespace {

TEST(NearestWord, FindsWhatWasMeant) {
  const std::vector<std::string> bogies = {"phs", "rigid_link", "soft_link"};
  EXPECT_EQ(NearestWord("psh", bogies), "phs");
  EXPECT_EQ(NearestWord("PHS", bogies), "phs");
  EXPECT_EQ(NearestWord("soft-link", bogies), "soft_link");
  EXPECT_EQ(NearestWord("rigid", bogies), "rigid_link");
  EXPECT_EQ(NearestWord("locomotive", bogies), "");
  EXPECT_EQ(NearestWord("", bogies), "");
  EXPECT_EQ(NearestWord("phs", {}), "");
  EXPECT_EQ(NearestWord(std::string(100000, 'x'), {std::string(100000, 'y')}), "");
}

TEST(Words, ListsAndQuotes) {
  EXPECT_EQ(JoinWords({"a", "b"}), "a, b");
  EXPECT_EQ(JoinWords({}), "");
  EXPECT_EQ(Quoted("a"), "'a'");
  EXPECT_EQ(Quoted(std::string(70, 'a')), "'" + std::string(60, 'a') + "…'");
  EXPECT_EQ(DidYouMean("xyz", {"abc"}, "check the name"), "check the name");
}

TEST(Numbers, ShortestFormReadsBackExactly) {
  EXPECT_EQ(Shortest(0.1), "0.1");
  EXPECT_EQ(Shortest(1e-7), "1e-07");
  EXPECT_EQ(Shortest(-0.0), "-0");
  EXPECT_EQ(ParseNumber("0.1"), 0.1);
  EXPECT_EQ(ParseNumber("+3"), 3.0);
  EXPECT_EQ(ParseNumber("5e-324"), 5e-324);
  for (const char* text : {"", "+", "++1", "1 ", " 1", "1,5", "nan", "inf", "1e999", "0x1p3"}) {
    EXPECT_EQ(ParseNumber(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace phs
