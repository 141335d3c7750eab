// Reference rows of the creep tests as inputs in SI.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "base/table.h"
#include "phs_places.h"
#include "rail/creep_law.h"

namespace phs::rail {

inline Table ReferenceTable(const std::string& name) {
  auto table = ReadCsv(std::string(PHS_TEST_DATA) + "/" + name);
  if (!table.ok()) ADD_FAILURE() << table.error().Line();
  return table.ok() ? table.value() : Table{};
}

/// Cell of a column that must exist.
inline double Cell(const Table& table, const std::string& name, int row) {
  const int column = table.Find(name);
  if (column < 0) {
    ADD_FAILURE() << "no column " << name;
    return 0;
  }
  return table.columns[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)];
}

/// Row of hertz_creep_table.csv.
inline CreepInput HertzCase(const Table& t, int row) {
  CreepInput in;
  in.a = Cell(t, "a_mm", row) * 1e-3;
  in.b = Cell(t, "b_mm", row) * 1e-3;
  in.normal = Cell(t, "FN_N", row);
  in.friction = Cell(t, "mu", row);
  in.xi = Cell(t, "xi", row);
  in.eta = Cell(t, "eta", row);
  in.phi = Cell(t, "phi_rad_per_mm", row) * 1e3;
  return in;
}

inline std::unique_ptr<CreepLaw> Law(CreepLawParams params) {
  params.use_disk_cache = false;
  auto law = CreateCreepLaw(params);
  if (!law.ok()) ADD_FAILURE() << law.error().Line();
  return law.ok() ? std::move(law).value() : nullptr;
}
inline std::unique_ptr<CreepLaw> Law(const std::string& method) {
  CreepLawParams params;
  params.method = method;
  return Law(params);
}

}  // namespace phs::rail
