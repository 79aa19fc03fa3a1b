// Drives a fuzz target without libFuzzer: damages given files in a fixed number of ways, the same
// in every run. Usage: plumbline_fuzz_<format> COUNT FILE...

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Lines = std::vector<std::string>;

std::string content(const char* file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Lines lines_of(const std::string& text) {
  Lines lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    lines.push_back(text.substr(begin, end - begin));
    begin = end;
  }
  return lines;
}

/// Draws the damage. Only the engine's own numbers are used: distributions differ by library.
class Damage {
 public:
  explicit Damage(std::uint32_t seed) : random_(seed) {}

  std::string apply(Lines lines) {
    for (std::size_t count = 1 + below(4); count > 0 && !lines.empty(); --count) change(lines);
    std::string text;
    for (const std::string& line : lines) text += line;
    if (below(8) == 0 && !text.empty()) text.resize(below(text.size()));
    for (std::size_t count = below(3); count > 0 && !text.empty(); --count) {
      text[below(text.size())] = static_cast<char>(below(256));
    }
    return text;
  }

 private:
  std::size_t below(std::size_t bound) { return random_() % bound; }

  void change(Lines& lines) {
    static const char* const kValues[] = {"0",   "-1", "1e9999", "1e-9999", "999999999999999999999",
                                          "nan", "",   "0.1",    "1e308",   "\xff\xfe"};
    const std::size_t at = below(lines.size());
    const auto here = lines.begin() + static_cast<std::ptrdiff_t>(at);
    const std::size_t other = below(lines.size());
    switch (below(5)) {
      case 0:
        *here = std::string(kValues[below(std::size(kValues))]) + "\n";
        break;
      case 1:
        lines.erase(here, here + static_cast<std::ptrdiff_t>(
                                     std::min<std::size_t>(1 + below(8), lines.size() - at)));
        break;
      case 2:
        *here = lines[other];
        break;
      case 3: {
        const Lines copy(lines.begin() + static_cast<std::ptrdiff_t>(other),
                         lines.begin() + static_cast<std::ptrdiff_t>(
                                             std::min(other + 1 + below(40), lines.size())));
        lines.insert(here, copy.begin(), copy.end());
        break;
      }
      default:
        std::swap(lines[at], lines[other]);
    }
  }

  std::mt19937 random_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "usage: " << argv[0] << " COUNT FILE...\n";
    return 2;
  }
  const unsigned long count = std::stoul(argv[1]);
  std::vector<Lines> seeds;
  for (int i = 2; i < argc; ++i) seeds.push_back(lines_of(content(argv[i])));
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::string text = Damage(i).apply(seeds[i % seeds.size()]);
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  }
  std::cout << count << " inputs\n";
}
