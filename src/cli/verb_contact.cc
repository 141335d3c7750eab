// phs contact: the wheel-rail contact alone, as a table in and a table out.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "base/data_path.h"
#include "base/table.h"
#include "cli/verbs.h"
#include "rail/creep_cases.h"
#include "rail/creep_law.h"
#include "rail/wheelset_cases.h"

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

int RunCases(const ContactOptions& options) {
  const std::string method = options.method.empty() ? "kalker_table" : options.method;
  const auto cases = ReadTable(options.cases);
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
    auto table = ReadTable(options.wheelset);
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

int RunContact(const ContactOptions& options) {
  if (Status s = CheckOut(options); !s.ok()) return BadInput(s.error());
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

void AddContact(CLI::App* app, Action* action) {
  CLI::App* verb = app->add_subcommand(
      "contact", "Wheel-rail contact alone: creepage cases, or a wheelset placed on track");
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
  what->require_option(1);
  verb->add_option("--method", options->method,
                   "Creep law (kalker_table for --cases, fastsim for --wheelset)")
      ->check(CLI::IsMember(rail::CreepLawNames()));
  verb->add_option("--side", options->side, "Wheel where the table names none (left)")
      ->check(CLI::IsMember({"left", "right"}));
  AddPairOptions(verb, &options->pair);
  verb->add_option("--out", options->out, "CSV to write")->required();
  verb->add_flag("--force", options->force, "Replace an existing file");
  verb->callback([=] { *action = [=] { return RunContact(*options); }; });
}

}  // namespace phs::cli
