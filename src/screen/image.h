// A picture in memory: 8 bits of red, green and blue per pixel, rows from the top.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace phs::screen {

struct Image {
  int width = 0, height = 0;
  std::vector<unsigned char> rgb;
};

/// From rows as OpenGL gives them, the lowest first.
Image FromBottom(const std::vector<unsigned char>& rows, int width, int height);

/// Written aside and renamed. Errors name the file.
Status WritePng(const Image& image, const std::string& path);

}  // namespace phs::screen
