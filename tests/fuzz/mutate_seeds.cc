// Seeds of a format, changed in fixed ways, given to the format's reader:
//   NAME_mutations COUNT FILE…
// The unchanged seeds first; then COUNT changed ones, each with one to four changes. The changes
// are drawn from a fixed seed, so that a failure repeats; the input at work is written to
// NAME_mutations.last before each step when PHS_FUZZ_KEEP is set.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace {

using Random = std::mt19937_64;

/// [0, n); n > 0. Not std::uniform_int_distribution: its draws differ between libraries.
size_t Below(Random& random, size_t n) { return static_cast<size_t>(random() % n); }

size_t LineBegin(const std::string& text, size_t at) {
  const size_t end = text.rfind('\n', at == 0 ? 0 : at - 1);
  return end == std::string::npos || at == 0 ? 0 : end + 1;
}

std::string LineAt(const std::string& text, size_t at) {
  const size_t begin = LineBegin(text, at);
  const size_t end = text.find('\n', at);
  return text.substr(begin, end == std::string::npos ? std::string::npos : end + 1 - begin);
}

/// Words that readers may trip over.
const char* const kWords[] = {
    "nan",  "-inf", "1e308", "-1",  "0",  "1e-320", "99999999999999999999",
    "",     ":",    "[",     "]",   "{",  "}",      ",",
    "\"",   "'",    "#",     "&a",  "*a", "---",    "null",
    "true", "\t",   "\r\n",  "\\0", "€",  "../..",  "-"};

std::string ChangeNumber(std::string text, Random& random) {
  std::vector<size_t> digits;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] >= '0' && text[i] <= '9') digits.push_back(i);
  }
  if (digits.empty()) return text;
  const size_t begin = digits[Below(random, digits.size())];
  size_t end = begin;
  while (end < text.size() && ((text[end] >= '0' && text[end] <= '9') || text[end] == '.')) ++end;
  return text.replace(begin, end - begin, kWords[Below(random, 7)]);
}

std::string Change(std::string text, const std::string& other, Random& random) {
  const size_t at = Below(random, text.size() + 1);
  switch (Below(random, 8)) {
    case 0:  // another byte
      if (!text.empty()) text[Below(random, text.size())] = static_cast<char>(random() & 0xff);
      return text;
    case 1:  // a word put in
      return text.insert(at, kWords[Below(random, std::size(kWords))]);
    case 2:  // cut short
      return text.substr(0, at);
    case 3:  // a piece taken out
      return text.erase(at, Below(random, 40));
    case 4:  // a line twice
      return text.insert(LineBegin(text, at), LineAt(text, at));
    case 5:  // a line taken out
      return text.erase(LineBegin(text, at), LineAt(text, at).size());
    case 6:  // a piece of another seed
      return text.insert(at, other.substr(Below(random, other.size() + 1), 60));
    default:
      return ChangeNumber(std::move(text), random);
  }
}

void Try(const std::string& input) {
  if (std::getenv("PHS_FUZZ_KEEP") != nullptr) {
    std::ofstream(std::getenv("PHS_FUZZ_KEEP"), std::ios::binary | std::ios::trunc) << input;
  }
  LLVMFuzzerTestOneInput(reinterpret_cast<const uint8_t*>(input.data()), input.size());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: %s COUNT SEED_FILE…\n", argv[0]);
    return 2;
  }
  std::vector<std::string> seeds;
  for (int i = 2; i < argc; ++i) {
    std::ifstream file(argv[i], std::ios::binary);
    if (!file) {
      std::fprintf(stderr, "%s: cannot be read\n", argv[i]);
      return 2;
    }
    seeds.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    Try(seeds.back());
  }
  Try("");
  Random random(20260);
  const int count = std::atoi(argv[1]);
  for (int i = 0; i < count; ++i) {
    std::string input = seeds[Below(random, seeds.size())];
    const std::string& other = seeds[Below(random, seeds.size())];
    const size_t changes = 1 + Below(random, 4);
    for (size_t k = 0; k < changes; ++k) input = Change(std::move(input), other, random);
    Try(input);
  }
  std::printf("%zu seeds, %d changed inputs\n", seeds.size(), count);
  return 0;
}
