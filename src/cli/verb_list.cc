// phs list: what ships and can be asked for by name. phs show: one of these.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/words.h"
#include "cli/shipped.h"
#include "cli/verb_table.h"

namespace phs::cli {
namespace {

using Json = nlohmann::ordered_json;

struct ListOptions {
  std::string kind;
  std::string format = "text";
};

void PrintKind(const ShippedKind& kind) {
  const std::vector<ShippedItem> items = kind.items();
  size_t widest = 0;
  for (const ShippedItem& item : items) widest = std::max(widest, item.name.size());
  fmt::print("{}: {}\n", kind.name, kind.text);
  for (const ShippedItem& item : items) {
    fmt::print("  {:{}}  {}\n", item.name, widest, item.text);
  }
}

int List(const ListOptions& options) {
  Json json = Json::object();
  bool first = true;
  for (const ShippedKind& kind : ShippedKinds()) {
    if (!options.kind.empty() && options.kind != kind.name) continue;
    if (options.format == "text") {
      if (!first) fmt::print("\n");
      PrintKind(kind);
    }
    first = false;
    json[kind.name] = Json::array();
    for (const ShippedItem& item : kind.items()) {
      json[kind.name].push_back({{"name", item.name}, {"text", item.text}, {"path", item.path}});
    }
  }
  if (options.format == "json") fmt::print("{}\n", json.dump(2));
  return kDone;
}

int Show(const std::string& name) {
  std::vector<std::string> known;
  bool found = false;
  for (const ShippedKind& kind : ShippedKinds()) {
    for (const ShippedItem& item : kind.items()) {
      known.push_back(item.name);
      if (item.name != name) continue;
      fmt::print("{}{}: {}\n{}", found ? "\n" : "", kind.name, item.name, ShownText(item));
      found = true;
    }
  }
  if (found) return kDone;
  return BadInput({name, "nothing of this name ships", "a name that `phs list` prints",
                   DidYouMean(name, known)});
}

}  // namespace

void AddList(CLI::App* verb, Action* action) {
  auto options = std::make_shared<ListOptions>();
  verb->add_option("kind", options->kind, "All without")->check(CLI::IsMember(ShippedKindNames()));
  verb->add_option("--format", options->format, "Output on stdout")
      ->check(CLI::IsMember({"text", "json"}))
      ->capture_default_str();
  verb->callback([=] { *action = [=] { return List(*options); }; });
}

void AddShow(CLI::App* verb, Action* action) {
  auto name = std::make_shared<std::string>();
  verb->add_option("name", *name, "As `phs list` prints it")->required();
  verb->callback([=] { *action = [=] { return Show(*name); }; });
}

}  // namespace phs::cli
