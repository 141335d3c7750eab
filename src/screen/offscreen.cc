#include "screen/offscreen.h"

#include <GL/osmesa.h>

#include <utility>
#include <vector>

namespace phs::screen {

struct Offscreen::Impl {
  OSMesaContext context = nullptr;
  std::vector<unsigned char> buffer;
};

Offscreen::Offscreen(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Offscreen::~Offscreen() { OSMesaDestroyContext(impl_->context); }

Result<std::unique_ptr<Offscreen>> Offscreen::Create() {
  // Pictures are drawn into the engine's own offscreen buffer; this one is never seen.
  constexpr int kSide = 64;
  auto impl = std::make_unique<Impl>();
  impl->buffer.resize(4 * kSide * kSide);
  impl->context = OSMesaCreateContextExt(GL_RGBA, 24, 8, 8, nullptr);
  if (impl->context == nullptr ||
      OSMesaMakeCurrent(impl->context, impl->buffer.data(), GL_UNSIGNED_BYTE, kSide, kSide) == 0) {
    return Error{"phs-view", "OSMesa gives no context to draw in", "Mesa's software renderer",
                 "install libosmesa6"};
  }
  return std::unique_ptr<Offscreen>(new Offscreen(std::move(impl)));
}

}  // namespace phs::screen
