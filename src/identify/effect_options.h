// What may be freed on top of a variant of an effect, and which effects are others simplified.
#pragma once

#include <string>
#include <vector>

namespace phs::identify::search {

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
