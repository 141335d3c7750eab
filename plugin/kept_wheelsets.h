// Wheelsets as the last step pressed them on the track, for who reads results between steps.
//
// While a KeptWheelsets lives, the plugin keeps what it finds in every evaluation of its mjData on its
// thread, and Binding::CalcWheelset searches no contact again where the wheelset still stands there,
// to the last bit: contact is a function of that place alone, so nobody can tell the difference.
#pragma once

#include <memory>

#include "plugin/binding.h"

namespace phs::plugin {

class KeptWheelsets {
 public:
  KeptWheelsets(const Binding& binding, const mjData* d);
  ~KeptWheelsets();
  KeptWheelsets(const KeptWheelsets&) = delete;
  KeptWheelsets& operator=(const KeptWheelsets&) = delete;

  using Pressed = Binding::PressedWheelset;
  /// Of `d` on this thread; null if nobody keeps them.
  static KeptWheelsets* Of(const Binding& binding, const mjData* d) {
    const bool here =
        innermost_ != nullptr && innermost_->data_ == d && innermost_->binding_ == &binding;
    return here ? innermost_ : nullptr;
  }
  /// Room for a wheelset whose body stands where (m, d) has it now.
  Pressed* Take(const mjData* d, int index);
  /// A wheelset, if it still stands there; else null.
  const Pressed* Find(const mjData* d, int index) const;

 private:
  struct Kept;
  static thread_local KeptWheelsets* innermost_;
  const Binding* binding_;
  const mjData* data_;
  std::unique_ptr<Kept[]> kept_;
  KeptWheelsets* outer_;
};

}  // namespace phs::plugin
