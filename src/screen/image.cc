#include "screen/image.h"

#include <png.h>

#include <algorithm>
#include <cstring>

#include "base/disk.h"

namespace phs::screen {

Image FromBottom(const std::vector<unsigned char>& rows, int width, int height) {
  Image image{width, height, std::vector<unsigned char>(rows.size())};
  const size_t row = 3 * static_cast<size_t>(width);
  for (size_t y = 0; y < static_cast<size_t>(height); ++y) {
    std::copy_n(rows.data() + row * (static_cast<size_t>(height) - 1 - y), row,
                image.rgb.data() + row * y);
  }
  return image;
}

Status WritePng(const Image& image, const std::string& path) {
  png_image header;
  std::memset(&header, 0, sizeof header);
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = 0;
  png_image_write_to_memory(&header, nullptr, &size, 0, image.rgb.data(), 0, nullptr);
  std::string bytes(size, 0);
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) ==
      0) {
    return Error{path, std::string("libpng: ") + header.message, "", ""};
  }
  bytes.resize(size);
  return WriteFileAtomically(path, bytes);
}

}  // namespace phs::screen
