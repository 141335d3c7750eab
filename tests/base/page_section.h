// Parts of a page in docs/ that are made from tables of the program: they stand between
//   <!-- NAME: written by scripts/write_pages -->   and   <!-- /NAME -->
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "phs_places.h"

namespace phs {

/// The part `name` of docs/`page` says what `expected` says; with PHS_WRITE_DOCS it is made to.
inline void ExpectPageSection(const std::string& page, const std::string& name,
                              const std::string& expected) {
  SCOPED_TRACE(page + ": " + name);
  const std::string path = std::string(PHS_SOURCE_DIR) + "/docs/" + page;
  const std::string begin = "<!-- " + name + ": written by scripts/write_pages -->\n";
  const std::string end = "<!-- /" + name + " -->";
  std::ifstream file(path);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  ASSERT_NE(text.find(begin), std::string::npos);
  const size_t from = text.find(begin) + begin.size();
  ASSERT_NE(text.find(end, from), std::string::npos);
  if (std::getenv("PHS_WRITE_DOCS") != nullptr) {
    text.replace(from, text.find(end, from) - from, expected);
    std::ofstream(path) << text;
  }
  EXPECT_EQ(text.substr(from, text.find(end, from) - from), expected)
      << "write it anew: scripts/write_pages";
}

}  // namespace phs
