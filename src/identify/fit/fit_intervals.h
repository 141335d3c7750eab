// How sure a fit is of its numbers, and how many independent samples a coloured residual holds.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identify/fit/search_fit.h"

namespace phs::identify::search {

/// Mean squares per channel and half widths of the 95 % intervals from residual, slopes and powers
/// of a fit: the larger of two, that of the likelihood (EvenHalfWidths), and that of blocks of the
/// record that disagree (JackknifeHalfWidths).
void SetIntervals(const FitProblem& problem, FitResult* result);

/// Half widths of the 95 % intervals if the likelihood's powers are right. A band's power is told by
/// its n coefficients, of which the numbers have taken h (the sum of their leverages): it is n/(n - h)
/// times the mean square that is left, and known with n - h degrees of freedom. A number whose
/// variance is a sum over bands v_b has (sum v_b)^2 / sum(v_b^2/(n_b - h_b)) of them (Satterthwaite
/// 1946, Biometrics Bulletin 2, 110), and Student's quantile: what is told by few coefficients, as an
/// offset by the slowest octave, is less sure. What theory leaves open of a band is one draw over
/// all blocks (likelihood.h): its n coefficients tell as n/(1 + n C g), and their part of the variance
/// is larger by that. `slopes`: weighted coefficients over numbers.
std::vector<double> EvenHalfWidths(const Likelihood& likelihood, const BandPowers& powers,
                                   const Eigen::MatrixXd& slopes);

/// Half widths of the 95 % intervals of least-squares estimates whose residuals are correlated, over
/// channels too, and whose model is not quite right: by how much the estimates move when one of the
/// blocks, far longer than the residual remembers, is left out in turn (the jackknife; Tukey 1958,
/// Annals of Mathematical Statistics 29, 614):
///   variance = (B - 1)/B sum_b (N - N_b)^-1 g_b g_b' (N - N_b)^-1
/// N = J'J, N_b and g_b = J_b' r_b of block b. (N alone in the place of N - N_b says too little where
/// few blocks tell a number: the fit has followed these. MacKinnon, Nielsen and Webb 2023,
/// arXiv 2301.04527.) Student's quantile with (sum v_b)^2 / sum v_b^2 - 1 degrees of freedom, v_b
/// the share of block b in the variance if residuals were even (Bell and McCaffrey 2002, Survey
/// Methodology 28, 169). 0 for a number that so few blocks tell that these are below 3: blocks cannot
/// disagree about it. `block_of_row`: 0 … blocks-1. Empty if there are too few blocks.
std::vector<double> JackknifeHalfWidths(const Eigen::MatrixXd& jacobian,
                                        const Eigen::VectorXd& residual,
                                        const std::vector<int>& block_of_row, int blocks);

/// Independent samples in a correlated residual of N samples: N / (1 + 2 sum rho_k), over the lags
/// until rho falls below 0.05 (Bayley and Hammersley 1946).
double EffectiveSamples(const Eigen::VectorXd& residual, int begin, int count);

/// The same of several blocks.
double IndependentSamples(const Eigen::VectorXd& residual, const std::vector<Block>& blocks);

}  // namespace phs::identify::search
