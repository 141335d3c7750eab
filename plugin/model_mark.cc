#include "plugin/model_mark.h"

#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>

#include "plugin/elements.h"

namespace phs::plugin {
namespace {

constexpr int kExponent = -900;

bool StartsWith(const char* text, const char* prefix) {
  return std::strncmp(text, prefix, std::strlen(prefix)) == 0;
}

uint64_t RandomBits() {
  std::random_device device;
  return (uint64_t{device()} << 32) ^ device();
}

}  // namespace

int MarkSlot(const mjModel* m) noexcept {
  for (int i = 0; i < m->ntuple; ++i) {
    const char* name = m->names + m->name_tupleadr[i];
    if (m->tuple_size[i] > 0 &&
        (StartsWith(name, "wheelset:") || StartsWith(name, "phs:") || DeclaresElement(name))) {
      return m->tuple_adr[i];
    }
  }
  return -1;
}

bool IsMark(double value) noexcept {
  return value >= std::ldexp(1.0, kExponent) && value <= std::ldexp(1.0, kExponent + 1);
}

double NewMark() {
  static const uint64_t process = RandomBits();
  static std::atomic<uint64_t> count{0};
  const uint64_t digits = (process + ++count) & ((uint64_t{1} << 52) - 1);
  return std::ldexp(1.0 + std::ldexp(static_cast<double>(digits), -52), kExponent);
}

}  // namespace phs::plugin
