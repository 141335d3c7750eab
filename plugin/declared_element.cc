#include "plugin/declared_element.h"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <sstream>

#include "base/numbers.h"
#include "base/words.h"
#include "plugin/model_text.h"

namespace phs::plugin {
namespace {

const ElementKey* FindKey(const ElementKind& kind, const std::string& name) {
  for (const ElementKey& key : kind.keys) {
    if (key.key == name) return &key;
  }
  return nullptr;
}

std::vector<std::string> KeysOf(const ElementKind& kind) {
  std::vector<std::string> names;
  for (const ElementKey& key : kind.keys) names.emplace_back(key.key);
  return names;
}

/// One "key=value".
Status ReadNumber(const std::string& word, const ElementKind& kind, const std::string& where,
                  std::map<std::string, double>* numbers) {
  const size_t equals = word.find('=');
  const std::string name = word.substr(0, equals);
  const std::vector<std::string> known = KeysOf(kind);
  const ElementKey* key = FindKey(kind, name);
  if (key == nullptr) {
    return Error{where, "has no key " + Quoted(name), JoinWords(known), DidYouMean(name, known)};
  }
  const auto value =
      equals == std::string::npos ? std::nullopt : ParseNumber(word.substr(equals + 1));
  if (!value || !(*value >= key->min) || !(*value <= key->max)) {
    return Error{where, Quoted(word) + " is no number that is allowed",
                 fmt::format("{}={} … {}", name, Shortest(key->min), Shortest(key->max)), ""};
  }
  if (!numbers->emplace(name, *value).second) {
    return Error{where, "gives " + name + " twice", "each key once", ""};
  }
  return {};
}

Status ReadNumbers(const std::string& text, const ElementKind& kind, const std::string& where,
                   std::map<std::string, double>* numbers) {
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (Status s = ReadNumber(word, kind, where, numbers); !s.ok()) return s;
  }
  for (const ElementKey& key : kind.keys) {
    if (numbers->contains(key.key)) continue;
    if (std::isnan(key.otherwise)) {
      return Error{where, std::string("lacks ") + key.key, JoinWords(KeysOf(kind)),
                   std::string("write ") + key.key + "=…: " + key.text};
    }
    numbers->emplace(key.key, key.otherwise);
  }
  return {};
}

/// A text whose tuple is missing would go unread.
Status CheckTexts(const mjModel* m, const std::string& prefix) {
  for (int i = 0; i < m->ntext; ++i) {
    const std::string name = ObjectName(m, mjOBJ_TEXT, i);
    if (!name.starts_with(prefix) || mj_name2id(m, mjOBJ_TUPLE, name.c_str()) >= 0) continue;
    return Error{"MJCF text '" + name + "'", "belongs to no tuple of the same name",
                 "<tuple name=\"" + name + "\"> with the sites at its ends", ""};
  }
  return {};
}

}  // namespace

Result<std::vector<DeclaredElement>> ReadDeclared(const mjModel* m, const ElementKind& kind,
                                                  size_t num_sites) {
  const std::string prefix = std::string(kind.name) + ":";
  if (Status s = CheckTexts(m, prefix); !s.ok()) return s.error();
  std::vector<DeclaredElement> declared;
  for (const NamedTuple& tuple : TuplesWithPrefix(m, prefix)) {
    DeclaredElement element{kind.name, tuple.name, tuple.Ids(mjOBJ_SITE), {}};
    const std::string name = prefix + tuple.name;
    const std::set<int> different(element.sites.begin(), element.sites.end());
    if (different.size() != num_sites || tuple.elements.size() != num_sites) {
      return Error{"MJCF tuple '" + name + "'",
                   "does not name " + std::to_string(num_sites) + " different sites",
                   "<element objtype=\"site\" objname=\"…\"/> for each end", ""};
    }
    const auto text = CustomText(m, name);
    const std::string where = "MJCF text '" + name + "'";
    if (!text) {
      return Error{where, "is missing", JoinWords(KeysOf(kind)),
                   "<text name=\"" + name + "\" data=\"KEY=NUMBER …\"/>"};
    }
    if (Status s = ReadNumbers(*text, kind, where, &element.numbers); !s.ok()) return s.error();
    declared.push_back(std::move(element));
  }
  return declared;
}

}  // namespace phs::plugin
