// The launcher's sentences about errors of the compiler: GCC's words, and a script.

#include "launcher/compile_errors.hpp"
#include "fuzzing.hpp"

using namespace moat;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Folder folder;
  static const bool in_folder = [] {
    std::filesystem::current_path(folder.path());
    // A few headers: the launcher reads all below the folder for each error.
    std::filesystem::create_directories("root/structures");
    for (const char* name : {"moat.hpp", "shear_building.hpp"})
      std::filesystem::copy_file(std::filesystem::path{MOAT_SOURCE_DIR} / "structures" / name,
                                 std::filesystem::path{"root/structures"} / name,
                                 std::filesystem::copy_options::overwrite_existing);
    return true;
  }();
  (void)in_folder;
  const std::vector<std::string_view> parts = fuzz::parts_of(fuzz::text_of(data, size), 2);
  (void)folder.file("tower.cpp", parts[1]);
  return fuzz::tried([&] { (void)launcher::explained(std::string{parts[0]}, "root"); });
}
