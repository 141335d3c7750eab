#include "sweep/axis_key.h"

#include "base/words.h"

namespace phs::sweep {

Status CheckAxisKey(const Subject& subject, const std::string& key) {
  std::vector<std::string> allowed, known;
  for (const auto& [prefix, word] : subject.axes) {
    if (key.starts_with(prefix) && key.size() > prefix.size() && key.back() != '.') return {};
    allowed.push_back(prefix + word);
    known.push_back(prefix.substr(0, prefix.size() - 1));
  }
  const std::string first = key.substr(0, key.find('.'));
  return Error{"", Quoted(key) + " is no key of a run", JoinWords(allowed),
               DidYouMean(first, known)};
}

}  // namespace phs::sweep
