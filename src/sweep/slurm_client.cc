#include "sweep/slurm_client.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <sstream>

#include "base/numbers.h"
#include "base/words.h"

namespace phs::sweep {
namespace {

struct Printed {
  int code = -1;
  std::string text;
};

Printed Ask(const std::string& command) {
  std::fflush(nullptr);
  std::FILE* pipe = popen((command + " 2>&1 </dev/null").c_str(), "r");
  if (pipe == nullptr) return {};
  Printed answer;
  std::array<char, 4096> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
    answer.text.append(buffer.data(), n);
  }
  const int state = pclose(pipe);
  answer.code = WIFEXITED(state) ? WEXITSTATUS(state) : -1;
  while (!answer.text.empty() && answer.text.back() == '\n') answer.text.pop_back();
  return answer;
}

Error SaysNo(const std::string& command, const Printed& answer) {
  constexpr int kNotFound = 127;
  if (answer.code == kNotFound) {
    return {command, "was not found", "a machine from which Slurm jobs are submitted",
            "install slurm-client, or use --engine local"};
  }
  return {command, answer.text.empty() ? "failed without a word" : answer.text,
          "a Slurm controller that answers", "ask its administrator, or use --engine local"};
}

/// The number after `key =` in scontrol's table, or nothing.
int Setting(const std::string& table, const std::string& key) {
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string name, equals;
    int value = 0;
    if (words >> name >> equals >> value && name == key) return value;
  }
  return 0;
}

}  // namespace

std::string ShellWord(const std::string& text) {
  std::string word = "'";
  for (char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

Result<int> MostTasksPerArray() {
  const Printed answer = Ask("scontrol show config");
  if (answer.code != 0) return SaysNo("scontrol", answer);
  const int size = Setting(answer.text, "MaxArraySize");
  if (size < 2) {
    return Error{"Slurm", "allows no job arrays (MaxArraySize)", "at least 2",
                 "ask its administrator, or use --engine local"};
  }
  return size;
}

int SlurmProcessors(const std::string& partition) {
  const std::string of = partition.empty() ? "" : " --partition=" + ShellWord(partition);
  const Printed answer = Ask("sinfo --noheader --format=%C" + of);  // allocated/idle/other/total
  const auto total = ParseNumber(answer.text.substr(answer.text.rfind('/') + 1));
  return answer.code == 0 && total && *total >= 1 ? static_cast<int>(*total) : 1;
}

std::string SubmitCommand(const ArrayRequest& request) {
  std::string command =
      fmt::format("sbatch --parsable --array=0-{} --job-name={} --output={}", request.tasks - 1,
                  ShellWord(request.name), ShellWord(request.log_folder + "/%A_%a.log"));
  if (!request.partition.empty()) command += " --partition=" + ShellWord(request.partition);
  if (request.time_min > 0) command += fmt::format(" --time={}", request.time_min);
  for (const std::string& option : request.options) command += " " + ShellWord(option);
  return command + " " + ShellWord(request.script) + " " + ShellWord(request.argument);
}

Result<std::string> Submit(const ArrayRequest& request) {
  const Printed answer = Ask(SubmitCommand(request));
  if (answer.code != 0) return SaysNo("sbatch", answer);
  // Warnings may stand above; the answer is JOB or JOB;CLUSTER.
  const std::string last = answer.text.substr(answer.text.rfind('\n') + 1);
  const std::string job = last.substr(0, last.find(';'));
  if (job.empty() || job.find_first_not_of("0123456789") != std::string::npos) {
    return Error{"sbatch", "answered " + Quoted(last), "the number of a job", ""};
  }
  return job;
}

Result<std::map<SlurmTask, std::string>> TaskStates() {
  const Printed answer = Ask(fmt::format(
      "squeue --noheader --array --states=all --user={} --format='%F %K %T'", getuid()));
  if (answer.code != 0) return SaysNo("squeue", answer);
  std::map<SlurmTask, std::string> states;
  std::istringstream lines(answer.text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string job, index, state;
    if (!(words >> job >> index >> state)) continue;
    // Jobs that are no arrays have "N/A".
    if (const auto number = ParseNumber(index)) states[{job, static_cast<int>(*number)}] = state;
  }
  return states;
}

bool IsOver(const std::string& state) {
  for (const char* over : {"COMPLETED", "CANCELLED", "FAILED", "TIMEOUT", "NODE_FAIL", "PREEMPTED",
                           "BOOT_FAIL", "DEADLINE", "OUT_OF_MEMORY", "REVOKED"}) {
    if (state == over) return true;
  }
  return false;
}

}  // namespace phs::sweep
