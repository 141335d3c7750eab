#include "identify/result/element_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/table.h"
#include "effects/unlisted.h"
#include "identify/discrepancy/formula_search.h"
#include "identify/discrepancy/residual_map.h"
#include "identify/fit/fit_intervals.h"

namespace phs::identify::element {

using json = nlohmann::ordered_json;

namespace {

/// Residual on the rows of the windows, with the places they belong to.
struct WindowRows {
  std::vector<double> residual;
  std::vector<std::pair<size_t, size_t>> at;  ///< record, full-rate sample
  std::vector<size_t> row;                    ///< of its record
  Eigen::VectorXd vector() const {
    return Eigen::Map<const Eigen::VectorXd>(residual.data(),
                                             static_cast<Eigen::Index>(residual.size()));
  }
};

WindowRows Collect(const ElementData& data, const Rows& predicted, bool fitted) {
  WindowRows out;
  for (size_t r = 0; r < data.records.size(); ++r) {
    const ElementRecord& record = data.records[r];
    const std::vector<char>& in = fitted ? record.fitted : record.scored;
    for (size_t k = 0; k < in.size(); ++k) {
      if (!in[k]) continue;
      out.residual.push_back(record.row_value[k] - predicted[r][k]);
      out.at.emplace_back(r, static_cast<size_t>(record.row_sample[k]));
      out.row.push_back(k);
    }
  }
  return out;
}

/// Of the sensor and, where `uncertain` says it, of what drives.
double NoiseAt(const ElementData& data, const Rows& uncertain, size_t r, size_t k) {
  return uncertain.empty() ? data.noise : std::hypot(data.noise, uncertain[r][k]);
}

/// Travel since the last reversal, with the sign of the motion [m], at the full rate.
std::vector<double> TravelSinceReversal(const ElementRecord& record) {
  const std::vector<double>& x = record.motion.position_m[0];
  std::vector<double> out(x.size(), 0.0);
  for (size_t i = 1; i < x.size(); ++i) {
    const double step = x[i] - x[i - 1];
    const bool moving = std::abs(record.motion.speed_m_s[0][i]) > 3 * record.speed_deviation[i];
    out[i] = !moving ? out[i - 1] : out[i - 1] * step < 0 ? step : out[i - 1] + step;
  }
  return out;
}

}  // namespace

RowScore ScoreRows(const ElementData& data, const Rows& predicted, bool fitted) {
  std::vector<double> time, measured, model;
  for (size_t r = 0; r < data.records.size(); ++r) {
    const ElementRecord& record = data.records[r];
    const std::vector<char>& in = fitted ? record.fitted : record.scored;
    for (size_t k = 0; k < in.size(); ++k) {
      if (!in[k]) continue;
      time.push_back(static_cast<double>(time.size()));
      measured.push_back(record.row_value[k]);
      model.push_back(predicted[r][k]);
    }
  }
  const measurement::ChannelScore s =
      measurement::Score(time, measured, model, {0, static_cast<double>(time.size())});
  double error = 0, whole = 0;
  for (size_t i = 0; i < measured.size(); ++i) {
    error += (measured[i] - model[i]) * (measured[i] - model[i]);
    whole += measured[i] * measured[i];
  }
  return {s, whole > 0 ? 100 * std::sqrt(error / whole) : 0};
}

json ToJson(const RowScore& score) {
  json out = measurement::ToJson(score.score);
  out["relative_percent"] = score.relative_percent;
  return out;
}

RowMap MapRows(const ElementData& data, const Rows& predicted, const Rows& uncertain, bool fitted) {
  const WindowRows rows = Collect(data, predicted, fitted);
  std::vector<std::pair<std::string, std::vector<double>>> variables;
  const auto add = [&](const std::string& name, auto value) {
    auto& column = variables.emplace_back(name, std::vector<double>{}).second;
    for (const auto& [r, i] : rows.at) column.push_back(value(r, i));
  };
  std::vector<std::vector<double>> since;
  for (const ElementRecord& record : data.records) since.push_back(TravelSinceReversal(record));
  const auto motion = [&](size_t r) -> const rigs::RigMotion& { return data.records[r].motion; };
  add("x_m", [&](size_t r, size_t i) { return motion(r).position_m[0][i]; });
  add("speed_m_s", [&](size_t r, size_t i) { return motion(r).speed_m_s[0][i]; });
  add("reversal", [&](size_t r, size_t i) { return since[r][i]; });
  add("t_s", [&](size_t r, size_t i) { return data.records[r].Time(static_cast<int>(i)); });
  if (data.has_pressure) add("p_Pa", [&](size_t r, size_t i) { return motion(r).pressure_Pa[i]; });
  if (data.has_temperature) {
    add("temperature_K", [&](size_t r, size_t i) { return motion(r).temperature_K[i]; });
  }
  const double independent =
      search::EffectiveSamples(rows.vector(), 0, static_cast<int>(rows.residual.size()));
  RowMap out;
  out.channel = data.compared;
  out.shares = ShareByVariable(rows.residual, independent, variables);
  for (const VariableShare& v : out.shares) {
    if (v.share > 0.03 && v.p_value < 1e-3 && out.depends_on.size() < 4) {
      out.depends_on.push_back(v.variable);
    }
  }
  double square = 0;
  for (size_t j = 0; j < rows.residual.size(); ++j) {
    const double noise = NoiseAt(data, uncertain, rows.at[j].first, rows.row[j]);
    square += std::pow(rows.residual[j] / noise, 2) / static_cast<double>(rows.residual.size());
  }
  out.over_noise = std::sqrt(square);
  out.whiteness_p = search::WhitenessP(rows.residual);
  return out;
}

json ToJson(const RowMap& map) {
  json share = json::object(), p = json::object();
  for (const VariableShare& v : map.shares) share[v.variable] = v.share, p[v.variable] = v.p_value;
  return {{"channel", map.channel},
          {"depends_on", map.depends_on},
          {"explained_share", share},
          {"p_values", p},
          {"residual_over_noise", map.over_noise},
          {"whiteness_p", map.whiteness_p}};
}

LeftOver LeftOfRows(const ElementData& data, const Rows& predicted, const Rows& uncertain,
                    bool fitted) {
  double square = 0, following = 0, count = 0;
  bool comes_and_goes = false;
  for (size_t r = 0; r < data.records.size(); ++r) {
    const ElementRecord& record = data.records[r];
    const rigs::RigMotion& motion = record.motion;
    std::vector<double> residual;
    Rows signals;
    double present = 0;
    std::vector<const std::vector<double>*> driven = {&motion.position_m[0]};
    if (data.has_pressure) driven.push_back(&motion.pressure_Pa);
    if (data.has_temperature) driven.push_back(&motion.temperature_K);
    signals.resize(driven.size() + 1);
    const std::vector<char>& in = fitted ? record.fitted : record.scored;
    const auto& window = fitted ? record.estimation : record.validation;
    for (size_t k = 0; k < in.size(); ++k) {
      const auto i = static_cast<size_t>(record.row_sample[k]);
      if (!window.Contains(record.Time(record.row_sample[k]))) continue;
      const double over = (record.row_value[k] - predicted[r][k]) / NoiseAt(data, uncertain, r, k);
      residual.push_back(in[k] ? over : std::numeric_limits<double>::quiet_NaN());
      if (in[k]) square += over * over, ++present;
      for (size_t s = 0; s < driven.size(); ++s) signals[s].push_back((*driven[s])[i]);
      signals.back().push_back(predicted[r][k]);
    }
    following += present * MeanSquareThatFollows(residual, signals);
    comes_and_goes = comes_and_goes || ComesAndGoes(residual);
    count += present;
  }
  if (!(count > 0)) return {};
  return {std::sqrt(square / count), following / count, comes_and_goes};
}

std::string FormulaText(const search::Identification& found) {
  for (const search::AcceptedEffect& effect : found.effects) {
    if (effect.candidate.effect != effects::UnlistedInfo().name) continue;
    const std::string prefix = "effects." + effect.candidate.effect + ".";
    std::string text = effect.candidate.params.formula;
    for (size_t i = 0; i < found.corrected.free.size(); ++i) {
      const std::string& name = found.corrected.free[i].name;
      if (!name.starts_with(prefix + "c")) continue;
      const std::string symbol = name.substr(prefix.size(), name.rfind("_N") - prefix.size());
      const size_t at = text.find(symbol + "*");
      if (at == std::string::npos) continue;
      text.replace(at, symbol.size(), fmt::format("{:.4g}[N]", found.after.values[i]));
    }
    return text;
  }
  return {};
}

Status WriteRows(const std::string& path, const ElementData& data, const Rows* predicted) {
  std::vector<std::string> names = {"t_s", "x_m", "force_N"};
  if (data.has_pressure) names.push_back("p_Pa");
  if (data.has_temperature) names.push_back("temperature_K");
  if (data.records.size() > 1) names.push_back("run");
  std::vector<std::vector<double>> columns(names.size());
  double shift = 0;
  for (size_t r = 0; r < data.records.size(); ++r) {
    const ElementRecord& record = data.records[r];
    const rigs::RigMotion& m = record.motion;
    if (r > 0) shift = columns[0].back() + 1 - m.t0_s;  // runs one second apart
    for (size_t k = 0; k < record.row_sample.size(); ++k) {
      const auto i = static_cast<size_t>(record.row_sample[k]);
      size_t c = 0;
      columns[c++].push_back(record.Time(record.row_sample[k]) + shift);
      const double compared = predicted != nullptr ? (*predicted)[r][k] : record.row_value[k];
      columns[c++].push_back(data.by_force ? compared : m.position_m[0][i]);
      columns[c++].push_back(data.by_force ? record.row_force_N[k] : compared);
      if (data.has_pressure) columns[c++].push_back(m.pressure_Pa[i]);
      if (data.has_temperature) columns[c++].push_back(m.temperature_K[i]);
      if (c < columns.size()) columns[c].push_back(static_cast<double>(r + 1));
    }
  }
  return WriteCsv(path, names, columns);
}

}  // namespace phs::identify::element
