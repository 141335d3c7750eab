#include "rail/track.h"

#include <utility>

#include "rail/alignment.h"
#include "rail/irregularity.h"
#include "rail/irregularity_psd.h"
#include "rail/track_layout.h"

namespace phs::rail {

struct Track::Impl {
  explicit Impl(Alignment a) : alignment(std::move(a)) {}
  TrackLayout layout;
  Alignment alignment;
  Irregularity irregularity;
  std::vector<TrackSection> sections;
};

namespace {

const char* SectionKind(SegmentKind kind) {
  switch (kind) {
    case SegmentKind::kTangent:
      return "tangent";
    case SegmentKind::kTransition:
      return "transition";
    case SegmentKind::kCurve:
      return "curve";
  }
  return "";
}

// One section for neighbouring segments of the same kind and curvature (they may differ in
// gradient).
std::vector<TrackSection> ListSections(const std::vector<TrackSegment>& segments) {
  std::vector<TrackSection> sections;
  double s = 0;
  for (const TrackSegment& segment : segments) {
    const double curvature = segment.kind == SegmentKind::kCurve ? segment.curvature_begin : 0;
    const std::string kind = SectionKind(segment.kind);
    if (!sections.empty() && sections.back().kind == kind &&
        sections.back().curvature == curvature) {
      sections.back().end_s = s + segment.length;
    } else {
      sections.push_back({kind, s, s + segment.length, curvature});
    }
    s += segment.length;
  }
  return sections;
}

Irregularity MakeIrregularity(const IrregularityLayout& layout, bool mirrored) {
  IrregularitySamples samples = layout.samples ? *layout.samples : GenerateIrregularity(layout.psd);
  if (mirrored) samples.Mirror();
  return Irregularity(samples, layout.fade);
}

}  // namespace

Result<Track> Track::Load(const std::string& path, bool mirror, const TrackErrors& errors,
                          double speed_m_s) {
  auto layout = ReadTrackLayout(path, mirror, speed_m_s);
  if (!layout.ok()) return layout.error();
  if (Status s = ApplyErrors(errors, &layout.value()); !s.ok()) return s.error();
  auto alignment = Alignment::Create(layout.value().alignment);
  if (!alignment.ok()) return alignment.error();
  auto impl = std::make_unique<Impl>(std::move(alignment).value());
  impl->layout = std::move(layout).value();
  impl->sections = ListSections(impl->layout.alignment.segments);
  if (impl->layout.irregularity) {
    impl->irregularity = MakeIrregularity(*impl->layout.irregularity, impl->layout.mirrored);
    impl->layout.irregularity->samples.reset();
  }
  return Track(std::move(impl));
}

Track::Track(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Track::Track(Track&&) noexcept = default;
Track& Track::operator=(Track&&) noexcept = default;
Track::~Track() = default;

const std::string& Track::name() const { return impl_->layout.name; }
double Track::length() const { return impl_->alignment.length(); }
double Track::gauge() const { return impl_->layout.gauge; }
double Track::gauge_height() const { return impl_->layout.gauge_height; }
double Track::friction() const { return impl_->layout.friction; }
double Track::cant_base() const { return impl_->layout.alignment.cant_base; }
const RailSupport& Track::support() const { return impl_->layout.support; }
const std::vector<TrackSection>& Track::sections() const { return impl_->sections; }
bool Track::has_irregularity() const { return !impl_->irregularity.empty(); }

TrackFrame Track::FrameAt(double s) const noexcept { return impl_->alignment.FrameAt(s); }
double Track::Project(const Vec3& point) const noexcept { return impl_->alignment.Project(point); }

RailOffset Track::Rail(Side side, double s) const noexcept {
  RailOffset offset = impl_->irregularity.At(side, s);
  const double half = side == Side::kLeft ? 0.5 : -0.5;
  const Quadratic widening = impl_->alignment.WideningAt(s);
  offset.lateral += half * widening.value;
  offset.lateral_slope += half * widening.slope;
  offset.twist = impl_->alignment.TwistAt(s);
  offset.half_base = 0.5 * cant_base();
  offset.vertical_slope -= half * cant_base() * offset.twist;
  offset.curvature = impl_->alignment.CurvatureAt(s);
  return offset;
}

}  // namespace phs::rail
