// The effects of the catalogue as a search tries them: a table of variants, and of the numbers that
// may be freed on top of each.
#pragma once

#include <string>
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

/// What a form may take on beyond its core, by effect.
struct OptionRow {
  const char* effect;
  std::vector<const char*> free;
  std::vector<std::vector<double>> starts;
};

const std::vector<OptionRow>& Options();

/// True if `simple` is `general` with some of its numbers equal or nil.
bool IsNested(const std::string& simple, const std::string& general);

}  // namespace phs::identify::search
