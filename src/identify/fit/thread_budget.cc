#include "identify/fit/thread_budget.h"

#include <algorithm>
#include <system_error>
#include <thread>
#include <vector>

#include "base/first_thrown.h"

namespace phs::identify::search {

int ThreadBudget::Take(int most) {
  int free = free_;
  const auto taken = [&] { return std::clamp(most, 0, std::max(free, 0)); };
  while (!free_.compare_exchange_weak(free, free - taken())) {
  }
  return taken();
}

void ThreadBudget::ForEach(int n, const std::function<void(int)>& work) {
  std::atomic<int> next{0};
  std::vector<std::thread> helpers;
  FirstThrown thrown;
  const auto do_one = [&](int i) {
    if (!thrown.Run([&] { work(i); })) next = n;  // nothing more is begun
  };
  const auto call_helpers = [&] {
    int taken = Take(n - 1 - next);  // one item is the caller's own
    try {
      for (; taken > 0; --taken) {
        helpers.emplace_back([&] {
          for (int i = next++; i < n; i = next++) do_one(i);
          ++free_;
        });
      }
    } catch (const std::system_error&) {  // the system gives no more threads: those there do it all
      free_ += taken;
    }
  };
  for (;;) {  // whoever has become free since the last item is called, too
    call_helpers();
    const int i = next++;
    if (i >= n) break;
    do_one(i);
  }
  ++free_;  // while it waits, the calling thread's place is the others'
  for (std::thread& t : helpers) t.join();
  --free_;
  thrown.Rethrow();
}

}  // namespace phs::identify::search
