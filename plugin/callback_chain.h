// One of the engine's global callbacks, shared with whoever else uses it.
//
// A callback of MuJoCo 2.2.2 is one global pointer. Whoever wants it saves what is there, puts his
// own function in and calls the saved one. So do we, with one function of ours (a layer) for each
// foreign function that we ever stood in front of:
//
//   engine -> layer 1 -> theirs -> layer 0 -> what was there before      (theirs chains)
//   engine -> layer 1 -> theirs                                          (theirs does not)
//   engine -> theirs -> layer 0 -> what was there before                 (theirs came last)
//
// A layer knows for good whom it calls, so that a host which puts back the pointer it saved gets
// the chain as it was then. Within one engine call (same thread, same mjData)
//   - the first layer that is reached serves the model, further ones only pass on;
//   - no foreign function is called again that is in front or was called by a layer before, even if
//     it saved a layer that calls it: a circle ends there and goes on below.
//
// Install and Uninstall are for one thread at a time (the registry's mutex); calls take no lock.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <utility>

namespace phs::plugin {

/// Hook: `Function` (a pointer to R(const mjModel*, data*, ...)), `Function* Slot()` (the engine's
/// pointer), `R Serve(previous, arguments...)`, which calls `previous()` at most once.
template <typename Hook, typename Function = typename Hook::Function>
class CallbackChain;

template <typename Hook, typename R, typename Model, typename Data, typename... More>
class CallbackChain<Hook, R (*)(Model, Data, More...)> {
 public:
  using Function = R (*)(Model, Data, More...);
  /// As many different foreign functions can stand behind ours in one process.
  static constexpr int kLayers = 32;

  /// Puts a layer of ours in front. False if there is no layer left.
  static bool Install() {
    const Function front = Front();
    if (IsOurs(front)) return true;
    int layer = 0;
    while (layer < num_layers_ && previous_[Index(layer)].load() != front) ++layer;
    if (layer >= kLayers) return false;
    if (layer == num_layers_) {
      previous_[Index(layer)].store(front);
      below_[Index(layer)].store(layer - 1);
      num_layers_ = layer + 1;
    }
    Change(Calls()[Index(layer)], nullptr);
    return true;
  }

  /// Gives the callback back, if nobody has chained after us.
  static void Uninstall() {
    const Function front = Front();
    for (int i = 0; i < num_layers_; ++i) {
      const Function previous = previous_[Index(i)].load();
      if (Calls()[Index(i)] == front) Change(previous, previous);
    }
  }

  /// True if a layer of ours is in front.
  static bool InFront() { return IsOurs(Front()); }
  /// True if the engine is known to reach us: we are in front, or who is in front has called us.
  static bool Reached() {
    const Function front = Front();
    return IsOurs(front) || (front != nullptr && reached_from_.load() == front);
  }

 private:
  /// One engine call that is under way on this thread.
  struct Frame {
    const void* data = nullptr;
    uint32_t called = 0;  ///< layers whose previous function has been called
    int calling = -1;     ///< the layer whose previous function runs now
    Frame* outer = nullptr;
  };
  /// While a foreign function runs, the layers that it calls find the frame, whatever it throws.
  class Calling {
   public:
    Calling(Frame* frame, int layer) : frame_(frame), before_(frame->calling), outer_(innermost_) {
      if (before_ < 0) {
        frame->outer = innermost_;
        innermost_ = frame;
      }
      frame->calling = layer;
    }
    ~Calling() {
      frame_->calling = before_;
      innermost_ = outer_;
    }
    Calling(const Calling&) = delete;
    Calling& operator=(const Calling&) = delete;

   private:
    Frame* frame_;
    int before_;
    Frame* outer_;
  };

  static constexpr size_t Index(int layer) { return static_cast<size_t>(layer); }
  static Function Front() { return std::atomic_ref<Function>(*Hook::Slot()).load(); }
  static void Change(Function front, Function given_back) {
    ++changes_;
    std::atomic_ref<Function>(*Hook::Slot()).store(front);
    given_back_.store(given_back);
    ++changes_;
  }
  /// The foreign function in front, which the engine has called before it came to us; null if we
  /// put it there ourselves while this call was under way.
  static Function CalledBefore() {
    for (;;) {
      const uint64_t changes = changes_.load();
      const Function front = Front();
      const Function given_back = given_back_.load();
      if (changes % 2 == 0 && changes == changes_.load()) {
        return front == given_back ? nullptr : front;
      }
    }
  }
  static bool IsOurs(Function f) {
    for (const Function ours : Calls()) {
      if (ours == f) return true;
    }
    return false;
  }

  template <int layer>
  static R Call(Model m, Data d, More... more) {
    for (Frame* frame = innermost_; frame != nullptr; frame = frame->outer) {
      if (frame->data != d) continue;
      const int caller = frame->calling;
      // This is what the function that replaced `layer` had saved.
      if constexpr (layer + 1 < kLayers) {
        if (caller > layer) below_[Index(caller)].store(layer);
      }
      return PassOn(frame, layer, m, d, more...);
    }
    const Function front = Front();
    if (front != Calls()[Index(layer)] && !IsOurs(front)) reached_from_.store(front);
    Frame frame;
    frame.data = d;
    return Hook::Serve([&] { return PassOn(&frame, layer, m, d, more...); }, m, d, more...);
  }

  /// Calls what `layer` replaced, or, if that has been called, what stood below it.
  static R PassOn(Frame* frame, int layer, Model m, Data d, More... more) {
    for (int at = layer; at >= 0; at = below_[Index(at)].load()) {
      const uint32_t bit = uint32_t{1} << at;
      if ((frame->called & bit) != 0) continue;
      frame->called |= bit;
      const Function previous = previous_[Index(at)].load();
      if (previous == nullptr) break;
      if (previous == CalledBefore()) continue;
      const Calling calling(frame, at);
      return previous(m, d, more...);
    }
    return R();
  }

  template <size_t... layer>
  static constexpr std::array<Function, kLayers> MakeCalls(std::index_sequence<layer...>) {
    return {&Call<static_cast<int>(layer)>...};
  }
  static const std::array<Function, kLayers>& Calls() {
    static constexpr std::array<Function, kLayers> calls =
        MakeCalls(std::make_index_sequence<kLayers>());
    return calls;
  }

  static inline std::array<std::atomic<Function>, kLayers> previous_{};
  static inline std::array<std::atomic<int>, kLayers> below_{};
  static inline int num_layers_ = 0;
  static inline std::atomic<uint64_t> changes_{0};  ///< odd while the front is being changed
  static inline std::atomic<Function> given_back_{nullptr};
  static inline std::atomic<Function> reached_from_{nullptr};
  static inline thread_local Frame* innermost_ = nullptr;
};

}  // namespace phs::plugin
