#include "rail/contact_reference.h"

#include <utility>

#include "rail/contact_search.h"

namespace phs::rail {

Result<std::vector<ContactReference>> CalcContactReferences(const WheelsetCases& cases,
                                                            const Table& result) {
  const WheelRailParams& pair = cases.wheel_rail;
  auto wheel = LoadProfile(pair.wheel_profile, ProfileKind::kWheel);
  if (!wheel.ok()) return wheel.error();
  auto rail = LoadProfile(pair.rail_profile, ProfileKind::kRail);
  if (!rail.ok()) return rail.error();
  rail.value().Incline(pair.rail_cant);
  rail.value().PutTopAtZero();
  const double rail_y = pair.gauge / 2 - rail.value().InnerSideAtDepth(pair.gauge_height);
  const auto& material = pair.creep.material;
  const ContactSearch search(std::move(wheel).value(), std::move(rail).value(),
                             pair.flange_back_distance / 2 - pair.flange_back_position,
                             pair.wheel_radius,
                             Hertz(material.shear_modulus_Pa, material.poisson_ratio));
  const double hand = cases.side == Side::kRight ? 1 : -1;
  const auto cell = [](const Table& t, const char* name, int row) {
    const int column = t.Find(name);
    return column < 0 ? 0 : t.columns[static_cast<size_t>(column)][static_cast<size_t>(row)];
  };
  std::vector<ContactReference> all;
  for (int row = 0; row < result.num_rows(); ++row) {
    const int k = static_cast<int>(cell(result, "case", row)) - 1;
    if (k < static_cast<int>(all.size())) continue;  // another patch of the same wheel
    const double height = 1e-3 * cell(result, "z_solved_mm", row) - pair.wheel_radius;
    const OverlapCentre c = search.Centre(
        {1e-3 * hand * cell(cases.table, "y_mm", k), height,
         hand * cell(cases.table, "roll_rad", k), hand * cell(cases.table, "yaw_rad", k)},
        rail_y, 0);
    all.push_back({1e3 * hand * c.rail_y, -hand * c.angle, 1e3 * c.radius});
  }
  return all;
}

}  // namespace phs::rail
