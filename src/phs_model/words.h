// Words of model files, in the order of the enumerations they stand for (phs_params.h).
#pragma once

#include <string>
#include <vector>

namespace phs::phs_model {

inline const std::vector<std::string> kModels = {"none", "static", "presliding"};
inline const std::vector<std::string> kCurves = {"table", "coulomb"};
inline const std::vector<std::string> kBalances = {"unified", "sequential"};

}  // namespace phs::phs_model
