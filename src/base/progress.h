// Long work at a terminal: how far it is, and whether the user wants it stopped.
#pragma once

#include <string>

namespace phs {

/// From now on Ctrl-C and SIGTERM ask for a stop; a second one, half a second later or more, ends
/// the program at once. A ProgressLine listens, too.
void ListenForStop();
/// The signal with which the user has asked for a stop, 0 for none.
int StopSignal();
/// A line of progress on stderr: rewritten in place on a terminal, one per tenth elsewhere.
class ProgressLine {
 public:
  ProgressLine(std::string what, bool quiet);
  ~ProgressLine();
  /// `share` from 0 to 1; false once the user has pressed Ctrl-C.
  bool operator()(double share);

 private:
  struct Impl;
  Impl* impl_;
};

}  // namespace phs
