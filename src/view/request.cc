#include "view/request.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/words.h"
#include "vehicle/scenario_file.h"

namespace phs::view {
namespace {

void AddCommon(CLI::App* verb, Request* r) {
  std::string views;
  for (const View& view : Views()) {
    views += std::string(views.empty() ? "" : "; ") + view.name + ": " + view.text;
  }
  verb->add_option("--bogies", r->bogies,
                   "Bogies, separated by commas: those of the result, or instead of the scenario's")
      ->delimiter(',');
  verb->add_option("--camera", r->view, "From where; " + views)
      ->check(CLI::IsMember(ViewNames()))
      ->capture_default_str();
  verb->add_option("--speed", r->speed, "Seconds of the run per second of the picture")
      ->check(CLI::Range(0.001, 1000.0))
      ->capture_default_str();
  verb->add_option("--from", r->from, "Begin at this time of the run in seconds")
      ->check(CLI::NonNegativeNumber);
  verb->add_option("--magnify-yaw", r->yaw,
                   "Draw every body's heading against the track so many times as large")
      ->check(CLI::Range(1.0, 1000.0))
      ->capture_default_str();
  verb->add_option("--magnify-lateral", r->lateral,
                   "Draw every body's distance from the track centre so many times as large")
      ->check(CLI::Range(1.0, 1000.0))
      ->capture_default_str();
  verb->add_flag("--no-forces", r->no_forces, "Without arrows");
  verb->add_flag("--body", r->body, "With the car body above");
  verb->add_flag("--quiet", r->quiet, "No progress on stderr");
}

/// Those of `recordings` that were asked for, in that order.
Result<std::vector<Recording>> Choose(const std::vector<std::string>& asked,
                                      std::vector<Recording> recordings, const std::string& dir) {
  if (asked.empty()) return recordings;
  std::vector<std::string> known;
  known.reserve(recordings.size());
  for (const Recording& recording : recordings) known.push_back(recording.label);
  std::vector<Recording> chosen;
  for (const std::string& name : asked) {
    const auto at = std::find(known.begin(), known.end(), name);
    if (at == known.end()) {
      return Error{"--bogies", Quoted(name) + " is not in " + dir, JoinWords(known),
                   DidYouMean(name, known)};
    }
    chosen.push_back(recordings[static_cast<size_t>(at - known.begin())]);
  }
  return chosen;
}

Status CheckTimes(const Request& request, const std::vector<Recording>& recordings) {
  for (const Recording& recording : recordings) {
    const double end = recording.end_s();
    if (!(request.from > end) && !(request.to > end)) continue;
    const bool from = request.from > end;
    return Error{from ? "--from" : "--to",
                 "lies beyond the run of " + recording.label + ", which ends at " +
                     std::to_string(end) + " s",
                 "0 s up to there", ""};
  }
  if (request.to >= 0 && request.to < std::max(0.0, request.from)) {
    return Error{"--to", "lies before --from", "a later time", ""};
  }
  return {};
}

}  // namespace

void AddVideoOptions(CLI::App* verb, Request* r) {
  verb->add_option("source", r->source,
                   "Scenario (a name or a YAML file), or result directory of simulate or compare")
      ->required();
  verb->add_option("out", r->out, "File to write: NAME.mp4, NAME.gif or NAME.png (one picture)")
      ->required();
  AddCommon(verb, r);
  verb->add_option("--to", r->to, "End at this time of the run in seconds")
      ->check(CLI::NonNegativeNumber);
  verb->add_option("--width", r->width, "Of the picture in pixels")
      ->check(CLI::Range(160, 3840))
      ->capture_default_str();
  verb->add_option("--height", r->height, "Of the picture in pixels")
      ->check(CLI::Range(120, 2160))
      ->capture_default_str();
  verb->add_option("--fps", r->fps, "Pictures per second")
      ->check(CLI::Range(1.0, 120.0))
      ->capture_default_str();
  verb->add_flag("--ghost", r->ghost, "Further bogies transparent in the picture of the first one");
  verb->add_flag("--force", r->force, "Replace the file if it is there");
}

void AddViewOptions(CLI::App* verb, Request* r) {
  verb->add_option("source", r->source,
                   "Scenario (a name or a YAML file), or result directory of simulate or compare")
      ->required();
  AddCommon(verb, r);
  verb->add_option("--screenshot", r->out,
                   "Write the window's picture to this PNG as soon as it stands, then end");
}

Result<std::vector<Recording>> Fetch(const Request& request, const vehicle::Progress& progress) {
  std::vector<Recording> recordings;
  if (IsResult(request.source)) {
    auto read = LoadRecordings(request.source);
    if (!read.ok()) return read.error();
    auto chosen = Choose(request.bogies, std::move(read).value(), request.source);
    if (!chosen.ok()) return chosen.error();
    recordings = std::move(chosen).value();
  } else if (std::filesystem::is_directory(request.source)) {
    return Error{request.source, "is no result of simulate or compare",
                 "a directory with summary.json or compare.json, or a scenario",
                 "run phs simulate or phs compare with --out first"};
  } else {
    auto scenario = vehicle::LoadScenario(request.source);
    if (!scenario.ok()) return scenario.error();
    std::vector<std::string> bogies = request.bogies;
    if (bogies.empty()) bogies = {scenario.value().bogie};
    for (size_t i = 0; i < bogies.size(); ++i) {
      vehicle::Scenario own = scenario.value();
      vehicle::UseBogie(bogies[i], &own);
      const double count = static_cast<double>(bogies.size());
      auto run = Record(own, vehicle::BogieLabel(bogies[i]), [&](double share) {
        return !progress || progress((static_cast<double>(i) + share) / count);
      });
      if (!run.ok()) return run.error();
      recordings.push_back(std::move(run).value());
    }
  }
  if (Status s = CheckTimes(request, recordings); !s.ok()) return s.error();
  return recordings;
}

Look LookOf(const Request& request) {
  Look look;
  look.magnify = {request.yaw, request.lateral};
  look.forces = !request.no_forces;
  look.body = request.body;
  look.contacts = FindView(request.view)->target == Target::kContact;
  return look;
}

}  // namespace phs::view
