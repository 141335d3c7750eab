// phs-view: what `phs view` and `phs video` start. Apart from `phs`, so that nobody needs OpenGL who
// only calculates. Same verbs, same options (view/request.h).
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>

#include "base/disk.h"
#include "base/progress.h"
#include "screen/video.h"
#include "screen/window.h"
#include "view/request.h"

namespace {

// As those of `phs` (docs/program.md).
enum ExitCode { kDone = 0, kFailed = 1, kUsage = 2, kBadInput = 3, kInternal = 5 };

int Report(const phs::Error& error) {
  std::fprintf(stderr, "phs: %s\n", error.Line().c_str());
  if (phs::StopSignal() != 0) return 128 + phs::StopSignal();
  return phs::IsDiskFault(error) ? kFailed : kBadInput;
}

int Video(const phs::view::Request& request) {
  phs::ProgressLine progress(request.source, request.quiet);
  auto filmed = phs::screen::MakeVideo(request, [&](double share) { return progress(share); });
  if (!filmed.ok()) return Report(filmed.error());
  if (!request.quiet && filmed.value().pictures > 1) {
    std::printf("%s: %d pictures, %.1f per second\n", request.out.c_str(), filmed.value().pictures,
                filmed.value().pictures / filmed.value().seconds);
  }
  return kDone;
}

int View(const phs::view::Request& request) {
  phs::ProgressLine progress(request.source, request.quiet);
  const phs::Status shown =
      phs::screen::ShowWindow(request, [&](double share) { return progress(share); });
  return shown.ok() ? kDone : Report(shown.error());
}

int Main(int argc, char** argv) {
  CLI::App app{"Runs of phs in three dimensions", "phs"};
  app.require_subcommand(1);
  app.failure_message([](const CLI::App*, const CLI::Error& e) {
    return std::string("phs: ") + e.what() + "; see phs view --help, phs video --help\n";
  });
  phs::view::Request request;
  CLI::App* video = app.add_subcommand("video", "A run as a film or picture, without a display");
  CLI::App* view = app.add_subcommand("view", "A run in a window");
  phs::view::AddVideoOptions(video, &request);
  phs::view::AddViewOptions(view, &request);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? kDone : kUsage;
  }
  return video->parsed() ? Video(request) : View(request);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return Main(argc, argv);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "phs: internal fault: %s; please report it with the command used\n",
                 e.what());
    return kInternal;
  }
}
