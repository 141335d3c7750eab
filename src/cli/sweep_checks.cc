#include "cli/sweep_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "analysis/running_statistics.h"
#include "base/json_path.h"
#include "base/result_dir.h"
#include "base/table.h"
#include "sweep/outputs.h"

namespace phs::cli {
namespace {

using Json = nlohmann::ordered_json;
using analysis::NamedSummary;

/// Puts a number where `path` says: keys joined by dots. NaN becomes null.
void Put(const std::string& path, double value, Json* json) {
  std::istringstream parts(path);
  for (std::string part; std::getline(parts, part, '.');) json = &(*json)[part];
  *json = NumberOrNull(value);
}

/// Where most, least and the middle of an output lie, over the runs that have it.
void PutSpread(const std::string& path, std::vector<double> values, Json* json) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  std::sort(values.begin(), values.end());
  const double none = std::nan("");
  Put("least." + path, values.empty() ? none : values.front(), json);
  Put("median." + path, analysis::Percentile(values, 50), json);
  Put("largest." + path, values.empty() ? none : values.back(), json);
}

Result<std::vector<NamedSummary>> NumbersOfBest(const std::string& dir) {
  const auto text = ReadFile(dir + "/optimum.json");
  if (!text.ok()) return text.error();
  const Json json = Json::parse(text.value(), nullptr, false);
  Json best = json.is_object() ? json.value("best", Json()) : Json();
  if (!best.is_object()) {
    best = {{"status", "failed"}, {"reason", "no candidate was calculated to the end"}};
  } else if (!best.value("keeps_constraints", false)) {
    best["status"] = "failed";
    best["reason"] = "the best design misses a constraint";
  }
  return std::vector<NamedSummary>{{"best", best}};
}

}  // namespace

Result<std::vector<NamedSummary>> NumbersOfSweep(const sweep::Study& study,
                                                 const std::string& dir) {
  if (study.optimisation) return NumbersOfBest(dir);
  const auto read = ReadCsv(dir + "/sweep.csv");
  if (!read.ok()) return read.error();
  const Table& table = read.value();
  const auto text = [&](const char* column, size_t row) {
    const int at = table.Find(column);
    return at < 0 ? std::string() : table.text[static_cast<size_t>(at)][row];
  };
  const size_t rows = static_cast<size_t>(table.num_rows());
  std::vector<NamedSummary> numbers;
  Json whole = {{"status", "ok"}, {"runs", rows}, {"failed", 0}};
  for (size_t row = 0; row < rows; ++row) {
    const Json run = {{"status", text("status", row)}, {"reason", text("reason", row)}};
    if (run["status"] != "ok") whole["failed"] = whole["failed"].get<int>() + 1;
    numbers.emplace_back("run_" + text("run", row), run);
  }
  const std::vector<std::string> columns = sweep::OutputColumns(study.outputs);
  for (size_t i = 0; i < columns.size(); ++i) {
    const auto values = table.Column(columns[i]);
    if (!values.ok()) return values.error();
    for (size_t row = 0; row < rows; ++row) {
      Put(study.outputs[i], values.value()[row], &numbers[row].second);
    }
    PutSpread(study.outputs[i], values.value(), &whole);
  }
  numbers.emplace_back("sweep", std::move(whole));
  return numbers;
}

}  // namespace phs::cli
