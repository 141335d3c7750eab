// Keys of model files that are no plain number: names, words, tables. With the rows of
// hydraulics/phs_numbers.h they are all a file may hold (docs/phs_models.md).
#pragma once

#include <string>
#include <vector>

namespace phs::phs_model {

/// Words, in the order of the enumerations they stand for (hydraulics/phs_params.h).
inline const std::vector<std::string> kModels = {"none", "static", "presliding"};
inline const std::vector<std::string> kCurves = {"table", "coulomb"};
inline const std::vector<std::string> kBalances = {"unified", "sequential"};

enum class FilePart { kWhole, kCylinder, kLine };

struct KeyRow {
  FilePart part;
  std::string where;      ///< below its part: "reservoir.law"
  std::string allowed;    ///< in words
  std::string otherwise;  ///< default
  std::string text;
};

/// In the order of files and pages.
const std::vector<KeyRow>& OtherKeys();

}  // namespace phs::phs_model
