// Long series made small enough for a page without losing their peaks.
//
// A curve y(x) with any number of rows is put on a uniform grid of `points` abscissae, two for each
// bucket of equal width w at a quarter and three quarters of it. Where the rows of a bucket go up
// and down, the two values are the bucket's smallest and largest row in the order in which they
// occur, so no peak is lost whatever the zoom; elsewhere they are the linear interpolation, so
// smooth curves stay smooth. The largest error in x is w.
#pragma once

#include <string>
#include <vector>

namespace phs::report {

/// Uniform abscissae begin + (i + 0.5) (end - begin) / points, i = 0 … points - 1.
struct Grid {
  double begin = 0;
  double end = 0;
  int points = 0;  ///< even, >= 2
  double At(int i) const { return begin + (i + 0.5) * (end - begin) / points; }
};

/// In another unit.
inline std::vector<double> Scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

/// `y` over `x` (rows whose x does not grow are left out) on `grid`; NaN outside the range of x and
/// next to rows that are NaN. x and y have equal length.
std::vector<double> PutOnGrid(const std::vector<double>& x, const std::vector<double>& y,
                              const Grid& grid);

/// Values as 16-bit steps between their least and greatest, little-endian, base64; 65535 = no
/// value. Step height: (greatest - least) / 65534, far below a pixel.
struct PackedValues {
  double least = 0;
  double greatest = 0;
  std::string base64;
};
PackedValues Pack(const std::vector<double>& values);

std::string Base64(const std::vector<unsigned char>& bytes);

}  // namespace phs::report
