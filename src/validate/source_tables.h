// Tables of T. P. Löwe's thesis, measured beside ours: `phs rig --table 6.3`. One row per table.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "hydraulics/phs_params.h"
#include "measurement/channel_scores.h"

namespace phs::validate {

struct MadeTable {
  std::string text;             ///< as printed
  nlohmann::ordered_json json;  ///< the same numbers
};

struct SourceTable {
  const char* name;  ///< "6.3"
  const char* text;  ///< one line
  Result<MadeTable> (*make)();
};

std::span<const SourceTable> SourceTables();
std::vector<std::string> SourceTableNames();
/// @pre one of the names.
Result<MadeTable> MakeSourceTable(const std::string& name);

/// Table 6-3, middle block: hydraulic force of a quarter rig against its load cell, after the first
/// period of the manifest's motion ("quarter_sine"). Friction over force, so it measures the force.
Result<measurement::ChannelScore> CalcFrictionError(const hydraulics::PhsParams& quarter,
                                                    const std::string& manifest);

/// What makes the isothermal middle block of both inputs fit best, friction alone being free.
struct FreeFriction {
  double value = 0;               ///< factor of the table, or N/Pa
  double sine = 0, triangle = 0;  ///< m%RE with it
};
/// A factor on the friction table.
Result<FreeFriction> FitFrictionScale(const hydraulics::PhsParams& quarter);
/// The table as it is, and a friction that rises with the pressure between the chambers
/// (pressure_friction).
Result<FreeFriction> FitPressureFriction(const hydraulics::PhsParams& quarter);

/// The rows of `SourceTables`.
Result<MadeTable> MakeTable63();
Result<MadeTable> MakeTableB1();

}  // namespace phs::validate
