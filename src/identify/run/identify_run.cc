#include "identify/run/identify_run.h"

#include "identify/run/bogie_run.h"
#include "identify/run/element_run.h"
#include "identify/run/rig_identify.h"
#include "measurement/manifest.h"

namespace phs::identify::search {

using measurement::LoadManifest;
using measurement::Manifest;
namespace {

/// Rigs whose model is driven by a measured motion over time.
bool IsDriven(const std::string& rig) { return rig != "steps"; }

Error NoSuchRun(const Manifest& manifest) {
  return {manifest.path + ": rig", "rig " + manifest.rig + " has no such run",
          "cylinder, quarter, full, element, bogie", ""};
}

}  // namespace

Result<IdentifyOutcome> RunIdentify(const std::string& manifest_path, const SearchOptions& options,
                                    const Progress& progress, const ResultDir& dir) {
  Result<Manifest> manifest = LoadManifest(manifest_path);
  if (!manifest.ok()) return manifest.error();
  if (manifest.value().rig == "element") {
    return element::RunElementIdentify(manifest.value(), options, progress, dir);
  }
  if (manifest.value().rig == "bogie") {
    if (!options.between.empty()) {
      return Error{"--between", "a bogie on its track is not driven by a motion of one's choice",
                   "rigs cylinder, quarter, full, element", ""};
    }
    return IdentifyBogie(manifest.value(), options, progress, dir);
  }
  if (IsDriven(manifest.value().rig)) {
    return IdentifyDriven(manifest.value(), options, progress, dir);
  }
  return NoSuchRun(manifest.value());
}

}  // namespace phs::identify::search
