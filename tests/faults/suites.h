// The smallest honest jobs of the fault walk (walk.cc). Each leaves its result in `out`.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace phs::faults {

struct Suite {
  std::string name = {};
  std::vector<std::pair<std::string, std::string>> files = {};  ///< name, text
  std::vector<std::string> arguments = {};                      ///< of phs
  std::vector<std::string> again = {};                          ///< after the fault
  std::vector<std::string> old_arguments = {};  ///< made the result that --force replaces
  bool resumes = false;                         ///< `again` may refuse: then from the start
};

std::vector<Suite> AllSuites();

}  // namespace phs::faults
