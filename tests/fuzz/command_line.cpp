// The command line of a script: words separated by line ends.

#include <iostream>

#include "app/command_line.hpp"
#include "base/parse_quantity.hpp"
#include "fuzzing.hpp"

using namespace moat;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::cerr.setstate(std::ios::badbit);  // the mistakes that it prints
  std::vector<std::string> words{"script"};
  std::string_view text = fuzz::text_of(data, size);
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    words.emplace_back(text.substr(0, std::min(end, text.find('\0'))));
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
  }
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  return fuzz::tried([&] {
    CommandLine line{static_cast<int>(arguments.size()), arguments.data(), "A script"};
    bool force = false;
    line.add_flag("force", force, "help");
    line.add_json_flag();
    if (const auto gap = line.look_up("gap", "10 cm", "help", "[m]")) (void)parse<Length>(*gap, "--gap");
    (void)line.look_up("out", "", "help", "FOLDER");
    (void)line.help();
    (void)line.parse();
  });
}
