// phs contact: the wheel-rail contact alone, as a table in and a table out.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/data_path.h"
#include "base/table.h"
#include "cli/verb_table.h"
#include "rail/contact_functions.h"
#include "rail/creep_cases.h"
#include "rail/creep_law.h"
#include "rail/wheelset_cases.h"
#include "report/report_page.h"

namespace phs::cli {
namespace {

/// What the user gave; what he left out comes from CONTACT's input file or from case.
struct PairOptions {
  std::string wheel, rail;
  std::optional<double> gauge, gauge_height, cant, flange_back_distance, flange_back_position,
      radius, friction, shear_modulus, poisson_ratio;
};

struct ContactOptions {
  std::string cases;
  std::string wheelset;
  bool functions = false;
  double load_N = 0;  ///< of the functions, on each wheel; 0 = rigid bodies
  double reach_m = 10e-3;
  double step_m = 0.1e-3;
  std::string report;
  std::string method;
  std::string side;
  PairOptions pair;
  std::string out;
  bool force = false;
};

/// Nothing already there is overwritten unasked.
Status CheckOut(const ContactOptions& options) {
  std::error_code ignored;
  if (std::filesystem::is_directory(options.out, ignored)) {
    return Error{options.out, "is a directory", "a file to be written", ""};
  }
  if (!options.force && std::filesystem::exists(options.out, ignored)) {
    return Error{options.out, "exists already", "a new file", "use --force to replace it"};
  }
  return {};
}

/// The user's table, or one of the examples by name.
Result<Table> ReadCases(const std::string& name) {
  const auto path = FindData("table of cases", "models/contact", name, {".csv"});
  if (!path.ok()) return path.error();
  return ReadTable(path.value());
}

int RunCases(const ContactOptions& options) {
  const std::string method = options.method.empty() ? "kalker_table" : options.method;
  const auto cases = ReadCases(options.cases);
  if (!cases.ok()) return BadInput(cases.error());
  const auto forces = rail::CalcCreepCases(cases.value(), method);
  if (!forces.ok()) return BadInput(forces.error());
  if (Status s = rail::WriteCaseTable(options.out, forces.value()); !s.ok()) {
    return BadInput(s.error());
  }
  fmt::print("{} cases by {}: {}\n", forces.value().num_rows(), method, options.out);
  return kDone;
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
Status Apply(const PairOptions& given, rail::WheelRailParams* p) {
  if (Status s = FindProfile("wheel", given.wheel, &p->wheel_profile); !s.ok()) return s;
  if (Status s = FindProfile("rail", given.rail, &p->rail_profile); !s.ok()) return s;
  p->gauge = given.gauge.value_or(p->gauge);
  p->gauge_height = given.gauge_height.value_or(p->gauge_height);
  p->rail_cant = given.cant.value_or(p->rail_cant);
  p->flange_back_distance = given.flange_back_distance.value_or(p->flange_back_distance);
  p->flange_back_position = given.flange_back_position.value_or(p->flange_back_position);
  p->wheel_radius = given.radius.value_or(p->wheel_radius);
  p->tread.coefficient = given.friction.value_or(p->tread.coefficient);
  p->flange.coefficient = given.friction.value_or(p->flange.coefficient);
  rail::ContactMaterial& steel = p->creep.material;
  steel.shear_modulus_Pa = given.shear_modulus.value_or(steel.shear_modulus_Pa);
  steel.poisson_ratio = given.poisson_ratio.value_or(steel.poisson_ratio);
  return {};
}

Result<rail::WheelsetCases> ReadWheelset(const ContactOptions& options) {
  rail::WheelsetCases cases;
  if (options.wheelset.ends_with(".inp")) {
    auto read = rail::ReadContactInput(options.wheelset);
    if (!read.ok()) return read.error();
    cases = std::move(read).value();
  } else {
    auto table = ReadCases(options.wheelset);
    if (!table.ok()) return table.error();
    cases.wheel_rail = BenchmarkPair();
    cases.table = std::move(table).value();
  }
  if (Status s = Apply(options.pair, &cases.wheel_rail); !s.ok()) return s.error();
  if (!options.side.empty()) {
    cases.side = options.side == "right" ? rail::Side::kRight : rail::Side::kLeft;
  }
  cases.wheel_rail.damping_ratio = 0;
  cases.wheel_rail.creep.method = options.method.empty() ? "fastsim" : options.method;
  return cases;
}

int RunWheelset(const ContactOptions& options) {
  const auto cases = ReadWheelset(options);
  if (!cases.ok()) return BadInput(cases.error());
  const auto patches = rail::CalcWheelsetCases(cases.value());
  if (!patches.ok()) return BadInput(patches.error());
  if (Status s = rail::WriteCaseTable(options.out, patches.value()); !s.ok()) {
    return BadInput(s.error());
  }
  fmt::print("{} positions by {}, {} rows of patches: {}\n", cases.value().table.num_rows(),
             cases.value().wheel_rail.creep.method, patches.value().num_rows(), options.out);
  return kDone;
}

Result<rail::WheelRail> CreatePair(const PairOptions& given) {
  rail::WheelRailParams params = BenchmarkPair();
  if (Status s = Apply(given, &params); !s.ok()) return s.error();
  params.creep.method = "linear";
  return rail::WheelRail::Create(params);
}

Status WriteFunctions(const std::string& path, const rail::ContactFunctions& f) {
  std::vector<std::vector<double>> columns(12);
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
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i].push_back(values[i]);
  }
  return WriteCsv(
      path,
      {"y_mm", "roll_rad", "z_mm", "radius_difference_mm", "radius_left_mm", "radius_right_mm",
       "contact_angle_left_rad", "contact_angle_right_rad", "ycp_wheel_left_mm",
       "ycp_wheel_right_mm", "ycp_rail_left_mm", "ycp_rail_right_mm"},
      columns);
}

Status WriteFunctionsReport(const std::string& path, const rail::WheelRailParams& pair,
                            double load_N, const rail::ContactFunctions& f) {
  using report::Curve;
  report::ReportPage page(
      "Contact functions",
      fmt::format("{} on {}, gauge {:.4g} m, {}, no yaw",
                  std::filesystem::path(pair.wheel_profile).filename().string(),
                  std::filesystem::path(pair.rail_profile).filename().string(), pair.gauge,
                  load_N > 0 ? fmt::format("{:.4g} kN on each wheel", 1e-3 * load_N)
                             : std::string("rigid bodies")));
  Curve difference{.label = "radius difference"}, left{.label = "left"},
      right{.label = "right", .colour = 1}, conicity{.label = "equivalent conicity"};
  for (const rail::ContactFunctionRow& row : f.rows) {
    difference.x.push_back(1e3 * row.y);
    difference.y.push_back(1e3 * row.RadiusDifference());
    for (auto [curve, point] : {std::pair{&left, &row.left}, {&right, &row.right}}) {
      curve->x.push_back(1e3 * row.y);
      curve->y.push_back(point->angle * 180 / std::numbers::pi);
    }
  }
  for (const rail::Conicity& c : f.conicity) {
    conicity.x.push_back(1e3 * c.amplitude);
    conicity.y.push_back(c.value);
  }
  const std::string place = "lateral position of the wheelset to the right [mm]";
  page.Section("Over the lateral position");
  page.BeginGrid(2);
  page.Add(report::XyPlot{.title = "Rolling-radius difference, right less left",
                          .x_label = place,
                          .y_label = "difference [mm]",
                          .curves = {difference}});
  page.Add(report::XyPlot{.title = "Contact angle",
                          .x_label = place,
                          .y_label = "angle [deg]",
                          .curves = {left, right}});
  page.EndGrid();
  page.Section("Equivalent conicity");
  page.Paragraph(
      "The cone whose free wave is as long as this pair's at the same amplitude (EN 15302).");
  page.Add(report::XyPlot{.title = "Equivalent conicity",
                          .x_label = "amplitude [mm]",
                          .y_label = "tan(gamma_e)",
                          .curves = {conicity}});
  return page.Write(path);
}

int RunFunctions(const ContactOptions& options) {
  const auto pair = CreatePair(options.pair);
  if (!pair.ok()) return BadInput(pair.error());
  const auto f = rail::CalcContactFunctions(pair.value(), pair.value(), options.reach_m,
                                            options.step_m, options.load_N);
  if (!f.ok()) return BadInput(f.error());
  if (Status s = WriteFunctions(options.out, f.value()); !s.ok()) return BadInput(s.error());
  fmt::print("amplitude [mm]   equivalent conicity\n");
  for (const rail::Conicity& c : f.value().conicity) {
    fmt::print("{:>14.1f}   {:>19.4f}\n", 1e3 * c.amplitude, c.value);
  }
  fmt::print("{} lateral positions: {}\n", f.value().rows.size(), options.out);
  if (options.report.empty()) return kDone;
  if (Status s =
          WriteFunctionsReport(options.report, pair.value().params(), options.load_N, f.value());
      !s.ok()) {
    return BadInput(s.error());
  }
  fmt::print("Report: {}\n", options.report);
  return kDone;
}

int RunContact(const ContactOptions& options) {
  if (Status s = CheckOut(options); !s.ok()) return BadInput(s.error());
  if (options.functions) return RunFunctions(options);
  return options.wheelset.empty() ? RunCases(options) : RunWheelset(options);
}

void AddPairOptions(CLI::App* verb, PairOptions* pair) {
  const char* group = "Wheelset on track";
  const auto add = [&](const char* name, auto& value, const char* help) {
    verb->add_option(name, value, help)->group(group);
  };
  add("--wheel", pair->wheel, "Wheel profile: name, path, cone:LAMBDA");
  add("--rail", pair->rail, "Rail profile: name, path, arc:RADIUS_M");
  add("--gauge_m", pair->gauge, "Track gauge (1.435)");
  add("--gauge_height_m", pair->gauge_height, "Depth of the gauge points (0.014)");
  add("--cant_rad", pair->cant, "Inclination of the rail section towards the track (0)");
  add("--flange_back_distance_m", pair->flange_back_distance, "Between the flange backs (1.360)");
  add("--flange_back_position_m", pair->flange_back_position,
      "y of the flange back in the wheel profile (-0.070)");
  add("--radius_m", pair->radius, "Wheel radius at the tape circle (0.460)");
  add("--mu", pair->friction, "Friction coefficient (0.3)");
  add("--shear_modulus_Pa", pair->shear_modulus, "Of wheel and rail (82e9)");
  add("--poisson_ratio", pair->poisson_ratio, "Of wheel and rail (0.28)");
}

}  // namespace

