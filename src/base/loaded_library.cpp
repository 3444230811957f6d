#include "base/loaded_library.hpp"

#include <dlfcn.h>

#include <filesystem>

#include "base/error.hpp"

namespace moat {

void* loaded_function(const std::string& library, const char* function, const std::string& failure,
                      const std::string& remedy) {
  Dl_info own{};
  if (dladdr(reinterpret_cast<const void*>(&loaded_function), &own) == 0 || own.dli_fname == nullptr)
    throw InputError{failure + ": the library of moat cannot be located. " + remedy};
  const auto file = std::filesystem::path{own.dli_fname}.parent_path() / library;
  void* const handle = dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL);
  void* const found = handle == nullptr ? nullptr : dlsym(handle, function);
  if (found == nullptr) throw InputError{failure + ": " + dlerror() + ". " + remedy};
  return found;
}

}  // namespace moat
