// phs study: a design study repeated from its file. Each part is a command of this program and runs
// as a process of its own, so that it is the command that a user would type.
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/disk.h"
#include "base/progress.h"
#include "base/words.h"
#include "cli/completion.h"
#include "cli/result_checks.h"
#include "cli/shipped.h"
#include "cli/verb_table.h"
#include "jobs/study_job.h"
#include "report/readable_name.h"
#include "report/report_page.h"

namespace phs::cli {
namespace {

using Json = nlohmann::ordered_json;

struct StudyOptions {
  CommonOptions common;
  ResultChecks checks;
  std::string name;
  bool resume = false;
  int jobs = 0;
};

/// Options of a part that the study gives itself.
constexpr const char* kOwnOptions[] = {"--out", "--format", "--force", "--quiet"};

/// Whether a part's words make a command, before anything runs.
Status CheckWords(const CLI::App& app, const jobs::DesignStudy& study,
                  const jobs::StudyPart& part) {
  const std::string where = study.path + ": part " + part.name;
  const CLI::App* verb = FindVerb(app, part.words[0]);
  std::vector<std::string> fit;
  for (const Verb& row : kVerbs) {
    const auto options = OptionNames(*FindVerb(app, row.name));
    const bool makes = std::find(options.begin(), options.end(), "--out") != options.end();
    if (makes && std::string(row.name) != "study") fit.emplace_back(row.name);
  }
  if (verb == nullptr || std::find(fit.begin(), fit.end(), part.words[0]) == fit.end()) {
    return Error{where, Quoted(part.words[0]) + " is no verb with a result", JoinWords(fit),
                 DidYouMean(part.words[0], fit)};
  }
  const auto options = OptionNames(*verb);
  for (size_t i = 1; i < part.words.size(); ++i) {
    const std::string word = part.words[i].substr(0, part.words[i].find('='));
    if (!word.starts_with("--")) continue;
    if (std::find(std::begin(kOwnOptions), std::end(kOwnOptions), word) != std::end(kOwnOptions)) {
      return Error{where, word + " is given by the study itself", "other options", "remove it"};
    }
    if (std::find(options.begin(), options.end(), word) == options.end()) {
      return Error{where, "phs " + part.words[0] + " has no option " + Quoted(word),
                   JoinWords(options), DidYouMean(word, options)};
    }
  }
  return {};
}

/// Waits for a child; a stop asked of this program alone goes on to it.
int WaitFor(pid_t child) {
  bool told = false;
  for (;;) {
    int state = 0;
    const pid_t ended = waitpid(child, &state, WNOHANG);
    if (ended == child) {
      return WIFEXITED(state) ? WEXITSTATUS(state) : kSignalled + WTERMSIG(state);
    }
    if (ended < 0 && errno != EINTR) return kInternal;
    if (StopSignal() != 0 && !told) {
      kill(child, SIGTERM);
      told = true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

/// Runs this program with `words`; what it prints goes into the file `printed`.
Result<int> RunSelf(const std::vector<std::string>& words, const std::string& printed, bool quiet) {
  std::error_code fault;
  std::string program = std::filesystem::read_symlink("/proc/self/exe", fault).string();
  if (fault) return Error{"/proc/self/exe", fault.message(), "this program's own file", ""};
  std::vector<std::string> all = {program};
  all.insert(all.end(), words.begin(), words.end());
  if (quiet) all.emplace_back("--quiet");
  std::vector<char*> arguments;
  arguments.reserve(all.size() + 1);
  for (std::string& word : all) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, printed.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0644);
  pid_t child = 0;
  const int code = posix_spawn(&child, program.c_str(), &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (code != 0) return WriteFault(printed, code);
  return WaitFor(child);
}

void PrintSpread(const Json& spread) {
  const report::ReadableName name = report::Readable(spread.at("of")[0]);
  fmt::print("    {}\n", spread.at("title").get<std::string>());
  for (const Json& group : spread.at("groups")) {
    const auto number = [&](const char* key, double factor) {
      const Json& value = group.at(key);
      return value.is_number() ? report::FormatNumber(factor * value.get<double>()) : "–";
    };
    fmt::print("      {:<44} {:>8} … {} {}, factor {}{}\n", group.at("name").get<std::string>(),
               number("least", name.factor), number("largest", name.factor), name.unit,
               number("factor", 1),
               group.at("lacking").get<int>() == 0
                   ? ""
                   : fmt::format(", {} of {} runs without", group.at("lacking").get<int>(),
                                 group.at("runs").get<int>()));
  }
  if (!spread.at("within_factor").is_number()) return;
  fmt::print("      {} of {} keep within a factor of {:g} in all runs\n",
             spread.at("kept").get<int>(), spread.at("groups").size(),
             spread.at("within_factor").get<double>());
}

void PrintStudy(const Json& study, const std::string& out) {
  fmt::print("{}: {}\n", study.at("study").get<std::string>(),
             study.at("question").get<std::string>());
  for (const Json& part : study.at("parts")) {
    fmt::print("  {}: {}; {}\n", part.at("name").get<std::string>(),
               part.at("result").get<std::string>(), part.at("command").get<std::string>());
    for (const Json& spread : part.at("spreads")) PrintSpread(spread);
  }
  fmt::print("Report: {}/report.html\n", out);
}

std::vector<analysis::NamedSummary> NumbersOf(const Json& study) {
  std::vector<analysis::NamedSummary> numbers;
  for (const Json& part : study.at("parts")) {
    Json own = part;
    if (own["status"] != "ok") own["reason"] = "exit code " + own["exit_code"].dump();
    for (Json& spread : own["spreads"]) spread["name"] = spread["title"];
    numbers.emplace_back(part.at("name"), std::move(own));
  }
  return numbers;
}

int RunStudy(const CLI::App& app, StudyOptions options) {
  if (Status s = options.checks.Read(); !s.ok()) return BadInput(s.error());
  auto study = jobs::LoadDesignStudy(options.name);
  if (!study.ok()) return BadInput(study.error());
  for (const jobs::StudyPart& part : study.value().parts) {
    if (Status s = CheckWords(app, study.value(), part); !s.ok()) return BadInput(s.error());
  }
  if (study.value().question.empty()) study.value().question = FirstSentence(study.value().path);
  const std::string out = options.common.out.empty() ? study.value().name : options.common.out;
  ListenForStop();
  const auto takes_workers = [&](const std::string& verb) {
    const auto names = OptionNames(*FindVerb(app, verb));
    return std::find(names.begin(), names.end(), "--workers") != names.end();
  };
  const auto made = jobs::MakeStudy(
      {.study = std::move(study).value(),
       .out = out,
       .resume = options.resume,
       .overwrite = options.common.force,
       .workers = options.jobs,
       .run = [&](const auto& words,
                  const auto& printed) { return RunSelf(words, printed, options.common.quiet); },
       .takes_workers = takes_workers});
  if (!made.ok()) return BadInput(made.error());
  if (!made.value().all) {
    return Stopped("in part " + made.value().stopped_in + "; --resume continues");
  }
  const Json& json = made.value().json;
  if (options.common.format == "json") {
    fmt::print("{}\n", json.dump(2));
  } else {
    PrintStudy(json, out);
  }
  return options.checks.Conclude("study", NumbersOf(json),
                                 json.at("status") == "ok" ? kDone : kFailed);
}

}  // namespace

void AddStudy(CLI::App* verb, Action* action) {
  auto options = std::make_shared<StudyOptions>();
  AddCommonOptions(verb, &options->common);
  options->checks.AddOptions(verb);
  verb->add_option("study", options->name, "A shipped study or sweep, or a file (YAML)")
      ->required();
  verb->add_option("--jobs", options->jobs, "Runs at a time in each part (one per core without it)")
      ->check(CLI::Range(1, 4096));
  verb->add_flag("--resume", options->resume, "Continue what was stopped or killed");
  verb->footer(
      "Exit code 1 when a part or a limit failed, 130 when it was stopped. What each part prints\n"
      "stands in DIR/PART.txt, its result in DIR/PART.");
  const CLI::App* app = verb->get_parent();
  verb->callback([=] { *action = [=] { return RunStudy(*app, *options); }; });
}

}  // namespace phs::cli
