// phs: Passive Hydraulic Steering on MuJoCo. Chooses the verb, maps outcomes to exit codes.
#include <cerrno>
#include <cstdio>
#include <exception>
#include <system_error>

#include "cli/verbs.h"

namespace {

int Main(int argc, char** argv) {
  CLI::App app{"Passive Hydraulic Steering of locomotive bogies on MuJoCo", "phs"};
  app.set_version_flag("--version", std::string("phs " PHS_VERSION));
  app.require_subcommand(1);
  app.failure_message([](const CLI::App*, const CLI::Error& e) {
    return std::string("phs: ") + e.what() + "; see phs --help\n";
  });
  phs::cli::Action action;
  phs::cli::AddSimulate(&app, &action);
  phs::cli::AddCompare(&app, &action);
  phs::cli::AddContact(&app, &action);
  phs::cli::AddModes(&app, &action);
  phs::cli::AddIdentify(&app, &action);
  phs::cli::AddImport(&app, &action);
  phs::cli::AddLoads(&app, &action);
  phs::cli::AddStability(&app, &action);
  phs::cli::AddRig(&app, &action);
  phs::cli::AddCurving(&app, &action);
  phs::cli::AddReport(&app, &action);
  phs::cli::AddSweep(&app, &action);
  phs::cli::AddValidate(&app, &action);
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
