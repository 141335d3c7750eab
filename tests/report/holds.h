// Looks for words in a page; on failure only the words are printed, not the page.
#pragma once

#include <gtest/gtest.h>

#include <string>

namespace phs::report::testing {

inline ::testing::AssertionResult Holds(const std::string& page, const std::string& words) {
  if (page.find(words) != std::string::npos) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "the page lacks: " << words;
}
inline ::testing::AssertionResult Lacks(const std::string& page, const std::string& words) {
  if (page.find(words) == std::string::npos) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "the page holds: " << words;
}

}  // namespace phs::report::testing
