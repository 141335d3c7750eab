#include "base/progress.h"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <utility>

namespace phs {
namespace {

using Nanoseconds = std::int64_t;
// timeout(1) sends its signal to the program and then to its group: the program gets it twice, a
// moment apart. Only a second signal later than this is a second wish.
constexpr Nanoseconds kOneWish = 500'000'000;

std::atomic<int> stop_signal{0};
std::atomic<Nanoseconds> first_at{0};

void OnStop(int signal) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  const Nanoseconds at = Nanoseconds{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
  Nanoseconds before = 0;
  if (first_at.compare_exchange_strong(before, at)) {
    stop_signal = signal;
  } else if (at - before > kOneWish) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

void ListenForStop() {
  if (StopSignal() != 0) return;
  std::signal(SIGINT, &OnStop);
  std::signal(SIGTERM, &OnStop);
}

int StopSignal() { return stop_signal; }

struct ProgressLine::Impl {
  std::string what;
  bool quiet = false;
  bool terminal = false;
  int last_tenth = -1;
  bool shown = false;
  std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last{};
};

ProgressLine::ProgressLine(std::string what, bool quiet) : impl_(new Impl) {
  impl_->what = std::move(what);
  impl_->quiet = quiet;
  impl_->terminal = isatty(STDERR_FILENO) != 0;
  ListenForStop();
}

ProgressLine::~ProgressLine() {
  if (impl_->shown && impl_->terminal) std::fprintf(stderr, "\r\033[K");
  delete impl_;
}

bool ProgressLine::operator()(double share) {
  if (StopSignal() != 0) return false;
  if (impl_->quiet) return true;
  const auto now = std::chrono::steady_clock::now();
  const double elapsed = std::chrono::duration<double>(now - impl_->begin).count();
  if (share <= 0) return true;  // no time left to tell yet
  const double left = elapsed * (1 - share) / share;
  if (impl_->terminal) {
    if (now - impl_->last < std::chrono::milliseconds(100)) return true;
    impl_->last = now;
    std::fprintf(stderr, "\r\033[K%s: %3.0f %%, %.0f s left", impl_->what.c_str(), 100 * share,
                 left);
    impl_->shown = true;
  } else if (const int tenth = static_cast<int>(share * 10);
             tenth > impl_->last_tenth && elapsed > 5) {
    impl_->last_tenth = tenth;
    std::fprintf(stderr, "%s: %3.0f %%, %.0f s left\n", impl_->what.c_str(), 100 * share, left);
  }
  return true;
}

}  // namespace phs
