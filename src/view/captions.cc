#include "view/captions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "view/palette.h"

namespace phs::view {
namespace {

/// Where an axle points: words for the sign of an angle of attack.
std::string AttackText(double attack, double curvature) {
  const double mrad = 1e3 * attack;
  if (curvature == 0 || std::abs(mrad) < 0.005) return fmt::format("{:.2f} mrad", std::abs(mrad));
  // Positive is to the left: in a left-hand curve towards the inner rail.
  const bool inner = (attack > 0) == (curvature > 0);
  return fmt::format("{:.2f} mrad to {} rail", std::abs(mrad), inner ? "inner" : "outer");
}

int WidthOf(const std::string& text, const mjrContext& context) {
  int width = 0;
  for (const char c : text) width += context.charWidth[static_cast<unsigned char>(c) % 127];
  return width;
}

void DrawPressureScale(const Stage& stage, const mjrRect& viewport) {
  if (!stage.has_pressures()) return;
  const mjrContext& context = stage.context();
  const PressureScale& scale = stage.picture().pressures;
  const std::string text =
      fmt::format("line pressure {:g} ... {:g} MPa absolute", scale.low * 1e-6, scale.high * 1e-6);
  const int bar = std::max(6, viewport.height / 70);
  const int width = WidthOf(text, context) + 2 * context.charHeight;
  if (width + 10 > viewport.width) return;
  const int left = viewport.left + viewport.width - width - 6;
  const int bottom = viewport.bottom + 6;
  mjr_label({left, bottom, width, bar + context.charHeight + 10}, mjFONT_NORMAL, "", 0.95f, 0.96f,
            0.97f, 0.85f, 0, 0, 0, &context);
  constexpr int kParts = 48;
  const int inside = width - 12;
  for (int i = 0; i < kParts; ++i) {
    const Colour c = ScaleColour((i + 0.5) / kParts);
    const int from = left + 6 + inside * i / kParts;
    const int to = left + 6 + inside * (i + 1) / kParts;
    mjr_rectangle({from, bottom + 4, to - from, bar}, c.r, c.g, c.b, 1);
  }
  mjr_label({left, bottom + bar + 6, width, context.charHeight + 2}, mjFONT_NORMAL, text.c_str(),
            0.95f, 0.96f, 0.97f, 0, 0.1f, 0.1f, 0.1f, &context);
}

/// Where there is room for little: who, and how the leading axle stands.
void DrawFewCaptions(const Stage& stage, const Look& look, const mjrRect& viewport) {
  const Picture& p = stage.picture();
  const std::string lead = p.model->binding().wheelsets()[0].name;
  const double curvature = p.Value("curvature_1_m");
  std::string text = fmt::format("{:.0f} km/h, {}\nangle of attack\n{}", 3.6 * p.Value("speed_m_s"),
                                 CurveText(curvature),
                                 AttackText(p.Value(lead + "_angle_of_attack_rad"), curvature));
  if (look.magnify.yaw != 1) text += fmt::format("\nyaw drawn x {:g}", look.magnify.yaw);
  mjr_overlay(mjFONT_NORMAL, mjGRID_TOPLEFT, viewport, TitleOf(stage.recording()).c_str(), nullptr,
              &stage.context());
  mjr_overlay(mjFONT_NORMAL, mjGRID_BOTTOMLEFT, viewport, text.c_str(), nullptr, &stage.context());
}

}  // namespace

std::string TitleOf(const Recording& recording) {
  std::string title = recording.label;
  for (char& c : title) c = c == '_' ? ' ' : c;
  if (title.starts_with("phs")) title.replace(0, 3, "PHS");
  if (!title.empty() && title[0] >= 'a' && title[0] <= 'z') title[0] -= 'a' - 'A';
  return title + (recording.scenario.vehicle == "locomotive" ? " locomotive" : " bogie");
}

std::string CurveText(double curvature) {
  if (std::abs(curvature) < 1e-6) return "straight";
  return fmt::format("R = {:.0f} m {}", std::abs(1 / curvature), curvature > 0 ? "left" : "right");
}

std::vector<CaptionLine> CaptionsOf(const Stage& stage, const Look& look) {
  const Picture& p = stage.picture();
  const std::string lead = p.model->binding().wheelsets()[0].name;
  const double curvature = p.Value("curvature_1_m");
  std::vector<CaptionLine> lines = {
      {"time", fmt::format("{:.2f} s", p.at.time)},
      {"place", fmt::format("{:.1f} m", p.Value("s_m"))},
      {"speed", fmt::format("{:.1f} km/h", 3.6 * p.Value("speed_m_s"))},
      {"curve", CurveText(curvature)},
      {"angle of attack", AttackText(p.Value(lead + "_angle_of_attack_rad"), curvature)},
      {"sum of Y", fmt::format("{:.1f} kN", 1e-3 * std::abs(p.Value(lead + "_sum_Y_N")))}};
  if (look.magnify.yaw != 1)
    lines.push_back({"yaw drawn", fmt::format("x {:g}", look.magnify.yaw)});
  if (look.magnify.lateral != 1) {
    lines.push_back({"sideways drawn", fmt::format("x {:g}", look.magnify.lateral)});
  }
  return lines;
}

void DrawCaptions(const Stage& stage, const Look& look, const mjrRect& viewport) {
  constexpr int kNarrow = 420;
  if (viewport.width < kNarrow) {
    DrawFewCaptions(stage, look, viewport);
    return;
  }
  std::string names;
  std::string values;
  for (const CaptionLine& line : CaptionsOf(stage, look)) {
    names += (names.empty() ? "" : "\n") + line.name;
    values += (values.empty() ? "" : "\n") + line.value;
  }
  mjr_overlay(mjFONT_BIG, mjGRID_TOPRIGHT, viewport, TitleOf(stage.recording()).c_str(), nullptr,
              &stage.context());
  mjr_overlay(mjFONT_NORMAL, mjGRID_TOPLEFT, viewport, names.c_str(), values.c_str(),
              &stage.context());
  if (look.forces && !look.contacts) {
    std::string scale = fmt::format(
        "arrows on the wheels: blue Q 100 kN = {:g} m, orange Y and green X 10 kN = {:g} m",
        1e5 * kLoadScale, 1e4 * kGuidingScale);
    if (stage.has_pressures()) {
      scale += fmt::format("\non the axle boxes: cylinders, red push, violet pull, 10 kN = {:g} m",
                           1e4 * kCylinderScale);
    }
    if (viewport.width >= 900) {
      mjr_overlay(mjFONT_NORMAL, mjGRID_BOTTOMLEFT, viewport, scale.c_str(), nullptr,
                  &stage.context());
    }
  }
  DrawPressureScale(stage, viewport);
}

}  // namespace phs::view
