#include "rail/creep_cases.h"

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "base/numbers.h"
#include "base/result_dir.h"

namespace phs::rail {
namespace {

constexpr double kMuch = std::numeric_limits<double>::max();

/// What a column may hold.
struct CaseColumn {
  const char* name;
  double low, high;
  bool above_low;  ///< low itself is not allowed
  const char* allowed;
};
constexpr CaseColumn kColumns[] = {
    {"a_mm", 0, 1000, true, "more than 0, up to 1000 mm"},
    {"b_mm", 0, 1000, true, "more than 0, up to 1000 mm"},
    {"FN_N", 0, 1e9, false, "0 … 1e9 N"},
    {"mu", 0, 2, true, "more than 0, up to 2"},
    {"G_MPa", 1000, 1e6, false, "1000 … 1000000 MPa"},
    {"nu", 0, 0.5, false, "0 … 0.5"},
    {"xi", -kMuch, kMuch, false, "a number"},
    {"eta", -kMuch, kMuch, false, "a number"},
    {"phi_rad_per_mm", -kMuch, kMuch, false, "a number"},
};
constexpr int kNumColumns = sizeof(kColumns) / sizeof(kColumns[0]);

Status CheckCell(const Table& cases, const CaseColumn& column, int index, int row, double value) {
  if (std::isfinite(value) && value <= column.high &&
      (column.above_low ? value > column.low : value >= column.low)) {
    return {};
  }
  const auto i = static_cast<std::size_t>(index);
  const auto r = static_cast<std::size_t>(row);
  const bool has_line = r < cases.line.size();
  const std::string where = cases.source + ":" + std::to_string(has_line ? cases.line[r] : row + 1);
  const bool has_text = i < cases.text.size() && r < cases.text[i].size();
  const std::string cell = has_text ? cases.text[i][r] : Shortest(value);
  return Error{where, std::string(column.name) + " is '" + cell + "'", column.allowed,
               "correct this cell"};
}

/// One law per material, made when a row asks for it.
class Laws {
 public:
  explicit Laws(const CreepLawParams& params) : params_(params) {}
  Result<const CreepLaw*> For(const ContactMaterial& material) {
    auto& law = laws_[{material.shear_modulus_Pa, material.poisson_ratio}];
    if (!law) {
      params_.material = material;
      auto made = CreateCreepLaw(params_);
      if (!made.ok()) return made.error();
      law = std::move(made).value();
    }
    return static_cast<const CreepLaw*>(law.get());
  }

 private:
  CreepLawParams params_;
  std::map<std::pair<double, double>, std::unique_ptr<CreepLaw>> laws_;
};

void Append(Table* table, const std::string& name, std::vector<double> values) {
  std::vector<std::string> cells;
  cells.reserve(values.size());
  for (double value : values) cells.push_back(Shortest(value));
  const int old = table->Find(name);
  if (old >= 0) {  // the input held a result already: replaced
    table->columns[static_cast<std::size_t>(old)] = std::move(values);
    if (!table->text.empty()) table->text[static_cast<std::size_t>(old)] = std::move(cells);
    return;
  }
  table->names.push_back(name);
  table->columns.push_back(std::move(values));
  if (!table->text.empty()) table->text.push_back(std::move(cells));
}

std::string Quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string quoted(1, '"');
  for (char c : cell) quoted.append(c == '"' ? 2 : 1, c);
  quoted.push_back('"');
  return quoted;
}

}  // namespace

Result<Table> CalcCreepCases(const Table& cases, const CreepLawParams& params) {
  int index[kNumColumns];
  for (int i = 0; i < kNumColumns; ++i) {
    const auto column = cases.Column(kColumns[i].name);
    if (!column.ok()) return column.error();
    index[i] = cases.Find(kColumns[i].name);
  }
  Laws laws(params);
  const auto rows = static_cast<std::size_t>(cases.num_rows());
  std::vector<double> fx(rows), fy(rows), mz(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    double v[kNumColumns];
    for (int i = 0; i < kNumColumns; ++i) {
      v[i] = cases.columns[static_cast<std::size_t>(index[i])][row];
      const Status good = CheckCell(cases, kColumns[i], index[i], static_cast<int>(row), v[i]);
      if (!good.ok()) return good.error();
    }
    const auto law = laws.For({v[4] * 1e6, v[5]});
    if (!law.ok()) return law.error();
    CreepInput in;
    in.a = v[0] * 1e-3;
    in.b = v[1] * 1e-3;
    in.normal = v[2];
    in.friction = v[3];
    in.xi = v[6];
    in.eta = v[7];
    in.phi = v[8] * 1e3;
    const CreepForce f = law.value()->Calc(in);
    fx[row] = f.x;
    fy[row] = f.y;
    mz[row] = f.moment * 1e3;
  }
  Table out = cases;
  Append(&out, "Fx_N", std::move(fx));
  Append(&out, "Fy_N", std::move(fy));
  Append(&out, "Mz_Nmm", std::move(mz));
  return out;
}

Result<Table> CalcCreepCases(const Table& cases, const std::string& method) {
  CreepLawParams params;
  params.method = method;
  return CalcCreepCases(cases, params);
}

Status WriteCaseTable(const std::string& path, const Table& table) {
  std::string text;
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    if (i > 0) text += ',';
    text += Quoted(table.names[i]);
  }
  text += '\n';
  for (std::size_t row = 0; row < static_cast<std::size_t>(table.num_rows()); ++row) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      if (i > 0) text += ',';
      text += table.text.empty() ? Shortest(table.columns[i][row]) : Quoted(table.text[i][row]);
    }
    text += '\n';
  }
  return WriteFileAtomically(path, text);
}

}  // namespace phs::rail
