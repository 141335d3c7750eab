#include "report/shown_paths.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace phs::report {
namespace {

constexpr std::string_view kBefore = " \t\n\"'=([:,";
constexpr std::string_view kEndsPath = " \t\n\"'<>:;,)]";

bool BeginsPath(const std::string& text, size_t at) {
  if (text[at] != '/' || at + 1 >= text.size()) return false;
  if (at > 0 && kBefore.find(text[at - 1]) == std::string_view::npos) return false;
  const auto next = static_cast<unsigned char>(text[at + 1]);
  return std::isalnum(next) || next == '_' || next == '.' || next == '-';
}

std::string Shortened(const std::string& path) {
  size_t from = std::string::npos;
  for (const std::string_view folder : {"/models/", "/bogie_xml/"}) {
    const size_t at = path.rfind(folder);
    if (at != std::string::npos && (from == std::string::npos || at > from)) from = at;
  }
  if (from != std::string::npos) return path.substr(from + 1);
  const size_t end = path.find_last_not_of('/');
  const size_t slash = path.rfind('/', end);
  return path.substr(slash + 1);
}

}  // namespace

std::string WithoutFolders(const std::string& text) {
  std::string shown;
  for (size_t at = 0; at < text.size();) {
    if (!BeginsPath(text, at)) {
      shown += text[at++];
      continue;
    }
    const size_t end = std::min(text.find_first_of(kEndsPath, at), text.size());
    shown += Shortened(text.substr(at, end - at));
    at = end;
  }
  return shown;
}

}  // namespace phs::report
