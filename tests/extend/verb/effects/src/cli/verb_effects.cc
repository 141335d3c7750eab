// phs effects: the catalogue, or one effect with its numbers.
#include <fmt/format.h>

#include <memory>

#include "base/words.h"
#include "cli/verb_table.h"
#include "effects/catalogue.h"

namespace phs::cli {
namespace {

int Describe(const std::string& name) {
  const auto* info = effects::Catalogue().Find(name);
  if (info == nullptr) {
    std::vector<std::string> names;
    for (const auto& known : effects::Catalogue().effects()) names.push_back(known.name);
    return BadInput(
        {"effect", Quoted(name) + " is not known", JoinWords(names), DidYouMean(name, names)});
  }
  fmt::print("{} ({}): {}\n", info->name, info->family, info->text);
  for (const auto& p : info->parameters) {
    fmt::print("  {} = {:g} {}: {}\n", p.name, p.otherwise, p.unit, p.text);
  }
  return kDone;
}

}  // namespace

void AddEffects(CLI::App* verb, Action* action) {
  auto name = std::make_shared<std::string>();
  verb->add_option("name", *name, "One effect; without it, all of them");
  verb->callback([=] {
    *action = [=]() -> int {
      if (!name->empty()) return Describe(*name);
      for (const auto& info : effects::Catalogue().effects()) {
        fmt::print("{:<24}{:<12}{}\n", info.name, info.family, info.text);
      }
      return kDone;
    };
  });
}

}  // namespace phs::cli
