#include "rail/contact_search.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <utility>

#include "contact_pair.h"
#include "rail/tread_wear.h"
#include "tests/base/scratch_dir.h"

namespace phs::rail {
namespace {

constexpr double kRadius = 0.46;
constexpr double kHalfTape = 0.75;

ContactSearch Pair(const std::string& wheel, const std::string& rail, int fineness = 1) {
  auto w = LoadProfile(wheel, ProfileKind::kWheel);
  auto r = LoadProfile(rail, ProfileKind::kRail);
  EXPECT_TRUE(w.ok() && r.ok());
  return ContactSearch(std::move(w).value(), std::move(r).value(), kHalfTape, kRadius,
                       Hertz(82e9, 0.28), fineness);
}

Overlaps Find(const ContactSearch& search, const WheelPlacement& place) {
  Overlaps found;
  search.Find(place, kHalfTape, 0, &found);
  return found;
}

TEST(ContactSearch, ConeOnArcTouchesWhereTheSlopesAgree) {
  const double lambda = 0.05;
  const double rail_radius = 0.3;
  // A light overlap has few nodes.
  const ContactSearch search = Pair("cone:0.05", "arc:0.3", 4);
  // The cone is a straight line in section: touch at y = -Rr sin(delta), tan(delta) = lambda.
  const double cosine = 1 / std::sqrt(1 + lambda * lambda);
  const double y = -rail_radius * lambda * cosine;
  const double rail_z = rail_radius - rail_radius * cosine;
  for (const double depth : {1e-6, 1e-5, 1e-4}) {
    // Vertical overlap depth/cosine at the touching point; the wheel's z there is R - lambda y.
    const double centre = rail_z - (kRadius - lambda * y) + depth / cosine;
    const Overlaps found = Find(search, {0, centre, 0, 0});
    ASSERT_EQ(found.count, 1);
    const Overlap& p = found.patch[0];
    EXPECT_NEAR(p.y, y, 5e-6);
    EXPECT_NEAR(p.slope, -lambda, 1e-5);
    EXPECT_NEAR(p.depth / depth, 1, 2e-3);
    EXPECT_NEAR(p.across, 0.5 / rail_radius, 0.01 / rail_radius);
    EXPECT_NEAR(p.radius, kRadius - lambda * y, 1e-6);
    EXPECT_FALSE(p.at_end);
  }
}

/// A wheel profile of one concave arc of 0.5 m.
std::string HollowWheel() {
  std::string path = ScratchFile("hollow_wheel.txt");
  std::ofstream file(path);
  file.precision(15);
  for (int i = -160; i <= 160; ++i) {
    const double y = 0.4 * i;
    file << y << " " << 500 - std::sqrt(500 * 500 - y * y) << "\n";
  }
  return path;
}

TEST(ContactSearch, HollowWheelOnArcHasTheDifferenceOfCurvatures) {
  const ContactSearch search = Pair(HollowWheel(), "arc:0.3");
  const Overlaps found = Find(search, {0, -kRadius + 5e-5, 0, 0});
  ASSERT_EQ(found.count, 1);
  EXPECT_NEAR(found.patch[0].across, 0.5 * (1 / 0.3 - 1 / 0.5), 0.01);
  // Displaced by y, the contact moves by y R1/(R1 - R2) on the rail.
  const double shift = 2e-3;
  const Overlaps moved = Find(search, {shift, -kRadius + 5e-5, 0, 0});
  ASSERT_EQ(moved.count, 1);
  EXPECT_NEAR(moved.patch[0].y, -shift * 0.3 / (0.5 - 0.3), 0.02e-3);
}

/// Deepest vertical overlap of the wheel's surface with the rail, by brute force over the surface
/// of revolution itself (profile position s, angle about the axle).
struct Deepest {
  double overlap = -1;
  Vec3 arm{};
};
Deepest Brute(const ContactSearch& search, const WheelPlacement& w, double from, double to) {
  const Vec3 e = {-std::sin(w.yaw) * std::cos(w.roll), std::cos(w.yaw) * std::cos(w.roll),
                  std::sin(w.roll)};
  // Two unit vectors square to the axle: d as far down as possible, f along.
  const double q = std::sqrt(1 - e[2] * e[2]);
  const Vec3 d = {-e[0] * e[2] / q, -e[1] * e[2] / q, q};
  const Vec3 f = {e[1] * d[2] - e[2] * d[1], e[2] * d[0] - e[0] * d[2], e[0] * d[1] - e[1] * d[0]};
  Deepest best;
  double ds = (to - from) / 400, da = 0.2 / 400;
  double s0 = 0.5 * (from + to), a0 = 0;
  for (int zoom = 0; zoom < 5; ++zoom) {
    const double s_centre = s0, a_centre = a0;
    for (int i = -200; i <= 200; ++i) {
      for (int j = -200; j <= 200; ++j) {
        const double s = s_centre + i * ds;
        const double a = a_centre + j * da;
        const double r = kRadius + search.wheel().At(s).z;
        Vec3 arm{};
        for (size_t k = 0; k < 3; ++k) {
          arm[k] = e[k] * (kHalfTape + s) + r * (std::cos(a) * d[k] + std::sin(a) * f[k]);
        }
        const double overlap = w.z + arm[2] - search.rail().At(w.y + arm[1] - kHalfTape).z;
        if (overlap > best.overlap) {
          best = {overlap, arm};
          s0 = s;
          a0 = a;
        }
      }
    }
    ds *= 0.02;
    da *= 0.02;
  }
  return best;
}

TEST(ContactSearch, YawedAndRolledWheelTouchesWhereTheSurfaceItselfDoes) {
  const ContactSearch search = Pair(ProfilePath("S1002.prw"), ProfilePath("UIC60.prr"), 4);
  for (const WheelPlacement& place :
       {WheelPlacement{-0.003, 0, 0.002, 0.02}, WheelPlacement{0.0075, 0, -0.003, 0.02},
        WheelPlacement{0.0085, 0, 0.001, -0.015}, WheelPlacement{0.002, 0, 0.004, -0.03}}) {
    // Raise the wheel until only the last 0.2 um overlaps: then every measure means one point.
    WheelPlacement w = place;
    double low = -kRadius + 0.03, high = -kRadius - 0.03;
    for (int i = 0; i < 60; ++i) {
      w.z = 0.5 * (low + high);
      (Find(search, w).count > 0 ? low : high) = w.z;
    }
    w.z = low + 0.2e-6;
    const Overlaps found = Find(search, w);
    ASSERT_GE(found.count, 1);
    const Overlap& p = found.patch[0];
    const Deepest truth = Brute(search, w, p.wheel_y - 2e-3, p.wheel_y + 2e-3);
    // The nearest node sees the touch a little late.
    EXPECT_NEAR(truth.overlap, 0.2e-6, 0.1e-6);
    EXPECT_NEAR(p.arm[0], truth.arm[0], 0.05e-3);
    EXPECT_NEAR(p.arm[1], truth.arm[1], 0.03e-3);
    EXPECT_NEAR(p.arm[2], truth.arm[2], 0.03e-3);
  }
}

TEST(ContactSearch, RootAndTreadAtOnce) {
  const ContactSearch search = Pair(ProfilePath("S1002.prw"), ProfilePath("UIC60.prr"));
  // Press down a little after first touch, over the end of the flange's play: somewhere both do.
  bool both = false;
  for (double y = -0.01; y < 0.002 && !both; y += 20e-6) {
    WheelPlacement place{y, 0, 0, 0.01};
    double low = -kRadius + 0.03, high = -kRadius - 0.03;
    for (int i = 0; i < 40; ++i) {
      place.z = 0.5 * (low + high);
      (Find(search, place).count > 0 ? low : high) = place.z;
    }
    for (const double sunk : {20e-6, 50e-6, 80e-6}) {
      place.z = low + sunk;
      const Overlaps found = Find(search, place);
      const auto last = static_cast<size_t>(std::max(found.count - 1, 0));
      both = both || (found.count >= 2 && found.patch[last].slope - found.patch[0].slope > 0.05);
    }
  }
  EXPECT_TRUE(both);
}

TEST(ContactSearch, WeightsOfAMergingChainAddUpToOnePerHump) {
  const ContactSearch search = Pair(ProfilePath("S1002.prw"), ProfilePath("UIC60.prr"));
  int merging = 0;
  for (double y = -0.01; y < 0.01; y += 0.1e-3) {
    for (double z = -0.4e-3; z < 0.6e-3; z += 0.01e-3) {
      const Overlaps found = Find(search, {y, -kRadius + z, 0, 0});
      EXPECT_LE(found.count, kMaxOverlaps);
      for (int i = 0; i < found.count; ++i) {
        const Overlap& p = found.patch[static_cast<size_t>(i)];
        EXPECT_GT(p.weight, 0);
        EXPECT_LE(p.weight, 1);
        EXPECT_GT(p.depth, 0);
        EXPECT_GT(p.across, 0);
        if (p.weight < 1) ++merging;
      }
    }
  }
  EXPECT_GT(merging, 100);
}

/// Vertical force on the rail [N].
double ForceAt(const ContactSearch& search, const WheelPlacement& place) {
  const Overlaps found = Find(search, place);
  double force = 0;
  for (int k = 0; k < found.count; ++k) {
    const Overlap& p = found.patch[static_cast<size_t>(k)];
    force += p.weight * p.push[2];
  }
  return force;
}

// Any pose between climbing flanges, new and hollow tread: lowered by 1 um at a time from the
// first touch, the force only grows, and halving a step finds no force that appears at once. (Yawed by
// more than 30 mrad, one flange in a thousand touches between two samples, which is seen late.)
RC_GTEST_PROP(ContactSearch, ForceGrowsWithDepthAndNeverJumps, ()) {
  static const ContactSearch fresh = Pair(ProfilePath("S1002.prw"), ProfilePath("UIC60.prr"));
  static const ContactSearch hollow = [] {
    Profile wheel = LoadProfile(ProfilePath("S1002.prw"), ProfileKind::kWheel).value();
    WearTread({1.5e-3}, &wheel);
    Profile rail = LoadProfile(ProfilePath("UIC60.prr"), ProfileKind::kRail).value();
    return ContactSearch(std::move(wheel), std::move(rail), kHalfTape, kRadius, Hertz(82e9, 0.28));
  }();
  const ContactSearch& search = *rc::gen::inRange(0, 2) == 0 ? fresh : hollow;
  const double side = *rc::gen::inRange(-10000, 10000);
  const double roll = *rc::gen::inRange(-11000, 11000);
  const double yaw = *rc::gen::inRange(-30000, 30000);
  WheelPlacement place{1e-6 * side, 0, 1e-6 * roll, 1e-6 * yaw};
  double above = -kRadius - 0.03;
  double below = -kRadius + 0.03;
  for (int i = 0; i < 50; ++i) {
    place.z = 0.5 * (above + below);
    (ForceAt(search, place) > 0 ? below : above) = place.z;
  }
  const auto at = [&](double z) {
    place.z = z;
    return ForceAt(search, place);
  };
  double before = 0;
  for (double z = above; z < above + 150e-6; z += 1e-6) {
    const double force = at(z);
    RC_ASSERT(force >= before * (1 - 1e-4) - 0.1);
    if (force - before > 0.02 * before + 200) {
      double low = z - 1e-6, high = z, f_low = before, f_high = force;
      for (int i = 0; i < 25; ++i) {
        const double middle = 0.5 * (low + high);
        const double f = at(middle);
        const bool lower = f - f_low > f_high - f;
        (lower ? high : low) = middle;
        (lower ? f_high : f_low) = f;
      }
      RC_ASSERT(f_high - f_low < 3e-3 * force + 50);
    }
    before = force;
  }
}

TEST(ContactSearch, NothingFarAwayOrNotANumber) {
  const ContactSearch search = Pair(ProfilePath("S1002.prw"), ProfilePath("UIC60.prr"));
  const double nan = std::nan("");
  EXPECT_EQ(Find(search, {0, -kRadius - 0.1, 0, 0}).count, 0);
  EXPECT_EQ(Find(search, {nan, -kRadius, 0, 0}).count, 0);
  EXPECT_EQ(Find(search, {0, nan, 0, 0}).count, 0);
  EXPECT_EQ(Find(search, {0, -kRadius, nan, 0}).count, 0);
  EXPECT_EQ(Find(search, {0, -kRadius, 0, nan}).count, 0);
  EXPECT_EQ(Find(search, {1e300, -kRadius, 0, 0}).count, 0);
}

}  // namespace
}  // namespace phs::rail
