#include "app/json_output.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/study_json.hpp"
#include "base/error.hpp"
#include "base/text/terminal.hpp"
#include "output/files/results_folder.hpp"

namespace moat {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace

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

std::string json_of(const StudyReport& report, const std::filesystem::path& folder) {
  Json json{{"title", report.title}, {"results_folder", folder.string()}, {"studies", Json::array()}};
  for (const NamedStudy& study : report.studies) {
    Json entry{{"name", study.name}, {"file", (folder / (study.name + ".db")).string()}};
    entry.update(counts_of(study.result));
    json["studies"].push_back(std::move(entry));
  }
  json["answers"] = report.answers;
  return text_of(json);
}

std::string summary_with_folder(const std::filesystem::path& folder) {
  std::ifstream file{folder / results_file::summary, std::ios::binary};
  Json json{{"results_folder", folder.string()}};
  json.update(Json::parse(file));
  return text_of(json);
}

}  // namespace moat
