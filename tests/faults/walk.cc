// The fault walk: phs with a disk that fails, or a machine that stops, at every n-th call.
//
//   fault_walk FAULT_AT_LIBRARY PHS STRIDE [SUITE …]
//
// Each suite is the smallest honest job of one kind. First it is done undisturbed: its result, and
// the number of calls that change files (fault_at.c). Then again and again with a fault at call n,
// for every n and mode, or for every STRIDE-th of these cases. After each fault the result is
// absent (or still the old one, where --force was to replace it), or complete and as it should be;
// the exit code is 0 only with the new result in place; and doing the job again, or --resume, gives
// the right result, or a refusal in one line after which --force does. Printed is how many faults
// were tried, how many results were lost and how many wrong; more than 0 is exit code 1.
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "base/result_dir.h"
#include "tests/faults/suites.h"

namespace phs::faults {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const std::vector<std::string> kModes = {"enospc", "eio", "kill_before", "kill_after"};

/// The numbers of a result that tell of the machine and not of the run.
void DropSpeeds(Json* json) {
  if (json->is_object()) {
    for (const char* name : {"real_time_factor", "processor_s"}) json->erase(name);
  }
  for (Json& part : *json) {
    if (part.is_structured()) DropSpeeds(&part);
  }
}

/// What is compared of a file: a page for being whole, as it shows those numbers too.
std::string Essence(const fs::path& path) {
  const std::string text = ReadFile(path.string()).value();
  if (path.extension() == ".html") return text.ends_with("</html>\n\n") ? "a whole page" : text;
  if (path.extension() != ".json") return text;
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return "broken: " + text;
  DropSpeeds(&json);
  if (path.filename() == "origin.json") json.erase("command");  // --resume makes it as well
  return json.dump();
}

using Snapshot = std::map<std::string, std::string>;  ///< by path in the folder; empty: no folder
Snapshot Look(const fs::path& folder) {
  Snapshot seen;
  if (!fs::exists(folder)) return seen;
  seen["."] = "";
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_directory()) continue;
    seen[entry.path().lexically_relative(folder).string()] = Essence(entry.path());
  }
  return seen;
}

struct Fault {
  long at = 0;  ///< 0: none
  std::string mode;
};

struct Ended {
  int code = -1;  ///< exit code, or 128 + signal
  long calls = 0;
  std::string last_line;
};

class Walk {
 public:
  Walk(std::string library, std::string phs, int stride)
      : library_(std::move(library)), phs_(std::move(phs)), stride_(stride) {
    std::string pattern = (fs::temp_directory_path() / "phs_faults_XXXXXX").string();
    root_ = mkdtemp(pattern.data());
    place_ = root_ / "place";
    counter_ = (root_ / "counter").string();
    fs::create_directories(root_ / "cache");
  }
  ~Walk() {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
  }
  Walk(const Walk&) = delete;
  Walk& operator=(const Walk&) = delete;

  /// False where something was lost or wrong.
  bool Go(const Suite& suite) {
    suite_ = &suite;
    tried_ = lost_ = wrong_ = refused_ = 0;
    old_.clear();
    if (!suite.old_arguments.empty()) {
      Lay();
      Do(suite.old_arguments, {});
      old_ = Look(place_ / "out");
      fs::remove_all(root_ / "old");
      fs::copy(place_ / "out", root_ / "old", fs::copy_options::recursive);
    }
    Lay();
    const Ended whole = Do(suite.arguments, {});
    right_ = Look(place_ / "out");
    if (whole.code != 0 || right_.empty() || right_ == old_) {
      std::printf("%s: does not work undisturbed: %d %s\n", suite.name.c_str(), whole.code,
                  whole.last_line.c_str());
      return false;
    }
    for (long n = 1, number = 0; n <= whole.calls; ++n) {
      for (const std::string& mode : kModes) {
        if (number++ % stride_ == 0) Try({n, mode});
      }
    }
    std::printf("%-16s %6ld calls %6d tried %6d lost %6d wrong %6d refused\n", suite.name.c_str(),
                whole.calls, tried_, lost_, wrong_, refused_);
    std::fflush(stdout);
    return tried_ > 0 && lost_ == 0 && wrong_ == 0;
  }

 private:
  /// The files of the suite in an empty place, with the old result where there is one.
  void Lay() {
    fs::remove_all(place_);
    fs::create_directories(place_ / "tmp");
    for (const auto& [name, text] : suite_->files) std::ofstream(place_ / name) << text;
    if (!old_.empty()) fs::copy(root_ / "old", place_ / "out", fs::copy_options::recursive);
  }

