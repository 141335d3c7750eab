// What a shell offers for a half-written command line: `phs --complete WORD…`, the last word being
// the one at the cursor. Verbs, options and choices come from the verb table, names from what ships.
// packaging/completion holds the few lines that bash, zsh and fish need to ask.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}  // namespace CLI

namespace phs::cli {

struct Candidate {
  std::string word;
  std::string text;  ///< one line, may be empty
};

/// Candidates for the last of `words`; none where a file is wanted that does not ship.
std::vector<Candidate> Complete(const CLI::App& app, const std::vector<std::string>& words);

/// Prints `Complete` to stdout, "word<TAB>text" a line.
void PrintCandidates(const std::vector<Candidate>& candidates);

/// The verb of this name; null if there is none.
const CLI::App* FindVerb(const CLI::App& app, const std::string& name);
/// All long and short names of the options of `verb`, with their dashes.
std::vector<std::string> OptionNames(const CLI::App& verb);

}  // namespace phs::cli
