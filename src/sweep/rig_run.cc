#include "sweep/rig_run.h"

#include "measurement/rig_numbers.h"

namespace phs::sweep {

using measurement::Manifest;

Result<std::string> FindRig(const std::string& name) { return measurement::FindManifest(name); }

Result<Manifest> ReadRig(const std::string& file) {
  return measurement::LoadManifest(file, measurement::WindowNeed::kNone);
}

Status CheckRig(const std::string& file) {
  const auto read = ReadRig(file);
  if (!read.ok()) return read.error();
  const Manifest& manifest = read.value();
  if (!measurement::HasClock(manifest)) {
    return Error{file + ": rig", "'" + manifest.rig + "' is no rig driven over time",
                 measurement::kRigsWithClock, ""};
  }
  if (manifest.rig == "element" && !manifest.signal) {
    return Error{file + ": data", "a bench with a record is compared by phs rig alone",
                 "signal:", ""};
  }
  return measurement::DeclaredModel(manifest).status();
}

std::vector<std::string> RigRecords(const std::string& path) {
  std::vector<std::string> records;
  const auto read = ReadRig(path);
  if (!read.ok()) return records;
  for (const auto& run : read.value().runs) records.push_back(run.data);
  return records;
}

Result<nlohmann::ordered_json> CalcRig(const std::string& file) {
  if (Status s = CheckRig(file); !s.ok()) return s.error();
  const auto read = ReadRig(file);
  const auto driven = measurement::DriveRig(read.value());
  if (!driven.ok()) return driven.error();
  return measurement::RigNumbers(read.value(), driven.value());
}

}  // namespace phs::sweep
