#include "plugin/guest.h"

#include <utility>

namespace phs::plugin {

thread_local Guest* Guest::innermost_ = nullptr;

Guest::Guest(const mjModel* m, const mjData* d, Ask ask)
    : data_(d), ask_(std::move(ask)), taken_(static_cast<size_t>(m->nu)), outer_(innermost_) {
  innermost_ = this;
}

Guest::~Guest() { innermost_ = outer_; }

void Guest::Serve(const mjModel* m, mjData* d) {
  if (data_ != d) return;
  taken_.assign(taken_.size(), false);
  ask_(m, d);
}

}  // namespace phs::plugin
