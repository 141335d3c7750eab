// Reading YAML: typed values with ranges, errors with file:line, unknown keys named with the
// nearest known one. Quantities carry their unit in the key (`radius_m`), so no unit parsing is
// needed.
//
// Use:
//   auto doc = YamlMap::Load(path);               // Result<YamlMap>
//   YamlMap& map = doc.value();
//   p.radius_m = map.Number("radius_m", {.min = 80});            // required
//   p.speed_m_s = map.Number("speed_m_s", {.min = 0}, 20.0);     // with a default
//   if (Status s = map.Finish(); !s.ok()) return s.error();      // first error, or an unknown key
// After the first error every getter returns its default (or zero), so checks need no ladder.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/range.h"
#include "base/result.h"
#include "base/words.h"

namespace phs {

/// A YAML map being read. Copies share the same error and the same record of used keys.
class YamlMap {
 public:
  /// Parses a file / a text: one document whose root is a map. Errors carry `path:line`. Refused:
  /// keys given twice, more than 64 levels, more than 16 MB or a million values (aliases counted
  /// wherever they are used).
  static Result<YamlMap> Load(const std::string& path);
  static Result<YamlMap> Parse(const std::string& text, const std::string& name);

  bool Has(std::string_view key) const;
  /// The value is a block of its own, not a number or a word.
  bool IsMap(std::string_view key) const;
  double Number(std::string_view key, const Range& range);
  double Number(std::string_view key, const Range& range, double otherwise);
  int Integer(std::string_view key, int min, int max);
  int Integer(std::string_view key, int min, int max, int otherwise);
  bool Bool(std::string_view key, bool otherwise);
  std::string Text(std::string_view key);
  std::string Text(std::string_view key, std::string_view otherwise);
  /// One of `words`; an error names the nearest.
  std::string Word(std::string_view key, const std::vector<std::string>& words);
  std::string Word(std::string_view key, const std::vector<std::string>& words,
                   std::string_view otherwise);
  std::vector<double> Numbers(std::string_view key, const Range& range);  ///< a sequence; required
  std::vector<double> Numbers(std::string_view key, const Range& range,
                              std::vector<double> otherwise);
  std::vector<std::string> Texts(std::string_view key);  ///< a sequence of words; empty if absent
  /// Nested map; an empty map if absent (Has tells). Shares this document's error.
  YamlMap Map(std::string_view key);
  /// A sequence of maps; empty if absent.
  std::vector<YamlMap> Maps(std::string_view key);
  /// The keys of this map in file order (for maps whose keys are names).
  std::vector<std::string> Keys() const;

  /// Records an error found by the caller at `key` (ignored after the first).
  void Fail(std::string_view key, std::string what, std::string allowed = "",
            std::string mend = "");
  /// `path:line: a.b.key`: for messages about a value that was read well but is wrong elsewhere.
  std::string Where(std::string_view key) const;
  /// The path the document was loaded from.
  const std::string& path() const;
  /// First error of the whole document, else the topmost key of this map (or of maps read from it)
  /// that nobody asked for, with the nearest known key.
  Status Finish() const;

 private:
  struct Document;
  struct Impl;
  explicit YamlMap(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}
  std::shared_ptr<Impl> impl_;
};

}  // namespace phs
