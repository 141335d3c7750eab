#include "sweep/axis_key.h"

#include "base/words.h"

namespace phs::sweep {

Status CheckAxisKey(const std::string& key) {
  for (const char* prefix : {"scenario.", "track.", "model.", "bogie.", "note."}) {
    const std::size_t length = std::string(prefix).size();
    if (key.compare(0, length, prefix) == 0 && key.size() > length && key.back() != '.') return {};
  }
  return Error{"", Quoted(key) + " is no key of a run",
               "scenario.KEY, track.KEY, model.PARAMETER, bogie.ELEMENT.ATTRIBUTE, note.NAME", ""};
}

}  // namespace phs::sweep
