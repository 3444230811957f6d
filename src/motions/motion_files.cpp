#include "motions/motion_files.hpp"

#include <algorithm>
#include <span>

#include "base/sha256.hpp"

namespace moat {

std::vector<FileRead> files_of(const GroundMotion& motion) {
  std::vector<FileRead> files;
  for (const MotionComponent& component : motion.components())
    if (!component.file.path.empty() && std::ranges::find(files, component.file) == files.end())
      files.push_back(component.file);
  return files;
}

std::string hash_of(const GroundMotion& motion) {
  std::string bytes;
  for (const FileRead& file : files_of(motion)) bytes += file.sha256;
  const auto add = [&](std::span<const double> numbers) {
    bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes());
  };
  const double time_step = motion.time_step();
  add({&time_step, 1});
  add(motion.samples());
  add(motion.samples_y());
  add(motion.samples_z());
  return sha256_of(bytes);
}

}  // namespace moat
