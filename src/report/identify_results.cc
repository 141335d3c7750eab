#include "report/identify_results.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/result_dir.h"
#include "base/table.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

/// First column of `names` that the table has; -1 if none.
int FindAny(const Table& table, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const int column = table.Find(name);
    if (column >= 0) return column;
  }
  return -1;
}

/// Column `name`; empty if there is none.
std::vector<double> ColumnOf(const Table& table, const std::string& name) {
  const int column = table.Find(name);
  return column < 0 ? std::vector<double>() : table.columns[column];
}

/// Column `name` of `table` on the clock `time`, linear between its rows; empty if it has none.
std::vector<double> OnClock(const Table& table, const std::string& name,
                            const std::vector<double>& time) {
  const int y = table.Find(name);
  if (y < 0) return {};
  const int t = table.Find("t_s");
  if (t < 0 || table.columns[t] == time) return table.columns[y];
  const std::vector<double>& from = table.columns[t];
  const std::vector<double>& values = table.columns[y];
  std::vector<double> moved(time.size(), kNoNumber);
  std::size_t row = 0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    while (row + 2 < from.size() && from[row + 1] <= time[i]) ++row;
    if (from.size() < 2 || time[i] < from.front() || time[i] > from.back()) continue;
    const double part = (time[i] - from[row]) / (from[row + 1] - from[row]);
    moved[i] = values[row] + part * (values[row + 1] - values[row]);
  }
  return moved;
}

/// Rate of a sampled signal: slope over five samples, which a little noise does not upset.
std::vector<double> RateOf(const std::vector<double>& time, const std::vector<double>& x) {
  std::vector<double> rate(x.size(), 0.0);
  const std::size_t n = x.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t a = i >= 2 ? i - 2 : 0;
    const std::size_t b = std::min(n - 1, i + 2);
    if (time[b] > time[a]) rate[i] = (x[b] - x[a]) / (time[b] - time[a]);
  }
  return rate;
}

void ReadWindows(IdentifyResults* results) {
  for (const char* name : {"estimation", "validation"}) {
    const json window = results->all.value(name, json::array());
    if (!window.is_array() || window.size() != 2 || !window[0].is_number()) continue;
    results->windows.push_back({.begin = window[0].get<double>(),
                                .end = window[1].get<double>(),
                                .label = name,
                                .strength = std::string(name) == "validation" ? 2 : 1});
  }
}

Status ReadData(const IdentifyReportInput& input, IdentifyResults* results) {
  if (input.measured.empty() || input.predicted.empty()) return {};
  Result<Table> measured = ReadTable(input.measured);
  if (!measured.ok()) return measured.status();
  Result<Table> predicted = ReadTable(input.predicted);
  if (!predicted.ok()) return predicted.status();
  Table baseline;
  if (!input.baseline.empty()) {
    Result<Table> read = ReadTable(input.baseline);
    if (!read.ok()) return read.status();
    baseline = std::move(read.value());
  }
  const Table& data = measured.value();
  const int t = data.Find("t_s");
  if (t < 0) {  // a table of steps has no clock: nothing to plot over time
    results->steps = {ColumnOf(data, "p_end_MPa"), ColumnOf(baseline, "p_end_MPa"),
                      ColumnOf(predicted.value(), "p_end_MPa")};
    return {};
  }
  results->time = data.columns[t];
  const int place = data.Find("s_m");
  const int x = place >= 0
                    ? -1
                    : FindAny(data, {"actuator_m", "actuator1_m", "x_m", "piston_m", "piston1_m"});
  if (place >= 0) results->place = data.columns[place];
  if (x >= 0) {
    results->displacement = data.columns[x];
    results->speed = RateOf(results->time, results->displacement);
  }
  for (int column = 0; column < data.num_columns(); ++column) {
    const std::string& name = data.names[column];
    if (column == t || column == x || column == place || predicted.value().Find(name) < 0) continue;
    if (name.starts_with("actuator") || name == "x_m" || name == "v_m_s") continue;
    const ReadableName readable = Readable(name);
    results->channels.push_back({.name = name,
                                 .label = readable.words + " [" + readable.unit + "]",
                                 .factor = readable.factor,
                                 .measured = data.columns[column],
                                 .before = OnClock(baseline, name, results->time),
                                 .after = OnClock(predicted.value(), name, results->time),
                                 .is_force = name.ends_with("_N")});
  }
  return {};
}

}  // namespace

double NumberAt(const json& object, const std::string& pointer) {
  const json::json_pointer at(pointer);
  if (!object.contains(at) || !object.at(at).is_number()) return kNoNumber;
  return object.at(at).get<double>();
}

std::vector<double> ResidualOf(const ChannelData& channel, bool after) {
  const std::vector<double>& predicted = after ? channel.after : channel.before;
  std::vector<double> residual;
  if (predicted.size() != channel.measured.size()) return residual;
  residual.reserve(predicted.size());
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    residual.push_back(channel.measured[i] - predicted[i]);
  }
  return residual;
}

std::vector<std::size_t> IdentifyResults::ScoredRows() const {
  const Band* window = nullptr;
  for (const Band& band : windows) {
    if (band.label == "validation") window = &band;
  }
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (window == nullptr || (time[i] >= window->begin && time[i] <= window->end)) {
      rows.push_back(i);
    }
  }
  return rows;
}

Result<IdentifyResults> ReadIdentifyResults(const IdentifyReportInput& input) {
  Result<std::string> text = ReadFile(input.result);
  if (!text.ok()) return text.error();
  IdentifyResults results;
  results.all = json::parse(text.value(), nullptr, false);
  if (!results.all.is_object()) {
    return Error{.where = input.result,
                 .what = "is not a JSON object",
                 .allowed = "result.json of phs identify or phs rig",
                 .mend = "run it again"};
  }
  const json channels = results.all.value("channels", json::object());
  for (const auto& [name, scores] : channels.items()) {
    results.has_before = results.has_before || scores.contains("before");
  }
  ReadWindows(&results);
  if (Status status = ReadData(input, &results); !status.ok()) return status.error();
  return results;
}

}  // namespace phs::report
