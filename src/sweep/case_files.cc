#include "sweep/case_files.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <cctype>
#include <filesystem>

#include "base/data_path.h"
#include "base/local_folder.h"
#include "base/numbers.h"
#include "base/result_dir.h"
#include "base/words.h"
#include "hydraulics/phs_params.h"
#include "phs_model/phs_model.h"
#include "vehicle/bogie_values.h"
#include "vehicle/compose.h"
#include "vehicle/scenario_file.h"

namespace phs::sweep {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> Parts(const std::string& key) {
  std::vector<std::string> parts(1);
  for (char c : key) {
    if (c == '.') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

Error NoSuchKey(const std::string& part, const YAML::Node& node) {
  std::vector<std::string> known;
  if (node.IsMap()) {
    for (const auto& item : node) known.push_back(item.first.Scalar());
  }
  return {"", "has no " + Quoted(part), JoinWords(known), DidYouMean(part, known)};
}

/// Sets the value at parts[i…] below `node`; counts the places set.
Status SetBelow(YAML::Node node, const std::vector<std::string>& parts, std::size_t i,
                const std::string& value, int* places) {
  const bool last = i + 1 == parts.size();
  if (node.IsSequence()) {
    const bool every = parts[i] == "*";
    const auto number = ParseNumber(parts[i]);
    if (!every && (!number || *number < 0 || *number >= static_cast<double>(node.size()) ||
                   *number != static_cast<double>(static_cast<std::size_t>(*number)))) {
      return Error{"", "has no element " + Quoted(parts[i]),
                   fmt::format("0 … {} or *", node.size() - 1), ""};
    }
    for (std::size_t n = 0; n < node.size(); ++n) {
      if (!every && n != static_cast<std::size_t>(*number)) continue;
      if (last) {
        node[n] = value;
        ++*places;
        continue;
      }
      if (every && !(node[n].IsMap() && node[n][parts[i + 1]])) continue;
      if (Status s = SetBelow(node[n], parts, i + 1, value, places); !s.ok()) return s;
    }
    return {};
  }
  if (!node.IsMap()) return Error{"", "is no map or list above " + Quoted(parts[i]), "", ""};
  if (last) {  // a key that does not exist is judged by the reader of the file
    node[parts[i]] = value;
    ++*places;
    return {};
  }
  if (parts[i] == "*") {
    for (auto item : node) {
      if (!(item.second.IsMap() && item.second[parts[i + 1]])) continue;
      if (Status s = SetBelow(item.second, parts, i + 1, value, places); !s.ok()) return s;
    }
    return {};
  }
  if (!node[parts[i]]) return NoSuchKey(parts[i], node);
  return SetBelow(node[parts[i]], parts, i + 1, value, places);
}

Status SetPath(YAML::Node root, const std::string& key, const std::string& value) {
  int places = 0;
  if (Status s = SetBelow(root, Parts(key), 0, value, &places); !s.ok()) return s;
  if (places == 0) return Error{"", "is in no element of the list or map", "", ""};
  return {};
}

/// "*.gas_volume_m3" fits "L1.gas_volume_m3": `*` stands for one part.
bool Fits(const std::string& pattern, const std::string& name) {
  const auto p = Parts(pattern), n = Parts(name);
  if (p.size() != n.size()) return false;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p[i] != "*" && p[i] != n[i]) return false;
  }
  return true;
}

Status SetModelParameter(const std::string& key, const std::string& value,
                         hydraulics::PhsParams* params) {
  const auto number = ParseNumber(value);
  if (!number) return Error{"", Quoted(value) + " is no number", "a number", ""};
  int places = 0;
  for (const auto& parameter : phs_model::ListAllParameters(*params)) {
    if (!Fits(key, parameter.name)) continue;
    if (Status s = phs_model::SetParameter(params, parameter.name, *number); !s.ok()) return s;
    ++places;
  }
  if (places > 0) return {};
  std::vector<std::string> known;
  for (const auto& parameter : phs_model::ListAllParameters(*params))
    known.push_back(parameter.name);
  const std::string shown =
      fmt::format("parameters of the model, e.g. {}", known.empty() ? "" : known.back());
  return Error{"", "has no parameter " + Quoted(key), shown, DidYouMean(key, known)};
}

Result<YAML::Node> LoadFile(const std::string& path) {
  try {
    return YAML::LoadFile(path);
  } catch (const YAML::Exception& fault) {
    return Error{fmt::format("{}:{}", path, fault.mark.line + 1), fault.msg, "YAML", ""};
  }
}

/// The files of a run while they are put together.
class CaseBuilder {
 public:
  CaseBuilder(const Study& study, int run, std::string folder)
      : study_(study), case_(study.CaseOf(run)), run_(run), folder_(std::move(folder)) {
    const auto& values = study.runs[static_cast<std::size_t>(run)];
    for (std::size_t i = 0; i < study.axes.size(); ++i) {
      set_.emplace_back(study.axes[i].key, values[i]);
    }
    set_.insert(set_.end(), case_.set.begin(), case_.set.end());
  }

