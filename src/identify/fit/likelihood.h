// How likely a residual is: noise of known size and a coloured discrepancy of unknown size.
//
// Of a weighted residual (variance 1 where the model is right) the coefficients of one band of one
// block are taken as normal with a variance S that the residual itself tells, but never below that
// of noise whose level is known to `noise_known`:
//   -2 ln L = sum over bands  m_b (ln S_b + P_b/S_b),   S_b = max(1 + e, P_b)
//   m_b = 1/(1/n_b + e²/2)
// P_b: mean square of the band's n_b coefficients (octave_bands.h), e: how well the power of noise
// is known. It is the profile likelihood of y = model + noise + discrepancy with one unknown power
// of the discrepancy per octave and block; its sizes are estimated with every fit, so that the same
// number compares any two models of one record.
//
// Why m_b and not n_b: ln P_b varies by 2/n_b by chance and by e² because no model of noise and
// discrepancy is right to better than e. Without that the fastest octave, with half of all
// coefficients, would outvote all others for the sake of a per cent (a likelihood tempered so is
// the coarsened posterior of Miller and Dunson 2019, J. Am. Stat. Assoc. 114, 1113).
//
// Where the motion that drives the model was measured with noise, the error that this makes has a
// colour that the weights of samples do not tell: its power V_b, over the noise, of draws, is added
// to that of noise: S_b >= 1 + e + V_b.
//
// Where the theory of the model leaves something open (forward_model.h), the difference d_t between
// it and each other one is one draw of an error of unknown size, common to all blocks. So
// - what lies along d_t costs its amplitude: -2 ln L is that of c - D a, and a², with the a that
//   minimises sum m/n (c - D a)²/S + a² (S of noise and theory alone);
// - what an error of another shape leaves is no evidence: S_b >= 1 + e + sum U_t, U_t the power of
//   d_t over the noise;
// - the power of one draw is known to its own size twice (the variance of chi² with one degree of
//   freedom is 2), of all blocks of an octave together: e² + 2 C g_b in the place of e² in m_b,
//   g_b = sum U_t²/(1 + sum U_t)², C = sum of g over the blocks of the octave, >= 1. An octave that
//   theory governs counts for about one sample, however many coefficients and channels it has;
// - one draw is within three times its size in 997 of 1000, and a record has some hundred octaves.
//   What goes beyond 1 + e + 9 sum U_t is no theory's but discrepancy like any other: there m_b is
//   that without theory. Else a cause might spoil one channel a hundredfold for the sake of others.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identify/fit/octave_bands.h"

namespace phs::identify {

/// One channel of one record in the residual.
struct Block {
  int begin = 0, count = 0;  ///< rows of the residual
  double present = 1;        ///< share of them that was measured (the others are 0)
};

/// Powers of the bands of every block: of a residual, over its noise.
class BandPowers {
 public:
  double operator()(size_t block, int band) const {
    return power_[block][static_cast<size_t>(band)];
  }
  std::vector<std::vector<double>>& rows() { return power_; }
  const std::vector<std::vector<double>>& rows() const { return power_; }
  double theory = 0;  ///< sum of the squared amplitudes along theories

 private:
  std::vector<std::vector<double>> power_;
};

class Likelihood {
 public:
  /// `noise_known`: e, as in Acceptance. `theories`: d of each theory beside the model's own, on
  /// the rows of a residual. `inputs`: draws of the error for what drives it, whose powers add up.
  Likelihood(std::vector<Block> blocks, double noise_known,
             const std::vector<Eigen::VectorXd>& theories = {},
             const std::vector<Eigen::VectorXd>& inputs = {});

  const std::vector<Block>& blocks() const { return blocks_; }
  const OctaveBands& bands(size_t block) const { return bands_[block]; }
  /// Coefficients of all blocks, and amplitudes along the theories.
  int size() const { return size_ + static_cast<int>(theory_.cols()); }
  /// Rows of a residual -> coefficients, block after block, without what lies along a theory; then
  /// the amplitudes a.
  Eigen::VectorXd Transform(const Eigen::VectorXd& residual) const;
  Eigen::MatrixXd Transform(const Eigen::MatrixXd& jacobian) const;
  /// Mean squares of the bands of these coefficients, over the rows that were measured.
  BandPowers Powers(const Eigen::VectorXd& coefficients) const;
  /// Deviation of each coefficient if noise and discrepancy have these powers.
  Eigen::VectorXd Deviations(const BandPowers& powers) const;
  /// Its weight in a least-squares step: root of m/n over the deviation.
  Eigen::VectorXd Weights(const BandPowers& powers) const;
  /// -2 ln L of these powers. `block` < 0: of all blocks.
  double MinusTwoLog(const BandPowers& powers, int block = -1) const;
  double MinusTwoLog(const Eigen::VectorXd& residual) const {
    return MinusTwoLog(Powers(Transform(residual)));
  }
  /// True if errors of what drives the model are known of: they were drawn with one model, so that
  /// what leaves less than them is no evidence between two (MostGain alone is).
  bool has_inputs() const { return has_inputs_; }
  /// By how much -2 ln L of these powers could fall at most: to that of noise alone.
  double MostGain(const BandPowers& powers) const;
  /// Mean square beyond the noise, per block, times its rows.
  std::vector<double> Excess(const BandPowers& powers) const;
  /// Sum of m over all bands: what the record is worth in independent samples.
  double Count() const;
  /// m of a band: what it is worth in independent samples while theory can be what is there.
  double Worth(size_t block, int band) const;
  /// C g of a band: what theory leaves open of it is one draw, whose n coefficients tell as 1/(C g).
  double Shared(size_t block, int band) const { return shared_(block, band); }
  /// Part 0 … parts-1 of the record that each coefficient lies in.
  std::vector<int> Parts(int parts) const;

 private:
  void SetFloors(const std::vector<Eigen::VectorXd>& inputs);
  Eigen::VectorXd InOctaves(const Eigen::VectorXd& residual) const;
  double WorthOf(size_t block, int band, double most) const;
  /// What a band of this power is worth more than while theory can be what is there.
  double WorthMore(size_t block, int band, double power) const;
  /// And what of -2 ln L is that.
  double BeyondTheory(size_t block, int band, double power) const;

  std::vector<Block> blocks_;
  std::vector<OctaveBands> bands_;
  std::vector<int> first_;  ///< coefficient of each block
  int size_ = 0;            ///< coefficients of all blocks
  BandPowers floor_;        ///< power that is noise, of inputs too, or left open by theory
  BandPowers beyond_;       ///< power above which it is no theory's
  BandPowers most_worth_;   ///< 2/(e² + 2 C g)
  BandPowers shared_;       ///< C g
  double noise_known_ = 0;  ///< e
  bool has_inputs_ = false;
  Eigen::MatrixXd theory_;  ///< D: a column for each
  Eigen::MatrixXd along_;   ///< coefficients -> a
};

}  // namespace phs::identify
