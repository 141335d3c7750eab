// Words and numbers over a picture.
#pragma once

#include <string>
#include <vector>

#include "view/stage.h"

namespace phs::view {

/// One line: what, and its value.
struct CaptionLine {
  std::string name, value;
};

/// "phs", "rigid_link": what the bogie is called; a first letter in capitals, blanks for '_'.
std::string TitleOf(const Recording& recording);
/// Radius with hand, or straight.
std::string CurveText(double curvature);
/// Time, speed, curve, angle of attack and guiding force of the leading axle; magnification.
std::vector<CaptionLine> CaptionsOf(const Stage& stage, const Look& look);

/// Draws the captions, and the scale of the pressures where there are lines, into the buffer that
/// is current.
void DrawCaptions(const Stage& stage, const Look& look, const mjrRect& viewport);

}  // namespace phs::view
