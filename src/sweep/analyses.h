// What one run of a study can calculate: the word after `analysis:`, a row each.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/yaml.h"
#include "sweep/analysis_row.h"

namespace phs::sweep {

/// All of them; the first of a subject is meant where a study says nothing.
std::span<const Analysis> Analyses();

/// Reads the word at key "analysis"; one of another subject than that with key `of` is an error.
const Analysis* ReadAnalysis(YamlMap* map, const std::string& of);

/// True for a path below the part of an analysis that may be lacking.
bool MayLack(const Analysis& analysis, const std::string& path);

}  // namespace phs::sweep
