// Finite-element models from SAP2000.
#pragma once

#include <filesystem>

#include "structures/files/matrix_file.hpp"
#include "structures/frame/finite_elements.hpp"

namespace moat {

/// Reads the matrices that SAP2000 writes beside a model, `tower.TXE`, `.TXC`, `.TXK` and `.TXM`, and notes the files:
///
///     FiniteElements model = read_sap2000("tower", "joints.csv", {.force = kN, .length = m});
///     model.diaphragms = {{.height = 3.5 * m}, {.height = 7 * m}};
///
/// Fields are separated by tabs; the first line of each file is a heading.
///
/// - TXE: joint, then for U1 U2 U3 R1 R2 R3 the number of an equation, 0 for a motion that is held, or a negative
///   number of a constraint. A line without a tab continues the line before. Labels that begin with C and are no joints
///   are constraints with equations of their own.
/// - TXC: constraint, equation, coefficient; the motion is the sum of these terms. May be missing without constraints.
/// - TXK, TXM: row, column, value, of one triangle. Without TXM there are no masses.
/// - joints: CSV with the heading `joint,x [m],y [m],z [m]` and one line for each joint.
///
/// Local axes of all joints must be those of the building. Restraints of feet are those of the file (Feet::given).
///
/// path: of the files, without an ending. units: of the model when it was saved. Throws InputError for bad units, and
/// FileError naming file and line: an equation that TXE does not have, an entry that is given twice, a joint without
/// coordinates.
FiniteElements read_sap2000(const std::filesystem::path& path, const std::filesystem::path& joints,
                            const MatrixUnits& units);

}  // namespace moat
