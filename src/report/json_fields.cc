#include "report/json_fields.h"

#include <limits>
#include <utility>

#include "base/result_dir.h"

namespace phs::report {

using json = nlohmann::ordered_json;

Result<json> ReadJsonObject(const std::string& path, const std::string& allowed,
                            const std::string& mend) {
  Result<std::string> text = ReadFile(path);
  if (!text.ok()) return text.error();
  json parsed = json::parse(text.value(), nullptr, false);
  if (!parsed.is_object()) return Error{path, "is not a JSON object", allowed, mend};
  return parsed;
}

double AsNumber(const json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

double NumberOf(const json& object, const std::string& key) {
  const auto found = object.find(key);
  return AsNumber(found == object.end() ? json() : *found);
}

Status MakeGuarded(const std::string& path, const std::function<Status()>& make) {
  try {
    return make();
  } catch (const json::exception& fault) {
    return Error{path, std::string("has another form than a result (") + fault.what() + ")",
                 "as phs writes it", "run it again"};
  }
}

}  // namespace phs::report
