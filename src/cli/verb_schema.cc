// phs schema: JSON schemas of the YAML files, for editors and for checks without phs.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "cli/schema_kinds.h"
#include "cli/verb_table.h"

namespace phs::cli {
namespace {

int PrintSchema(const std::string& name) {
  for (const SchemaKind& kind : SchemaKinds()) {
    if (name != kind.name) continue;
    const auto schema = MakeSchema(kind);
    if (!schema.ok()) return BadInput(schema.error());
    fmt::print("{}\n", schema.value().dump(1));
  }
  return kDone;
}

}  // namespace

void AddSchema(CLI::App* verb, Action* action) {
  auto kind = std::make_shared<std::string>();
  verb->add_option("kind", *kind, "Kind of file")
      ->required()
      ->check(CLI::IsMember(SchemaKindNames()));
  verb->footer(
      "An editor with yaml-language-server completes and checks a file that begins with\n"
      "# yaml-language-server: $schema=PREFIX/share/phs/models/schemas/KIND.json");
  verb->callback([=] { *action = [=] { return PrintSchema(*kind); }; });
}

}  // namespace phs::cli
