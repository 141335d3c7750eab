#include "cli/completion.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/shipped.h"

namespace phs::cli {
namespace {

/// What ships and fits an option or a positional, by the kinds of `phs list`.
struct NamedBy {
  const char* option;
  const char* kind;  ///< empty: any
};

constexpr NamedBy kNamedBy[] = {
    {"--bogie", "bogies"},  {"--bogies", "bogies"},
    {"--beside", "bogies"}, {"--track", "tracks"},
    {"--phs", "phs"},       {"--wheel", "profiles"},
    {"--rail", "profiles"}, {"scenario", "scenarios"},
    {"manifest", "rigs"},   {"study", "studies"},
    {"name", ""},
};

bool BeginsWith(const std::string& word, const std::string& start) {
  return word.compare(0, start.size(), start) == 0;
}

std::string FirstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string NameOf(const CLI::Option& option) {
  return option.get_lnames().empty() ? option.get_name() : "--" + option.get_lnames().front();
}

/// The words of "TEXT:{text,json}", as --help shows them.
std::vector<std::string> Choices(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const size_t open = type.find('{');
  const size_t close = type.find('}', open);
  std::vector<std::string> words;
  if (open == std::string::npos || close == std::string::npos) return words;
  for (size_t at = open + 1; at < close;) {
    const size_t end = std::min(type.find(',', at), close);
    words.push_back(type.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

/// Values of an option, the last of a list "a,b,c" in place of `word`.
std::vector<Candidate> Values(const CLI::Option& option, const std::string& word) {
  const size_t comma = word.rfind(',');
  const std::string before =
      comma == std::string::npos || option.get_delimiter() == '\0' ? "" : word.substr(0, comma + 1);
  std::vector<Candidate> candidates;
  const auto add = [&](const std::string& value, const std::string& text) {
    if (BeginsWith(before + value, word)) candidates.push_back({before + value, text});
  };
  for (const std::string& choice : Choices(option)) add(choice, "");
  for (const NamedBy& named : kNamedBy) {
    if (NameOf(option) != named.option) continue;
    for (const ShippedKind& kind : ShippedKinds()) {
      if (*named.kind != '\0' && std::string(named.kind) != kind.name) continue;
      for (const ShippedItem& item : kind.items()) add(item.name, item.text);
    }
  }
  return candidates;
}

std::vector<Candidate> Verbs(const CLI::App& app, const std::string& word) {
  std::vector<Candidate> candidates;
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (BeginsWith(verb->get_name(), word)) {
      candidates.push_back({verb->get_name(), verb->get_description()});
    }
  }
  return candidates;
}

/// Its options and those of its option groups, which are subcommands without a name.
std::vector<const CLI::Option*> OptionsOf(const CLI::App& app) {
  std::vector<const CLI::Option*> options = app.get_options();
  for (const CLI::App* group :
       app.get_subcommands([](const CLI::App* sub) { return sub->get_name().empty(); })) {
    const auto own = OptionsOf(*group);
    options.insert(options.end(), own.begin(), own.end());
  }
  return options;
}

std::vector<Candidate> Options(const CLI::App& app, const std::string& word) {
  std::vector<Candidate> candidates;
  for (const CLI::Option* option : OptionsOf(app)) {
    for (const std::string& name : option->get_lnames()) {
      if (BeginsWith("--" + name, word)) {
        candidates.push_back({"--" + name, FirstLine(option->get_description())});
      }
    }
  }
  return candidates;
}

/// The option that `word` names and that takes a value; null if there is none.
const CLI::Option* WithValue(const CLI::App& verb, const std::string& word) {
  if (!BeginsWith(word, "-")) return nullptr;
  const CLI::Option* option = verb.get_option_no_throw(word);
  return option != nullptr && option->get_items_expected_max() > 0 ? option : nullptr;
}

const CLI::Option* Positional(const CLI::App& verb, int index) {
  for (const CLI::Option* option : OptionsOf(verb)) {
    if (option->get_positional() && index-- == 0) return option;
  }
  return nullptr;
}

}  // namespace

std::vector<Candidate> Complete(const CLI::App& app, const std::vector<std::string>& words) {
  const std::string last = words.empty() ? "" : words.back();
  if (words.size() < 2) return BeginsWith(last, "-") ? Options(app, last) : Verbs(app, last);
  const CLI::App* verb = FindVerb(app, words[0]);
  if (verb == nullptr) return {};
  if (BeginsWith(last, "-")) return Options(*verb, last);
  int positionals = 0;
  for (size_t i = 1; i + 1 < words.size(); ++i) {
    const CLI::Option* option = WithValue(*verb, words[i]);
    if (option != nullptr && i + 2 == words.size()) return Values(*option, last);
    if (option != nullptr) ++i;
    if (!BeginsWith(words[i], "-") && option == nullptr) ++positionals;
  }
  const CLI::Option* positional = Positional(*verb, positionals);
  return positional == nullptr ? std::vector<Candidate>() : Values(*positional, last);
}

void PrintCandidates(const std::vector<Candidate>& candidates) {
  for (const Candidate& candidate : candidates) {
    fmt::print("{}\t{}\n", candidate.word, candidate.text);
  }
}

const CLI::App* FindVerb(const CLI::App& app, const std::string& name) {
  const auto found =
      app.get_subcommands([&](const CLI::App* verb) { return verb->get_name() == name; });
  return found.empty() ? nullptr : found.front();
}

std::vector<std::string> OptionNames(const CLI::App& verb) {
  std::vector<std::string> names;
  for (const CLI::Option* option : OptionsOf(verb)) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

}  // namespace phs::cli
