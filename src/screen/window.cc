#include "screen/window.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "screen/image.h"
#include "screen/player.h"
#include "screen/plots.h"
#include "view/captions.h"

namespace phs::screen {
namespace {

constexpr int kWidth = 1280, kHeight = 800;

/// GLFW's library and one window, closed at the end whatever happens.
class Glass {
 public:
  static Result<std::unique_ptr<Glass>> Open(const std::string& title, bool shown) {
    if (glfwInit() == 0) {
      return Error{"phs view", "there is no display to open a window on", "X11 ($DISPLAY)",
                   "phs video draws without one"};
    }
    glfwWindowHint(GLFW_SAMPLES, 4);
    glfwWindowHint(GLFW_VISIBLE, shown ? GLFW_TRUE : GLFW_FALSE);
    auto glass = std::unique_ptr<Glass>(new Glass);
    glass->window_ = glfwCreateWindow(kWidth, kHeight, title.c_str(), nullptr, nullptr);
    if (glass->window_ == nullptr) {
      const char* why = nullptr;
      glfwGetError(&why);
      return Error{"phs view", std::string("no window: ") + (why == nullptr ? "" : why),
                   "a display with OpenGL 1.5 or newer", "phs video draws without one"};
    }
    glfwMakeContextCurrent(glass->window_);
    glfwSwapInterval(1);
    return glass;
  }
  ~Glass() { glfwTerminate(); }
  GLFWwindow* window() const { return window_; }

 private:
  Glass() = default;
  GLFWwindow* window_ = nullptr;
};

/// What the callbacks of GLFW reach through the window.
struct Hands {
  Player* player;
  double x = 0, y = 0;
};

Hands* HandsOf(GLFWwindow* window) { return static_cast<Hands*>(glfwGetWindowUserPointer(window)); }

void Listen(GLFWwindow* window, Hands* hands) {
  glfwSetWindowUserPointer(window, hands);
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int mods) {
    if (action != GLFW_RELEASE) HandsOf(w)->player->Press(key, (mods & GLFW_MOD_SHIFT) != 0);
  });
  glfwSetScrollCallback(window,
                        [](GLFWwindow* w, double, double dy) { HandsOf(w)->player->Zoom(dy); });
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    Hands* h = HandsOf(w);
    int width = 1, height = 1;
    glfwGetWindowSize(w, &width, &height);
    const double dx = (x - h->x) / height;
    const double dy = (y - h->y) / height;
    h->x = x;
    h->y = y;
    if (glfwGetMouseButton(w, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) h->player->Drag(true, dx, dy);
    if (glfwGetMouseButton(w, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS) {
      h->player->Drag(false, dx, dy);
    }
  });
}

class Show {
 public:
  Show(Player* player, std::vector<std::unique_ptr<view::Stage>>* stages)
      : player_(player), stages_(stages) {
    for (auto& stage : *stages_) {
      stage->UseContext(kWidth, kHeight);
      mjr_setBuffer(mjFB_WINDOW, stage->mutable_context());
      plots_.emplace_back(*stage);
    }
  }

  void Draw(int width, int height, double frames_per_second) {
    const size_t at = static_cast<size_t>(player_->vehicle());
    view::Stage& stage = *(*stages_)[at];
    stage.SetMoment(player_->time(), player_->look());
    if (player_->ghost() && stages_->size() > 1) {
      stage.AddGhost((*stages_)[(at + 1) % stages_->size()].get(), player_->look());
    }
    const int beside = player_->plots() ? std::min(width / 3, 420) : 0;
    const mjrRect whole{0, 0, width - beside, height};
    stage.Render(player_->CameraOf(stage), whole);
    view::DrawCaptions(stage, player_->look(), whole);
    if (beside > 0) {
      mjr_rectangle({width - beside, 0, beside, height}, 0.95f, 0.96f, 0.97f, 1);
      plots_[at].Draw(player_->time(), {width - beside, 0, beside, height}, stage.context());
    }
    const std::string state =
        fmt::format("{}  x {:g}  {:.0f} pictures/s   H: keys",
                    player_->running() ? "runs" : "paused", player_->speed(), frames_per_second);
    mjr_overlay(
        mjFONT_NORMAL, mjGRID_BOTTOMRIGHT,
        {whole.left, whole.bottom + 3 * stage.context().charHeight, whole.width, whole.height},
        state.c_str(), nullptr, &stage.context());
    if (player_->help()) {
      mjr_overlay(
          mjFONT_NORMAL, mjGRID_BOTTOMLEFT,
          {whole.left, whole.bottom + 4 * stage.context().charHeight, whole.width, whole.height},
          KeyHelp().c_str(), nullptr, &stage.context());
    }
  }

  /// What the window holds.
  Image Grab(int width, int height) const {
    std::vector<unsigned char> up(static_cast<size_t>(3 * width * height));
    mjr_readPixels(up.data(), nullptr, {0, 0, width, height}, &(*stages_)[0]->context());
    return FromBottom(up, width, height);
  }

 private:
  Player* player_;
  std::vector<std::unique_ptr<view::Stage>>* stages_;
  std::vector<Plots> plots_;
};

/// Until the window is closed, or for a screenshot after the first pictures.
Status Run(const view::Request& request, GLFWwindow* window, Player* player, Show* show) {
  double before = glfwGetTime();
  double rate = 0;
  for (int picture = 0; glfwWindowShouldClose(window) == 0 && !player->done(); ++picture) {
    if (StopSignal() != 0) return {};
    int width = 0, height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    show->Draw(width, height, rate);
    if (!request.out.empty() && picture >= 2)
      return WritePng(show->Grab(width, height), request.out);
    glfwSwapBuffers(window);
    glfwPollEvents();
    const double now = glfwGetTime();
    const double step = std::max(1e-6, now - before);
    rate += (picture < 2 ? 1.0 : 0.1) * (1 / step - rate);
    before = now;
    player->Advance(std::min(step, 0.25));
  }
  return {};
}

}  // namespace

Status ShowWindow(const view::Request& request, const vehicle::Progress& progress) {
  // The display first: nobody waits for a run that cannot be shown.
  auto glass = Glass::Open("phs view " + request.source, true);
  if (!glass.ok()) return glass.error();
  auto fetched = view::Fetch(request, progress);
  if (!fetched.ok()) return fetched.error();
  const std::vector<view::Recording>& recordings = fetched.value();
  std::vector<std::unique_ptr<view::Stage>> stages;
  double end = 0;
  for (const view::Recording& recording : recordings) {
    auto stage = view::Stage::Create(recording);
    if (!stage.ok()) return stage.error();
    stages.push_back(std::move(stage).value());
    end = std::max(end, recording.end_s());
  }
  const double rows = static_cast<double>(recordings[0].columns[0].size());
  Player player(request, 0, end, recordings[0].end_s() / std::max(1.0, rows - 1),
                static_cast<int>(stages.size()));
  Show show(&player, &stages);
  Hands hands{&player};
  Listen(glass.value()->window(), &hands);
  return Run(request, glass.value()->window(), &player, &show);
}

}  // namespace phs::screen