  Result<std::string> Write() {
    auto scenario = LoadFile(case_.scenario);
    if (!scenario.ok()) return scenario.error();
    scenario_ = scenario.value();
    PutPaths(case_.scenario);
    if (Status s = Set("scenario.", scenario_); !s.ok()) return s.error();
    PutPaths(study_.path);
    if (Status s = WriteTrack(); !s.ok()) return s.error();
    if (Status s = WriteModel(); !s.ok()) return s.error();
    if (Status s = WriteBogie(); !s.ok()) return s.error();
    return File("scenario.yaml", YAML::Dump(scenario_) + "\n");
  }

 private:
  Error AtAxis(const std::string& key, const Error& inner) const {
    return {study_.path + ": " + key, inner.what, inner.allowed, inner.mend};
  }

  Status Set(const std::string& prefix, YAML::Node root) {
    for (const auto& [key, value] : set_) {
      if (key.compare(0, prefix.size(), prefix) != 0) continue;
      if (Status s = SetPath(root, key.substr(prefix.size()), value); !s.ok()) {
        return AtAxis(key, s.error());
      }
    }
    return {};
  }

  /// Paths that `naming` means beside itself, absolute: the run's files lie elsewhere.
  void PutPaths(const std::string& naming) {
    for (const char* key : {"track", "bogie", "wheel", "rail", "phs"}) {
      if (!scenario_[key] || !scenario_[key].IsScalar()) continue;
      scenario_[key] = Anywhere(BesideFile(naming, scenario_[key].Scalar()));
    }
  }

  bool Varies(const std::string& prefix) const {
    for (const auto& [key, value] : set_) {
      if (key.compare(0, prefix.size(), prefix) == 0) return true;
    }
    return false;
  }

  Result<std::string> File(const std::string& name, const std::string& text) const {
    const std::string path = (fs::path(folder_) / name).string();
    if (Status s = WritePassingFile(path, text); !s.ok()) return s.error();
    return path;
  }

  Status WriteTrack() {
    if (!Varies("track.") && !study_.vary_irregularity) return {};
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
    if (Status s = Set("track.", track); !s.ok()) return s;
    const auto file = File("track.yaml", YAML::Dump(track) + "\n");
    if (!file.ok()) return file.error();
    scenario_["track"] = file.value();
    return {};
  }

  Status WriteModel() {
    if (!Varies("model.")) return {};
    const std::string bogie = scenario_["bogie"] ? scenario_["bogie"].Scalar() : "phs";
    const std::string model =
        scenario_["phs"] ? scenario_["phs"].Scalar() : vehicle::PhsModelOf(bogie);
    if (model.empty()) return {};  // a bogie without hydraulics has nothing to vary
    auto params = phs_model::FindPhsParams(model);
    if (!params.ok()) return params.error();
    for (const auto& [key, value] : set_) {
      if (key.compare(0, 6, "model.") != 0) continue;
      if (Status s = SetModelParameter(key.substr(6), value, &params.value()); !s.ok()) {
        return AtAxis(key, s.error());
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
    if (!made.ok()) return AtAxis("bogie." + made.error().where, made.error());
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
  std::vector<std::pair<std::string, std::string>> set_;  ///< axes, then those of the case
  int run_;
  std::string folder_;
  YAML::Node scenario_;
};

}  // namespace

Result<std::string> WriteCaseFiles(const Study& study, int run, const std::string& folder) {
  return CaseBuilder(study, run, folder).Write();
}

Status LayOutRun(const Study& study, int run, const std::string& folder,
                 const std::string& final_folder) {
  const std::string from = fs::absolute(folder).string() + "/";
  const std::string to = fs::absolute(final_folder).string() + "/";
  const auto file = WriteCaseFiles(study, run, from);
  if (!file.ok()) return file.error();
  auto text = ReadFile(file.value());
  if (!text.ok()) return text.error();
  std::string moved = text.value();
  for (std::size_t at = 0; (at = moved.find(from, at)) != std::string::npos; at += to.size()) {
    moved.replace(at, from.size(), to);
  }
  return WritePassingFile(file.value(), moved);
}

namespace {

Status CheckCase(const Study& study, int run, const std::string& folder) {
  const auto file = WriteCaseFiles(study, run, folder);
  if (!file.ok()) return file.error();
  const auto scenario = vehicle::LoadScenario(file.value());
  if (scenario.ok()) return {};
  const Error& inner = scenario.error();
  // The reader names the run's own file: name the study and the key instead.
  const std::string key = inner.where.substr(inner.where.rfind(' ') + 1);
  const std::string of = study.CaseOf(run).name;
  return Error{study.path + (of.empty() ? "" : ": case " + of) + ": scenario." + key, inner.what,
               inner.allowed, inner.mend};
}

}  // namespace

Status CheckCases(const Study& study) {
  const LocalFolder scratch;
  if (Status s = scratch.status(); !s.ok()) return s;
  Status status;
  for (int run = 0; run < static_cast<int>(study.cases.size()) && status.ok(); ++run) {
    status = CheckCase(study, run, scratch.path());
  }
  return status;
}

}  // namespace phs::sweep
