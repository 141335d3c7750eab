// A film written picture by picture through the program ffmpeg: .mp4 (H.264) or .gif.
#pragma once

#include <string>

#include "base/result.h"
#include "screen/image.h"

namespace phs::screen {

class Film {
 public:
  /// Whether such a film can be written: ending, size, the program ffmpeg.
  static Status Check(const std::string& path, int width, int height);
  /// Starts ffmpeg, which writes aside. Errors as those of Check.
  static Result<Film> Create(const std::string& path, int width, int height, double fps);
  Film(Film&& other) noexcept;
  Film& operator=(Film&&) = delete;
  ~Film();  ///< without Finish(): ends ffmpeg and leaves nothing behind
  Status Add(const Image& image);
  /// Waits for ffmpeg and puts the film into its place.
  Status Finish();

 private:
  Film() = default;
  Error Failed(const std::string& what) const;

  std::string path_, partial_;
  int pipe_ = -1;
  int process_ = -1;
};

}  // namespace phs::screen
