// Any YAML text: the document reader behind every YAML file.
#include "base/yaml.h"
#include "one_input.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  phs::fuzz::ExpectValueOrLine(phs::YamlMap::Parse(phs::fuzz::Text(data, size), "input"));
  return 0;
}
