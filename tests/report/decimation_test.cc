#include "report/decimation.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace phs::report {
namespace {

std::vector<double> Ramp(int rows, double step) {
  std::vector<double> x(rows);
  for (int i = 0; i < rows; ++i) x[i] = step * i;
  return x;
}

double Least(const std::vector<double>& values) {
  double least = std::numeric_limits<double>::infinity();
  for (double value : values) {
    if (std::isfinite(value)) least = std::min(least, value);
  }
  return least;
}

double Greatest(const std::vector<double>& values) {
  double greatest = -std::numeric_limits<double>::infinity();
  for (double value : values) {
    if (std::isfinite(value)) greatest = std::max(greatest, value);
  }
  return greatest;
}

/// Inverse of Base64, written for the test alone.
std::vector<unsigned> Decode(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned> bytes;
  unsigned bits = 0;
  int count = 0;
  for (char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<unsigned>(letters.find(c));
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes.push_back(bits >> count & 255);
    }
  }
  return bytes;
}

TEST(PutOnGrid, KeepsASingleSpike) {
  const std::vector<double> x = Ramp(100000, 0.01);
  std::vector<double> y(x.size(), 1.0);
  y[54321] = 7.5;
  y[70007] = -3.25;
  const std::vector<double> drawn = PutOnGrid(x, y, {0, x.back(), 2000});
  EXPECT_EQ(Greatest(drawn), 7.5);
  EXPECT_EQ(Least(drawn), -3.25);
  const auto at = std::max_element(drawn.begin(), drawn.end()) - drawn.begin();
  EXPECT_NEAR(Grid({0, x.back(), 2000}).At(static_cast<int>(at)), 543.21, x.back() / 1000);
}

TEST(PutOnGrid, StraightLineStaysStraight) {
  const std::vector<double> x = Ramp(12345, 0.02);
  std::vector<double> y;
  for (double at : x) y.push_back(3 - 2 * at);
  const Grid grid{0, x.back(), 1600};
  const std::vector<double> drawn = PutOnGrid(x, y, grid);
  for (int i = 0; i < grid.points; ++i) EXPECT_NEAR(drawn[i], 3 - 2 * grid.At(i), 1e-9);
}

TEST(PutOnGrid, NothingOutsideTheRecordedRange) {
  const std::vector<double> x = Ramp(1000, 0.1);  // up to 99.9
  const Grid grid{0, 200, 100};
  const std::vector<double> drawn = PutOnGrid(x, x, grid);
  EXPECT_TRUE(std::isfinite(drawn[49]));
  for (int i = 50; i < 100; ++i) EXPECT_TRUE(std::isnan(drawn[i])) << i;
}

TEST(PutOnGrid, RowsThatStandStillOrAreMissingDoNoHarm) {
  const std::vector<double> x = {0, 1, 1, 0.5, 2, 3, 4};
  const double none = std::nan("");
  const std::vector<double> drawn = PutOnGrid(x, {0, 1, 9, 9, 2, none, 4}, {0, 4, 8});
  EXPECT_DOUBLE_EQ(drawn[1], 0.75);
  EXPECT_DOUBLE_EQ(drawn[3], 1.75);
  EXPECT_TRUE(std::isnan(drawn[5]));
}

RC_GTEST_PROP(PutOnGrid, ExtremesOfAnyCurveSurvive, ()) {
  const int rows = *rc::gen::inRange(3000, 9000);
  const auto seed = *rc::gen::arbitrary<unsigned>();
  std::vector<double> x(rows);
  std::vector<double> y(rows);
  unsigned state = seed | 1u;
  double at = 0;
  for (int i = 0; i < rows; ++i) {
    state = state * 1664525u + 1013904223u;
    at += 1e-3 + (state >> 16) * 1e-6;
    x[i] = at;
    y[i] = std::sin(0.01 * i) + (state >> 20) * 1e-3;
  }
  const std::vector<double> drawn = PutOnGrid(x, y, {x.front(), x.back(), 200});
  RC_ASSERT(Greatest(drawn) == Greatest(y));
  RC_ASSERT(Least(drawn) == Least(y));
}

TEST(Base64, VectorsOfRfc4648) {
  const auto of = [](const std::string& text) {
    return Base64(std::vector<unsigned char>(text.begin(), text.end()));
  };
  EXPECT_EQ(of(""), "");
  EXPECT_EQ(of("f"), "Zg==");
  EXPECT_EQ(of("fo"), "Zm8=");
  EXPECT_EQ(of("foo"), "Zm9v");
  EXPECT_EQ(of("foobar"), "Zm9vYmFy");
}

TEST(Pack, ComesBackWithinHalfAStep) {
  const std::vector<double> values = {-12.5, 0, std::nan(""), 3.14159, 88.25};
  const PackedValues packed = Pack(values);
  EXPECT_EQ(packed.least, -12.5);
  EXPECT_EQ(packed.greatest, 88.25);
  const std::vector<unsigned> bytes = Decode(packed.base64);
  ASSERT_EQ(bytes.size(), 2 * values.size());
  const double height = (packed.greatest - packed.least) / 65534;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const unsigned step = bytes[2 * i] + 256 * bytes[2 * i + 1];
    if (std::isnan(values[i])) {
      EXPECT_EQ(step, 65535u);
    } else {
      EXPECT_NEAR(packed.least + step * height, values[i], 0.5 * height);
    }
  }
}

TEST(Pack, AConstantAndNothingAtAll) {
  EXPECT_EQ(Pack({4, 4}).base64, "AAAAAA==");
  EXPECT_EQ(Pack({4, 4}).least, 4);
  EXPECT_EQ(Pack({std::nan("")}).base64, "//8=");
}

}  // namespace
}  // namespace phs::report
