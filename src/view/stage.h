// One recorded vehicle on its track, drawn at any moment into the OpenGL context that is current.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <vector>

#include "view/camera.h"
#include "view/magnify.h"
#include "view/picture.h"
#include "view/pose.h"
#include "view/recording.h"
#include "view/view_model.h"

namespace phs::view {

/// What is shown.
struct Look {
  Magnification magnify;
  bool forces = true;
  bool body = false;      ///< the car body above
  bool contacts = false;  ///< outlines of wheel and rail, places of contact
  /// For a film of parts (src/film): no track, wheels that do not turn, coils left out (CoilsOf), and
  /// every shape keeps its number in the scene.
  bool parts_only = false;
};

class Stage {
 public:
  /// `recording` must outlive the stage. Needs no OpenGL yet.
  static Result<std::unique_ptr<Stage>> Create(const Recording& recording);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// Once an OpenGL context is current: pictures up to this size.
  void UseContext(int width, int height);
  /// Poses the vehicle and fills the scene; no OpenGL.
  void SetMoment(double time, const Look& look);
  /// A second vehicle in this scene, transparent, where it is when its leading wheelset has come as
  /// far; after SetMoment.
  void AddGhost(Stage* ghost, const Look& look);
  /// Draws the scene of the last SetMoment; then captions may be drawn with context().
  void Render(const mjvCamera& camera, const mjrRect& viewport);

  mjvCamera CameraOf(const View& view) const { return view::CameraOf(view, picture_, outer_); }
  const Recording& recording() const { return recording_; }
  const Picture& picture() const { return picture_; }
  const mjrContext& context() const { return context_; }
  mjrContext* mutable_context() { return &context_; }
  mjvScene* scene() { return &scene_; }
  const mjModel* model() const { return view_.model(); }
  /// High rail of the first curve; the left one on straight track.
  rail::Side outer() const { return outer_; }
  /// What the pressures' colours stand for; false without lines.
  bool has_pressures() const { return has_pressures_; }

 private:
  Stage(const Recording& recording, ViewModel view);
  void DrawAll(const Look& look, Pen* pen);

  const Recording& recording_;
  ViewModel view_;
  vehicle::DataPtr data_;
  Poser poser_;
  double posed_time_ = 0;
  std::vector<double> posed_;  ///< qpos as posed for that time, not moved
  Picture picture_;
  rail::Side outer_ = rail::Side::kLeft;
  bool has_pressures_ = false;
  mjvScene scene_;
  mjvOption option_;
  mjrContext context_;
  bool has_context_ = false;
  int track_begin_ = 0, track_end_ = 0;  ///< geoms of the scene that are the track
};

}  // namespace phs::view
