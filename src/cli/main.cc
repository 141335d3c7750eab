// phs: Passive Hydraulic Steering on MuJoCo. Chooses the verb, maps outcomes to exit codes.
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <string>
#include <system_error>
#include <vector>

#include "base/words.h"
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
  if (const std::string unknown = UnknownVerb(argc, argv); !unknown.empty()) {
    std::fprintf(stderr, "%s\n", unknown.c_str());
    return phs::cli::kUsage;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    const int code = app.exit(e);
    return code == 0 ? phs::cli::kDone : phs::cli::kUsage;
  }
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
