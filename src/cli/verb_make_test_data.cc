// phs make-test-data: records with something hidden in them, and the score of `phs identify` there.
// The programs that make and judge them stand apart: they share no line with the product
// (tests/rigdata), and know `phs` by its command line alone.
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/words.h"
#include "cli/verb_table.h"

namespace phs::cli {
namespace {

namespace fs = std::filesystem;

struct TestDataVerb {
  std::string suite, folder, only;
  int sets = 20, jobs = 1;
  bool score = false;
};

const std::vector<std::string>& Suites() {
  static const std::vector<std::string> names = {"tune", "score", "holdout"};
  return names;
}

bool IsSeed(const std::string& text) {
  return !text.empty() && text.size() <= 9 &&
         text.find_first_not_of("0123456789") == std::string::npos;
}

fs::path OwnProgram() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error);
}

/// Beside this program, or in its own folder of the build; empty if it is in neither.
std::string FindTool(const std::string& name) {
  const fs::path beside = OwnProgram().parent_path();
  std::error_code error;
  for (const fs::path& place : {beside / name, beside / "../../tests/rigdata" / name}) {
    if (fs::exists(place, error)) return place.lexically_normal().string();
  }
  return "";
}

Error NoTool(const std::string& name) {
  return {"phs make-test-data", "finds no program " + name + " beside phs", "",
          "it is built with the tests of the sources: scripts/build release " + name};
}

/// Runs a program to its end; its exit code, 128 + the signal that ended it, or -1: not started.
int RunTool(const std::vector<std::string>& words) {
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  pid_t child = 0;
  errno = posix_spawn(&child, argv[0], nullptr, nullptr, argv.data(), environ);
  if (errno != 0) return -1;
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

int RunMakeTestData(const TestDataVerb& verb) {
  const bool seed = IsSeed(verb.suite);
  const std::string generator = FindTool("generate_rig_data"), judge = FindTool("score_identify");
  if (generator.empty()) return BadInput(NoTool("generate_rig_data"));
  if (verb.score && judge.empty()) return BadInput(NoTool("score_identify"));
  const std::string jobs = std::to_string(verb.jobs);
  std::vector<std::string> words = {generator, "--out", verb.folder, "--jobs", jobs};
  if (seed) {
    words.insert(words.end(), {"--seed", verb.suite, "--sets", std::to_string(verb.sets)});
  } else {
    words.insert(words.end(), {"--suite", verb.suite});
  }
  if (!verb.only.empty()) words.insert(words.end(), {"--only", verb.only});
  int code = RunTool(words);
  if (code == 0 && verb.score) {
    words = {judge,
             verb.folder,
             "--phs",
             OwnProgram().string(),
             "--out",
             verb.folder + "/results",
             "--jobs",
             jobs,
             "--reuse",
             "--title",
             "Suite " + verb.suite};
    if (!verb.only.empty()) words.insert(words.end(), {"--only", verb.only});
    code = RunTool(words);
  }
  return code < 0 ? BadInput({words[0], std::strerror(errno), "a program that can be started", ""})
                  : code;
}

}  // namespace

void AddMakeTestData(CLI::App* verb, Action* action) {
  auto o = std::make_shared<TestDataVerb>();
  const auto suite = [](const std::string& text) {
    const auto& names = Suites();
    const bool known = IsSeed(text) || std::find(names.begin(), names.end(), text) != names.end();
    return known ? std::string()
                 : "is " + text + "; allowed: " + JoinWords(names) + ", or a seed 0 … 999999999";
  };
  verb->add_option("suite", o->suite,
                   "tune, score or holdout; or a seed, from which sets are drawn blindly")
      ->required()
      ->check(suite);
  verb->add_option("dir", o->folder, "Folder of the records; the truth is in its folder truth")
      ->required();
  verb->add_option("--sets", o->sets, "Sets that are drawn from a seed")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  verb->add_option("--only", o->only, "Sets of this kind alone")
      ->check(CLI::IsMember({"clean", "single", "pair", "off_list"}));
  verb->add_option("--jobs", o->jobs, "Sets at a time")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  verb->add_flag("--score", o->score,
                 "Identify each set, too, and hold what is said against the truth");
  verb->footer(
      "Sets and results that are there already are kept. Exit code 1 when the score misses a "
      "threshold (docs/identify_score.md).");
  verb->callback([=] { *action = [=] { return RunMakeTestData(*o); }; });
}

}  // namespace phs::cli
