// What the grid of samples and nodes changes in the forces of a wheel: against one four times as fine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "contact_pair.h"
#include "rail/contact_search.h"

namespace phs::rail {
namespace {

constexpr double kRailY = 0.5765;  ///< UIC60 at 1067 mm
constexpr double kLoad = 80e3;     ///< [N]

ContactSearch Pair(int fineness) {
  auto wheel = LoadProfile(ProfilePath("S1002.prw"), ProfileKind::kWheel);
  auto rail = LoadProfile(ProfilePath("UIC60.prr"), ProfileKind::kRail);
  EXPECT_TRUE(wheel.ok() && rail.ok());
  rail.value().PutTopAtZero();
  return ContactSearch(std::move(wheel).value(), std::move(rail).value(), 0.566, 0.625,
                       Hertz(82e9, 0.28), fineness);
}

struct Force {
  double vertical = 0, lateral = 0, radius = 0;
};

Force ForcesAt(const ContactSearch& search, const WheelPlacement& place) {
  Overlaps found;
  search.Find(place, kRailY, 0, &found);
  Force f;
  for (int i = 0; i < found.count; ++i) {
    const Overlap& p = found.patch[static_cast<size_t>(i)];
    f.vertical += p.weight * p.push[2];
    f.lateral += p.weight * p.push[1];
    f.radius += p.weight * p.push[2] * p.radius;
  }
  f.radius /= f.vertical;
  return f;
}

/// Lowered until it carries the load.
void SinkUnderLoad(const ContactSearch& search, WheelPlacement* place, double load = kLoad) {
  double low = -0.7, high = -0.5;
  for (int i = 0; i < 45; ++i) {
    place->z = 0.5 * (low + high);
    (ForcesAt(search, *place).vertical < load ? low : high) = place->z;
  }
}

TEST(ContactGrid, ChangesForceAndRadiusByLittle) {
  const ContactSearch usual = Pair(1), fine = Pair(4);
  std::mt19937 random(3);
  std::uniform_real_distribution<> one(-1, 1);
  std::vector<double> vertical, lateral, radius;
  for (int i = 0; i < 3000; ++i) {
    WheelPlacement place{6.5e-3 * one(random), 0, 0.5e-3 * one(random), 3e-3 * one(random)};
    SinkUnderLoad(fine, &place);
    const Force a = ForcesAt(usual, place), b = ForcesAt(fine, place);
    vertical.push_back(std::abs(a.vertical / b.vertical - 1));
    lateral.push_back(std::abs(a.lateral - b.lateral) / b.vertical);
    radius.push_back(std::abs(a.radius - b.radius));
  }
  const auto check = [](std::vector<double>* errors, double median, double largest) {
    std::sort(errors->begin(), errors->end());
    EXPECT_LT((*errors)[errors->size() / 2], median);
    EXPECT_LT(errors->back(), largest);
  };
  check(&vertical, 6e-5, 1.5e-3);
  check(&lateral, 2e-6, 3e-3);
  check(&radius, 0.01e-6, 4e-6);
}

TEST(ContactGrid, MakesNoStepInTheForce) {
  const ContactSearch search = Pair(1);
  constexpr double kStep = 0.2e-6;
  for (int tenth = -70; tenth < 65; ++tenth) {
    const double from = 1e-4 * tenth;
    WheelPlacement place{from, 0, -1e-3, 0.15e-3};
    SinkUnderLoad(search, &place);
    Force before[2];
    for (int i = -2; i < 500; ++i) {
      place.y = from + i * kStep;
      const Force now = ForcesAt(search, place);
      if (i >= 0) {
        const double step = std::abs(now.vertical - 2 * before[1].vertical + before[0].vertical) +
                            std::abs(now.lateral - 2 * before[1].lateral + before[0].lateral);
        EXPECT_LT(step, 1e-4 * kLoad) << "at " << place.y;
      }
      before[0] = before[1];
      before[1] = now;
    }
  }
}

// A climbing wheel on two humps, 18 mrad of yaw, moved by a quarter of a micrometre at a time: the
// second difference of the lateral force under one load. Chords of the rail that are not made finer
// with the samples look like ridges: then it is 600 to 5000 N.
TEST(ContactGrid, FinerGridsHaveNoStepsEither) {
  for (const int fineness : {1, 2, 4}) {
    const ContactSearch search = Pair(fineness);
    double before = 0, last = 0, largest = 0;
    for (int i = 0; i <= 440; ++i) {
      WheelPlacement place{6.29e-3 + 0.25e-6 * i, 0, 0, -17.73e-3};
      SinkUnderLoad(search, &place, 163e3);
      const double lateral = ForcesAt(search, place).lateral;
      if (i > 1) largest = std::max(largest, std::abs(lateral - 2 * last + before));
      before = last;
      last = lateral;
    }
    EXPECT_LT(largest, 100) << fineness;
  }
}

}  // namespace
}  // namespace phs::rail
