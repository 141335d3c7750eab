#include "identify/fit/likelihood.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace phs::identify {

Likelihood::Likelihood(std::vector<Block> blocks, double noise_known,
                       const std::vector<Eigen::VectorXd>& theories,
                       const std::vector<Eigen::VectorXd>& inputs)
    : blocks_(std::move(blocks)), noise_known_(noise_known), has_inputs_(!inputs.empty()) {
  for (const Block& block : blocks_) {
    bands_.emplace_back(block.count);
    first_.push_back(size_);
    size_ += bands_.back().size();
  }
  theory_.resize(size_, static_cast<Eigen::Index>(theories.size()));
  for (size_t t = 0; t < theories.size(); ++t) {
    theory_.col(static_cast<Eigen::Index>(t)) = InOctaves(theories[t]);
  }
  SetFloors(inputs);
  if (theories.empty()) return;
  const Eigen::VectorXd weight = Weights(floor_).head(size_).array().square();
  const Eigen::MatrixXd weighted = theory_.transpose() * weight.asDiagonal();
  Eigen::MatrixXd normal = weighted * theory_;
  normal.diagonal().array() += 1;
  along_ = normal.ldlt().solve(weighted);
}

/// Of inputs and theories in all blocks, and what each octave is worth.
void Likelihood::SetFloors(const std::vector<Eigen::VectorXd>& inputs) {
  constexpr double kMost = 9;  // three times the size of a draw, as power
  std::vector<BandPowers> open, driven;
  for (const Eigen::VectorXd& draw : inputs) driven.push_back(Powers(InOctaves(draw)));
  for (Eigen::Index t = 0; t < theory_.cols(); ++t) open.push_back(Powers(theory_.col(t)));
  std::vector<std::vector<double>> doubt;  // g of each band of each block
  std::vector<double> sharing;             // their sum over the blocks
  for (size_t b = 0; b < blocks_.size(); ++b) {
    const auto count = static_cast<size_t>(bands_[b].num_bands());
    std::vector<double>& floor = floor_.rows().emplace_back(count, 1 + noise_known_);
    std::vector<double>& beyond = beyond_.rows().emplace_back(count, 0.0);
    doubt.emplace_back(count, 0.0);
    sharing.resize(std::max(sharing.size(), count), 0.0);
    for (size_t k = 0; k < count; ++k) {
      double power = 0, squares = 0;
      for (const BandPowers& one : open) {
        const double u = one(b, static_cast<int>(k));
        power += u, squares += u * u;
      }
      floor[k] += power;
      for (const BandPowers& one : driven) floor[k] += one(b, static_cast<int>(k));
      beyond[k] = floor[k] + (kMost - 1) * power;
      doubt[b][k] = squares / ((1 + power) * (1 + power));
      sharing[k] += doubt[b][k];
    }
  }
  for (const std::vector<double>& own : doubt) {
    std::vector<double>& most_worth = most_worth_.rows().emplace_back();
    std::vector<double>& shared = shared_.rows().emplace_back();
    for (size_t k = 0; k < own.size(); ++k) {
      shared.push_back(std::max(1.0, sharing[k]) * own[k]);
      most_worth.push_back(2 / (noise_known_ * noise_known_ + 2 * shared.back()));
    }
  }
}

Eigen::VectorXd Likelihood::InOctaves(const Eigen::VectorXd& residual) const {
  Eigen::VectorXd out(size_);
  for (size_t b = 0; b < blocks_.size(); ++b) {
    out.segment(first_[b], bands_[b].size()) =
        bands_[b].Transform(residual.segment(blocks_[b].begin, blocks_[b].count));
  }
  return out;
}

Eigen::VectorXd Likelihood::Transform(const Eigen::VectorXd& residual) const {
  Eigen::VectorXd out = InOctaves(residual);
  if (theory_.cols() == 0) return out;
  const Eigen::VectorXd along = along_ * out;
  out -= theory_ * along;
  out.conservativeResize(size());
  out.tail(along.size()) = along;
  return out;
}

Eigen::MatrixXd Likelihood::Transform(const Eigen::MatrixXd& jacobian) const {
  Eigen::MatrixXd out(size(), jacobian.cols());
  for (Eigen::Index k = 0; k < jacobian.cols(); ++k) {
    out.col(k) = Transform(Eigen::VectorXd(jacobian.col(k)));
  }
  return out;
}

BandPowers Likelihood::Powers(const Eigen::VectorXd& coefficients) const {
  BandPowers out;
  for (size_t b = 0; b < blocks_.size(); ++b) {
    std::vector<double>& row = out.rows().emplace_back();
    for (int k = 0; k < bands_[b].num_bands(); ++k) {
      const int count = bands_[b].end(k) - bands_[b].begin(k);
      const double square =
          coefficients.segment(first_[b] + bands_[b].begin(k), count).squaredNorm();
      row.push_back(square / (count * std::max(blocks_[b].present, 1e-3)));
    }
  }
  out.theory = coefficients.tail(coefficients.size() - size_).squaredNorm();
  return out;
}

