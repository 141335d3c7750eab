#include "sweep/case_values.h"

#include <fmt/format.h>

#include "base/numbers.h"
#include "base/words.h"
#include "phs_model/phs_model.h"

namespace phs::sweep {
namespace {

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

Status SetPath(const YAML::Node& root, const std::string& key, const std::string& value) {
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

}  // namespace

SetValues ValuesOf(const Study& study, int run) {
  const auto& values = study.runs[static_cast<std::size_t>(run)];
  SetValues set;
  for (std::size_t i = 0; i < study.axes.size(); ++i) {
    set.emplace_back(study.axes[i].key, values[i]);
  }
  const StudyCase& of = study.CaseOf(run);
  set.insert(set.end(), of.set.begin(), of.set.end());
  return set;
}

bool Varies(const SetValues& values, const std::string& prefix) {
  for (const auto& [key, value] : values) {
    if (key.starts_with(prefix)) return true;
  }
  return false;
}

Error AtAxis(const Study& study, const std::string& key, const Error& inner) {
  return {study.path + ": " + key, inner.what, inner.allowed, inner.mend};
}

Status SetKeys(const Study& study, const SetValues& values, const std::string& prefix,
               const YAML::Node& root) {
  for (const auto& [key, value] : values) {
    if (!key.starts_with(prefix)) continue;
    if (Status s = SetPath(root, key.substr(prefix.size()), value); !s.ok()) {
      return AtAxis(study, key, s.error());
    }
  }
  return {};
}

Result<std::vector<ModelNumber>> ModelNumbers(const std::string& key, const std::string& value,
                                              const hydraulics::PhsParams& params) {
  const auto number = ParseNumber(value);
  if (!number) return Error{"", Quoted(value) + " is no number", "a number", ""};
  std::vector<ModelNumber> numbers;
  std::vector<std::string> known;
  for (const auto& parameter : phs_model::ListAllParameters(params)) {
    if (Fits(key, parameter.name)) numbers.push_back({parameter.name, *number});
    known.push_back(parameter.name);
  }
  if (!numbers.empty()) return numbers;
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

}  // namespace phs::sweep
