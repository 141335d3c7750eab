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
/// `families`: folders below it that hold more of its kind, for the message: "lowe/fig_6_10".
/// Example: FindData("bogie", "bogie_xml", "phs", {".xml"}).
Result<std::string> FindData(const std::string& kind, const std::string& folder,
                             const std::string& name, const std::vector<std::string>& extensions,
                             const std::vector<std::string>& families = {});
/// `name` as the file `naming` means it: the file of that name beside it if there is one (a path
/// that begins in its folder), else `name` as it stands. Bare words stay: they are names of shipped
/// data.
std::string BesideFile(const std::string& naming, const std::string& name);
/// A path that is there now made absolute, to be read from anywhere; a name stays.
std::string Anywhere(const std::string& name);
/// Names (without extension) available in a data folder; those of `families` with their folder.
std::vector<std::string> ListData(const std::string& folder,
                                  const std::vector<std::string>& extensions,
                                  const std::vector<std::string>& families = {});

}  // namespace phs
