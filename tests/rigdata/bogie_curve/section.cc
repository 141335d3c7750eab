#include "section.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace bogie_curve {
namespace {

constexpr double kSteepest = 5;  // slopes beyond are no running surface

struct FilePoints {
  std::vector<std::pair<double, double>> points;  // [m]
  bool mirrored = false;
};

FilePoints ReadFile(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path);
  FilePoints file;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line.find("mirror.y") != std::string::npos) {
      file.mirrored = std::stod(line.substr(line.find('=') + 1)) != 0;
    }
    if (line.find("point.begin") != std::string::npos) inside = true;
    if (line.find("point.end") != std::string::npos) inside = false;
    std::istringstream words(line);
    double y = 0, z = 0;
    if (inside && words >> y >> z) file.points.emplace_back(1e-3 * y, 1e-3 * z);
  }
  if (file.points.size() < 20) throw std::runtime_error(path + " has no profile points");
  return file;
}

}  // namespace

Section Section::Read(const std::string& path, bool top_at_zero) {
  FilePoints file = ReadFile(path);
  double top = 0;
  if (top_at_zero) {
    top = 1e9;
    for (const auto& [y, z] : file.points) top = std::min(top, z);
  }
  for (auto& [y, z] : file.points) y = file.mirrored ? -y : y, z -= top;
  const auto outline = file.points;
  std::sort(file.points.begin(), file.points.end());
  // From the middle outwards to where the flank gets too steep.
  size_t begin = 0, end = 0;
  while (end + 1 < file.points.size() && file.points[end].first < 0) ++end;
  begin = end;
  const auto steep = [&](size_t i) {
    const auto& [y0, z0] = file.points[i];
    const auto& [y1, z1] = file.points[i + 1];
    return y1 - y0 < 1e-9 || std::abs(z1 - z0) > kSteepest * (y1 - y0);
  };
  while (begin > 0 && !steep(begin - 1)) --begin;
  while (end + 1 < file.points.size() && !steep(end)) ++end;
  std::vector<double> y, z;
  for (size_t i = begin; i <= end; ++i) {
    y.push_back(file.points[i].first), z.push_back(file.points[i].second);
  }
  Section section = Of(std::move(y), std::move(z));
  section.outline_ = outline;
  return section;
}

// Cubic between the points, slopes from the parabola through three neighbours.
Section Section::Of(std::vector<double> y, std::vector<double> z) {
  const size_t n = y.size();
  std::vector<double> slope(n);
  for (size_t i = 0; i < n; ++i) {
    const size_t m = std::clamp<size_t>(i, 1, n - 2);
    const double h0 = y[m] - y[m - 1], h1 = y[m + 1] - y[m];
    const double d0 = (z[m] - z[m - 1]) / h0, d1 = (z[m + 1] - z[m]) / h1;
    const double second = (d1 - d0) / (0.5 * (h0 + h1));
    slope[i] = (d0 * h1 + d1 * h0) / (h0 + h1) + second * (y[i] - y[m]);
  }
  Section section;
  section.first_ = y.front();
  size_t i = 0;
  for (size_t k = 0; section.first_ + step_ * static_cast<double>(k) <= y.back(); ++k) {
    const double at = section.first_ + step_ * static_cast<double>(k);
    while (i + 2 < n && y[i + 1] <= at) ++i;
    const double h = y[i + 1] - y[i], t = (at - y[i]) / h, u = 1 - t;
    section.z_.push_back(u * u * (1 + 2 * t) * z[i] + t * t * (3 - 2 * t) * z[i + 1] +
                         h * t * u * (u * slope[i] - t * slope[i + 1]));
  }
  return section;
}

Section Section::Cone(double conicity) {
  std::vector<double> y, z;
  for (int i = -65; i <= 65; ++i) y.push_back(1e-3 * i), z.push_back(-1e-3 * i * conicity);
  return Of(std::move(y), std::move(z));
}

Section Section::Arc(double radius) {
  std::vector<double> y, z;
  for (int i = -70; i <= 70; ++i) {
    y.push_back(5e-4 * i);
    z.push_back(radius - std::sqrt(radius * radius - y.back() * y.back()));
  }
  return Of(std::move(y), std::move(z));
}

Section::Place Section::At(double y) const {
  const double place = (y - first_) / step_;
  const auto i = static_cast<size_t>(std::clamp(place, 0.0, static_cast<double>(z_.size() - 2)));
  const double slope = (z_[i + 1] - z_[i]) / step_;
  return {z_[i] + slope * (y - first_ - step_ * static_cast<double>(i)), slope};
}

double Section::InnerFlank(double depth) const {
  for (size_t i = 0; i + 1 < outline_.size(); ++i) {
    const auto& [y0, z0] = outline_[i];
    const auto& [y1, z1] = outline_[i + 1];
    if (y0 < 0 && (z0 - depth) * (z1 - depth) <= 0 && z0 != z1) {
      return y0 + (y1 - y0) * (depth - z0) / (z1 - z0);
    }
  }
  return first_;  // a head of one arc need not reach so deep: its end stands for it
}

}  // namespace bogie_curve
