// What `phs compare --radii` prints: one block per curve, one line per bogie.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace phs::cli {

/// `described`: what vehicle::DescribeRadii returns.
std::string RadiusTable(const nlohmann::ordered_json& described);

}  // namespace phs::cli