double Likelihood::WorthOf(size_t block, int band, double most) const {
  const double n = blocks_[block].present * (bands_[block].end(band) - bands_[block].begin(band));
  return n * most / (n + most);
}

double Likelihood::Worth(size_t block, int band) const {
  return WorthOf(block, band, most_worth_(block, band));
}

double Likelihood::WorthMore(size_t block, int band, double power) const {
  if (!(power > beyond_(block, band))) return 0;
  return WorthOf(block, band, 2 / (noise_known_ * noise_known_)) - Worth(block, band);
}

double Likelihood::BeyondTheory(size_t block, int band, double power) const {
  const double more = WorthMore(block, band, power);
  return more > 0 ? more * std::log(power / beyond_(block, band)) : 0;
}

Eigen::VectorXd Likelihood::Weights(const BandPowers& powers) const {
  Eigen::VectorXd out = Deviations(powers).cwiseInverse();
  for (size_t b = 0; b < blocks_.size(); ++b) {
    for (int k = 0; k < bands_[b].num_bands(); ++k) {
      const int count = bands_[b].end(k) - bands_[b].begin(k);
      const double n = std::max(blocks_[b].present, 1e-3) * count;
      const double worth = Worth(b, k) + WorthMore(b, k, powers(b, k));
      out.segment(first_[b] + bands_[b].begin(k), count) *= std::sqrt(worth / n);
    }
  }
  return out;
}

Eigen::VectorXd Likelihood::Deviations(const BandPowers& powers) const {
  Eigen::VectorXd out = Eigen::VectorXd::Ones(size());
  for (size_t b = 0; b < blocks_.size(); ++b) {
    for (int k = 0; k < bands_[b].num_bands(); ++k) {
      const int count = bands_[b].end(k) - bands_[b].begin(k);
      out.segment(first_[b] + bands_[b].begin(k), count)
          .setConstant(std::sqrt(std::max(floor_(b, k), powers(b, k))));
    }
  }
  return out;
}

double Likelihood::MinusTwoLog(const BandPowers& powers, int block) const {
  double sum = block < 0 ? powers.theory : 0;
  for (size_t b = 0; b < blocks_.size(); ++b) {
    if (block >= 0 && static_cast<size_t>(block) != b) continue;
    for (int k = 0; k < bands_[b].num_bands(); ++k) {
      const double power = powers(b, k), variance = std::max(floor_(b, k), power);
      sum += Worth(b, k) * (std::log(variance) + power / variance);
      sum += BeyondTheory(b, k, power);
    }
  }
  return sum;
}

double Likelihood::MostGain(const BandPowers& powers) const {
  double sum = powers.theory;
  for (size_t b = 0; b < blocks_.size(); ++b) {
    for (int k = 0; k < bands_[b].num_bands(); ++k) {
      const double over = powers(b, k) / floor_(b, k);
      if (over > 1) sum += Worth(b, k) * std::log(over);
      sum += BeyondTheory(b, k, powers(b, k));
    }
  }
  return sum;
}

std::vector<double> Likelihood::Excess(const BandPowers& powers) const {
  std::vector<double> out;
  for (size_t b = 0; b < blocks_.size(); ++b) {
    double sum = 0;
    for (int k = 0; k < bands_[b].num_bands(); ++k) {
      sum += blocks_[b].present * (bands_[b].end(k) - bands_[b].begin(k)) *
             std::max(0.0, powers(b, k) - floor_(b, k));
    }
    out.push_back(sum);
  }
  return out;
}

double Likelihood::Count() const {
  double sum = 0;
  for (size_t b = 0; b < blocks_.size(); ++b) {
    for (int k = 0; k < bands_[b].num_bands(); ++k) sum += Worth(b, k);
  }
  return sum;
}

std::vector<int> Likelihood::Parts(int parts) const {
  std::vector<int> out;
  out.reserve(static_cast<size_t>(size()));
  for (size_t b = 0; b < blocks_.size(); ++b) {
    for (int k = 0; k < bands_[b].num_bands(); ++k) {
      for (int i = bands_[b].begin(k); i < bands_[b].end(k); ++i) {
        out.push_back(std::min(parts - 1, static_cast<int>(parts * bands_[b].Place(k, i))));
      }
    }
  }
  for (int t = 0; size_ + t < size(); ++t) out.push_back(t % parts);
  return out;
}

}  // namespace phs::identify
