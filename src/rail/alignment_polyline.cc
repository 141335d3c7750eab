#include "rail/alignment_polyline.h"

#include <algorithm>

#include "base/check.h"

namespace phs::rail {

RoundedPolyline::RoundedPolyline(const std::vector<Vertex>& vertices) {
  PHS_CHECK(vertices.size() >= 2);
  auto slope_after = [&](size_t i) {
    return (vertices[i + 1].value - vertices[i].value) / (vertices[i + 1].s - vertices[i].s);
  };
  pieces_.push_back({vertices[0].s, {vertices[0].value, slope_after(0), 0}});
  for (size_t i = 1; i + 1 < vertices.size(); ++i) {
    const Vertex& v = vertices[i];
    const double before = slope_after(i - 1);
    const double after = slope_after(i);
    if (before == after) continue;
    const double d = v.half_length;
    constexpr double kRounding = 1e-6;  // parabolas may meet, and then overlap by rounding [m]
    PHS_CHECK(v.s - d >= pieces_.back().s - kRounding && v.s + d <= vertices[i + 1].s + kRounding);
    if (d > 0) {
      pieces_.push_back({std::max(v.s - d, pieces_.back().s),
                         {v.value - before * d, before, (after - before) / (4 * d)}});
    }
    pieces_.push_back({v.s + d, {v.value + after * d, after, 0}});
  }
}

Quadratic RoundedPolyline::ExpandAt(double s) const {
  auto next = std::upper_bound(pieces_.begin(), pieces_.end(), s,
                               [](double at, const Piece& piece) { return at < piece.s; });
  const Piece& piece = next == pieces_.begin() ? *next : *(next - 1);
  const double u = s - piece.s;
  return {piece.f.At(u), piece.f.SlopeAt(u), piece.f.half_second};
}

std::vector<double> RoundedPolyline::Breaks() const {
  std::vector<double> breaks;
  for (const Piece& piece : pieces_) breaks.push_back(piece.s);
  return breaks;
}

}  // namespace phs::rail
