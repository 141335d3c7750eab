#include "base/words.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace phs {
namespace {

char Lower(char letter) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}

/// Levenshtein distance without regard to case.
size_t Distance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t change = diagonal + (Lower(a[i - 1]) == Lower(b[j - 1]) ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({change, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

bool BeginsAlike(std::string_view a, std::string_view b) {
  const size_t length = std::min(a.size(), b.size());
  if (length < 3) return false;
  return std::equal(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(length), b.begin(),
                    [](char x, char y) { return Lower(x) == Lower(y); });
}

}  // namespace

std::string NearestWord(std::string_view word, const std::vector<std::string>& words) {
  constexpr size_t kLongest = 256;  // a mistyped name is not longer; keeps hostile input cheap
  if (word.empty() || word.size() > kLongest) return "";
  std::string nearest;
  size_t best = std::max<size_t>(2, word.size() / 2) + 1;
  for (const std::string& candidate : words) {
    if (candidate.size() > kLongest) continue;
    size_t distance = Distance(word, candidate);
    if (BeginsAlike(word, candidate)) distance = std::min<size_t>(distance, 2);
    if (distance >= best) continue;
    best = distance;
    nearest = candidate;
  }
  return nearest;
}

std::string DidYouMean(std::string_view word, const std::vector<std::string>& words,
                       std::string otherwise) {
  const std::string nearest = NearestWord(word, words);
  return nearest.empty() ? std::move(otherwise) : "did you mean '" + nearest + "'?";
}

std::string JoinWords(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string Quoted(std::string_view text) {
  constexpr size_t kLongest = 60;
  std::string quoted = "'";
  quoted += text.substr(0, kLongest);
  quoted += text.size() > kLongest ? "…'" : "'";
  return quoted;
}

}  // namespace phs
