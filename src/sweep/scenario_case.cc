#include "sweep/scenario_case.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>

#include "base/data_path.h"
#include "base/result_dir.h"
#include "phs_model/phs_model.h"
#include "sweep/case_values.h"
#include "vehicle/bogie_values.h"
#include "vehicle/compose.h"
#include "vehicle/scenario_file.h"

namespace phs::sweep {
namespace {

namespace fs = std::filesystem;

/// The files of a run while they are put together.
class ScenarioCase {
 public:
  ScenarioCase(const Study& study, int run, std::string folder)
      : study_(study),
        case_(study.CaseOf(run)),
        set_(ValuesOf(study, run)),
        run_(run),
        folder_(std::move(folder)) {}

  Result<std::string> Write() {
    auto scenario = LoadFile(case_.base);
    if (!scenario.ok()) return scenario.error();
    scenario_ = scenario.value();
    PutPaths(case_.base);
    if (Status s = SetKeys(study_, set_, "scenario.", scenario_); !s.ok()) return s.error();
    PutPaths(study_.path);
    if (Status s = WriteTrack(); !s.ok()) return s.error();
    if (Status s = WriteModel(); !s.ok()) return s.error();
    if (Status s = WriteBogie(); !s.ok()) return s.error();
    return File("scenario.yaml", YAML::Dump(scenario_) + "\n");
  }

 private:
  /// Paths that `naming` means beside itself, absolute: the run's files lie elsewhere.
  void PutPaths(const std::string& naming) {
    for (const char* key : {"track", "bogie", "wheel", "rail", "phs"}) {
      if (!scenario_[key] || !scenario_[key].IsScalar()) continue;
      scenario_[key] = Anywhere(BesideFile(naming, scenario_[key].Scalar()));
    }
  }

  Result<std::string> File(const std::string& name, const std::string& text) const {
    const std::string path = (fs::path(folder_) / name).string();
    if (Status s = WritePassingFile(path, text); !s.ok()) return s.error();
    return path;
  }

  Status WriteTrack() {
    if (!Varies(set_, "track.") && !study_.vary_irregularity) return {};
    const std::string name = scenario_["track"] ? scenario_["track"].Scalar() : "";
    const auto path = FindData("track", "models/tracks", name, {".yaml"});
    if (!path.ok()) return path.error();
    auto loaded = LoadFile(path.value());
    if (!loaded.ok()) return loaded.error();
    YAML::Node track = loaded.value();
    if (track["mirror_of"]) {
      return Error{path.value(), "is the mirror image of another track", "a track with segments",
                   "vary " + track["mirror_of"].Scalar() + " instead"};
    }
    YAML::Node irregularity = track["irregularity"];
    if (irregularity && irregularity["file"]) {  // relative to the track file: it has moved
      const fs::path record = fs::path(path.value()).parent_path() / irregularity["file"].Scalar();
      irregularity["file"] = fs::absolute(record).string();
    }
    if (study_.vary_irregularity) {
      if (!irregularity || !irregularity["psd"]) {
        return Error{study_.path + ": vary_irregularity", "the track has no spectrum",
                     "a track with irregularity.psd", ""};
      }
      irregularity["seed"] =
          fmt::format("{}", RunSeed(study_.seed, static_cast<std::uint64_t>(run_)));
    }
    if (Status s = SetKeys(study_, set_, "track.", track); !s.ok()) return s;
    const auto file = File("track.yaml", YAML::Dump(track) + "\n");
    if (!file.ok()) return file.error();
    scenario_["track"] = file.value();
    return {};
  }

  Status WriteModel() {
    if (!Varies(set_, "model.")) return {};
    const std::string bogie = scenario_["bogie"] ? scenario_["bogie"].Scalar() : "phs";
    const std::string model =
        scenario_["phs"] ? scenario_["phs"].Scalar() : vehicle::PhsModelOf(bogie);
    if (model.empty()) return {};  // a bogie without hydraulics has nothing to vary
    auto params = phs_model::FindPhsParams(model);
    if (!params.ok()) return params.error();
    for (const auto& [key, value] : set_) {
      if (!key.starts_with("model.")) continue;
      const auto numbers = ModelNumbers(key.substr(6), value, params.value());
      if (!numbers.ok()) return AtAxis(study_, key, numbers.error());
      for (const ModelNumber& n : numbers.value()) {
        if (Status s = phs_model::SetParameter(&params.value(), n.name, n.value); !s.ok()) {
          return AtAxis(study_, key, s.error());
        }
      }
    }
    const auto file = File("model.yaml", phs_model::ToYaml(params.value()));
    if (!file.ok()) return file.error();
    scenario_["phs"] = file.value();
    return {};
  }

  /// An empty value leaves the file's: a list may hold bogies with different elements.
  Status WriteBogie() {
    constexpr std::string_view kPrefix = "bogie.";
    vehicle::BogieValues values;
    for (const auto& [key, value] : set_) {
      if (key.starts_with(kPrefix) && !value.empty()) {
        values.emplace_back(key.substr(kPrefix.size()), value);
      }
    }
    if (values.empty()) return {};
    const auto made =
        vehicle::VaryBogie(scenario_["bogie"] ? scenario_["bogie"].Scalar() : "phs", values);
    if (!made.ok()) return AtAxis(study_, "bogie." + made.error().where, made.error());
    const vehicle::VariedBogie& varied = made.value();
    if (!varied.car_body.empty()) {
      if (const auto file = File(varied.car_body_file, varied.car_body); !file.ok()) {
        return file.error();
      }
    }
    const auto file = File(varied.name + ".xml", varied.text);
    if (!file.ok()) return file.error();
    scenario_["bogie"] = file.value();
    return {};
  }

  const Study& study_;
  const StudyCase& case_;
  SetValues set_;
  int run_;
  std::string folder_;
  YAML::Node scenario_;
};

}  // namespace

Result<std::string> WriteScenarioCase(const Study& study, int run, const std::string& folder) {
  return ScenarioCase(study, run, folder).Write();
}

Status CheckScenario(const std::string& file) { return vehicle::LoadScenario(file).status(); }

Result<std::string> FindScenario(const std::string& name) {
  return FindData("scenario", "models/scenarios", name, {".yaml"});
}

}  // namespace phs::sweep
