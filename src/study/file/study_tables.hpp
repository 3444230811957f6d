// The tables of a study in its file: their layout, the axes, versions and sessions. Included by .cpp files alone.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/file/sqlite.hpp"
#include "study/file/store.hpp"

namespace moat::study_tables {

/// Whether the file has the tables; false for an empty one. Throws FileError for another database or format.
bool exist_in(const sqlite::Database& database);

/// Makes the tables, with axes and title, in the transaction of the caller.
void create(const sqlite::Database& database, const StudyCases& cases, const std::string& title);

StudyCases cases_of(const sqlite::Database& database);

/// Returns a value of the table `study`; empty for an unknown key.
std::string property(const sqlite::Database& database, const std::string& key);
void set_property(const sqlite::Database& database, const std::string& key, const std::string& value);

/// All versions, in the order in which they came into the file.
std::vector<StudyIdentity> versions_of(const sqlite::Database& database);
/// The number of a version, which is added if the file lacks it.
std::size_t version_with(const sqlite::Database& database, const StudyIdentity& identity);
/// The version that the study goes on with.
std::size_t current_version(const sqlite::Database& database);
void set_current_version(const sqlite::Database& database, std::size_t version);

/// Returns the number of the session.
std::int64_t add_session(const sqlite::Database& database, const StoredSession& session);
/// How the session ended.
void set_ending(const sqlite::Database& database, std::int64_t session, const std::string& ending);
/// All sessions, in their order.
std::vector<StoredSession> sessions_of(const sqlite::Database& database);

}  // namespace moat::study_tables
