// Track files: reading, errors, the product's own tracks, both hands, quasi-static curving.
#include "rail/track.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "phs_places.h"
#include "tests/base/scratch_dir.h"

namespace phs::rail {
namespace {

using ::testing::HasSubstr;

std::string Written(const std::string& text, const std::string& name = "some_track.yaml") {
  const std::string path = ScratchFile(name);
  std::ofstream(path) << text;
  return path;
}

std::string Model(const std::string& name) {
  return std::string(PHS_SOURCE_DIR) + "/models/tracks/" + name + ".yaml";
}

Track Loaded(const std::string& path, bool mirror = false) {
  Result<Track> track = Track::Load(path, mirror);
  if (!track.ok()) ADD_FAILURE() << track.error().Line();
  return std::move(track).value();
}

constexpr char kSimple[] = R"(gauge_m: 1.067
friction: 0.4
segments:
  - {kind: tangent, length_m: 50}
  - {kind: transition, length_m: 40}
  - {kind: curve, hand: right, radius_m: 300, angle_deg: 30, cant_m: 0.05, gauge_widening_m: 0.008}
  - {kind: transition, length_m: 40}
  - {kind: tangent, length_m: 50}
support: {lateral_stiffness_N_per_m: 2.0e+7, lateral_damping_Ns_per_m: 5.0e+4}
)";

TEST(Track, ReadsSegmentsSectionsAndValues) {
  const Track track = Loaded(Written(kSimple));
  const double arc = 300 * M_PI / 6;
  EXPECT_EQ(track.name(), "some_track");
  EXPECT_DOUBLE_EQ(track.length(), 180 + arc);
  EXPECT_EQ(track.gauge(), 1.067);
  EXPECT_EQ(track.gauge_height(), 0.014);
  EXPECT_EQ(track.friction(), 0.4);
  EXPECT_DOUBLE_EQ(track.cant_base(), 1.139);
  EXPECT_EQ(track.support().lateral_stiffness_N_per_m, 2e7);
  EXPECT_EQ(track.support().lateral_damping_Ns_per_m, 5e4);
  EXPECT_EQ(track.support().vertical_stiffness_N_per_m, 0);
  EXPECT_FALSE(track.has_irregularity());
  ASSERT_EQ(track.sections().size(), 5u);
  EXPECT_EQ(track.sections()[1].kind, "transition");
  EXPECT_EQ(track.sections()[2].kind, "curve");
  EXPECT_DOUBLE_EQ(track.sections()[2].begin_s, 90);
  EXPECT_DOUBLE_EQ(track.sections()[2].end_s, 90 + arc);
  EXPECT_DOUBLE_EQ(track.sections()[2].curvature, -1 / 300.0);
  EXPECT_LT(track.FrameAt(120).cant, 0);  // right-hand curve: left rail raised
  EXPECT_DOUBLE_EQ(track.Rail(Side::kLeft, 120).lateral, 0.004);
  EXPECT_DOUBLE_EQ(track.Rail(Side::kRight, 120).lateral, -0.004);
}

// On a cant ramp the rails run against x_T although their displacement is zero: the slope of the
// rail heads in the world less the slope of the centre line.
TEST(Track, VerticalSlopeOfTheRailsHoldsTheTwistOfTheRamp) {
  const Track track = Loaded(Written(kSimple));
  for (double s : {51.0, 70.0, 88.0, 120.0, 250.0}) {
    for (Side side : {Side::kLeft, Side::kRight}) {
      const double y = (side == Side::kLeft ? 0.5 : -0.5) * track.cant_base();
      auto rail_z = [&](double at) {
        const TrackFrame f = track.FrameAt(at);
        return f.origin[2] + y * f.left[2];
      };
      const double h = 1e-3;
      const double slope = (rail_z(s + h) - rail_z(s - h)) / (2 * h);
      const TrackFrame f = track.FrameAt(s);
      const double centre = f.forward[2] / std::sqrt(1 - f.forward[2] * f.forward[2]);
      EXPECT_NEAR(track.Rail(side, s).vertical_slope, slope - centre, 5e-6) << s;
    }
  }
}

TEST(Track, FrictionIsNaNWhenNotGiven) {
  EXPECT_TRUE(std::isnan(Loaded(Written("segments: [{kind: tangent, length_m: 10}]")).friction()));
}

TEST(Track, MirrorOfAFileEqualsTheMirrorOnLoading) {
  const Track original = Loaded(Written(kSimple));
  Written("mirror_of: some_track\n", "other_hand.yaml");
  const Track file = Loaded(ScratchFile("other_hand.yaml"));
  const Track loaded = Loaded(Written(kSimple), true);
  EXPECT_EQ(file.name(), "other_hand");
  for (double s = -5; s < original.length() + 5; s += 3.3) {
    const TrackFrame a = original.FrameAt(s);
    const TrackFrame b = file.FrameAt(s);
    EXPECT_EQ(a.origin, (Vec3{b.origin[0], -b.origin[1], b.origin[2]}));
    EXPECT_EQ(loaded.FrameAt(s).origin, b.origin);
    const RailOffset left = original.Rail(Side::kLeft, s);
    const RailOffset right = file.Rail(Side::kRight, s);
    EXPECT_EQ(left.lateral, -right.lateral);
    EXPECT_EQ(left.vertical_slope, right.vertical_slope);
  }
}

TEST(Track, IrregularityIsMirroredWithTheTrack) {
  const Track a = Loaded(Model("curve_r550_rough"));
  const Track b = Loaded(Model("curve_r550_rough"), true);
  ASSERT_TRUE(a.has_irregularity());
  double largest = 0;
  for (double s = 0; s < a.length(); s += 1.7) {
    const RailOffset left = a.Rail(Side::kLeft, s);
    const RailOffset right = b.Rail(Side::kRight, s);
    EXPECT_EQ(left.lateral, -right.lateral);
    EXPECT_EQ(left.vertical, right.vertical);
    EXPECT_EQ(left.lateral_slope, -right.lateral_slope);
    EXPECT_EQ(left.vertical_slope, right.vertical_slope);
    largest = std::max(largest, std::abs(left.vertical));
  }
  EXPECT_GT(largest, 1e-3);
  EXPECT_LT(largest, 20e-3);
}

TEST(Track, RecordIsReadBesideTheTrackFile) {
  Written("s_m,alignment_m\n0,0\n20,0.002\n40,0.002\n60,0.002\n80,0\n", "record.csv");
  const Track track = Loaded(Written(
      "segments: [{kind: tangent, length_m: 100}]\nirregularity: {file: record.csv, fade_m: 5}\n"));
  EXPECT_DOUBLE_EQ(track.Rail(Side::kRight, 40).lateral, 0.002);
  EXPECT_EQ(track.Rail(Side::kRight, 90).lateral, 0);
}

struct BadFile {
  const char* what;
  const char* text;
  std::vector<const char*> message;
};

class TrackErrors : public ::testing::TestWithParam<BadFile> {};

TEST_P(TrackErrors, NameFileLineAllowedAndMend) {
  const Result<Track> track = Track::Load(Written(GetParam().text, "bad.yaml"));
  ASSERT_FALSE(track.ok());
  for (const char* part : GetParam().message) {
    EXPECT_THAT(track.error().Line(), HasSubstr(part));
  }
}

INSTANTIATE_TEST_SUITE_P(
    EveryMessage, TrackErrors,
    ::testing::Values(
        BadFile{"curvature",
                "segments:\n  - {kind: tangent, length_m: 50}\n  - {kind: curve, hand: left, "
                "radius_m: 400, length_m: 100}\n  - {kind: tangent, length_m: 50}\n",
                {"bad.yaml:3", "curvature jumps from straight to R = 400 m left", "transition"}},
        BadFile{"cant",
                "segments:\n  - {kind: tangent, length_m: 50}\n  - {kind: transition, length_m: "
                "50}\n  - {kind: curve, hand: left, radius_m: 400, length_m: 100, cant_m: 0.05}\n"
                "  - {kind: curve, hand: left, radius_m: 400, length_m: 100}\n  - {kind: "
                "transition, length_m: 50}\n  - {kind: tangent, length_m: 50}\n",
                {"bad.yaml:5", "cant jumps from 50.0"}},
        BadFile{"ends",
                "segments:\n  - {kind: curve, hand: left, radius_m: 400, length_m: 100}\n",
                {"bad.yaml:2", "begins or ends outside a tangent"}},
        BadFile{"transitions",
                "segments:\n  - {kind: tangent, length_m: 50}\n  - {kind: transition, length_m: "
                "50}\n  - {kind: transition, length_m: 50}\n  - {kind: tangent, length_m: 50}\n",
                {"bad.yaml:3", "a transition without a tangent or curve on both sides"}},
        BadFile{"none", "gauge_m: 1.067\n", {"bad.yaml", "segments"}},
        BadFile{"kind",
                "segments:\n  - {kind: tangnet, length_m: 50}\n",
                {"bad.yaml:2", "tangnet", "tangent"}},
        BadFile{"key",
                "segments:\n  - {kind: tangent, length_m: 50, cant_m: 0.1}\n",
                {"bad.yaml:2", "cant_m"}},
        BadFile{"radius",
                "segments:\n  - {kind: curve, hand: left, radius_m: 20, length_m: 100}\n",
                {"bad.yaml:2", "radius_m", "50"}},
        BadFile{"arc",
                "segments:\n  - {kind: curve, hand: left, radius_m: 200}\n",
                {"bad.yaml:2", "one of length_m, angle_deg"}},
        BadFile{
            "length", "segments:\n  - {kind: tangent, length_m: 0}\n", {"bad.yaml:2", "length_m"}},
        BadFile{"gauge",
                "gauge_m: 1067\nsegments:\n  - {kind: tangent, length_m: 5}\n",
                {"bad.yaml:1", "gauge_m"}},
        BadFile{"stiffness",
                "segments: [{kind: tangent, length_m: 5}]\nsupport: {lateral_stiffness_N_per_m: "
                "-1}\n",
                {"bad.yaml:2", "lateral_stiffness_N_per_m"}},
        BadFile{"damper alone",
                "segments: [{kind: tangent, length_m: 5}]\nsupport: {vertical_damping_Ns_per_m: "
                "9.0e+4}\n",
                {"bad.yaml:2", "vertical_damping_Ns_per_m", "vertical_stiffness_N_per_m"}},
        BadFile{"psd name",
                "segments: [{kind: tangent, length_m: 50}]\nirregularity: {psd: erri_low}\n",
                {"bad.yaml:2", "errib176_low"}},
        BadFile{"psd or file",
                "segments: [{kind: tangent, length_m: 50}]\nirregularity: {fade_m: 5}\n",
                {"bad.yaml:2", "one of file, psd"}},
        BadFile{"band",
                "segments: [{kind: tangent, length_m: 50}]\nirregularity: {psd: fra_4, "
                "shortest_wavelength_m: 20, longest_wavelength_m: 10}\n",
                {"bad.yaml:2", "band of wavelengths"}},
        BadFile{"range",
                "segments: [{kind: tangent, length_m: 50}]\nirregularity: {psd: fra_4, "
                "begin_s_m: 40, end_s_m: 20}\n",
                {"bad.yaml:2", "shorter than 1 m"}},
        BadFile{"psd too long",
                "segments: [{kind: tangent, length_m: 60000}]\nirregularity: {psd: fra_4}\n",
                {"bad.yaml:2", "would take minutes", "about 30 km"}},
        BadFile{"record",
                "segments: [{kind: tangent, length_m: 50}]\nirregularity: {file: none.csv}\n",
                {"none.csv"}},
        BadFile{"mirror", "mirror_of: nowhere\n", {"bad.yaml:1", "nowhere"}},
        BadFile{"mirror of itself", "mirror_of: bad\n", {"bad.yaml:1", "mirror image"}}),
    [](const auto& info) {
      std::string name = info.param.what;
      for (char& c : name) c = c == ' ' ? '_' : c;
      return name;
    });

TEST(TrackErrors, MissingFile) {
  const Result<Track> track = Track::Load("/nowhere/track.yaml");
  ASSERT_FALSE(track.ok());
  EXPECT_THAT(track.error().Line(), HasSubstr("/nowhere/track.yaml"));
}

TEST(TrackModels, AllLoadAndProject) {
  int count = 0;
  for (const auto& file :
       std::filesystem::directory_iterator(std::string(PHS_SOURCE_DIR) + "/models/tracks")) {
    if (file.path().extension() != ".yaml") continue;
    const Track track = Loaded(file.path().string());
    EXPECT_EQ(track.name(), file.path().stem().string());
    EXPECT_EQ(track.gauge(), 1.067);
    for (double s = 1; s < track.length(); s += 7.7) {
      const TrackFrame f = track.FrameAt(s);
      EXPECT_NEAR(track.Project({f.origin[0], f.origin[1], f.origin[2] + 0.6}), s,
                  0.601 * std::abs(f.forward[2]) + 1e-9);
    }
    ++count;
  }
  EXPECT_GE(count, 10);
}

// Quasi-static statics of a curve from the frames alone: a point on the centre line at speed V
// feels V^2 k cos(cant) - g sin(cant) along y_T; cant deficiency e V^2/(g R) - h from the files'
// comments.
TEST(TrackModels, CantDeficiencyAtLineSpeedIsModerateInEveryCurve) {
  struct Case {
    const char* track;
    double speed_km_h, deficiency;
  };
  for (const Case& c : {Case{"curve_r150", 40, 0.0456}, Case{"curve_r250", 50, 0.0446},
                        Case{"curve_r300", 55, 0.0453}, Case{"curve_r400", 65, 0.0446},
                        Case{"curve_r550", 80, 0.0442}, Case{"curve_r800", 80, 0.0416}}) {
    const Track track = Loaded(Model(c.track));
    const TrackSection& arc = track.sections()[2];
    ASSERT_EQ(arc.kind, "curve");
    EXPECT_GE(arc.end_s - arc.begin_s, 200);
    const double s = (arc.begin_s + arc.end_s) / 2;
    const double v = c.speed_km_h / 3.6;
    const double h = 0.5;
    const TrackFrame f = track.FrameAt(s);
    const Vec3 a = track.FrameAt(s - h).origin;
    const Vec3 b = track.FrameAt(s + h).origin;
    double lateral = 0;
    for (int i = 0; i < 3; ++i) {
      lateral += f.left[i] * (b[i] - 2 * f.origin[i] + a[i]) / (h * h) * v * v;
    }
    lateral += 9.81 * f.left[2];  // gravity pulls to the low side
    EXPECT_NEAR(lateral * track.cant_base() / 9.81, c.deficiency, 0.0005) << c.track;
  }
}

TEST(Track, ErrorsComeOnTopOfTheDesign) {
  const std::string path = Written(kSimple);
  const Track design = Loaded(path);
  auto off = Track::Load(path, false, {0.02, 0.005});
  ASSERT_TRUE(off.ok()) << off.error().Line();
  const double e = design.cant_base(), arc = 150, transition = 70;
  // Right-hand curve: the left rail is raised, more by the error; half of it half way up the ramp.
  EXPECT_NEAR(off.value().FrameAt(arc).cant, -std::asin(0.07 / e), 1e-12);
  EXPECT_NEAR(off.value().FrameAt(transition).cant, -std::asin(0.035 / e), 1e-5);
  EXPECT_EQ(off.value().FrameAt(20).cant, 0);
  EXPECT_NEAR(Track::Load(path, false, {-0.02, 0}).value().FrameAt(arc).cant, -std::asin(0.03 / e),
              1e-12);
  for (const double s : {20.0, arc}) {
    EXPECT_NEAR(off.value().Rail(Side::kLeft, s).lateral - design.Rail(Side::kLeft, s).lateral,
                0.0025, 1e-12);
    EXPECT_NEAR(off.value().Rail(Side::kRight, s).lateral - design.Rail(Side::kRight, s).lateral,
                -0.0025, 1e-12);
  }
  auto mirrored = Track::Load(path, true, {0.02, 0.005});
  ASSERT_TRUE(mirrored.ok());
  EXPECT_EQ(mirrored.value().FrameAt(arc).cant, -off.value().FrameAt(arc).cant);
  EXPECT_EQ(mirrored.value().FrameAt(arc).curvature, design.FrameAt(arc).curvature * -1);
  for (const auto& wrong : {rail::TrackErrors{0.2, 0}, rail::TrackErrors{0, 0.1}}) {
    EXPECT_FALSE(Track::Load(path, false, wrong).ok());
  }
}

}  // namespace
}  // namespace phs::rail
