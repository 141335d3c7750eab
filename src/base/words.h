// Words in messages: lists, quotes and the known word nearest to a mistyped one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace phs {

/// The word of `words` nearest to `word`: fewest letters changed, added or removed, upper and lower
/// case alike; a word that the other begins with is near too ("rigid" for "rigid_link"). Empty if
/// none is close: more than max(2, half its length) letters differ.
std::string NearestWord(std::string_view word, const std::vector<std::string>& words);

/// "did you mean 'x'?", or `otherwise` if no known word is near.
std::string DidYouMean(std::string_view word, const std::vector<std::string>& words,
                       std::string otherwise = "");

/// "a, b, c".
std::string JoinWords(const std::vector<std::string>& words);

/// 'text' in quotes for a message: long text shortened.
std::string Quoted(std::string_view text);

}  // namespace phs
