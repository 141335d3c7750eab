// Power spectral densities of track irregularity, and irregularities generated from them.
//
// All spectra are one-sided over the angular spatial frequency W = 2 pi/L [rad/m] of wavelength L:
// the variance of a channel within a band is the integral of S(W) dW over that band.
//
// German spectra ("ERRI B176", low and high disturbance):
//   S_alignment = Aa Wc^2/((W^2 + Wr^2)(W^2 + Wc^2))
//   S_level     = Av Wc^2/((W^2 + Wr^2)(W^2 + Wc^2))
//   S_cross     = (2b)^2 (Av/b^2) Wc^2 W^2/((W^2 + Wr^2)(W^2 + Wc^2)(W^2 + Ws^2))
//   S_gauge     = Ag Wc^2 W^2/((W^2 + Wr^2)(W^2 + Wc^2)(W^2 + Ws^2))
// Wc 0.8246, Wr 0.0206, Ws 0.4380 rad/m, b = 0.75 m; the published cross-level spectrum is that of
// the angle at half base b, here multiplied with the base (2b)^2 to metres, so that the difference
// in height of the rails is what was measured on standard gauge.
//   low  Aa 2.119e-7, Av 4.032e-7, Ag 5.32e-8;  high Aa 6.125e-7, Av 1.08e-6, Ag 1.032e-7 [m rad].
// Sources: ORE B176 RP1 (1989); H. Claus, W. Schiehlen, Modeling and simulation of railway bogie
// structural vibrations, VSD 29 S1 (1998) 538 (alignment, level, cross level). Ag as in later use.
//
// US spectra (FRA line classes 1 to 6, 6 the best), k = 0.25:
//   S_alignment = k Aa Wc^2/(W^2 (W^2 + Wc^2)),   S_level = k Av Wc^2/(W^2 (W^2 + Wc^2))
//   S_cross = S_gauge = 4 k Av Wc^2/((W^2 + Wc^2)(W^2 + Ws^2))
// Wc 0.8245 rad/m; Av, Aa, Ws by class in the table of the source file (there in cm^2 rad/m).
// Sources: A. Hamid et al., Analytical descriptions of track geometry variations, FRA/ORD-83/03
// (1983); R.H. Fries, B.M. Coffey, A state-space approach to the synthesis of random vertical and
// crosslevel rail irregularities, J. Dyn. Sys. Meas. Control 112 (1990) 83; constants as tabulated
// by X. Lei, N.-A. Noda, J. Sound Vib. 258 (2002) 147.
//
// Generation: the sum of cosines x(s) = sum sqrt(2 S(W_k) dW) cos(W_k s + p_k), W_k in the middle
// of equal steps dW over the band, phases p_k uniform from a counter-based generator (SplitMix64),
// so a seed gives the same track on every machine. dW <= 2 pi/(2 x length): no repetition in the
// range. Beyond the shortest wavelength the steps may go on to the finest one: the same waves and
// further, shorter ones.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "rail/irregularity.h"

namespace phs::rail {

struct IrregularityPsdParams {
  std::string psd = "errib176_low";  ///< a name of PsdNames()
  std::uint64_t seed = 1;
  double begin_s = 0;               ///< [m]
  double end_s = 100;               ///< [m]
  double shortest_wavelength = 3;   ///< > 0 [m]
  double finest_wavelength = 0;     ///< the waves go on down to it; 0 = they do not [m]
  double longest_wavelength = 100;  ///< [m]
  double scale = 1;                 ///< factor on all channels
};

/// Samples times waves of one channel: what generating it costs, about 0.8 ns each.
double IrregularityWork(const IrregularityPsdParams& params);

/// errib176_low, errib176_high, fra_1 … fra_6.
const std::vector<std::string>& PsdNames();
/// One-sided S(W) of a channel [m^2/(rad/m)]. @pre psd is one of PsdNames(), w > 0 [rad/m].
double CalcPsd(const std::string& psd, IrregularityChannel channel, double w);
/// The wavelength that `speed` [m/s] turns into 20 Hz, the end of the band that EN 14363 looks at;
/// within 0.5 … 3 m. No speed (0): that of 80 km/h, 1.11 m.
double FinestWavelength(double speed_m_s);
/// Samples with twelve points per shortest wave. @pre the parameters are valid.
IrregularitySamples GenerateIrregularity(const IrregularityPsdParams& params);

}  // namespace phs::rail
