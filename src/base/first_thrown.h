// Work on several threads of which one may throw: an exception that leaves a thread would end the
// program at once. The first one is kept, and thrown again by the thread that waits for the others.
#pragma once

#include <atomic>
#include <exception>

namespace phs {

class FirstThrown {
 public:
  /// Calls work(). False: it threw.
  template <typename Work>
  bool Run(const Work& work) noexcept {
    try {
      work();
      return true;
    } catch (...) {
      if (!taken_.exchange(true)) first_ = std::current_exception();
      return false;
    }
  }
  /// When all have ended.
  void Rethrow() const {
    if (first_) std::rethrow_exception(first_);
  }

 private:
  std::atomic<bool> taken_ = false;
  std::exception_ptr first_;
};

}  // namespace phs
