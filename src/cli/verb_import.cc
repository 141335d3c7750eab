// phs import: a bogie from a URDF and a mapping as MJCF.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/data_path.h"
#include "base/origin.h"
#include "base/result_dir.h"
#include "cli/run_options.h"
#include "cli/verb_table.h"
#include "vehicle/bogie_import.h"
#include "vehicle/simulation.h"

namespace phs::cli {
namespace {

struct ImportOptions {
  CommonOptions common;
  std::string urdf;
  std::string mapping;
  std::string track;
  double timestep_s = 0;
};

/// Stands the written bogie on its track, so that what cannot run is refused here.
Status TryOut(const std::string& file, const std::string& track) {
  vehicle::Scenario scenario;
  scenario.name = "import";
  scenario.bogie = file;
  scenario.track = track;
  scenario.speed_m_s = 20;
  auto simulation = vehicle::Simulation::Create(scenario);
  return simulation.ok() ? Status() : Status(simulation.error());
}

int RunImport(const ImportOptions& options) {
  auto urdf = vehicle::ReadUrdf(options.urdf);
  if (!urdf.ok()) return BadInput(urdf.error());
  auto mapping = vehicle::LoadBogieMapping(options.mapping);
  if (!mapping.ok()) return BadInput(mapping.error());
  if (!options.track.empty()) mapping.value().track = Anywhere(options.track);
  if (options.timestep_s > 0) mapping.value().timestep_s = options.timestep_s;
  auto text = vehicle::ImportBogie(urdf.value(), mapping.value());
  if (!text.ok()) return BadInput(text.error());
  auto dir = ResultDir::Create(options.common.out, options.common.force);
  if (!dir.ok()) return BadInput(dir.error());
  const std::string name = mapping.value().name + ".xml";
  const std::string file = dir.value().File(name);
  if (Status s = WriteFileAtomically(file, text.value()); !s.ok()) return BadInput(s.error());
  if (Status s = TryOut(file, mapping.value().track); !s.ok()) return BadInput(s.error());
  if (Status s = WriteOrigin(dir.value().File("")); !s.ok()) return BadInput(s.error());
  if (Status s = dir.value().Commit(); !s.ok()) return BadInput(s.error());
  const std::string made = dir.value().final_path() + "/" + name;
  if (options.common.format == "json") {
    const nlohmann::ordered_json json = {{"bogie", made},
                                         {"links", urdf.value().links.size()},
                                         {"axles", mapping.value().axles.size()},
                                         {"cylinders", mapping.value().cylinders.size()}};
    fmt::print("{}\n", json.dump());
  } else {
    fmt::print("{}: {} links, {} axles, {} cylinders; stands on track {}\n", made,
               urdf.value().links.size(), mapping.value().axles.size(),
               mapping.value().cylinders.size(), mapping.value().track);
    const bool usual = mapping.value().track == "straight";
    fmt::print("next: phs {}{}{}\n", usual ? "compare curve_r550 --bogies " : "modes --bogie ",
               made, usual ? ",rigid_link" : "");
  }
  return kDone;
}

}  // namespace

void AddImport(CLI::App* verb, Action* action) {
  auto options = std::make_shared<ImportOptions>();
  AddCommonOptions(verb, &options->common);
  verb->get_option("--out")->required();
  verb->add_option("urdf", options->urdf, "URDF file")->required();
  verb->add_option("--mapping", options->mapping,
                   "YAML file: what the links are, springs, cylinders")
      ->required();
  AddTrackOption(verb, &options->track,
                 "Track it is written for and tried on, instead of the mapping's");
  AddTimestepOption(verb, &options->timestep_s, "Step written into it");
  verb->callback([=] { *action = [=] { return RunImport(*options); }; });
}

}  // namespace phs::cli
