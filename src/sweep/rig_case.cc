#include "sweep/rig_case.h"

#include <algorithm>
#include <filesystem>

#include "base/data_path.h"
#include "base/numbers.h"
#include "base/result_dir.h"
#include "sweep/case_values.h"
#include "sweep/rig_run.h"

namespace phs::sweep {
namespace {

namespace fs = std::filesystem;

/// `text` as the manifest at `naming` means it, to be read from anywhere. A record lies beside its
/// manifest; what begins with an environment variable is a path already.
std::string Placed(const std::string& naming, const std::string& text, bool record) {
  if (text.starts_with("${")) return text;
  if (!record) return Anywhere(BesideFile(naming, text));
  const fs::path beside = fs::path(naming).parent_path() / text;
  std::error_code none;
  const bool there = fs::exists(beside, none) || !fs::exists(text, none);
  return fs::absolute(there ? beside : fs::path(text), none).lexically_normal().string();
}

void PutPaths(const std::string& naming, YAML::Node map) {
  for (const char* key : {"model", "compare_with", "data"}) {
    if (!map[key] || !map[key].IsScalar()) continue;
    map[key] = Placed(naming, map[key].Scalar(), std::string(key) == "data");
  }
  if (!map["runs"] || !map["runs"].IsSequence()) return;
  for (std::size_t i = 0; i < map["runs"].size(); ++i) {
    if (map["runs"][i].IsMap()) PutPaths(naming, map["runs"][i]);
  }
}

bool AsksForComparison(const Study& study) {
  return std::any_of(study.outputs.begin(), study.outputs.end(),
                     [](const std::string& path) { return path.starts_with("compared_with."); });
}

/// Numbers of the model become changes of the declared one.
Status PutModelNumbers(const Study& study, const SetValues& values, const std::string& file,
                       YAML::Node manifest) {
  const auto read = ReadRig(file);
  if (!read.ok()) return read.error();
  const auto params = measurement::DeclaredModel(read.value());
  if (!params.ok()) return params.error();
  for (const auto& [key, value] : values) {
    if (!key.starts_with("model.")) continue;
    const auto numbers = ModelNumbers(key.substr(6), value, params.value());
    if (!numbers.ok()) return AtAxis(study, key, numbers.error());
    for (const ModelNumber& n : numbers.value()) {
      manifest["phs_parameters"][n.name] = Shortest(n.value);
    }
  }
  return {};
}

}  // namespace

Result<std::string> WriteRigCase(const Study& study, int run, const std::string& folder) {
  const std::string& base = study.CaseOf(run).base;
  if (study.vary_irregularity) {
    return Error{study.path + ": vary_irregularity", "a rig has no track", "scenario:", ""};
  }
  auto loaded = LoadFile(base);
  if (!loaded.ok()) return loaded.error();
  YAML::Node manifest = loaded.value();
  PutPaths(base, manifest);
  const SetValues values = ValuesOf(study, run);
  if (Status s = SetKeys(study, values, "rig.", manifest); !s.ok()) return s.error();
  PutPaths(study.path, manifest);
  if (!manifest["compare_with"] && AsksForComparison(study)) {
    std::error_code none;
    manifest["compare_with"] = fs::absolute(base, none).lexically_normal().string();
  }
  const std::string file = (fs::path(folder) / "rig.yaml").string();
  const auto write = [&] { return WritePassingFile(file, YAML::Dump(manifest) + "\n"); };
  if (Status s = write(); !s.ok()) return s.error();
  if (!Varies(values, "model.")) return file;
  if (Status s = PutModelNumbers(study, values, file, manifest); !s.ok()) return s.error();
  if (Status s = write(); !s.ok()) return s.error();
  return file;
}

}  // namespace phs::sweep
