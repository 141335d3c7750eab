#include "screen/columns.h"

#include <algorithm>
#include <utility>

#include "view/captions.h"

namespace phs::screen {
namespace {

/// Narrow pictures show less to the sides: the camera goes back until the vehicle fits.
constexpr double kUsualShape = 1.4;

}  // namespace

Result<Columns> Columns::Create(const view::Request& request,
                                const std::vector<view::Recording>& recordings) {
  Columns columns;
  columns.view_ = view::FindView(request.view);
  columns.look_ = view::LookOf(request);
  columns.ghost_ = request.ghost;
  columns.width_ = request.width;
  columns.height_ = request.height;
  for (const view::Recording& recording : recordings) {
    auto stage = view::Stage::Create(recording);
    if (!stage.ok()) return stage.error();
    columns.stages_.push_back(std::move(stage).value());
  }
  return columns;
}

void Columns::UseContext() {
  for (auto& stage : stages_) {
    stage->UseContext(width_, height_);
    mjr_setBuffer(mjFB_OFFSCREEN, stage->mutable_context());
  }
}

Image Columns::Draw(double time) {
  Image image{width_, height_,
              std::vector<unsigned char>(static_cast<size_t>(3 * width_ * height_))};
  const int count = ghost_ ? 1 : static_cast<int>(stages_.size());
  std::vector<unsigned char> part;
  for (int i = 0; i < count; ++i) {
    view::Stage& stage = *stages_[static_cast<size_t>(i)];
    const int left = width_ * i / count;
    const int width = width_ * (i + 1) / count - left;
    const mjrRect viewport{0, 0, width, height_};
    stage.SetMoment(time, look_);
    for (size_t g = 1; ghost_ && g < stages_.size(); ++g) stage.AddGhost(stages_[g].get(), look_);
    mjr_setBuffer(mjFB_OFFSCREEN, stage.mutable_context());
    mjvCamera camera = stage.CameraOf(*view_);
    // Along the picture's height where the way runs upwards.
    const double shape = view_->azimuth_deg == 0 ? 1 : kUsualShape;
    camera.distance *= std::max(1.0, shape * height_ / width);
    stage.Render(camera, viewport);
    view::DrawCaptions(stage, look_, viewport);
    part.resize(3 * static_cast<size_t>(width) * static_cast<size_t>(height_));
    mjr_readPixels(part.data(), nullptr, viewport, &stage.context());
    for (int y = 0; y < height_; ++y) {
      const auto* from = part.data() + static_cast<size_t>(3 * width * (height_ - 1 - y));
      std::copy_n(from, 3 * width, image.rgb.data() + static_cast<size_t>(3 * (width_ * y + left)));
    }
  }
  return image;
}

}  // namespace phs::screen
