// phs modes: stiffness and damping of the axle modes.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "analysis/axle_modes.h"
#include "base/result_dir.h"
#include "cli/verbs.h"
#include "vehicle/simulation.h"

namespace phs::cli {
namespace {

using Json = nlohmann::ordered_json;

struct ModesOptions {
  CommonOptions common;
  vehicle::Scenario scenario;
  analysis::AxleModeOptions measure;
};

Json ModeJson(const analysis::AxleMode& mode) {
  const bool turns = mode.rotation;
  Json json;
  json[turns ? "stiffness_Nm_per_rad" : "stiffness_N_per_m"] = mode.stiffness;
  json[turns ? "damping_Nms_per_rad" : "damping_Ns_per_m"] = mode.damping;
  json[turns ? "amplitude_rad" : "amplitude_m"] = mode.amplitude;
  json["loss_per_cycle_J"] = mode.loss_per_cycle;
  return json;
}

Json ModesJson(const std::string& bogie, const analysis::AxleModes& modes) {
  Json json;
  for (size_t i = 0; i < modes.large.size(); ++i) {
    json[modes.large[i].name] = ModeJson(modes.large[i]);
    json[modes.large[i].name]["small_amplitude"] = ModeJson(modes.small[i]);
  }
  json["bogie"] = bogie;
  return json;
}

int RunModes(const ModesOptions& options) {
  std::optional<ResultDir> dir;
  if (!options.common.out.empty()) {
    auto created = ResultDir::Create(options.common.out, options.common.force);
    if (!created.ok()) return BadInput(created.error());
    dir.emplace(std::move(created).value());
  }
  auto simulation = vehicle::Simulation::Create(options.scenario);
  if (!simulation.ok()) return BadInput(simulation.error());
  auto modes = analysis::MeasureAxleModes(simulation.value(), options.measure);
  if (!modes.ok()) return BadInput(modes.error());
  const Json json = ModesJson(options.scenario.bogie, modes.value());
  if (options.common.format == "json") {
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("{}: axle modes at {:g} Hz, totals over both axles\n", options.scenario.bogie,
               options.measure.frequency_Hz);
    fmt::print("{:<11}{:>22}{:>18}{:>22}{:>18}\n", "mode", "stiffness, large", "damping",
               "stiffness, small", "damping");
    for (size_t i = 0; i < modes.value().large.size(); ++i) {
      const auto& large = modes.value().large[i];
      const auto& small = modes.value().small[i];
      const char* k = large.rotation ? "kNm/rad" : "kN/m";
      const char* c = large.rotation ? "kNms/rad" : "kNs/m";
      fmt::print("{:<11}{:>14.1f} {:<7}{:>9.2f} {:<8}{:>14.1f} {:<7}{:>9.2f} {:<8}\n", large.name,
                 large.stiffness / 1e3, k, large.damping / 1e3, c, small.stiffness / 1e3, k,
                 small.damping / 1e3, c);
    }
    fmt::print("amplitudes at the axle boxes: large {:g} mm, small {:g} mm\n",
               options.measure.large_displacement_m * 1e3,
               options.measure.small_displacement_m * 1e3);
  }
  if (!dir) return kDone;
  if (Status s = WriteFileAtomically(dir->File("modes.json"), json.dump(2) + "\n"); !s.ok()) {
    return BadInput(s.error());
  }
  const Status s = dir->Commit();
  return s.ok() ? kDone : BadInput(s.error());
}

}  // namespace

void AddModes(CLI::App* app, Action* action) {
  CLI::App* verb = app->add_subcommand("modes", "Stiffness and damping of the axle modes");
  auto options = std::make_shared<ModesOptions>();
  options->scenario.track = "straight";
  options->scenario.speed_m_s = 20;
  AddCommonOptions(verb, &options->common);
  verb->add_option("--bogie", options->scenario.bogie, "Bogie: a name or an MJCF file")->required();
  verb->add_option("--phs", options->scenario.phs, "PHS model, instead of the bogie's");
  verb->add_option("--frequency", options->measure.frequency_Hz, "Hz")->check(CLI::Range(0.01, 20.0));
  verb->callback([=] { *action = [=] { return RunModes(*options); }; });
}

}  // namespace phs::cli
