// The memory that this process may still take.
#pragma once

#include <filesystem>
#include <string>

namespace moat {

/// Returns the smallest of these, in bytes; infinite where the system says nothing:
///
///   - MemAvailable of /proc/meminfo,
///   - the limits of the control groups of the process (versions 1 and 2) less their use; cached files count as free,
///   - `ulimit -v` less the size of the process.
///
/// root: of the folders proc and sys/fs/cgroup.
double available_memory(const std::filesystem::path& root = "/");

/// "1.52 GB", "200 MB".
std::string memory_text(double bytes);

}  // namespace moat
