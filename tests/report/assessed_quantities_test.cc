// Every quantity that is assessed has its row in the tables and its name in docs/results.md.
#include "report/assessed_quantities.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "analysis/en14363.h"
#include "phs_places.h"

namespace phs::report {
namespace {

/// Names of all that AssessWheelset gives, instability included.
std::set<std::string> Assessed() {
  const size_t n = 5000;
  analysis::WheelsetForces f;
  for (size_t i = 0; i < n; ++i) f.distance_m.push_back(0.04 * static_cast<double>(i));
  f.y_left_N = f.y_right_N = std::vector<double>(n, 1e3);
  f.q_left_N = f.q_right_N = std::vector<double>(n, 1e5);
  const auto rows = analysis::AssessWheelset(f, {0.002, 1e5, 550, 1, 5});
  std::set<std::string> names;
  for (const auto& row : rows.value()) names.insert(row.name);
  return names;
}

TEST(AssessedQuantities, EachHasItsRowInTheTables) {
  std::set<std::string> rows;
  for (const AssessedName& row : AssessedNames()) rows.insert(row.key);
  for (const std::string& name : Assessed()) {
    EXPECT_EQ(rows.count(name), 1u)
        << name << ": give it a row in src/report/assessed_quantities.cc";
  }
  EXPECT_EQ(rows.size(), Assessed().size()) << "a row of something that is not assessed";
}

TEST(AssessedQuantities, EachStandsOnThePageOfResults) {
  std::ifstream file(PHS_SOURCE_DIR "/docs/results.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  for (const std::string& name : Assessed()) {
    EXPECT_NE(page.find("`" + name + "`"), std::string::npos)
        << name << ": say in docs/results.md, `assessment`, what it is";
  }
}

TEST(AssessedQuantities, LabelsFitTheirColumn) {
  for (const AssessedName& row : AssessedNames()) {
    EXPECT_LT(std::string(row.label).size(), 30u) << row.label;
  }
}

}  // namespace
}  // namespace phs::report
