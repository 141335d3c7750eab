// Threads shared by the loops of a search, one inside the other: a loop takes what is free before
// each of its items, so who has no more work of the outer loop lends a hand in the inner ones.
#pragma once

#include <atomic>
#include <functional>

namespace phs::identify::search {

class ThreadBudget {
 public:
  /// `threads` in all, with the one that calls.
  explicit ThreadBudget(int threads) : free_(threads - 1) {}
  /// Calls work(i) for i in 0 … n-1 on the calling thread and those that are or become free;
  /// returns when all is done. Results must not depend on the order. If one throws, no further one
  /// is begun, and what it threw is thrown here.
  void ForEach(int n, const std::function<void(int)>& work);

 private:
  int Take(int most);
  std::atomic<int> free_;
};

}  // namespace phs::identify::search
