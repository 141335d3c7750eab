// Results read back for their page: a JSON file, and its numbers.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "base/result.h"

namespace phs::report {

/// A file that holds one JSON object; otherwise an error with what was expected and how to mend it.
Result<nlohmann::ordered_json> ReadJsonObject(const std::string& path,
                                              const std::string& allowed = "",
                                              const std::string& mend = "");

/// The number itself; NaN for anything else (JSON writes NaN as null).
double AsNumber(const nlohmann::ordered_json& value);
/// The number under `key`; NaN if there is none.
double NumberOf(const nlohmann::ordered_json& object, const std::string& key);

/// A page made of what stands in `path`; an error where that has another form than a result.
Status MakeGuarded(const std::string& path, const std::function<Status()>& make);

}  // namespace phs::report
