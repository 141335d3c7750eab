// phs: Passive Hydraulic Steering on MuJoCo. Chooses the verb, maps outcomes to exit codes.
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <string>
#include <system_error>
#include <vector>

#include "base/origin.h"
#include "base/words.h"
#include "cli/completion.h"
#include "cli/verb_table.h"

namespace {

/// What is wrong with the first argument where it should name a verb; empty if nothing is.
std::string UnknownVerb(int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return "";
  std::vector<std::string> names;
  for (const phs::cli::Verb& verb : phs::cli::kVerbs) names.emplace_back(verb.name);
  const std::string asked = argv[1];
  if (std::find(names.begin(), names.end(), asked) != names.end()) return "";
  return phs::Error{"phs", "no verb " + phs::Quoted(asked), phs::JoinWords(names),
                    phs::DidYouMean(asked, names, "see phs --help")}
      .Line();
}

/// What is wrong with the first option that the verb does not have; empty if nothing is.
std::string UnknownOption(const CLI::App& app, int argc, char** argv) {
  const CLI::App* verb = argc < 2 ? nullptr : phs::cli::FindVerb(app, argv[1]);
  if (verb == nullptr) return "";
  const std::vector<std::string> names = phs::cli::OptionNames(*verb);
  for (int i = 2; i < argc && std::string(argv[i]) != "--"; ++i) {
    const std::string word = std::string(argv[i]).substr(0, std::string(argv[i]).find('='));
    if (!word.starts_with("--") || std::find(names.begin(), names.end(), word) != names.end()) {
      continue;
    }
    return phs::Error{"phs " + verb->get_name(), "no option " + phs::Quoted(word),
                      phs::JoinWords(names),
                      phs::DidYouMean(word, names, "see phs " + verb->get_name() + " --help")}
        .Line();
  }
  return "";
}

int Main(int argc, char** argv) {
  CLI::App app{"Passive Hydraulic Steering of locomotive bogies on MuJoCo", "phs"};
  app.set_version_flag("--version", std::string("phs " PHS_VERSION));
  app.require_subcommand(1);
  app.failure_message([](const CLI::App*, const CLI::Error& e) {
    return std::string("phs: ") + e.what() + "; see phs --help\n";
  });
  phs::cli::Action action;
  for (const phs::cli::Verb& verb : phs::cli::kVerbs) {
    verb.add(app.add_subcommand(verb.name, verb.text), &action);
  }
  if (argc > 1 && std::string(argv[1]) == "--complete") {
    phs::cli::PrintCandidates(phs::cli::Complete(app, {argv + 2, argv + argc}));
    return phs::cli::kDone;
  }
  std::string unknown = UnknownVerb(argc, argv);
  if (unknown.empty()) unknown = UnknownOption(app, argc, argv);
  if (!unknown.empty()) {
    std::fprintf(stderr, "%s\n", unknown.c_str());
    return phs::cli::kUsage;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    const int code = app.exit(e);
    return code == 0 ? phs::cli::kDone : phs::cli::kUsage;
  }
  std::vector<std::string> words = {"phs"};
  words.insert(words.end(), argv + 1, argv + argc);
  const phs::OriginNotes notes("phs " PHS_VERSION, phs::ShellLine(words));
  return action();
}

/// What was printed has been taken: a full disk may be behind stdout, too.
int Flushed(int code) {
  errno = 0;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  return phs::cli::BadInput(phs::WriteFault("stdout", errno != 0 ? errno : EIO));
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return Flushed(Main(argc, argv));
  } catch (const std::system_error& e) {
    const phs::Error fault = phs::WriteFault("stdout", e.code().value());
    if (phs::IsDiskFault(fault)) return phs::cli::BadInput(fault);
    std::fprintf(stderr,
                 "phs: the system refuses: %s; free memory, threads or files, then repeat\n",
                 e.what());
    return phs::cli::kFailed;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "phs: internal fault: %s; please report it with the command used\n",
                 e.what());
    return phs::cli::kInternal;
  }
}
