// The caller's own controls and forces inside steps that he has somebody else take.
//
// While a Guest lives, each evaluation of its mjData on its thread asks it first, before the plugin
// works out the forces: it may write d->ctrl and d->xfrc_applied, which the half step then knows
// like any other force. It is asked in every evaluation (several in a step with Runge-Kutta, more
// while somebody differentiates), so what it writes must follow from (m, d) alone.
#pragma once

#include <mujoco/mujoco.h>

#include <functional>
#include <vector>

namespace phs::plugin {

class Guest {
 public:
  /// Must not throw: MuJoCo stands between it and the caller.
  using Ask = std::function<void(const mjModel* m, mjData* d)>;

  Guest(const mjModel* m, const mjData* d, Ask ask);
  ~Guest();
  Guest(const Guest&) = delete;
  Guest& operator=(const Guest&) = delete;

  /// In Ask: actuator `id` takes its d->ctrl as it stands, also where it is a drive that would hold
  /// the speed. For this evaluation.
  void Take(int id) { taken_[static_cast<size_t>(id)] = true; }

  /// Asks the guest of `d` on this thread, if there is one.
  static void Call(const mjModel* m, mjData* d) {
    if (innermost_ != nullptr) innermost_->Serve(m, d);
  }
  /// True if the guest of `d` has taken actuator `id`.
  static bool Has(const mjData* d, int id) {
    return innermost_ != nullptr && innermost_->data_ == d &&
           innermost_->taken_[static_cast<size_t>(id)];
  }

 private:
  void Serve(const mjModel* m, mjData* d);

  static thread_local Guest* innermost_;
  const mjData* data_;
  Ask ask_;
  std::vector<bool> taken_;  ///< [actuator]
  Guest* outer_;
};

}  // namespace phs::plugin
