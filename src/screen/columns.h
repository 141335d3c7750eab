// Vehicles beside each other in one picture.
#pragma once

#include <memory>
#include <vector>

#include "screen/image.h"
#include "view/request.h"
#include "view/stage.h"

namespace phs::screen {

class Columns {
 public:
  /// One column per recording; with request.ghost one picture with the others transparent in it.
  /// `recordings` must outlive it.
  static Result<Columns> Create(const view::Request& request,
                                const std::vector<view::Recording>& recordings);
  /// Once a context is current.
  void UseContext();
  Image Draw(double time);

 private:
  const view::View* view_ = nullptr;
  view::Look look_;
  bool ghost_ = false;
  int width_ = 0, height_ = 0;
  std::vector<std::unique_ptr<view::Stage>> stages_;
};

}  // namespace phs::screen
