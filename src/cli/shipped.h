// What the program can be asked for by name, one row per kind: `phs list` and `phs show`.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/result.h"

namespace phs::cli {

/// Something with a name.
struct ShippedItem {
  std::string name;
  std::string text;  ///< one sentence
  std::string path;  ///< of its file; empty: an effect of the catalogues
};

struct ShippedKind {
  const char* name;  ///< "bogies"
  const char* text;
  std::vector<ShippedItem> (*items)();
};

/// All kinds, in the order of --help.
std::span<const ShippedKind> ShippedKinds();
std::vector<std::string> ShippedKindNames();

/// The first sentence that a file says of itself: its `description:` or `question:`, else its first
/// comment.
std::string FirstSentence(const std::string& path);

/// What `phs show` prints of an item: its file, or the numbers of an effect.
std::string ShownText(const ShippedItem& item);

}  // namespace phs::cli
