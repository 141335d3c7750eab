#include "rail/profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/tridiagonal.h"

namespace phs::rail {
namespace {

constexpr double kKnotStep = 0.25e-3;  ///< of the equidistant knots [m]
constexpr double kThin = 0.4e-3;       ///< points nearer together are thinned out [m]
constexpr double kSteepest = 6;        ///< |dz/dy|
constexpr double kShortest = 10e-3;    ///< usable width [m]

/// Second derivatives of the natural cubic spline through (y, z).
std::vector<double> NaturalSpline(const std::vector<double>& y, const std::vector<double>& z) {
  const size_t n = y.size();
  std::vector<double> second(n, 0.0);
  std::vector<TridiagonalRow> rows;
  for (size_t i = 1; i + 1 < n; ++i) {
    const double left = y[i] - y[i - 1];
    const double right = y[i + 1] - y[i];
    rows.push_back({left, 2 * (left + right), right,
                    6 * ((z[i + 1] - z[i]) / right - (z[i] - z[i - 1]) / left)});
  }
  SolveTridiagonal(rows, std::span(second).subspan(1, rows.size()));
  return second;
}

double EvaluateSpline(const std::vector<double>& y, const std::vector<double>& z,
                      const std::vector<double>& second, double at) {
  const size_t i = std::clamp<size_t>(
      static_cast<size_t>(std::upper_bound(y.begin(), y.end(), at) - y.begin()), 1, y.size() - 1);
  const double h = y[i] - y[i - 1];
  const double a = (y[i] - at) / h;
  const double b = (at - y[i - 1]) / h;
  return a * z[i - 1] + b * z[i] +
         ((a * a * a - a) * second[i - 1] + (b * b * b - b) * second[i]) * h * h / 6;
}

/// The longest run of points around the middle that is nowhere too steep.
void CutSteepEnds(std::vector<double>* y, std::vector<double>* z) {
  const auto steep = [&](size_t i) {
    return std::abs((*z)[i + 1] - (*z)[i]) > kSteepest * ((*y)[i + 1] - (*y)[i]);
  };
  // Start from the point nearest y = 0, where wheel and rail meet.
  size_t middle = 0;
  for (size_t i = 0; i < y->size(); ++i) {
    if (std::abs((*y)[i]) < std::abs((*y)[middle])) middle = i;
  }
  size_t begin = middle;
  size_t end = middle;
  while (begin > 0 && !steep(begin - 1)) --begin;
  while (end + 1 < y->size() && !steep(end)) ++end;
  *y = std::vector<double>(y->begin() + static_cast<long>(begin),
                           y->begin() + static_cast<long>(end) + 1);
  *z = std::vector<double>(z->begin() + static_cast<long>(begin),
                           z->begin() + static_cast<long>(end) + 1);
}

}  // namespace

Result<Profile> Profile::FromPoints(const std::string& name, std::vector<double> y,
                                    std::vector<double> z) {
  std::vector<double> ty;
  std::vector<double> tz;
  for (size_t i = 0; i < y.size(); ++i) {
    const bool far = ty.empty() || std::hypot(y[i] - ty.back(), z[i] - tz.back()) >= kThin;
    if (far && (ty.empty() || y[i] > ty.back())) {
      ty.push_back(y[i]);
      tz.push_back(z[i]);
    }
  }
  if (ty.size() >= 2) CutSteepEnds(&ty, &tz);
  if (ty.size() < 5 || ty.back() - ty.front() < kShortest) {
    return Error{name, "has too little usable surface", "at least 10 mm between the steep ends",
                 "check units and the direction of y and z"};
  }
  const std::vector<double> second = NaturalSpline(ty, tz);
  const int pieces = static_cast<int>((ty.back() - ty.front()) / kKnotStep);
  std::vector<double> ky(static_cast<size_t>(pieces) + 1);
  std::vector<double> kz(ky.size());
  for (size_t i = 0; i < ky.size(); ++i) {
    ky[i] = ty.front() + kKnotStep * static_cast<double>(i);
    kz[i] = EvaluateSpline(ty, tz, second, ky[i]);
  }
  const std::vector<double> bend = NaturalSpline(ky, kz);
  Profile profile;
  profile.name_ = name;
  profile.outline_y_ = std::move(y);
  profile.outline_z_ = std::move(z);
  profile.begin_ = ty.front();
  profile.step_ = kKnotStep;
  profile.per_step_ = 1 / kKnotStep;
  for (size_t i = 0; i + 1 < ky.size(); ++i) {
    profile.piece_.push_back(
        {kz[i], (kz[i + 1] - kz[i]) / kKnotStep - kKnotStep * (2 * bend[i] + bend[i + 1]) / 6,
         bend[i] / 2, (bend[i + 1] - bend[i]) / (6 * kKnotStep)});
  }
  return profile;
}

void Profile::Incline(double angle) {
  if (angle == 0) return;
  std::vector<double> y;
  std::vector<double> z;
  for (size_t i = 0; i < outline_y_.size(); ++i) {
    // The top (z < 0) moves inward (y < 0).
    y.push_back(outline_y_[i] * std::cos(angle) + outline_z_[i] * std::sin(angle));
    z.push_back(-outline_y_[i] * std::sin(angle) + outline_z_[i] * std::cos(angle));
  }
  auto turned = FromPoints(name_, y, z);
  if (turned.ok()) *this = std::move(turned).value();
}

void Profile::Lower(const std::function<double(double)>& depth) {
  std::vector<double> z;
  for (size_t i = 0; i < outline_y_.size(); ++i) {
    z.push_back(outline_z_[i] - depth(outline_y_[i]));
  }
  auto lowered = FromPoints(name_, outline_y_, z);
  if (lowered.ok()) *this = std::move(lowered).value();
}

void Profile::PutTopAtZero() {
  double top = std::numeric_limits<double>::infinity();
  for (double y = min_y(); y <= max_y(); y += step_ / 4) top = std::min(top, At(y).z);
  for (Piece& piece : piece_) piece.c0 -= top;
  for (double& z : outline_z_) z -= top;
}

double Profile::InnerSideAtDepth(double z) const {
  const auto top = std::min_element(outline_z_.begin(), outline_z_.end());
  // From the top inwards (towards smaller y): the first crossing of the depth.
  for (size_t i = static_cast<size_t>(top - outline_z_.begin()); i > 0; --i) {
    const double above = outline_z_[i] - *top;
    const double below = outline_z_[i - 1] - *top;
    if (above <= z && below >= z && below > above) {
      const double share = (z - above) / (below - above);
      return outline_y_[i] + share * (outline_y_[i - 1] - outline_y_[i]);
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace phs::rail
