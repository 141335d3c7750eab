// score_identify: runs `phs identify` on every set of a suite and tells how much of the truth it
// found. The program is a black box: only its command line and its result.json are used.
//   score_identify SUITE_DIR --phs PATH --out DIR [--only KIND] [--limit N] [--jobs N]
//                  [--markdown FILE] [--title TEXT] [--reuse]
// Exit: 0 every threshold met, 1 one missed, 2 wrong usage, 3 the suite cannot be read.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "score.h"

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr const char* kUsage =
    "score_identify SUITE_DIR --phs PATH --out DIR [--only clean|single|pair|off_list]\n"
    "               [--limit N] [--jobs N] [--markdown FILE] [--title TEXT] [--reuse]\n"
    "Runs PATH identify on each set of the suite; --reuse keeps results that are in DIR already.\n";

struct Options {
  std::string suite, phs, out, only, markdown, title = "Score";
  size_t limit = 1000000, jobs = 1;
  bool reuse = false;
};

struct Usage {
  std::string problem;
};

Options Parse(int argc, char** argv) {
  Options o;
  const std::map<std::string, std::string*> texts = {{"--phs", &o.phs},
                                                     {"--out", &o.out},
                                                     {"--only", &o.only},
                                                     {"--markdown", &o.markdown},
                                                     {"--title", &o.title}};
  for (int i = 1; i < argc; ++i) {
    const std::string key = argv[i];
    if (key == "--reuse") {
      o.reuse = true;
    } else if (key.rfind("--", 0) != 0 && o.suite.empty()) {
      o.suite = key;
    } else if (i + 1 >= argc) {
      throw Usage{key + " is unknown or needs a value"};
    } else if (texts.count(key) > 0) {
      *texts.at(key) = argv[++i];
    } else if (key == "--limit" || key == "--jobs") {
      const std::string number = argv[++i];
      if (number.empty() || number.size() > 6 ||
          number.find_first_not_of("0123456789") != std::string::npos || std::stoul(number) == 0) {
        throw Usage{key + " must be a whole number of at least 1, not '" + number + "'"};
      }
      (key == "--limit" ? o.limit : o.jobs) = std::stoul(number);
    } else {
      throw Usage{"unknown option " + key};
    }
  }
  if (o.suite.empty() || o.phs.empty() || o.out.empty()) {
    throw Usage{"SUITE_DIR, --phs and --out are needed"};
  }
  return o;
}

Json ReadJson(const fs::path& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  return Json::parse(in);
}

struct RunOutcome {
  int exit_code = -1;
  double seconds = 0, megabytes = 0;
};

RunOutcome RunIdentify(const std::string& phs, const std::string& manifest,
                       const std::string& result, const std::string& log) {
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<std::string> words = {phs,    "identify", manifest, "--out",
                                          result, "--force",  "--quiet"};
  std::vector<char*> arguments;
  for (const std::string& w : words) arguments.push_back(const_cast<char*>(w.c_str()));
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (file >= 0) {
      dup2(file, STDOUT_FILENO);
      dup2(file, STDERR_FILENO);
    }
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  RunOutcome outcome;
  int status = 0;
  rusage usage{};
  if (child > 0 && wait4(child, &status, 0, &usage) == child && WIFEXITED(status)) {
    outcome.exit_code = WEXITSTATUS(status);
  }
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  outcome.megabytes = static_cast<double>(usage.ru_maxrss) / 1024.0;
  return outcome;
}

std::string LastLine(const fs::path& path) {
  std::ifstream in(path);
  std::string last;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty()) last = line;
  }
  return last.substr(0, 120);
}

rigdata::SetScore ScoreOne(const Options& o, const Json& entry) {
  const std::string set = entry.at("set");
  const std::string kind = entry.at("kind");
  const fs::path out = fs::path(o.out) / set;
  const Json truth = ReadJson(fs::path(o.suite) / "truth" / entry.at("truth").get<std::string>());
  const fs::path result = out / "result.json", timing = fs::path(o.out) / (set + ".run.json");
  RunOutcome outcome;
  if (o.reuse && fs::exists(result) && fs::exists(timing)) {
    const Json kept = ReadJson(timing);
    outcome = {0, kept.at("seconds"), kept.at("megabytes")};
  } else {
    fs::remove_all(out);
    outcome = RunIdentify(o.phs, (fs::path(o.suite) / set / "MANIFEST.yaml").string(), out.string(),
                          (fs::path(o.out) / (set + ".log")).string());
    std::ofstream(timing) << Json{{"exit", outcome.exit_code},
                                  {"seconds", outcome.seconds},
                                  {"megabytes", outcome.megabytes}};
  }
  Json answer;
  std::string problem;
  if (outcome.exit_code != 0) {
    problem = "exit " + std::to_string(outcome.exit_code) + ": " +
              LastLine(fs::path(o.out) / (set + ".log"));
  } else {
    try {
      answer = ReadJson(result);
    } catch (const std::exception& e) {
      problem = e.what();
    }
  }
  rigdata::SetScore score = rigdata::JudgeSet(set, kind, truth, answer);
  if (!problem.empty()) score.problem = problem;
  score.seconds = outcome.seconds;
  score.megabytes = outcome.megabytes;
  return score;
}

std::vector<Json> ChooseSets(const Options& o) {
  std::vector<Json> chosen;
  for (const Json& entry : ReadJson(fs::path(o.suite) / "truth" / "index.json")) {
    const bool wanted = o.only.empty() || entry.at("kind") == o.only;
    // A suite may have been written in part only.
    const bool there = fs::exists(fs::path(o.suite) / "truth" / entry.at("truth"));
    if (wanted && there && chosen.size() < o.limit) chosen.push_back(entry);
  }
  if (chosen.empty()) throw std::runtime_error("no sets to score in " + o.suite);
  return chosen;
}

int Run(const Options& o) {
  const std::vector<Json> entries = ChooseSets(o);
  fs::create_directories(o.out);
  std::vector<rigdata::SetScore> sets(entries.size());
  std::atomic<size_t> next = 0;
  std::mutex printing;
  const auto work = [&] {
    for (size_t i = next++; i < entries.size(); i = next++) {
      try {
        sets[i] = ScoreOne(o, entries[i]);
      } catch (const std::exception& e) {
        sets[i].set = entries[i].at("set");
        sets[i].kind = entries[i].at("kind");
        sets[i].problem = e.what();
      }
      const std::lock_guard<std::mutex> lock(printing);
      std::fprintf(stderr, "%zu of %zu: %s %s %.0f s\n", i + 1, entries.size(), sets[i].set.c_str(),
                   sets[i].answered ? "" : sets[i].problem.c_str(), sets[i].seconds);
    }
  };
  std::vector<std::thread> pool;
  for (size_t j = 1; j < o.jobs; ++j) pool.emplace_back(work);
  work();
  for (std::thread& t : pool) t.join();

  const rigdata::SuiteScore score = rigdata::JudgeSuite(std::move(sets));
  const std::string text = rigdata::ScoreMarkdown(score, o.title);
  std::printf("%s", text.c_str());
  if (!o.markdown.empty()) {
    std::ofstream file(o.markdown);
    file << text;
    if (!file.flush()) throw std::runtime_error("cannot write " + o.markdown);
  }
  return score.Passed() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return Run(Parse(argc, argv));
  } catch (const Usage& usage) {
    std::fprintf(stderr, "score_identify: %s\n%s", usage.problem.c_str(), kUsage);
    return 2;
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "score_identify: %s\n", failure.what());
    return 3;
  }
}
