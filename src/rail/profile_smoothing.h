// Smoothing of measured profiles that keeps curvature.
//
// The outline is resampled at equal steps h of arc length and both coordinates u are replaced by
//   min over v of  sum (v - u)^2 + mu sum (D3 v)^2,   mu = (L/(2 pi h))^6
// with the third difference D3 (Whittaker 1923, order 3). Straight lines and parabolas pass
// unchanged up to both ends, so arcs keep their curvature; waves of length L are halved, waves of
// L/2 are reduced to 1/65.
#pragma once

#include <vector>

namespace phs::rail {

/// @param y,z outline in order along the surface [m]; replaced by the smooth outline at steps of
///   at most L/20. @param wavelength L > 0 [m]. @pre at least five points.
void SmoothOutline(double wavelength, std::vector<double>* y, std::vector<double>* z);

}  // namespace phs::rail
