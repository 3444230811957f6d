// A state with values of all kinds that runs keep in checkpoints.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/script/checkpoint_file.hpp"

namespace moat::fuzz {

inline const StudyIdentity identity_of_saved{{"script", "a"}};

struct SavedState {
  std::array<double, 3> forces{};
  Eigen::VectorXd displacements{};
  Eigen::MatrixXd loops{};
  std::vector<std::optional<double>> moments{};
  std::vector<std::vector<double>> histories{};
  std::map<std::string, std::vector<int>> places{};

  void archive(StateArchive& archive) {
    archive(forces, displacements, loops, moments, histories, places);
    archive.require_same("bearing", "The state is that of another model.");
    archive.require_end();
  }
};

}  // namespace moat::fuzz
