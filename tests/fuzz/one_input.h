// One input of a fuzzed reader. Whatever the bytes are, a reader returns a value or an Error whose
// line says something; it never crashes, hangs or throws.
//
// Each *_fuzz.cc defines libFuzzer's entry for one format. It is built twice: with -DPHS_FUZZ=ON
// (clang) as a libFuzzer program, and always with mutate_seeds.cc, which is a test: the shipped
// files of the format, changed in fixed ways.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/result.h"

namespace phs::fuzz {

inline std::string Text(const uint8_t* data, size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// The input as a file of this process; the same path each time.
inline std::string InputFile(const std::string& text, const std::string& extension) {
  static const std::string stem = [] {
    std::string pattern = (std::filesystem::temp_directory_path() / "phs_fuzz_XXXXXX").string();
    std::string made = mkdtemp(pattern.data());
    static const struct Remover {
      std::string path;
      ~Remover() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
      }
    } remover{made};
    return made + "/input";
  }();
  std::ofstream file(stem + extension, std::ios::binary | std::ios::trunc);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  return stem + extension;
}

/// Aborts if an error says nothing or takes more than its one line.
inline void ExpectOneLine(const Error& error) {
  const std::string line = error.Line();
  if (error.what.empty() || line.find('\n') != std::string::npos || line.size() > 4000) {
    std::fprintf(stderr, "an error must be one line that says what: '%s'\n", line.c_str());
    std::abort();
  }
}

template <typename T>
void ExpectValueOrLine(const Result<T>& result) {
  if (!result.ok()) ExpectOneLine(result.error());
}

}  // namespace phs::fuzz
