// A folder with one study, and `phs sweep` run on it from outside.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "base/result_dir.h"
#include "tests/base/execute.h"
#include "tests/base/scratch_dir.h"

namespace phs {

class SweepFolder : public testing::Test {
 protected:
  /// The command that sweeps study.yaml into `out`.
  std::string Command(const std::string& out, const std::string& more) const {
    return PhsCommand("sweep " + dir_.File("study.yaml") + " --quiet --out " + dir_.File(out) +
                      " " + more);
  }
  Output Sweep(const std::string& out, const std::string& more = "") const {
    return Execute(environment_ + Command(out, more));
  }
  /// Sweeps until at least `records` runs are on disk, then kills the sweep: code 137.
  Output SweepAndKill(const std::string& out, const std::string& more, int records) const {
    return Execute(Command(out, more) + " & P=$!; " + UntilRecords(out, records) +
                   "kill -KILL $P; wait $P");
  }
  /// Shell commands that wait for so many records of an unfinished sweep, half a minute at most.
  std::string UntilRecords(const std::string& out, int records) const {
    return "for i in $(seq 1500); do [ \"$(ls " + dir_.File(out + ".unfinished/runs") +
           " 2>/dev/null | wc -l)\" -ge " + std::to_string(records) +
           " ] && break; sleep 0.02; done; ";
  }
  std::string Text(const std::string& file) const {
    const auto text = ReadFile(dir_.File(file));
    EXPECT_TRUE(text.ok()) << file;
    return text.ok() ? text.value() : "";
  }
  std::string Table(const std::string& out) const { return Text(out + "/sweep.csv"); }
  ScratchDir dir_;
  std::string environment_;  ///< set in front of every command
};

}  // namespace phs
