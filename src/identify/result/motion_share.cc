#include "identify/result/motion_share.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numeric>
#include <unsupported/Eigen/FFT>

#include "identify/fit/acceptance.h"
#include "identify/fit/octave_bands.h"
#include "identify/select/verdict.h"
#include "measurement/series.h"

namespace phs::identify {
namespace {

constexpr int kLeastRows = 64;
constexpr int kLeastCoefficients = 32;
constexpr int kPerFunction = 4;  // coefficients of an octave for each function that takes part

Eigen::VectorXd Standardised(Eigen::VectorXd u) {
  u.array() -= u.mean();
  const double deviation = std::sqrt(u.squaredNorm() / static_cast<double>(u.size()));
  if (deviation > 0) u /= deviation;
  return u;
}

/// Central differences, a row apart.
Eigen::VectorXd Rate(const Eigen::VectorXd& u) {
  const Eigen::Index n = u.size();
  Eigen::VectorXd out(n);
  out.segment(1, n - 2) = 0.5 * (u.tail(n - 2) - u.head(n - 2));
  out[0] = u[1] - u[0], out[n - 1] = u[n - 1] - u[n - 2];
  return out;
}

/// The functions of one signal, one column each.
Eigen::MatrixXd Functions(const std::vector<double>& signal) {
  const Eigen::VectorXd raw =
      Eigen::Map<const Eigen::VectorXd>(signal.data(), static_cast<Eigen::Index>(signal.size()));
  const Eigen::ArrayXd u = Standardised(raw).array();
  Eigen::ArrayXd rate = Rate(u.matrix()).array();
  const double rms = std::sqrt(rate.square().mean());
  if (rms > 0) rate /= rms;
  const Eigen::ArrayXd way = rate / (rate.abs() + 0.1);
  Eigen::MatrixXd out(u.size(), 8);
  out << u.matrix(), u.square().matrix(), u.cube().matrix(), rate.matrix(), rate.abs().matrix(),
      (rate * rate.abs()).matrix(), way.matrix(), (way * u).matrix();
  for (Eigen::Index k = 0; k < out.cols(); ++k) out.col(k) = Standardised(out.col(k));
  return out;
}

/// Sum of squares of `y` that the columns explain beyond chance; `left` per coefficient.
double Explained(const Eigen::VectorXd& y, const Eigen::MatrixXd& columns, double* left) {
  const Eigen::Index n = y.size(), most = std::min(columns.cols(), n / kPerFunction);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> own(columns.transpose() * columns);
  const double largest = own.eigenvalues().tail<1>()[0];
  double taken = 0;
  Eigen::Index count = 0;
  for (Eigen::Index k = columns.cols() - 1; k >= 0 && count < most; --k) {
    const double square = own.eigenvalues()[k];
    if (!(square > 1e-12 * largest)) break;
    const Eigen::VectorXd direction = columns * own.eigenvectors().col(k) / std::sqrt(square);
    taken += std::pow(direction.dot(y), 2), ++count;
  }
  *left = std::max(0.0, y.squaredNorm() - taken) / static_cast<double>(n - count);
  return taken - *left * static_cast<double>(count);
}

bool IsLoudInBursts(const std::vector<double>& residual) {
  constexpr double kLeastIndependent = 40;
  std::vector<double> present;
  for (const double r : residual) {
    if (std::isfinite(r)) present.push_back(r);
  }
  const auto count = static_cast<double>(present.size());
  return measurement::ComesInBursts(present) &&
         count > kLeastIndependent * measurement::CorrelationTime(present);
}

/// Power by line, k cycles in `length` rows; white noise of one has a power of one in each. Rows that
/// are not finite count as zero.
std::vector<double> Spectrum(const std::vector<double>& y, size_t length) {
  std::vector<double> power(length / 2, 0.0);
  Eigen::FFT<double> transform;
  int segments = 0;
  for (size_t begin = 0; begin + length <= y.size(); begin += length / 2, ++segments) {
    std::vector<double> part(length);
    double square = 0;  // of the window
    for (size_t i = 0; i < length; ++i) {
      const double window =
          1 - std::cos(2 * M_PI * (static_cast<double>(i) + 0.5) / static_cast<double>(length));
      const double value = y[begin + i];
      part[i] = std::isfinite(value) ? window * value : 0, square += window * window;
    }
    std::vector<std::complex<double>> lines;
    transform.fwd(lines, part);
    for (size_t k = 0; k < power.size(); ++k) power[k] += std::norm(lines[k]) / square;
  }
  for (double& p : power) p /= std::max(1, segments);
  return power;
}

}  // namespace

double SwingsAt(const std::vector<double>& residual,
                const std::vector<std::vector<double>>& drives) {
  constexpr size_t kLeastLength = 256, kSegments = 32, kLines = 2;
  constexpr double kHalf = 0.5, kDriven = 0.1, kWide = 0.1;
  if (residual.size() < 2 * kLeastLength) return 0;
  const size_t length = std::max(kLeastLength, std::bit_floor(residual.size() / kSegments));
  std::vector<double> power = Spectrum(residual, length);
  for (double& p : power) p = std::max(0.0, p - 1);
  const auto peak =
      static_cast<size_t>(std::max_element(power.begin(), power.end()) - power.begin());
  if (peak <= kLines) return 0;
  const size_t wide = std::max(kLines, static_cast<size_t>(kWide * static_cast<double>(peak)));
  const size_t first = peak - wide, last = std::min(peak + wide + 1, power.size());
  const auto share = [&](const std::vector<double>& of) {
    const auto at = [&](size_t k) { return of.begin() + static_cast<long>(k); };
    return std::accumulate(at(first), at(last), 0.0) /
           std::max(std::accumulate(of.begin(), of.end(), 0.0), 1e-300);
  };
  if (!(share(power) >= kHalf)) return 0;
  for (const std::vector<double>& drive : drives) {
    if (share(Spectrum(drive, length)) > kDriven) return 0;
  }
  double sum = 0, moment = 0;
  for (size_t k = first; k < last; ++k)
    sum += power[k], moment += power[k] * static_cast<double>(k);
  return moment / sum / static_cast<double>(length);
}

double MeanSquareThatFollows(const std::vector<double>& residual,
                             const std::vector<std::vector<double>>& signals) {
  const auto rows = static_cast<int>(residual.size());
  Eigen::VectorXd r(rows);
  int present = 0;
  for (int i = 0; i < rows; ++i) {
    const double value = residual[static_cast<size_t>(i)];
    r[i] = std::isfinite(value) ? value : 0;
    present += std::isfinite(value) ? 1 : 0;
  }
  if (present == 0) return 0;
  const double all = r.squaredNorm() / present;
  if (rows < kLeastRows || signals.empty()) return all;
  Eigen::MatrixXd columns(rows, 0);
  for (const std::vector<double>& signal : signals) {
    if (signal.size() != residual.size()) return all;
    const Eigen::MatrixXd more = Functions(signal);
    columns.conservativeResize(Eigen::NoChange, columns.cols() + more.cols());
    columns.rightCols(more.cols()) = more;
  }
  if (!columns.allFinite()) return all;
  const OctaveBands bands(rows);
  const Eigen::VectorXd y = bands.Transform(r);
  Eigen::MatrixXd turned(bands.size(), columns.cols());
  for (Eigen::Index k = 0; k < columns.cols(); ++k) turned.col(k) = bands.Transform(columns.col(k));
  double sum = 0, left = 1;
  for (int b = 0; b < bands.num_bands(); ++b) {
    const int count = bands.end(b) - bands.begin(b);
    const Eigen::VectorXd own = y.segment(bands.begin(b), count);
    sum += count < kLeastCoefficients
               ? std::max(0.0, own.squaredNorm() - count * std::max(1.0, left))
               : Explained(own, turned.middleRows(bands.begin(b), count), &left);
  }
  return std::max(0.0, sum / present);
}

bool IsQuietAtRest(const std::vector<double>& residual, const std::vector<char>& still) {
  struct Sum {
    double square = 0, count = 0;
    double Beyond() const { return square / std::max(count, 1.0) - 1; }
  };
  std::vector<Sum> rests;
  Sum moving;
  for (size_t i = 0; i < residual.size(); ++i) {
    if (still[i] && (i == 0 || !still[i - 1])) rests.emplace_back();
    if (!std::isfinite(residual[i])) continue;
    Sum& sum = still[i] ? rests.back() : moving;
    sum.square += residual[i] * residual[i], ++sum.count;
  }
  std::erase_if(rests, [](const Sum& rest) { return rest.count < kLeastRows; });
  if (rests.size() < 2 || !(moving.Beyond() > 0)) return false;
  double loudest = kAsLargeAsNoise;
  for (const Sum& rest : rests) loudest = std::max(loudest, rest.Beyond());
  return std::pow(loudest / moving.Beyond(), rests.size()) < Acceptance{}.false_alarms;
}

std::optional<TwoLevels> FindTwoLevels(const std::vector<double>& residual) {
  constexpr double kLeastApart = 6, kMostBetween = 0.5 * 0.19, kLeastStay = 5;
  std::vector<double> present;
  for (const double r : residual) {
    if (std::isfinite(r)) present.push_back(r);
  }
  const auto count = static_cast<double>(present.size());
  if (count < kLeastRows) return std::nullopt;
  std::vector<double> sorted = present;
  std::sort(sorted.begin(), sorted.end());
  const double sum = std::accumulate(sorted.begin(), sorted.end(), 0.0);
  double below = 0, most = 0, low = 0, high = 0;
  for (size_t i = 0; i + 1 < sorted.size(); ++i) {
    below += sorted[i];
    const double n = static_cast<double>(i + 1), rest = count - n;
    const double under = below / n, over = (sum - below) / rest;
    const double between = n * rest / (count * count) * (over - under) * (over - under);
    if (between > most) most = between, low = under, high = over;
  }
  double square = 0;
  for (const double r : present) square += (r - sum / count) * (r - sum / count) / count;
  const double left = square - most - 1;  // beyond the noise
  if (high - low < kLeastApart || left > kMostBetween * (square - 1)) return std::nullopt;
  // A jump has come when the sample is nearer than a quarter of the way to the other level.
  TwoLevels out{high - low, 0};
  bool up = present.front() > 0.5 * (low + high);
  for (const double r : present) {
    const double part = (r - low) / out.apart;
    if (up ? part < 0.25 : part > 0.75) up = !up, ++out.jumps;
  }
  if (out.jumps < 2 || count < kLeastStay * out.jumps) return std::nullopt;
  return out;
}

bool ComesAndGoes(const std::vector<double>& residual) {
  constexpr size_t kParts = 8, kQuiet = 2, kWays = 28;  // to choose two of eight
  const size_t n = residual.size();
  if (n < kLeastRows) return false;
  if (IsLoudInBursts(residual)) return true;
  std::vector<double> beyond;
  for (size_t part = 0; part < kParts; ++part) {
    double square = 0, count = 0;
    for (size_t i = part * n / kParts; i < (part + 1) * n / kParts; ++i) {
      if (std::isfinite(residual[i])) square += residual[i] * residual[i], ++count;
    }
    if (!(count > 0)) return false;
    beyond.push_back(square / count - 1);
  }
  const double mean = std::accumulate(beyond.begin(), beyond.end(), 0.0) / kParts;
  std::sort(beyond.begin(), beyond.end());
  const double quiet = std::max(beyond[kQuiet - 1], kAsLargeAsNoise);
  return mean > 0 && kWays * std::pow(quiet / mean, 2) < Acceptance{}.false_alarms;
}

}  // namespace phs::identify
