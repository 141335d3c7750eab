// Where the product's own data (models/, bogie_xml/) are found. In this order: the current
// directory, $PHS_DATA, share/phs of the prefix that the running program or the plugin is installed
// in, the source folder of the build.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace phs {

/// Finds `name` as a path, or as `folder/name` with one of `extensions` in the data folders.
/// `kind` is for the message ("wheel profile"). An error lists the known names and the nearest one.
/// Example: FindData("bogie", "bogie_xml", "phs", {".xml"}).
Result<std::string> FindData(const std::string& kind, const std::string& folder,
                             const std::string& name, const std::vector<std::string>& extensions);
/// Names (without extension) available in a data folder.
std::vector<std::string> ListData(const std::string& folder,
                                  const std::vector<std::string>& extensions);

}  // namespace phs
