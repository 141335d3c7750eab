#include "sweep/outputs.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include "sweep/analyses.h"

namespace phs::sweep {
namespace {

std::vector<std::string> PathParts(const std::string& path) {
  std::vector<std::string> parts;
  std::istringstream stream(path);
  for (std::string part; std::getline(stream, part, '.');) parts.push_back(part);
  return parts;
}

bool NamesList(const std::string& part) {
  return std::any_of(Analyses().begin(), Analyses().end(), [&](const Analysis& analysis) {
    return std::find(analysis.lists.begin(), analysis.lists.end(), part) != analysis.lists.end();
  });
}

/// A part as it stands in a column's name: "traction, electric braking" is traction_electric_braking,
/// since a comma would end the column.
std::string ForColumn(const std::string& part) {
  std::string out;
  for (const char c : part) {
    if (c != ',' && c != ' ' && c != '"') {
      out += c;
    } else if (out.empty() || out.back() != '_') {
      out += '_';
    }
  }
  return out;
}

std::string Joined(const std::vector<std::string>& parts, std::size_t first) {
  std::string column;
  for (std::size_t i = first; i < parts.size(); ++i) {
    if (NamesList(parts[i])) continue;
    column += (column.empty() ? "" : "_") + ForColumn(parts[i]);
  }
  return column;
}

}  // namespace

std::string OutputColumn(const std::string& path) {
  const auto parts = PathParts(path);
  return Joined(parts, parts.size() > 1 ? 1 : 0);
}

std::vector<std::string> OutputColumns(const std::vector<std::string>& paths) {
  std::map<std::string, int> count;
  for (const std::string& path : paths) ++count[OutputColumn(path)];
  std::vector<std::string> columns;
  for (const std::string& path : paths) {
    const std::string column = OutputColumn(path);
    columns.push_back(count[column] > 1 ? Joined(PathParts(path), 0) : column);
  }
  return columns;
}

}  // namespace phs::sweep
