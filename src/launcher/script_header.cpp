#include "launcher/script_header.hpp"

#include "launcher/lock.hpp"
#include "launcher/phase.hpp"
#include "launcher/text.hpp"
#include "launcher/time_of_change.hpp"

namespace moat::launcher {

namespace fs = std::filesystem;

fs::path precompiled_header(const Places& places, Command& compile) {
  const fs::path of_library = places.build / "script_header" / "moat.hpp.gch";
  if (fs::exists(of_library)) return of_library;
  if (!places.installed()) return {};
  const fs::path folder = places.work / "script_header", header = folder / "moat.hpp.gch", made = folder / "made";
  const Lock lock{folder / "lock"};
  const fs::path launcher = places.build / "bin" / "moat", compiler = compile.front();
  if (changed_after(launcher, header) || changed_after(compiler, header)) {
    write_text(folder / "moat.hpp", "#include \"" + (places.root / "src" / "moat.hpp").string() + "\"\n");
    Command command = compile;
    command.insert(command.end(), {"-x", "c++-header", folder / "moat.hpp", "-o", made});
    required_phase(places.logs(), "header", "moat.hpp, once for all scripts", command);
    fs::rename(made, header);
  }
  compile.insert(compile.begin() + 1, {"-isystem", folder});
  return header;
}

}  // namespace moat::launcher
