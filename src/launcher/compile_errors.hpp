// Errors of the compiler in a script, in the words of the script's writer.
#pragma once

#include <filesystem>
#include <string>

namespace moat::launcher {

/// A text for the user: for each error the useful sentence first, then the line of the source it is about.
///
///     tower.cpp:30: field floor_mass of ShearBuilding is missing
///        30 |  .post_yield_stiffness = 19.3 * MN / m}});
///           |                                        ^
///
/// Errors that are not known here keep the compiler's words, with names of dimensions. `output` is GCC's text in
/// English, `script` the name of the script in it, `root` the checkout, where fields are looked up.
std::string explained(const std::string& output, const std::string& script, const std::filesystem::path& root);

}  // namespace moat::launcher
