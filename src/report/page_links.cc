#include "report/page_links.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "base/result_dir.h"
#include "report/report_page.h"

namespace phs::report {
namespace {

namespace fs = std::filesystem;

constexpr char kBegin[] = "<!--links-->";
constexpr char kEnd[] = "<!--/links-->";
constexpr char kOwnPage[] = "<meta name=\"generator\" content=\"phs\">";

std::string Anchor(const std::string& address, const std::string& text) {
  return "<a href=\"" + EscapeHtml(Address(address)) + "\">" + EscapeHtml(text) + "</a>";
}

}  // namespace

std::string Address(const std::string& path) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
  std::string address;
  for (const char c : path) {
    if (kPlain.find(c) != std::string_view::npos) {
      address += c;
    } else {
      address += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return address;
}

bool IsOwnPage(const std::string& html) { return html.find(kOwnPage) != std::string::npos; }

std::string LinkToIndexAbove(const std::string& page) {
  constexpr int kMost = 4;
  std::error_code fault;
  fs::path folder = fs::absolute(page, fault).lexically_normal().parent_path();
  std::string up;
  for (int i = 0; i < kMost && folder.has_relative_path(); ++i) {
    folder = folder.parent_path();
    up += "../";
    const fs::path index = folder / kIndexName;
    if (!fs::is_regular_file(index, fault)) continue;
    const auto html = ReadFile(index.string());
    if (html.ok() && IsOwnPage(html.value())) return Anchor(up + kIndexName, "All results");
  }
  return "";
}

std::string NeighbourLinks(const std::vector<PageLink>& reports, size_t own,
                           const std::string& up) {
  constexpr size_t kAll = 50, kAside = 25;
  const auto link = [&](size_t i, const std::string& before, const std::string& after) {
    return Anchor(up + reports[i].path, before + reports[i].text + after);
  };
  std::string html = Anchor(up + kIndexName, "All results");
  if (reports.size() < 2) return html;
  if (own > 0) html += link(own - 1, "‹ ", "");
  if (own + 1 < reports.size()) html += link(own + 1, "", " ›");
  const bool all = reports.size() <= kAll;
  const size_t first = all || own < kAside ? 0 : own - kAside;
  const size_t end = all ? reports.size() : std::min(reports.size(), own + kAside + 1);
  html += fmt::format("<details><summary>{} reports of this folder</summary><ul>", reports.size());
  for (size_t i = first; i < end; ++i) {
    html += "<li>" + (i == own ? EscapeHtml(reports[i].text) + " (this one)" : link(i, "", "")) +
            "</li>";
  }
  const size_t more = reports.size() - (end - first);
  if (more > 0) html += fmt::format("<li>{} more in the index</li>", more);
  return html + "</ul></details>";
}

Result<bool> PutLinks(const std::string& page, const std::string& links) {
  auto html = ReadFile(page);
  if (!html.ok()) return html.error();
  std::string& text = html.value();
  const size_t begin = text.find(kBegin);
  const size_t end = text.find(kEnd);
  if (begin == std::string::npos || end == std::string::npos || end < begin || !IsOwnPage(text)) {
    return false;
  }
  const size_t from = begin + sizeof kBegin - 1;
  if (text.compare(from, end - from, links) == 0) return true;
  text.replace(from, end - from, links);
  if (Status s = WriteFileAtomically(page, text); !s.ok()) return s.error();
  return true;
}

}  // namespace phs::report
