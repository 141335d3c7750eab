// Programs run from outside, as a user does: their exit code and what they wrote.
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstddef>
#include <cstdio>
#include <string>

#include "phs_places.h"

namespace phs {

struct Output {
  int code = -1;     ///< exit code, 128 + signal where one ended the command, -1 if not started
  std::string text;  ///< standard output and error, in the order written
};

/// Runs shell commands to their end, with nothing on standard input.
inline Output Execute(const std::string& commands) {
  Output out;
  std::FILE* pipe = popen(("{ " + commands + "; } 2>&1 </dev/null").c_str(), "r");
  if (pipe == nullptr) return out;
  std::array<char, 4096> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
    out.text.append(buffer.data(), n);
  }
  const int status = pclose(pipe);
  out.code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return out;
}

/// The program of this build with its arguments, as a shell command.
inline std::string PhsCommand(const std::string& arguments) {
  return PHS_BINARY_DIR "/src/cli/phs " + arguments;
}
inline Output ExecutePhs(const std::string& arguments) { return Execute(PhsCommand(arguments)); }

}  // namespace phs
