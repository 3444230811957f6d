#include "launcher/installed_text.hpp"

#include "launcher/text.hpp"

namespace moat::launcher {

std::string as_installed(const std::string& text, const Places& places) {
  if (!places.installed()) return text;
  const std::string command = replaced(replaced(text, "~/moat/moat ", "moat "), "./moat ", "moat ");
  return replaced(command, " examples/", " " + (places.root / "examples" / "").string());
}

}  // namespace moat::launcher
