// Small operations on sampled series that several parts of the identification share: robust
// levels, quantiles, autocorrelation, zero-phase filtering.
#pragma once

#include <span>
#include <vector>

namespace phs::measurement {

double Mean(std::span<const double> y);
/// Root mean square deviation from the mean.
double StandardDeviation(std::span<const double> y);
/// Value below which `share` of the samples lie (0 … 1). NaN if empty. Takes a copy.
double Quantile(std::vector<double> y, double share);
/// 1.4826 median |y - median|: standard deviation of the normal core, deaf to outliers.
double RobustDeviation(const std::vector<double>& y);
/// Three quarters of the mean square of y (about zero), or more, are beyond what RobustDeviation
/// tells of it. Noise of any colour has normal values, of which that is the whole.
bool ComesInBursts(const std::vector<double>& y);
/// Autocorrelation rho(0 … most) of y minus its mean.
std::vector<double> Autocorrelation(std::span<const double> y, int most);
/// Integrated autocorrelation time 1 + 2 sum rho (Geyer's initial positive sequence), >= 1: how
/// many correlated samples are worth one independent sample.
double CorrelationTime(std::span<const double> y);
/// Butterworth low-pass of second order run forwards and backwards: no lag, -6 dB at `cut_Hz`.
std::vector<double> LowPass(const std::vector<double>& y, double step_s, double cut_Hz);

}  // namespace phs::measurement
