// Table B-1 of the thesis, measured beside ours: as declared, and by the joint fit of setups 2 to 4
// with the step left out of it.
#include <fmt/format.h>

#include <map>
#include <optional>

#include "base/data_path.h"
#include "phs_model/phs_model.h"
#include "rigs/step_table.h"
#include "validate/source_tables.h"
#include "validate/table_b1_checks.h"

namespace phs::validate {
namespace {

using json = nlohmann::ordered_json;
using rigs::StepRow;

/// Our pressures of one row [Pa gauge]; fitted: none in a setup that is not.
struct Ours {
  double declared_Pa = 0;
  std::optional<double> begin_Pa, end_Pa;  ///< its step left out
};

std::string Shown(std::optional<double> pressure) {
  return pressure ? fmt::format("{:9.2f}", 1e-6 * *pressure) : fmt::format("{:>9}", "-");
}

void AddRow(const StepRow& row, const Ours& ours, MadeTable* table) {
  const bool measured = row.end_Pa > 0;
  table->text +=
      fmt::format("{:>3}  {:5}  {:>5}  {:>7.2f} {}{}  {}{}{}{}\n", row.row, row.setup,
                  row.bore ? "bore" : "rod", 1e3 * row.piston_step_m,
                  Shown(measured ? std::optional(row.begin_Pa) : std::nullopt),
                  Shown(ours.begin_Pa), Shown(measured ? std::optional(row.end_Pa) : std::nullopt),
                  Shown(ours.declared_Pa), Shown(ours.end_Pa), measured ? "" : "  not recorded");
  const auto number = [](std::optional<double> p) { return p ? json(*p) : json(nullptr); };
  table->json["rows"].push_back(
      {{"row", row.row},
       {"setup", row.setup},
       {"chamber", row.bore ? "bore" : "rod"},
       {"piston_step_m", row.piston_step_m},
       {"measured", measured},
       {"p_begin_Pa", {{"measured", row.begin_Pa}, {"left_out", number(ours.begin_Pa)}}},
       {"p_end_Pa",
        {{"measured", row.end_Pa},
         {"declared", ours.declared_Pa},
         {"left_out", number(ours.end_Pa)}}}});
}

/// Of the joint fit, by row.
std::map<int, Ours> FittedRows(const identify::StepSearch& search) {
  std::map<int, Ours> rows;
  for (size_t r = 0; r < search.problem.runs.size(); ++r) {
    const auto& of_run = search.problem.runs[r].rows;
    const auto& heat = search.thermal[r];
    for (size_t i = 0; i < of_run.size(); ++i) {
      rows[of_run[i].row] = {search.after.declared_Pa[r][i],
                             heat.accepted ? heat.thermal_Pa[i] : heat.isothermal_Pa[i],
                             search.after.left_out_Pa[r][i]};
    }
  }
  return rows;
}

}  // namespace

Result<MadeTable> MakeTableB1() {
  const auto path = FindData("step table", "models/rigs", "lowe_table_b1", {".csv"});
  if (!path.ok()) return path.error();
  const auto rows = rigs::ReadStepTable(path.value());
  if (!rows.ok()) return rows.error();
  const auto search = SearchTableB1();
  if (!search.ok()) return search.error();
  const std::map<int, Ours> fitted = FittedRows(search.value());
  MadeTable table;
  table.json = {{"table", "B-1"}, {"unit", "Pa gauge"}, {"rows", json::array()}};
  table.text =
      "Table B-1 of the thesis: pressures after steps of the quarter rig [MPa gauge]\n"
      "ours: as declared (one value for both pressures), and the joint fit of setups 2 to 4, this\n"
      "step left out; setup 1 has three pressures, too few to fit\n"
      "                      step   just after          settled\n"
      "row  setup  chamb.      mm  measured     ours   measured declared     ours\n";
  for (const StepRow& row : rows.value()) {
    const auto known = fitted.find(row.row);
    Ours ours = known == fitted.end() ? Ours{} : known->second;
    if (known == fitted.end()) {
      const auto model = phs_model::FindPhsParams(fmt::format("quarter_setup{}", row.setup));
      if (!model.ok()) return model.error();
      const auto settled = rigs::PredictSettled(model.value(), {row});
      if (!settled.ok()) return settled.error();
      ours.declared_Pa = settled.value().front();
    }
    AddRow(row, ours, &table);
  }
  return table;
}

}  // namespace phs::validate
