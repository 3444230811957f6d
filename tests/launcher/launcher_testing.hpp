// A small checkout in a temporary folder, with the real compiler and the real Ninja.
#pragma once

#include <sys/stat.h>

#include <string>

#include "launcher/places.hpp"
#include "launcher/text.hpp"
#include "run_program.hpp"

namespace moat::launcher {

class InSmallCheckout : public moat::testing::InTemporaryFolder {
 protected:
  InSmallCheckout() {
    for (const auto& path : {places.root / "src", places.build, places.root / "examples", folder / "study"})
      std::filesystem::create_directories(path);
    write_text(places.root / "CMakeLists.txt", "");
    write_text(places.root / "src" / "moat.hpp", "#pragma once\n");
    write_text(places.build / "script_compile.txt",
               std::string{COMPILER} + "\n-Wall\n-isystem\n" + (places.root / "src").string() + "\n");
    write_text(places.build / "script_link.txt", "");
  }

  /// An installed package has no sources.
  void become_a_package() const { std::filesystem::remove(places.root / "CMakeLists.txt"); }

  /// Writes <folder>/study/<name>, a script that prints a text.
  std::filesystem::path write_script(const std::string& name, const std::string& text) const {
    const std::filesystem::path script = folder / "study" / name;
    std::filesystem::create_directories(script.parent_path());
    write_text(script, "#include <moat.hpp>\n#include <cstdio>\nint main() { std::puts(\"" + text + "\"); }\n");
    return script;
  }

  [[nodiscard]] std::string output_of_program(const std::filesystem::path& program) const {
    return moat::testing::run_program(program, {}, folder).output;
  }

  /// Differs for every file that was written again.
  static std::pair<ino_t, long> identity(const std::filesystem::path& file) {
    struct stat status {};
    ::stat(file.c_str(), &status);
    return {status.st_ino, status.st_mtim.tv_nsec};
  }

  const Places places{.root = folder / "the checkout",
                      .build = folder / "the checkout" / "build" / "release",
                      .work = folder / "the checkout" / "build"};
};

}  // namespace moat::launcher
