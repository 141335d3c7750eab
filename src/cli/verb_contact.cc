// phs contact: the wheel-rail contact alone, as a table in and a table out.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "base/table.h"
#include "cli/verbs.h"
#include "rail/creep_cases.h"
#include "rail/creep_law.h"

namespace phs::cli {
namespace {

struct ContactOptions {
  std::string cases;
  std::string method = "kalker_table";
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
  if (Status s = CheckOut(options); !s.ok()) return BadInput(s.error());
  const auto cases = ReadTable(options.cases);
  if (!cases.ok()) return BadInput(cases.error());
  const auto forces = rail::CalcCreepCases(cases.value(), options.method);
  if (!forces.ok()) return BadInput(forces.error());
  if (Status s = rail::WriteCaseTable(options.out, forces.value()); !s.ok()) {
    return BadInput(s.error());
  }
  fmt::print("{} cases by {}: {}\n", forces.value().num_rows(), options.method, options.out);
  return kDone;
}

}  // namespace

void AddContact(CLI::App* app, Action* action) {
  CLI::App* verb = app->add_subcommand(
      "contact", "Wheel-rail contact alone: creep forces of a table of creepage cases");
  verb->footer(
      "Columns of --cases: a_mm,b_mm,FN_N,mu,G_MPa,nu,xi,eta,phi_rad_per_mm; others are passed\n"
      "through. Added: Fx_N,Fy_N,Mz_Nmm on the rail (positive creepage gives negative force).");
  auto options = std::make_shared<ContactOptions>();
  verb->add_option("--cases", options->cases, "CSV of contact patches and creepages")->required();
  verb->add_option("--method", options->method, "Creep law")
      ->check(CLI::IsMember(rail::CreepLawNames()))
      ->capture_default_str();
  verb->add_option("--out", options->out, "CSV to write")->required();
  verb->add_flag("--force", options->force, "Replace an existing file");
  verb->callback([=] { *action = [=] { return RunCases(*options); }; });
}

}  // namespace phs::cli