void AddContact(CLI::App* verb, Action* action) {
  verb->footer(
      "--cases: columns a_mm,b_mm,FN_N,mu,G_MPa,nu,xi,eta,phi_rad_per_mm; adds Fx_N,Fy_N,Mz_Nmm.\n"
      "--wheelset: columns y_mm, Fz_N or z_mm, roll_rad, yaw_rad, vs_mm_s, vpitch_rad_s (and "
      "side,\n"
      "vy_mm_s, vz_mm_s, vroll_rad_s, vyaw_rad_s), or CONTACT's names for them, or CONTACT's own\n"
      "input file; one row per contact patch. Other columns are passed through. Forces act on the\n"
      "rail (positive creepage gives negative force); y to the right, z down.");
  auto options = std::make_shared<ContactOptions>();
  auto* what = verb->add_option_group("What");
  what->add_option("--cases", options->cases, "CSV of contact patches and creepages");
  what->add_option("--wheelset", options->wheelset,
                   "CSV of wheelset positions, or CONTACT's input file (.inp)");
  what->add_flag("--functions", options->functions,
                 "Radius difference, contact angles and equivalent conicity of a pair");
  what->require_option(1);
  verb->add_option("--reach_m", options->reach_m, "--functions: largest lateral position")
      ->check(CLI::Range(2e-3, 40e-3))
      ->capture_default_str();
  verb->add_option("--step_m", options->step_m, "--functions: between lateral positions")
      ->check(CLI::Range(1e-5, 1e-3))
      ->capture_default_str();
  verb->add_option("--load_N", options->load_N,
                   "--functions: on each wheel, elastic bodies (0: rigid bodies)")
      ->check(CLI::Range(0.0, 1e6));
  verb->add_option("--report", options->report, "--functions: page with the plots (HTML)");
  verb->add_option("--method", options->method,
                   "Creep law (kalker_table for --cases, fastsim for --wheelset): " +
                       rail::DescribeCreepLaws())
      ->check(CLI::IsMember(rail::CreepLawNames()));
  verb->add_option("--side", options->side, "Wheel where the table names none (left)")
      ->check(CLI::IsMember({"left", "right"}));
  AddPairOptions(verb, &options->pair);
  verb->add_option("--out", options->out, "CSV to write")->required()->check(NotEmpty);
  verb->add_flag("--force", options->force, "Replace an existing file");
  verb->callback([=] { *action = [=] { return RunContact(*options); }; });
}

}  // namespace phs::cli
