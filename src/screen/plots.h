// Plots beside the picture: the same channels over time, with a line at the moment shown.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <vector>

#include "view/stage.h"

namespace phs::screen {

class Plots {
 public:
  explicit Plots(const view::Stage& stage);
  /// One above the other in `viewport`.
  void Draw(double time, const mjrRect& viewport, const mjrContext& context);

 private:
  struct Curve {
    std::string channel, name;
  };
  void Add(const view::Recording& recording, const char* title, double scale,
           const std::vector<Curve>& curves);
  std::vector<std::unique_ptr<mjvFigure>> figures_;
};

}  // namespace phs::screen
