#include "screen/film.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <utility>
#include <vector>

namespace phs::screen {
namespace {

/// How ffmpeg writes a kind of file.
struct Format {
  const char* ending;
  const char* name;  ///< of ffmpeg's muxer
  bool even;         ///< numbers of pixels
  std::vector<std::string> options;
};

const std::vector<Format>& Formats() {
  static const std::vector<Format> kFormats = {
      {".mp4",
       "mp4",
       true,
       {"-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "20", "-preset", "medium", "-movflags",
        "+faststart"}},
      // One palette for the whole film; ordered dither keeps still parts still.
      {".gif",
       "gif",
       false,
       {"-filter_complex",
        "split[a][b];[a]palettegen=max_colors=96:stats_mode=diff[p];"
        "[b][p]paletteuse=dither=bayer:bayer_scale=4:diff_mode=rectangle",
        "-loop", "0"}},
  };
  return kFormats;
}

const Format* FormatOf(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  for (const Format& format : Formats()) {
    if (ending == format.ending) return &format;
  }
  return nullptr;
}

bool HasFfmpeg() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (access((folder + "/ffmpeg").c_str(), X_OK) == 0) return true;
  }
  return false;
}

constexpr int kNoProgram = 127;

/// In the child: becomes ffmpeg, reading pictures from `in`.
[[noreturn]] void BecomeFfmpeg(int in, const std::vector<std::string>& arguments) {
  dup2(in, STDIN_FILENO);
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  execvp("ffmpeg", argv.data());
  _exit(kNoProgram);
}

}  // namespace

Status Film::Check(const std::string& path, int width, int height) {
  const Format* format = FormatOf(path);
  if (format == nullptr) return Error{path, "is no kind of film", ".mp4, .gif", ""};
  if (format->even && (width % 2 != 0 || height % 2 != 0)) {
    return Error{path, fmt::format("{} x {} pixels", width, height),
                 std::string("even numbers of pixels for ") + format->ending,
                 "change --width or --height"};
  }
  if (!HasFfmpeg()) {
    return Error{path, "there is no program ffmpeg", "it writes films",
                 "apt-get install ffmpeg, or ask for a .png"};
  }
  return {};
}

Result<Film> Film::Create(const std::string& path, int width, int height, double fps) {
  if (Status s = Check(path, width, height); !s.ok()) return s.error();
  const Format* format = FormatOf(path);
  Film film;
  film.path_ = path;
  film.partial_ = fmt::format("{}.partial.{}", path, getpid());
  std::vector<std::string> arguments = {"ffmpeg",
                                        "-nostdin",
                                        "-loglevel",
                                        "error",
                                        "-y",
                                        "-f",
                                        "rawvideo",
                                        "-pix_fmt",
                                        "rgb24",
                                        "-s",
                                        fmt::format("{}x{}", width, height),
                                        "-r",
                                        fmt::format("{:g}", fps),
                                        "-i",
                                        "-"};
  arguments.insert(arguments.end(), format->options.begin(), format->options.end());
  for (const std::string& a : {std::string("-f"), std::string(format->name), film.partial_}) {
    arguments.push_back(a);
  }
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return film.Failed(std::strerror(errno));
  signal(SIGPIPE, SIG_IGN);
  film.process_ = fork();
  if (film.process_ < 0) {
    close(ends[0]);
    close(ends[1]);
    return film.Failed(std::strerror(errno));
  }
  if (film.process_ == 0) BecomeFfmpeg(ends[0], arguments);
  close(ends[0]);
  film.pipe_ = ends[1];
  return film;
}

Film::Film(Film&& other) noexcept
    : path_(std::move(other.path_)),
      partial_(std::move(other.partial_)),
      pipe_(std::exchange(other.pipe_, -1)),
      process_(std::exchange(other.process_, -1)) {}

Film::~Film() {
  if (process_ <= 0) return;
  kill(process_, SIGKILL);
  close(pipe_);
  waitpid(process_, nullptr, 0);
  std::error_code ignored;
  std::filesystem::remove(partial_, ignored);
}

Error Film::Failed(const std::string& what) const {
  return Error{path_, "ffmpeg: " + what, "", "see the lines above, if any"};
}

Status Film::Add(const Image& image) {
  size_t done = 0;
  while (done < image.rgb.size()) {
    const ssize_t n = write(pipe_, image.rgb.data() + done, image.rgb.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return Finish();  // ffmpeg has gone: its exit code says why
    done += static_cast<size_t>(n);
  }
  return {};
}

Status Film::Finish() {
  close(pipe_);
  int state = 0;
  waitpid(process_, &state, 0);
  process_ = -1;
  std::error_code error;
  if (!WIFEXITED(state) || WEXITSTATUS(state) != 0) {
    std::filesystem::remove(partial_, error);
    return Failed("ended with a fault");
  }
  std::filesystem::rename(partial_, path_, error);
  if (error) return Failed(error.message());
  return {};
}

}  // namespace phs::screen
