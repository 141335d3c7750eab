// Promises inside our own code: a broken one is a bug and throws std::logic_error.
#pragma once

#include <stdexcept>
#include <string>

#define PHS_CHECK(condition)                                                                  \
  do {                                                                                        \
    if (!(condition)) {                                                                       \
      throw std::logic_error(std::string("broken promise: " #condition " at " __FILE__ ":") + \
                             std::to_string(__LINE__));                                       \
    }                                                                                         \
  } while (false)
