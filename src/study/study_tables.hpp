// The tables of a study in its file: their layout, and the axes. Included by .cpp files alone.
#pragma once

#include <string>

#include "study/cases.hpp"
#include "study/file/sqlite.hpp"

namespace moat::study_tables {

/// Whether the file has the tables; false for an empty one. Throws FileError for another database or format.
bool exist_in(const sqlite::Database& database);

/// Makes the tables, with axes and title, in the transaction of the caller.
void create(const sqlite::Database& database, const StudyCases& cases, const std::string& title);

StudyCases cases_of(const sqlite::Database& database);

/// Returns a value of the table `study`; empty for an unknown key.
std::string property(const sqlite::Database& database, const std::string& key);
void set_property(const sqlite::Database& database, const std::string& key, const std::string& value);

}  // namespace moat::study_tables
