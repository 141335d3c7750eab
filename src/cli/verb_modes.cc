// phs modes: stiffness and damping of the axle modes, beside the closed form.
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <vector>

#include "analysis/axle_modes_json.h"
#include "analysis/plain_track.h"
#include "base/result_dir.h"
#include "cli/run_options.h"
#include "cli/verb_table.h"
#include "report/analysis_report.h"
#include "vehicle/simulation.h"

namespace phs::cli {
namespace {

using analysis::AxleMode;
using analysis::AxleModes;

struct ModesOptions {
  CommonOptions common;
  vehicle::Scenario scenario;
  analysis::AxleModeOptions measure;
  std::vector<std::string> beside;  ///< further bogies
};

struct Measured {
  std::string bogie;
  AxleModes modes;
};

void PrintModes(const Measured& measured, const analysis::AxleModeOptions& options) {
  fmt::print("{}: axle modes at {:g} Hz, totals over both axles\n", measured.bogie,
             options.frequency_Hz);
  fmt::print("{:<9}{:<13}{:>13}{:>12}{:>13}{:>14}{:>12}\n", "mode", "unit", "stiff, large",
             "damping", "stiff, small", "closed form", "damping");
  for (size_t i = 0; i < measured.modes.large.size(); ++i) {
    const AxleMode& large = measured.modes.large[i];
    const AxleMode& small = measured.modes.small[i];
    fmt::print("{:<11}{:<11}{:>13.1f}{:>12.2f}{:>13.1f}{:>14.1f}{:>12.2f}\n", large.name,
               large.rotation ? "kNm(s)/rad" : "kN(s)/m", large.stiffness / 1e3,
               large.damping / 1e3, small.stiffness / 1e3, small.closed_form.total() / 1e3,
               small.damping / 1e3);
  }
}

Status WriteResults(const std::vector<Measured>& all, const ModesOptions& options, ResultDir* dir) {
  std::vector<std::string> files;
  for (const Measured& measured : all) {
    files.push_back(
        dir->File(files.empty() ? "modes.json" : fmt::format("modes_{}.json", files.size())));
    const std::string text =
        analysis::AxleModesJson(measured.bogie, measured.modes, options.measure).dump(2) + "\n";
    if (Status s = WriteFileAtomically(files.back(), text); !s.ok()) return s;
  }
  if (Status s = report::WriteModesReport(files, dir->File("report.html")); !s.ok()) return s;
  return dir->Commit();
}

Result<std::vector<Measured>> MeasureAll(const ModesOptions& options) {
  std::vector<std::string> bogies = {options.scenario.bogie};
  bogies.insert(bogies.end(), options.beside.begin(), options.beside.end());
  std::vector<Measured> all;
  for (const std::string& bogie : bogies) {
    vehicle::Scenario scenario = options.scenario;
    scenario.bogie = bogie;
    if (!all.empty()) scenario.phs.clear();
    const auto track = analysis::StraightTrack::For(bogie, options.scenario.track);
    if (!track.ok()) return track.error();
    scenario.track = track.value().name();
    auto simulation = vehicle::Simulation::Create(scenario);
    if (!simulation.ok()) return simulation.error();
    auto modes = analysis::MeasureAxleModes(simulation.value(), options.measure);
    if (!modes.ok()) return modes.error();
    all.push_back({bogie, std::move(modes).value()});
  }
  return all;
}

int RunModes(const ModesOptions& options) {
  auto asked = OpenAskedDir(options.common);
  if (!asked.ok()) return BadInput(asked.error());
  std::optional<ResultDir>& dir = asked.value();
  auto all = MeasureAll(options);
  if (!all.ok()) return BadInput(all.error());
  if (options.common.format == "json") {
    fmt::print("{}\n",
               analysis::AxleModesJson(all.value()[0].bogie, all.value()[0].modes, options.measure)
                   .dump(2));
  } else {
    for (const Measured& measured : all.value()) PrintModes(measured, options.measure);
    fmt::print("amplitudes at the axle boxes: large {:g} mm, small {:g} mm (seals stick)\n",
               options.measure.large_displacement_m * 1e3,
               options.measure.small_displacement_m * 1e3);
    if (dir) fmt::print("report: {}/report.html\n", options.common.out);
  }
  if (!dir) return kDone;
  const Status s = WriteResults(all.value(), options, &*dir);
  return s.ok() ? kDone : BadInput(s.error());
}

}  // namespace

void AddModes(CLI::App* verb, Action* action) {
  auto options = std::make_shared<ModesOptions>();
  options->scenario.speed_m_s = 20;
  AddCommonOptions(verb, &options->common);
  verb->add_option("--bogie", options->scenario.bogie, "Bogie: a name or an MJCF file")->required();
  verb->add_option("--beside", options->beside, "Further bogies, shown beside it: a,b")
      ->delimiter(',');
  verb->add_option("--phs", options->scenario.phs, "PHS model, instead of the bogie's");
  AddTrackOption(verb, &options->scenario.track,
                 "Track that gives the gauge; default straight track as wide as the bogie's own");
  AddTimestepOption(verb, &options->scenario.timestep_s);
  verb->add_option("--frequency", options->measure.frequency_Hz, "Hz")
      ->check(CLI::Range(0.01, 20.0));
  verb->callback([=] { *action = [=] { return RunModes(*options); }; });
}

}  // namespace phs::cli
