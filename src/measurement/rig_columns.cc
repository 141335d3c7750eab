#include "measurement/rig_columns.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>

#include "base/words.h"
#include "measurement/units.h"

namespace phs::measurement {
namespace {

/// Where measuring programs write nothing, nan, or a dash, a sample is missing.
bool IsMissing(std::string cell) {
  constexpr const char* kMarks[] = {"",     "nan", "n/a",  "#n/a",    "na", "null",
                                    "none", "inf", "-inf", "missing", "?"};
  std::transform(cell.begin(), cell.end(), cell.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const bool dashes = cell.find_first_not_of('-') == std::string::npos;
  return dashes || std::find(std::begin(kMarks), std::end(kMarks), cell) != std::end(kMarks);
}

/// "v_m_s" -> "v", "load_cell_N" -> "load_cell".
std::string StemOf(const std::string& channel) {
  return channel.substr(0, EndsWith(channel, "_m_s") ? channel.size() - 4 : channel.rfind('_'));
}

}  // namespace

int FindChannel(const Table& table, const Manifest& manifest, const std::string& channel) {
  const auto named = manifest.columns.find(channel);
  if (named != manifest.columns.end()) return table.Find(named->second);
  if (const int same = table.Find(channel); same >= 0) return same;
  for (int i = 0; i < table.num_columns(); ++i) {
    const std::string& full = table.names[static_cast<size_t>(i)];
    const std::string name =
        full.substr(full.rfind('.') == std::string::npos ? 0 : full.rfind('.') + 1);
    if (name == channel) return i;
    const auto [before, bracket] = SplitBracket(full);
    const bool known = !bracket.empty() && UnknownUnit(channel, full).empty();
    if (known && before == StemOf(channel)) return i;
    for (const Unit& unit : KnownUnits()) {
      if (!EndsWith(channel, unit.si)) continue;
      const std::string stem = channel.substr(0, channel.size() - std::string(unit.si).size());
      if (name == stem + unit.ending) return i;
    }
  }
  return -1;
}

std::string InUnknownUnit(const Table& table, const Manifest& manifest, const std::string& name) {
  const std::string stem = name.substr(0, name.rfind('_') + 1);
  for (const std::string& column : table.names) {
    const bool named = std::any_of(manifest.columns.begin(), manifest.columns.end(),
                                   [&](const auto& entry) { return entry.second == column; });
    if (named || !column.starts_with(stem)) continue;
    if (column.find('_', stem.size()) == std::string::npos) return column;
  }
  return {};
}

UnreadableCells FindUnreadable(const Table& table, int column) {
  UnreadableCells out;
  if (table.text.empty()) return out;
  const auto c = static_cast<size_t>(column);
  for (size_t row = 0; row < table.text[c].size(); ++row) {
    if (std::isfinite(table.columns[c][row]) || IsMissing(table.text[c][row])) continue;
    if (out.count++ > 0) continue;
    out.where = table.source + ":" + std::to_string(table.line[row]);
    out.cell = table.text[c][row];
  }
  return out;
}

Status CheckReadable(const Table& table, const Manifest& manifest, const std::string& channel) {
  const int column = FindChannel(table, manifest, channel);
  if (column < 0) return {};
  const UnreadableCells cells = FindUnreadable(table, column);
  if (2 * cells.count <= table.num_rows()) return {};
  return Error{cells.where,
               Quoted(table.names[static_cast<size_t>(column)]) + ": " + Quoted(cells.cell) +
                   " is no number, nor are most cells of this column",
               "numbers with '.' as decimal mark and no other signs; empty or nan: missing",
               "write it so, or leave the column out"};
}

Status CheckNames(const Manifest& manifest, const Table& table, std::vector<std::string> known) {
  known.insert(known.end(), {"t_s", "v_m_s", "p_Pa", "temperature_K"});
  known.insert(known.end(), manifest.extra.begin(), manifest.extra.end());
  const auto check = [&](const std::string& key, const std::string& name) -> Status {
    if (std::find(known.begin(), known.end(), name) != known.end()) return {};
    return Error{manifest.path + ": " + key + "." + name, "no channel of this rig has that name",
                 JoinWords(known), DidYouMean(name, known)};
  };
  for (const auto& [name, column] : manifest.columns) {
    if (Status s = check("columns", name); !s.ok()) return s;
  }
  for (const auto& [name, factor] : manifest.factors) {
    if (Status s = check("factors", name); !s.ok()) return s;
  }
  for (const auto& [channel, column] : manifest.columns) {
    if (table.Find(column) >= 0) continue;
    const auto& further = manifest.extra;
    const bool extra = std::find(further.begin(), further.end(), channel) != further.end();
    return Error{manifest.path + (extra ? ": extra." : ": columns.") + channel,
                 "no column \"" + column + "\" in " + table.source, "",
                 DidYouMean(column, table.names)};
  }
  return {};
}

}  // namespace phs::measurement
