#include "jobs/contact_job.h"

#include <filesystem>
#include <utility>
#include <vector>

#include "base/data_path.h"
#include "rail/creep_cases.h"
#include "rail/creep_law.h"

namespace phs::jobs {
namespace {

/// The user's table, or one of the examples by name.
Result<Table> ReadCases(const Cases& cases) {
  if (const Table* table = std::get_if<Table>(&cases)) return *table;
  const auto path =
      FindData("table of cases", "models/contact", std::get<std::string>(cases), {".csv"});
  if (!path.ok()) return path.error();
  return ReadTable(path.value());
}

/// The Manchester contact benchmark's wheelset on its track (Iwnicki 1998), no damping.
rail::WheelRailParams BenchmarkPair() {
  rail::WheelRailParams p;
  p.gauge = 1.435;
  p.gauge_height = 0.014;
  p.flange_back_distance = 1.360;
  p.flange_back_position = -0.070;
  p.wheel_radius = 0.460;
  return p;
}

Status FindProfile(const char* kind, const std::string& name, std::string* path) {
  if (name.empty() && !path->empty() && std::filesystem::exists(*path)) return {};
  if (name.empty()) {
    return path->empty() ? Error{std::string("--") + kind, "is not given", "a name or a path", ""}
                         : Error{*path, "is not there",
                                 std::string("the ") + kind + " profile beside the input file",
                                 std::string("give it by --") + kind};
  }
  *path = name;
  if (name.starts_with("cone:") || name.starts_with("arc:")) return {};
  const auto found = FindData(std::string(kind) + " profile", "models/profiles", name,
                              {std::string(kind) == "wheel" ? ".prw" : ".prr"});
  if (!found.ok()) return found.error();
  *path = found.value();
  return {};
}

/// Puts what the user gave over `p`.
Status Apply(const ContactPair& given, rail::WheelRailParams* p) {
  if (Status s = FindProfile("wheel", given.wheel, &p->wheel_profile); !s.ok()) return s;
  if (Status s = FindProfile("rail", given.rail, &p->rail_profile); !s.ok()) return s;
  p->gauge = given.gauge_m.value_or(p->gauge);
  p->gauge_height = given.gauge_height_m.value_or(p->gauge_height);
  p->rail_cant = given.cant_rad.value_or(p->rail_cant);
  p->flange_back_distance = given.flange_back_distance_m.value_or(p->flange_back_distance);
  p->flange_back_position = given.flange_back_position_m.value_or(p->flange_back_position);
  p->wheel_radius = given.radius_m.value_or(p->wheel_radius);
  p->tread.coefficient = given.mu.value_or(p->tread.coefficient);
  p->flange.coefficient = given.mu.value_or(p->flange.coefficient);
  rail::ContactMaterial& steel = p->creep.material;
  steel.shear_modulus_Pa = given.shear_modulus_Pa.value_or(steel.shear_modulus_Pa);
  steel.poisson_ratio = given.poisson_ratio.value_or(steel.poisson_ratio);
  return {};
}

/// The positions with the pair that they belong to before the user's changes.
Result<rail::WheelsetCases> ReadWheelset(const Cases& given) {
  const std::string* name = std::get_if<std::string>(&given);
  if (name != nullptr && name->ends_with(".inp")) return rail::ReadContactInput(*name);
  auto table = ReadCases(given);
  if (!table.ok()) return table.error();
  rail::WheelsetCases cases;
  cases.wheel_rail = BenchmarkPair();
  cases.table = std::move(table).value();
  return cases;
}

}  // namespace

Result<Table> CalcPatches(const Cases& given, const std::string& method) {
  const auto cases = ReadCases(given);
  if (!cases.ok()) return cases.error();
  return rail::CalcCreepCases(cases.value(), method.empty() ? "kalker_table" : method);
}

Result<WheelsetPatches> CalcWheelset(const Cases& given, const ContactPair& pair,
                                     const std::string& side, const std::string& method) {
  auto read = ReadWheelset(given);
  if (!read.ok()) return read.error();
  rail::WheelsetCases cases = std::move(read).value();
  if (Status s = Apply(pair, &cases.wheel_rail); !s.ok()) return s.error();
  if (!side.empty()) cases.side = side == "right" ? rail::Side::kRight : rail::Side::kLeft;
  cases.wheel_rail.damping_ratio = 0;
  cases.wheel_rail.creep.method = method.empty() ? "fastsim" : method;
  auto patches = rail::CalcWheelsetCases(cases);
  if (!patches.ok()) return patches.error();
  return WheelsetPatches{std::move(cases), std::move(patches).value()};
}

Result<Functions> CalcFunctions(const FunctionsRequest& request) {
  rail::WheelRailParams params = BenchmarkPair();
  if (Status s = Apply(request.pair, &params); !s.ok()) return s.error();
  params.creep.method = "linear";
  const auto pair = rail::WheelRail::Create(params);
  if (!pair.ok()) return pair.error();
  auto functions = rail::CalcContactFunctions(pair.value(), pair.value(), request.reach_m,
                                              request.step_m, request.load_N);
  if (!functions.ok()) return functions.error();
  return Functions{pair.value().params(), std::move(functions).value()};
}

Table FunctionsTable(const rail::ContactFunctions& f) {
  Table table;
  table.names = {"y_mm",
                 "roll_rad",
                 "z_mm",
                 "radius_difference_mm",
                 "radius_left_mm",
                 "radius_right_mm",
                 "contact_angle_left_rad",
                 "contact_angle_right_rad",
                 "ycp_wheel_left_mm",
                 "ycp_wheel_right_mm",
                 "ycp_rail_left_mm",
                 "ycp_rail_right_mm"};
  table.columns.resize(table.names.size());
  for (const rail::ContactFunctionRow& row : f.rows) {
    const double values[] = {1e3 * row.y,
                             row.roll,
                             1e3 * row.height,
                             1e3 * row.RadiusDifference(),
                             1e3 * row.left.radius,
                             1e3 * row.right.radius,
                             row.left.angle,
                             row.right.angle,
                             1e3 * row.left.wheel_y,
                             1e3 * row.right.wheel_y,
                             1e3 * row.left.rail_y,
                             1e3 * row.right.rail_y};
    for (std::size_t i = 0; i < table.columns.size(); ++i) table.columns[i].push_back(values[i]);
  }
  return table;
}

}  // namespace phs::jobs
