// Links between the pages of one folder: each report to the index above it and to its neighbours.
// They stand between two marks in the page, so that `phs report --index` can put new ones in
// without making the page again.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace phs::report {

inline constexpr char kReportName[] = "report.html";
inline constexpr char kIndexName[] = "index.html";

/// A path as an address in a page: what an address gives a meaning of its own (%, #, ?, blanks …)
/// written by its number.
std::string Address(const std::string& path);

/// True if this text is a page of this program.
bool IsOwnPage(const std::string& html);

/// A link to the nearest index that `phs report --index` has written in one of the four folders
/// above that of `page`; empty if there is none.
std::string LinkToIndexAbove(const std::string& page);

struct PageLink {
  std::string text;
  std::string path;  ///< relative to the folder of the index
};

/// Index, the reports before and after number `own`, and a fold with all, or, where they are more
/// than 50, with the 25 before and after and how many more the index has. `up`: from the page's
/// folder to that of the index ("../").
std::string NeighbourLinks(const std::vector<PageLink>& reports, size_t own, const std::string& up);

/// Puts `links` between the marks of the page in that file. False: it has none (an older page).
Result<bool> PutLinks(const std::string& page, const std::string& links);

}  // namespace phs::report
