// What `phs view` and `phs video` are asked for. The verbs of `phs` and the program phs-view, which
// they start, read the same options.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "view/recording.h"
#include "view/stage.h"

namespace CLI {
class App;
}  // namespace CLI

namespace phs::view {

struct Request {
  std::string source;  ///< scenario, or directory of a result
  std::string out;     ///< file to write; video only
  std::vector<std::string> bogies;
  std::string view = "bogie";
  int width = 1280;
  int height = 720;
  double fps = 25;
  double speed = 1;  ///< seconds of the run per second of the video
  double from = -1;  ///< [s]; < 0: not given
  double to = -1;    ///< [s]
  double yaw = 1;    ///< magnification
  double lateral = 1;
  bool no_forces = false;
  bool body = false;
  bool ghost = false;  ///< the second bogie in the first one's picture
  bool force = false;
  bool quiet = false;
};

void AddVideoOptions(CLI::App* verb, Request* request);
void AddViewOptions(CLI::App* verb, Request* request);

/// The recordings asked for: read, or run now.
Result<std::vector<Recording>> Fetch(const Request& request, const vehicle::Progress& progress);

Look LookOf(const Request& request);

}  // namespace phs::view
