#include "app/json_output.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/text/terminal.hpp"
#include "output/files/results_folder.hpp"

namespace moat {

JsonOutput::JsonOutput() {
  std::cout.flush();
  std::fflush(stdout);
  standard_output_ = ::dup(STDOUT_FILENO);
  if (standard_output_ < 0 || ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
    throw FileError{"--json: standard output cannot be used (" + std::string{std::strerror(errno)} + ")."};
}

JsonOutput::~JsonOutput() {
  std::cout.flush();
  std::fflush(stdout);
  ::dup2(standard_output_, STDOUT_FILENO);
  ::close(standard_output_);
}

void JsonOutput::write(const std::string& text) const {
  const std::string json = printable(text);
  std::cout.flush();
  for (std::size_t done = 0; done < json.size();) {
    const ssize_t count = ::write(standard_output_, json.data() + done, json.size() - done);
    if (count < 0 && errno != EINTR)
      throw FileError{"--json: standard output cannot be written (" + std::string{std::strerror(errno)} + ")."};
    if (count > 0) done += static_cast<std::size_t>(count);
  }
}

std::string summary_with_folder(const std::filesystem::path& folder) {
  using Json = nlohmann::ordered_json;
  std::ifstream file{folder / results_file::summary, std::ios::binary};
  Json json{{"results_folder", folder.string()}};
  json.update(Json::parse(file));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace moat
