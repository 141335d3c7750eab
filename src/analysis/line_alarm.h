// The alarm for a lost hose: two line pressures made one signal, a threshold that follows from a
// wanted rate of false alarms, and what a count of false alarms over a distance proves.
//
// Signal of lines a, b (absolute pressures): p_a - p_b, p_a + p_b, ln(p_a/p_b), ln(p_a p_b/p_1^2) with
// p_1 = 1 MPa, or ln(p_a p_b/p_r^2) with p_r the geometric mean of all other lines, behind a lag of
// first order dy/dt = (x - y)/tau. The alarm is given above or below a threshold; signals are turned
// so that it is always above:
//
//   signal ----.   .--.          lag      ____ u threshold
//               `-'    `--.  ------->  __/
//
// What shears the bogie or pulls at it moves oil u from one line to the other. Over gas of volume V
// at one temperature p_a = p_0/(1 - u/V), p_b = p_0/(1 + u/V): sum and product change with u^2 only.
// A torn hose takes its line to the atmosphere, which is ln(p_0/p_atm) of the product and half of
// the sum. Oil and gas that cool lower every line alike: over the rest the level does not count.
//
// Each signal also comes against its own mean: y less the mean z of what came before, of all rows up
// to a time T, then dz/dt = (y - z)/T. Oil that warms or leaks moves the level over minutes, a torn
// hose in a second. Traction that comes or goes within T moves it too and has to be among the
// services.
//
// Threshold: the largest values M of the signal in blocks of track of one length, without failure,
// follow the generalised extreme value law P(M <= x) = exp(-(1 - k (x - m)/s)^(1/k)), for k = 0
// Gumbel's exp(-exp(-(x - m)/s)). m, s, k from the first three L-moments (Hosking, Wallis and Wood
// 1985); a tail that would be lighter than Gumbel's (k > 0) is taken as Gumbel's: the careful side. A
// block gives a false alarm with probability r above u = m + s (1 - exp(-k y))/k, y = -ln(-ln(1-r)).
// How far n blocks leave u open is told by a parametric bootstrap. Blocks count as independent and
// of one kind: a block is a run over the whole line. Blocks shorter than that are some of straights,
// some of curves, some of traction that goes; the law takes several kinds for one with a heavy tail
// (its threshold then lies far beyond all that ever comes).
#pragma once

#include <span>
#include <string>
#include <vector>

namespace phs::analysis {

/// A way to make one number of two pressures [Pa]; `rest`: geometric mean of all other lines [Pa].
struct PairForm {
  const char* name;
  const char* unit;
  bool needs_rest;  ///< then there must be a third line
  double (*value)(double a, double b, double rest);
};
std::span<const PairForm> PairForms();

/// A pair of lines, a form of it, whether against its own mean, and on which side of its threshold
/// it alarms.
struct PairSignal {
  int first = 0;
  int second = 0;
  const PairForm* form = nullptr;
  bool against_mean = false;
  bool above = true;
  double sign() const { return above ? 1 : -1; }
};
/// Every pair of `lines` lines in every form, plain and against its mean, both sides. Differences
/// and ratios turn over with the pair, so each pair comes once.
std::vector<PairSignal> PairSignals(int lines);

/// tau and T of the signals [s].
struct SignalTimes {
  double lag_s = 0.3;  ///< >= 0
  double mean_s = 60;  ///< > 0
};

/// The signal behind its lag, turned so that it alarms above. `pressures`: [line][row], absolute
/// [Pa], rows every `interval_s`; the lag begins settled at the first row.
std::vector<double> CalcSignal(const PairSignal& signal,
                               const std::vector<std::vector<double>>& pressures, double interval_s,
                               const SignalTimes& times);

/// Largest value of each whole block of `block_m`; `place` [m] never falls. What is left at the end
/// is no block.
std::vector<double> BlockMaxima(const std::vector<double>& place, const std::vector<double>& signal,
                                double block_m);

struct Extremes {
  double location = 0;
  double scale = 0;
  double shape = 0;  ///< k <= 0; < 0: a heavier tail than Gumbel's
  int count = 0;     ///< maxima it was made from
  /// Exceeded by a block with probability r, 0 < r < 1.
  double Level(double r) const;
  /// The same at the upper end of its one-sided 95 % interval; the same draws for the same law.
  double UpperLevel(double r) const;
};
/// @pre at least three maxima
Extremes FitExtremes(std::vector<double> maxima);

/// Times that the signal passes the threshold; one that comes again within `hold_s` of the last row
/// above it is the same alarm.
int CountAlarms(const std::vector<double>& signal, double threshold, double interval_s,
                double hold_s);

/// Largest mean that a Poisson count of `count` or fewer does not refute at `confidence`: 3.0 for
/// none seen at 95 %.
double PoissonUpper(int count, double confidence = 0.95);

}  // namespace phs::analysis
