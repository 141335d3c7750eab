// The effects of the catalogue as a search tries them: a table of variants.
#pragma once

#include <utility>
#include <vector>

namespace phs::identify::search {

/// On all targets together only, also on each alone, or on each alone only.
enum class Spread { kAll, kEach, kAlone };

/// One row: the effect, its free numbers, the starts, numbers held at other
/// than default values.
struct Recipe {
  const char* effect;
  Spread spread;
  std::vector<const char*> free;
  std::vector<std::vector<double>> starts;
  std::vector<std::pair<const char*, double>> fixed = {};
};

const std::vector<Recipe>& Hydraulic();
const std::vector<Recipe>& FrictionAndMounting();
const std::vector<Recipe>& InstrumentAndEnvironment();

}  // namespace phs::identify::search
