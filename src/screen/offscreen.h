// A place to draw without a display: Mesa's software renderer (OSMesa).
#pragma once

#include <memory>

#include "base/result.h"

namespace phs::screen {

class Offscreen {
 public:
  /// Makes its context current as long as it lives.
  static Result<std::unique_ptr<Offscreen>> Create();
  ~Offscreen();
  Offscreen(const Offscreen&) = delete;
  Offscreen& operator=(const Offscreen&) = delete;

 private:
  struct Impl;
  explicit Offscreen(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace phs::screen
