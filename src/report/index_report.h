// `phs report --index DIR`: a page of all results below a folder, each with a link to its report;
// and links in those reports to the index and to each other.
#pragma once

#include <string>

#include "base/result.h"

namespace phs::report {

struct IndexWritten {
  std::string page = {};
  int results = 0;
  int reports = 0;  ///< of them with a report
  int older = 0;    ///< reports of older versions, which keep no links
};

/// Writes FOLDER/index.html, and the links in the reports below; nothing outside the folder. An
/// index.html that phs has not written is left alone and told.
Result<IndexWritten> WriteIndex(const std::string& folder);

}  // namespace phs::report
