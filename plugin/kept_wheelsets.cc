#include "plugin/kept_wheelsets.h"

#include <algorithm>

#include "plugin/binding_work.h"

namespace phs::plugin {

thread_local KeptWheelsets* KeptWheelsets::innermost_ = nullptr;

struct KeptWheelsets::Kept {
  bool filled = false;
  mjtNum place[12];  ///< position and axes of the body
  Pressed wheelset;
};

KeptWheelsets::KeptWheelsets(const Binding& binding, const mjData* d)
    : binding_(&binding),
      data_(d),
      kept_(new Kept[binding.wheelsets().size()]),
      outer_(innermost_) {
  innermost_ = this;
}

KeptWheelsets::~KeptWheelsets() { innermost_ = outer_; }

KeptWheelsets::Pressed* KeptWheelsets::Take(const mjData* d, int index) {
  Kept& kept = kept_[static_cast<size_t>(index)];
  const int body = binding_->wheelsets()[static_cast<size_t>(index)].body;
  std::copy_n(d->xpos + 3 * body, 3, kept.place);
  std::copy_n(d->xmat + 9 * body, 9, kept.place + 3);
  kept.filled = true;
  return &kept.wheelset;
}

const KeptWheelsets::Pressed* KeptWheelsets::Find(const mjData* d, int index) const {
  const Kept& kept = kept_[static_cast<size_t>(index)];
  const int body = binding_->wheelsets()[static_cast<size_t>(index)].body;
  const bool same = kept.filled && std::equal(kept.place, kept.place + 3, d->xpos + 3 * body) &&
                    std::equal(kept.place + 3, kept.place + 12, d->xmat + 9 * body);
  return same ? &kept.wheelset : nullptr;
}

}  // namespace phs::plugin
