// phs modes: stiffness and damping of the axle modes, beside the closed form.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "base/progress.h"
#include "base/result_dir.h"
#include "cli/number_within.h"
#include "cli/result_checks.h"
#include "cli/run_options.h"
#include "cli/verb_table.h"
#include "jobs/modes_job.h"

namespace phs::cli {
namespace {

using analysis::AxleMode;

struct ModesOptions {
  CommonOptions common;
  ResultChecks checks;
  jobs::ModesRequest request;
};

void PrintModes(const jobs::MeasuredModes& measured, const analysis::AxleModeOptions& options) {
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

int Conclude(const ModesOptions& options, const std::vector<jobs::MeasuredModes>& all) {
  std::vector<analysis::NamedSummary> results;
  results.reserve(all.size());
  for (const jobs::MeasuredModes& measured : all) {
    results.emplace_back(measured.bogie, jobs::ModesJson(measured, options.request));
  }
  return options.checks.Conclude("modes", results, kDone);
}

int RunModes(ModesOptions options) {
  if (Status s = options.checks.Read(); !s.ok()) return BadInput(s.error());
  auto asked = OpenAskedDir(options.common);
  if (!asked.ok()) return BadInput(asked.error());
  std::optional<ResultDir>& dir = asked.value();
  const analysis::AxleModeOptions& measure = options.request.measure;
  auto all = jobs::MeasureModes(options.request, {.stopped = [] { return StopSignal() != 0; }});
  if (StopSignal() != 0) return Stopped("nothing written");
  if (!all.ok()) return BadInput(all.error());
  if (options.common.format == "json") {
    fmt::print("{}\n", jobs::ModesJson(all.value()[0], options.request).dump(2));
  } else {
    for (const jobs::MeasuredModes& measured : all.value()) PrintModes(measured, measure);
    fmt::print("amplitudes at the axle boxes: large {:g} mm, small {:g} mm (seals stick)\n",
               measure.large_displacement_m * 1e3, measure.small_displacement_m * 1e3);
    if (dir) fmt::print("report: {}/report.html\n", options.common.out);
  }
  if (dir) {
    if (Status s = jobs::WriteModes(all.value(), options.request, &*dir); !s.ok()) {
      return BadInput(s.error());
    }
    if (Status s = dir->Commit(); !s.ok()) return BadInput(s.error());
  }
  return Conclude(options, all.value());
}

}  // namespace

void AddModes(CLI::App* verb, Action* action) {
  auto options = std::make_shared<ModesOptions>();
  options->request.scenario.speed_m_s = 20;
  AddCommonOptions(verb, &options->common);
  options->checks.AddOptions(verb);
  verb->add_option("--bogie", options->request.scenario.bogie, "Bogie: a name or an MJCF file")
      ->required();
  verb->add_option("--beside", options->request.beside, "Further bogies, shown beside it: a,b")
      ->delimiter(',');
  verb->add_option("--phs", options->request.scenario.phs, "PHS model, instead of the bogie's");
  AddTrackOption(verb, &options->request.scenario.track,
                 "Track that gives the gauge; default straight track as wide as the bogie's own");
  AddTimestepOption(verb, &options->request.scenario.timestep_s);
  verb->add_option("--frequency", options->request.measure.frequency_Hz, "Hz")
      ->check(NumberWithin(0.01, 20.0));
  verb->callback([=] { *action = [=] { return RunModes(*options); }; });
}

}  // namespace phs::cli
