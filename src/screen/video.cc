#include "screen/video.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <utility>

#include "screen/columns.h"
#include "screen/film.h"
#include "screen/offscreen.h"

namespace phs::screen {
namespace {

bool IsStill(const view::Request& request) {
  return std::filesystem::path(request.out).extension() == ".png";
}

/// Before any long work: an ending that can be written, nothing replaced unasked.
Status CheckOut(const view::Request& request) {
  const std::filesystem::path out = request.out;
  if (!IsStill(request)) {
    if (Status s = Film::Check(request.out, request.width, request.height); !s.ok()) {
      Error error = s.error();
      if (out.extension() != ".mp4" && out.extension() != ".gif") error.allowed += ", .png";
      return error;
    }
  }
  if (std::filesystem::exists(out) && !request.force) {
    return Error{request.out, "is there already", "", "give another name, or --force"};
  }
  const std::filesystem::path parent = out.parent_path();
  if (!parent.empty() && !std::filesystem::is_directory(parent)) {
    return Error{request.out, "has no folder to go to", "", "make " + parent.string() + " first"};
  }
  return {};
}

/// The moment of a single picture: asked for, or where the run's curve is steady.
double StillTime(const view::Request& request, const view::Recording& recording) {
  if (request.from >= 0) return request.from;
  const int curvature = recording.Find("curvature_1_m");
  double sharpest = 0;
  double at = 0.5 * (recording.begin_s() + recording.end_s());
  if (curvature < 0) return at;
  // The last moment of the sharpest curve.
  const auto& values = recording.columns[static_cast<size_t>(curvature)];
  for (size_t i = 0; i < values.size(); ++i) {
    if (std::abs(values[i]) >= sharpest * (1 - 1e-9) && std::abs(values[i]) > 1e-6) {
      sharpest = std::max(sharpest, std::abs(values[i]));
      at = recording.columns[static_cast<size_t>(recording.time_column)][i];
    }
  }
  return std::max(recording.begin_s(), at - 1.0);
}

}  // namespace

Result<Filmed> MakeVideo(const view::Request& request, const vehicle::Progress& progress) {
  if (Status s = CheckOut(request); !s.ok()) return s.error();
  auto fetched = view::Fetch(request, progress);
  if (!fetched.ok()) return fetched.error();
  const std::vector<view::Recording>& recordings = fetched.value();
  auto offscreen = Offscreen::Create();
  if (!offscreen.ok()) return offscreen.error();
  auto created = Columns::Create(request, recordings);
  if (!created.ok()) return created.error();
  Columns columns = std::move(created).value();
  columns.UseContext();
  const auto begin = std::chrono::steady_clock::now();
  Filmed filmed;
  if (IsStill(request)) {
    const Image image = columns.Draw(StillTime(request, recordings[0]));
    if (Status s = WritePng(image, request.out); !s.ok()) return s.error();
    filmed.pictures = 1;
  } else {
    auto film = Film::Create(request.out, request.width, request.height, request.fps);
    if (!film.ok()) return film.error();
    double end = 0;
    for (const view::Recording& recording : recordings) end = std::max(end, recording.end_s());
    const double from = std::max(0.0, request.from);
    const double to = request.to >= 0 ? request.to : end;
    const int count = 1 + static_cast<int>((to - from) * request.fps / request.speed + 1e-9);
    for (int i = 0; i < count; ++i) {
      if (Status s = film.value().Add(columns.Draw(from + i * request.speed / request.fps));
          !s.ok()) {
        return s.error();
      }
      if (progress && !progress(static_cast<double>(i + 1) / count)) {
        return Error{request.out, "stopped; nothing written", "", ""};
      }
    }
    if (Status s = film.value().Finish(); !s.ok()) return s.error();
    filmed.pictures = count;
  }
  filmed.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return filmed;
}

}  // namespace phs::screen
