#include "identify/likelihood.h"

#include <algorithm>
#include <cmath>

namespace phs::identify {

Likelihood::Likelihood(std::vector<Block> blocks, double noise_known)
    : blocks_(std::move(blocks)),
      floor_(1 + noise_known),
      most_worth_(2 / (noise_known * noise_known)) {
  for (const Block& block : blocks_) {
    bands_.emplace_back(block.count);
    first_.push_back(size_);
    size_ += bands_.back().size();
  }
}

Eigen::VectorXd Likelihood::Transform(const Eigen::VectorXd& residual) const {
  Eigen::VectorXd out(size_);
  for (size_t b = 0; b < blocks_.size(); ++b) {
    out.segment(first_[b], bands_[b].size()) =
        bands_[b].Transform(residual.segment(blocks_[b].begin, blocks_[b].count));
  }
  return out;
}

Eigen::MatrixXd Likelihood::Transform(const Eigen::MatrixXd& jacobian) const {
  Eigen::MatrixXd out(size_, jacobian.cols());
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
  return out;
}

double Likelihood::Worth(size_t block, int band) const {
  const double n = blocks_[block].present * (bands_[block].end(band) - bands_[block].begin(band));
  return n * most_worth_ / (n + most_worth_);
}

Eigen::VectorXd Likelihood::Weights(const BandPowers& powers) const {
  Eigen::VectorXd out = Deviations(powers).cwiseInverse();
  for (size_t b = 0; b < blocks_.size(); ++b) {
    for (int k = 0; k < bands_[b].num_bands(); ++k) {
      const int count = bands_[b].end(k) - bands_[b].begin(k);
      const double n = std::max(blocks_[b].present, 1e-3) * count;
      out.segment(first_[b] + bands_[b].begin(k), count) *= std::sqrt(Worth(b, k) / n);
    }
  }
  return out;
}

Eigen::VectorXd Likelihood::Deviations(const BandPowers& powers) const {
  Eigen::VectorXd out(size_);
  for (size_t b = 0; b < blocks_.size(); ++b) {
    for (int k = 0; k < bands_[b].num_bands(); ++k) {
      const int count = bands_[b].end(k) - bands_[b].begin(k);
      out.segment(first_[b] + bands_[b].begin(k), count)
          .setConstant(std::sqrt(std::max(floor_, powers(b, k))));
    }
  }
  return out;
}

double Likelihood::MinusTwoLog(const BandPowers& powers, int block) const {
  double sum = 0;
  for (size_t b = 0; b < blocks_.size(); ++b) {
    if (block >= 0 && static_cast<size_t>(block) != b) continue;
    for (int k = 0; k < bands_[b].num_bands(); ++k) {
      const double power = powers(b, k), variance = std::max(floor_, power);
      sum += Worth(b, k) * (std::log(variance) + power / variance);
    }
  }
  return sum;
}

double Likelihood::MostGain(const BandPowers& powers) const {
  double sum = 0;
  for (size_t b = 0; b < blocks_.size(); ++b) {
    for (int k = 0; k < bands_[b].num_bands(); ++k) {
      const double over = powers(b, k) / floor_;
      if (over > 1) sum += Worth(b, k) * std::log(over);
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
             std::max(0.0, powers(b, k) - floor_);
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
  out.reserve(static_cast<size_t>(size_));
  for (size_t b = 0; b < blocks_.size(); ++b) {
    for (int k = 0; k < bands_[b].num_bands(); ++k) {
      for (int i = bands_[b].begin(k); i < bands_[b].end(k); ++i) {
        out.push_back(std::min(parts - 1, static_cast<int>(parts * bands_[b].Place(k, i))));
      }
    }
  }
  return out;
}

}  // namespace phs::identify