  Ended Do(const std::vector<std::string>& arguments, const Fault& fault) {
    std::ofstream(counter_, std::ios::binary).write("\0\0\0\0\0\0\0\0", 8);
    const std::string log = (root_ / "log").string();
    const pid_t child = fork();
    if (child == 0) Become(arguments, fault, log);
    setpgid(child, child);
    int state = 0;
    waitpid(child, &state, 0);
    // Workers die with their parent, but not in the same moment.
    while (kill(-child, 0) == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    Ended ended;
    ended.code = WIFSIGNALED(state) ? 128 + WTERMSIG(state) : WEXITSTATUS(state);
    std::ifstream(counter_, std::ios::binary).read(reinterpret_cast<char*>(&ended.calls), 8);
    std::ifstream lines(log);
    for (std::string line; std::getline(lines, line);) {
      if (!line.empty()) ended.last_line = line;
    }
    return ended;
  }

  [[noreturn]] void Become(const std::vector<std::string>& arguments, const Fault& fault,
                           const std::string& log) const {
    setpgid(0, 0);
    const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    if (chdir(place_.c_str()) != 0) _exit(120);
    setenv("TMPDIR", (place_ / "tmp").c_str(), 1);
    setenv("XDG_CACHE_HOME", (root_ / "cache").c_str(), 1);
    setenv("SOURCE_DATE_EPOCH", "0", 1);  // results of two days are then alike to the byte
    setenv("LD_PRELOAD", library_.c_str(), 1);
    setenv("FAULT_UNDER", place_.c_str(), 1);
    setenv("FAULT_COUNTER", counter_.c_str(), 1);
    setenv("FAULT_AT", std::to_string(fault.at).c_str(), 1);
    setenv("FAULT_MODE", fault.mode.c_str(), 1);
    std::vector<char*> words = {const_cast<char*>(phs_.c_str())};
    for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    execv(phs_.c_str(), words.data());
    _exit(121);
  }

  void Try(const Fault& fault) {
    ++tried_;
    Lay();
    const Ended ended = Do(suite_->arguments, fault);
    const Snapshot seen = Look(place_ / "out");
    const bool killed = fault.mode.starts_with("kill");
    if (seen != right_ && seen != old_)
      return Tell(seen.empty() ? &lost_ : &wrong_, fault, ended, "is neither absent nor right");
    if (ended.code == 0 && seen != right_)
      return Tell(&wrong_, fault, ended, "was announced and is not there");
    if (killed ? ended.code != 137 && ended.code != 0 : ended.code != 0 && ended.code != 1) {
      return Tell(&wrong_, fault, ended, "ends with another code than the fault asks for");
    }
    if (seen == right_ && !suite_->resumes) return;
    GoOn(fault, ended);
  }

  /// Once the disk is mended: the job again.
  void GoOn(const Fault& fault, const Ended& ended) {
    Ended again = Do(suite_->again, {});
    if (again.code == 3 && suite_->resumes) again = Do(suite_->arguments, {});
    if (again.code == 3) {
      ++refused_;
      std::vector<std::string> forced = suite_->arguments;
      forced.emplace_back("--force");
      again = Do(forced, {});
    }
    if (again.code != 0 || Look(place_ / "out") != right_) {
      return Tell(&wrong_, fault, again, "is not right when done again");
    }
    for (const auto& entry : fs::directory_iterator(place_)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with("out.")) return Tell(&wrong_, fault, ended, "leaves " + name);
    }
  }

  void Tell(int* count, const Fault& fault, const Ended& ended, const std::string& what) const {
    ++*count;
    std::printf("%s, call %ld, %s: the result %s; exit code %d: %s\n", suite_->name.c_str(),
                fault.at, fault.mode.c_str(), what.c_str(), ended.code, ended.last_line.c_str());
  }

  std::string library_, phs_;
  int stride_;
  fs::path root_, place_;
  std::string counter_;
  const Suite* suite_ = nullptr;
  Snapshot old_, right_;
  int tried_ = 0, lost_ = 0, wrong_ = 0, refused_ = 0;
};

}  // namespace
}  // namespace phs::faults

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "fault_walk FAULT_AT_LIBRARY PHS STRIDE [SUITE …]\n");
    return 2;
  }
  phs::faults::Walk walk(argv[1], argv[2], std::atoi(argv[3]));
  bool good = true;
  for (const phs::faults::Suite& suite : phs::faults::AllSuites()) {
    bool asked = argc == 4;
    for (int i = 4; i < argc; ++i) asked |= suite.name == argv[i];
    if (asked) good &= walk.Go(suite);
  }
  return good ? 0 : 1;
}
