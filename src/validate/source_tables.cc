#include "validate/source_tables.h"

#include "base/check.h"

namespace phs::validate {
namespace {

constexpr SourceTable kTables[] = {
    {"6.3", "errors of the forces on the quarter rig, by gas law", &MakeTable63},
    {"B-1", "pressures after steps of the quarter rig, all setups", &MakeTableB1},
};

}  // namespace

std::span<const SourceTable> SourceTables() { return kTables; }

std::vector<std::string> SourceTableNames() {
  std::vector<std::string> names;
  for (const SourceTable& table : kTables) names.emplace_back(table.name);
  return names;
}

Result<MadeTable> MakeSourceTable(const std::string& name) {
  const SourceTable* found = nullptr;
  for (const SourceTable& table : kTables) {
    if (name == table.name) found = &table;
  }
  PHS_CHECK(found != nullptr);
  return found->make();
}

}  // namespace phs::validate
