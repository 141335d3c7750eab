// Table 6-3 of the thesis. Its middle block needs no record: the hydraulic force against the load
// cell is friction over force. The others compare with pressures and forces that were not printed.
#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "base/data_path.h"
#include "base/table.h"
#include "measurement/manifest.h"
#include "measurement/rig_numbers.h"
#include "phs_model/phs_model.h"
#include "validate/source_tables.h"

namespace phs::validate {
namespace {

using hydraulics::PhsParams;
using json = nlohmann::ordered_json;
using measurement::ChannelScore;

struct Input {
  const char* name;      ///< in the table's file
  const char* manifest;  ///< our motion
  const char* words;
  double tolerance;  ///< that the middle block is to be within, a share of its value
};
constexpr Input kInputs[] = {
    {"sine_0.1Hz_1.5mm", "quarter_sine", "sine 0.1 Hz", 0.10},
    {"triangle_0.25Hz_1.5mm", "quarter_triangle", "triangle 0.25 Hz", 0.12},
};

struct Law {
  const char* theirs;
  const char* ours;
};
constexpr Law kLaws[] = {{"IG_isothermal", "isothermal"},
                         {"polytropic", "polytropic"},
                         {"IG_EE", "ideal"},
                         {"BWR_EE", "bwr"}};
/// Of setup 2, Table 6-2 as printed; the laws with an energy equation need one.
constexpr double kThermalTime_s = 1.73;

/// One block of a printed row.
struct Block {
  double m_re = 0, at_or_below_mean = 0, below_12 = 0;  ///< %
};
json ToJson(const Block& block) {
  return {{"m_re_percent", block.m_re},
          {"share_at_or_below_mean_percent", block.at_or_below_mean},
          {"share_below_12_percent", block.below_12}};
}

Block BlockAt(const Table& table, const std::string& name, int row) {
  const auto at = [&](const char* ending) {
    return table.columns[static_cast<size_t>(table.Find(name + ending))][static_cast<size_t>(row)];
  };
  return {at("_m_re_percent"), at("_at_or_below_mean_percent"), at("_below_12_percent")};
}

PhsParams WithGas(PhsParams params, const char* law) {
  for (auto& line : params.lines) {
    for (auto* gas : {&line.reservoir, &line.accumulator}) {
      gas->law = hydraulics::FindGasLaw(law);
      gas->thermal_time_s = kThermalTime_s;
    }
  }
  return params;
}

Result<Table> ReadPrinted() {
  const auto path = FindData("table", "models/rigs", "lowe_table_6_3", {".csv"});
  if (!path.ok()) return path.error();
  Result<Table> table = ReadCsv(path.value());
  if (!table.ok()) return table.error();
  for (const char* block : {"pressure", "friction", "load"}) {
    for (const char* ending : {"_m_re_percent", "_at_or_below_mean_percent", "_below_12_percent"}) {
      if (const auto column = table.value().Column(std::string(block) + ending); !column.ok()) {
        return column.error();
      }
    }
  }
  return table;
}

int FindRow(const Table& table, const Input& input, const Law& law) {
  const int inputs = table.Find("input"), laws = table.Find("gas_law");
  for (int i = 0; inputs >= 0 && laws >= 0 && i < table.num_rows(); ++i) {
    const auto k = static_cast<size_t>(i);
    if (table.text[static_cast<size_t>(inputs)][k] == input.name &&
        table.text[static_cast<size_t>(laws)][k] == law.theirs) {
      return i;
    }
  }
  return -1;
}

/// Mean errors of both inputs with a friction.
using BothErrors = Result<std::pair<double, double>>;
BothErrors ErrorsOf(const PhsParams& quarter) {
  double errors[2] = {};
  for (int i = 0; i < 2; ++i) {
    const auto score = CalcFrictionError(quarter, kInputs[i].manifest);
    if (!score.ok()) return score.error();
    errors[i] = score.value().m_re_percent;
  }
  return std::pair{errors[0], errors[1]};
}

/// Golden section over [low, high]: the error of either input rises with the friction, so the sum
/// of squared relative misses has one minimum.
template <typename With>
Result<FreeFriction> FitFriction(double low, double high, const With& with) {
  const auto printed = ReadPrinted();
  if (!printed.ok()) return printed.error();
  double theirs[2];
  for (int i = 0; i < 2; ++i) {
    const int row = FindRow(printed.value(), kInputs[i], kLaws[0]);
    if (row < 0) return Error{printed.value().source, "lacks a row", kInputs[i].name, ""};
    theirs[i] = BlockAt(printed.value(), "friction", row).m_re;
  }
  std::optional<Error> fault;
  FreeFriction best;
  const auto miss = [&](double value) {
    const BothErrors errors = ErrorsOf(with(value));
    if (!errors.ok()) {
      fault = errors.error();
      return 0.0;
    }
    best = {value, errors.value().first, errors.value().second};
    return std::pow(best.sine / theirs[0] - 1, 2) + std::pow(best.triangle / theirs[1] - 1, 2);
  };
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double fa = miss(a), fb = miss(b);
  for (int i = 0; i < 25 && !fault; ++i) {
    if (fa < fb) {
      high = b, b = a, fb = fa;
      fa = miss(a = high - golden * (high - low));
    } else {
      low = a, a = b, fa = fb;
      fb = miss(b = low + golden * (high - low));
    }
  }
  if (fault) return *fault;
  miss(0.5 * (low + high));
  return best;
}

struct Column {
  const char* model;
  const char* words;
};
constexpr Column kColumns[] = {{"quarter_measured", "measured"},
                               {"quarter_setup2", "declared"},
                               {"quarter_source", "source's"}};

/// One printed row beside ours; a line of the middle block is added to `text`.
Result<json> MakeRow(const Table& printed, const Input& input, const Law& law, std::string* text) {
  const int row = FindRow(printed, input, law);
  if (row < 0) return Error{printed.source, "lacks a row", input.name, ""};
  const Block theirs = BlockAt(printed, "friction", row);
  json out = {{"input", input.name}, {"gas_law", law.ours}};
  out["friction"] = {{"theirs", ToJson(theirs)}};
  *text += fmt::format("{:17} {:11}{:8.2f}", input.words, law.ours, theirs.m_re);
  std::string shares;
  for (const Column& column : kColumns) {
    const auto params = phs_model::FindPhsParams(column.model);
    if (!params.ok()) return params.error();
    const auto score = CalcFrictionError(WithGas(params.value(), law.ours), input.manifest);
    if (!score.ok()) return score.error();
    const ChannelScore& s = score.value();
    const Block ours = {s.m_re_percent, 100 * s.share_at_or_below_mean,
                        100 * s.share_below_12_percent};
    out["friction"]["ours"][column.model] = ToJson(ours);
    *text += fmt::format("{:10.2f}", ours.m_re);
    if (&column != kColumns) continue;
    const double off = ours.m_re / theirs.m_re - 1;
    out["friction"]["relative"] = off;
    shares =
        fmt::format("{:+8.1f} %   {:4.1f}, {:4.1f}   {:4.1f}, {:4.1f}", 100 * off,
                    theirs.at_or_below_mean, theirs.below_12, ours.at_or_below_mean, ours.below_12);
    if (&law != kLaws) continue;
    out["friction"]["tolerance"] = input.tolerance;
    out["friction"]["within"] = std::abs(off) <= input.tolerance;
    shares += fmt::format("  within {:g} %: {}", 100 * input.tolerance,
                          std::abs(off) <= input.tolerance ? "yes" : "NO");
  }
  *text += shares + "\n";
  for (const char* block : {"pressure", "load"}) {
    out[block] = {{"theirs", ToJson(BlockAt(printed, block, row))}, {"ours", "needs the record"}};
  }
  return out;
}

std::string OtherBlocks(const json& rows) {
  std::string text =
      "\nThe other blocks compare with pressures and forces that are not printed:\n"
      "                                theirs  ours\n";
  for (const auto& [block, words] :
       {std::pair{"pressure", "hydraulic force against that of the pressures"},
        std::pair{"load", "whole model against the load cell"}}) {
    text += fmt::format("{}\n", words);
    for (const json& row : rows) {
      text += fmt::format("  {:22} {:11}{:6.2f}  needs the record\n",
                          row["input"].get<std::string>(), row["gas_law"].get<std::string>(),
                          row[block]["theirs"]["m_re_percent"].get<double>());
    }
  }
  return text;
}

Status AddFreeFriction(const PhsParams& measured, MadeTable* table) {
  const auto scale = FitFrictionScale(measured);
  if (!scale.ok()) return scale.error();
  const auto pressed = FitPressureFriction(measured);
  if (!pressed.ok()) return pressed.error();
  const auto ToNumbers = [](const FreeFriction& f) {
    return json{
        {"value", f.value}, {"sine_m_re_percent", f.sine}, {"triangle_m_re_percent", f.triangle}};
  };
  table->json["friction_free"] = {{"friction.scale", ToNumbers(scale.value())},
                                  {"difference_N_per_Pa", ToNumbers(pressed.value())}};
  table->text += fmt::format(
      "\nWith friction free (fitted to the two isothermal rows; measured hydraulics):\n"
      "  friction table times {:.3f}: {:.2f} and {:.2f} %\n"
      "  table as it is, and {:.1f} N per MPa between the chambers: {:.2f} and {:.2f} %\n",
      scale.value().value, scale.value().sine, scale.value().triangle, 1e6 * pressed.value().value,
      pressed.value().sine, pressed.value().triangle);
  return {};
}

}  // namespace

Result<ChannelScore> CalcFrictionError(const PhsParams& quarter, const std::string& name) {
  const auto path = measurement::FindManifest(name);
  if (!path.ok()) return path.error();
  const auto manifest = measurement::LoadManifest(path.value(), measurement::WindowNeed::kNone);
  if (!manifest.ok()) return manifest.error();
  const auto driven = measurement::DriveRig(manifest.value(), quarter);
  if (!driven.ok()) return driven.error();
  return measurement::ScoreHydraulicForce(manifest.value(), driven.value());
}

Result<FreeFriction> FitFrictionScale(const PhsParams& quarter) {
  return FitFriction(0.3, 3, [&](double scale) {
    PhsParams with = quarter;
    with.friction.scale *= scale;
    return with;
  });
}

Result<FreeFriction> FitPressureFriction(const PhsParams& quarter) {
  return FitFriction(0, 5e-4, [&](double slope) {
    PhsParams with = quarter;
    with.effects.push_back({"pressure_friction",
                            {},
                            {{"bore_N_per_Pa", 0},
                             {"rod_N_per_Pa", 0},
                             {"difference_N_per_Pa", slope},
                             {"retraction_ratio", 1}}});
    return with;
  });
}

Result<MadeTable> MakeTable63() {
  const auto printed = ReadPrinted();
  if (!printed.ok()) return printed.error();
  const auto measured = phs_model::FindPhsParams("quarter_measured");
  if (!measured.ok()) return measured.error();
  MadeTable table;
  table.json = {{"table", "6.3"}, {"unit", "m%RE"}, {"rows", json::array()}};
  table.text =
      "Table 6-3 of the thesis, quarter rig, setup 2, 1.5 mm: mean relative error [%]\n\n"
      "Middle block: hydraulic force against the load cell, friction table as declared\n"
      "                               theirs  ours by hydraulics:           measured, shares %\n"
      "                                       measured  declared  source's  off       theirs      "
      " ours (at or below mean, below 12 %)\n";
  for (const Input& input : kInputs) {
    for (const Law& law : kLaws) {
      auto row = MakeRow(printed.value(), input, law, &table.text);
      if (!row.ok()) return row.error();
      table.json["rows"].push_back(std::move(row).value());
    }
  }
  if (Status s = AddFreeFriction(measured.value(), &table); !s.ok()) return s.error();
  table.text += OtherBlocks(table.json["rows"]);
  return table;
}

}  // namespace phs::validate
