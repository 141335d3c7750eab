// S1002 on UIC60 1:40 against a table of contact functions of the program RSGEO (Kik), as given
// with DYTSI (github.com/daniele-bigoni/dytsi, LGPL-3: not shipped). PHS_RSGEO_FILE names the
// table:
//   y_rel_m, normal_force_N, contact angle, a_m, b_m, lateral_contact_pos_m, rolling_radius_m, …
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include "base/table.h"
#include "contact_pair.h"

namespace phs::rail {
namespace {

/// Root mean squares of the differences over y = -8 … 7 mm, the table's single contact on the
/// tread.
struct Differences {
  double angle = 0;     ///< [rad]
  double position = 0;  ///< of the contact from the track's centre, apart from its mean [m]
  double offset = 0;    ///< that mean [m]
  double radius = 0;    ///< apart from its mean [m]
};

struct Contact {
  double angle, position, radius;
};

/// A right wheel without roll under a load [N].
Contact UnderLoad(const WheelRail& pair, double y, double load) {
  WheelsetMotion motion;
  motion.lateral = y;
  motion.speed = 20;
  motion.velocity = {20, 0, 0};
  double low = pair.Touch(y, 0, 0).height;
  double high = low + 2e-3;
  WheelRailForces f;
  for (int i = 0; i < 50; ++i) {
    motion.vertical = 0.5 * (low + high);
    pair.Calc(motion, Side::kRight, {}, {}, &f);
    (-f.elastic_force[2] < load ? low : high) = motion.vertical;
  }
  Contact c{};
  double sum = 0;
  for (int i = 0; i < f.count; ++i) {
    const ContactPatch& patch = f.patch[static_cast<size_t>(i)];
    c.angle += patch.normal * patch.angle;
    c.position += patch.normal * patch.point[1];
    c.radius += patch.normal * patch.rolling_radius;
    sum += patch.normal;
  }
  return {c.angle / sum, c.position / sum, c.radius / sum};
}

Differences Compare(double flange_back_distance, const Table& t) {
  WheelRailParams p = StandardPair();
  p.flange_back_distance = flange_back_distance;
  p.wheel_radius = 0.425;
  p.creep.method = "linear";
  const WheelRail pair = Create(p);
  double count = 0, angle = 0, place = 0, place2 = 0, radius = 0, radius2 = 0;
  for (size_t i = 0; i < t.columns[0].size(); ++i) {
    const double y = t.columns[0][i];
    if (y < -8.05e-3 || y > 7.05e-3) continue;
    const Contact own = UnderLoad(pair, y, t.columns[1][i]);
    const double d_place = own.position - t.columns[5][i];
    const double d_radius = own.radius - t.columns[6][i];
    angle += std::pow(own.angle - t.columns[2][i], 2);
    place += d_place;
    place2 += d_place * d_place;
    radius += d_radius;
    radius2 += d_radius * d_radius;
    ++count;
  }
  const auto spread = [&](double sum, double squares) {
    return std::sqrt(squares / count - sum * sum / (count * count));
  };
  return {std::sqrt(angle / count), spread(place, place2), place / count, spread(radius, radius2)};
}

TEST(RsgeoTest, TheTableIsOursWithFlangeBacksFiveMillimetresNearer) {
  const char* path = std::getenv("PHS_RSGEO_FILE");
  if (path == nullptr) GTEST_SKIP() << "PHS_RSGEO_FILE is not set";
  const auto table = ReadCsv(path);
  ASSERT_TRUE(table.ok()) << table.error().Line();
  const Differences near = Compare(1.355, table.value());
  EXPECT_LT(near.angle, 5e-3);
  EXPECT_LT(near.position, 1.5e-3);
  EXPECT_LT(std::abs(near.offset), 1.5e-3);
  EXPECT_LT(near.radius, 0.1e-3);
  // With the usual 1360 mm the flange is there 2.5 mm earlier.
  EXPECT_GT(Compare(1.360, table.value()).angle, 0.1);
}

}  // namespace
}  // namespace phs::rail
