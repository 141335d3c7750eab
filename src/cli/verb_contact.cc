// phs contact: the wheel-rail contact alone, as a table in and a table out.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "base/origin.h"
#include "base/table.h"
#include "cli/number_within.h"
#include "cli/verb_table.h"
#include "jobs/contact_job.h"
#include "rail/creep_cases.h"
#include "rail/creep_law.h"
#include "report/report_page.h"

namespace phs::cli {
namespace {

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
  jobs::ContactPair pair;
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

int RunCases(const ContactOptions& options) {
  const auto forces = jobs::CalcPatches(options.cases, options.method);
  if (!forces.ok()) return BadInput(forces.error());
  if (Status s = rail::WriteCaseTable(options.out, forces.value()); !s.ok()) {
    return BadInput(s.error());
  }
  fmt::print("{} cases by {}: {}\n", forces.value().num_rows(),
             options.method.empty() ? "kalker_table" : options.method, options.out);
  return kDone;
}

int RunWheelset(const ContactOptions& options) {
  const auto done =
      jobs::CalcWheelset(options.wheelset, options.pair, options.side, options.method);
  if (!done.ok()) return BadInput(done.error());
  const auto& [cases, patches] = done.value();
  if (Status s = rail::WriteCaseTable(options.out, patches); !s.ok()) return BadInput(s.error());
  fmt::print("{} positions by {}, {} rows of patches: {}\n", cases.table.num_rows(),
             cases.wheel_rail.creep.method, patches.num_rows(), options.out);
  return kDone;
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
  page.SetOrigin(NotedOrigin());
  return page.Write(path);
}

int RunFunctions(const ContactOptions& options) {
  const auto done = jobs::CalcFunctions({.pair = options.pair,
                                         .reach_m = options.reach_m,
                                         .step_m = options.step_m,
                                         .load_N = options.load_N});
  if (!done.ok()) return BadInput(done.error());
  const auto& [pair, f] = done.value();
  const Table table = jobs::FunctionsTable(f);
  if (Status s = WriteCsv(options.out, table.names, table.columns); !s.ok()) {
    return BadInput(s.error());
  }
  fmt::print("amplitude [mm]   equivalent conicity\n");
  for (const rail::Conicity& c : f.conicity) {
    fmt::print("{:>14.1f}   {:>19.4f}\n", 1e3 * c.amplitude, c.value);
  }
  fmt::print("{} lateral positions: {}\n", f.rows.size(), options.out);
  if (options.report.empty()) return kDone;
  if (Status s = WriteFunctionsReport(options.report, pair, options.load_N, f); !s.ok()) {
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

void AddPairOptions(CLI::App* verb, jobs::ContactPair* pair) {
  const char* group = "Wheelset on track";
  const auto add = [&](const char* name, auto& value, const char* help) {
    verb->add_option(name, value, help)->group(group);
  };
  add("--wheel", pair->wheel, "Wheel profile: name, path, cone:LAMBDA");
  add("--rail", pair->rail, "Rail profile: name, path, arc:RADIUS_M");
  add("--gauge_m", pair->gauge_m, "Track gauge (1.435)");
  add("--gauge_height_m", pair->gauge_height_m, "Depth of the gauge points (0.014)");
  add("--cant_rad", pair->cant_rad, "Inclination of the rail section towards the track (0)");
  add("--flange_back_distance_m", pair->flange_back_distance_m, "Between the flange backs (1.360)");
  add("--flange_back_position_m", pair->flange_back_position_m,
      "y of the flange back in the wheel profile (-0.070)");
  add("--radius_m", pair->radius_m, "Wheel radius at the tape circle (0.460)");
  add("--mu", pair->mu, "Friction coefficient (0.3)");
  add("--shear_modulus_Pa", pair->shear_modulus_Pa, "Of wheel and rail (82e9)");
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
      ->check(NumberWithin(2e-3, 40e-3))
      ->capture_default_str();
  verb->add_option("--step_m", options->step_m, "--functions: between lateral positions")
      ->check(NumberWithin(1e-5, 1e-3))
      ->capture_default_str();
  verb->add_option("--load_N", options->load_N,
                   "--functions: on each wheel, elastic bodies (0: rigid bodies)")
      ->check(NumberWithin(0.0, 1e6));
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
