// Who computed the cases of a study, and with which version of everything they depend on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "study/file/study_version.hpp"

namespace moat {

namespace sqlite {
class Database;
}

/// Where and by whom cases are computed.
struct StudySession {
  std::string title{};         ///< of the study
  std::string command_line{};  ///< that started it
  std::string moat_version{};  ///< that computes
  std::string git_commit{};    ///< of the library
  std::string date{};          ///< UTC
  std::string engine{};        ///< "2 threads", "4 ranks"
};

/// A session as it is in the file of a study.
struct StoredSession : StudySession {
  std::string host{};  ///< name of the machine
  /// "finished", "stopped by SIGINT", "part 0:100 finished"; empty while it runs, and where it was killed.
  std::string ending{};
  std::size_t version = 0;  ///< index of its StudyIdentity
  std::size_t cases = 0;    ///< that it computed, and no later session again
};

namespace study_sessions {

/// All versions, in the order in which they came into the file.
std::vector<StudyIdentity> versions_of(const sqlite::Database& database);
/// The number of a version, which is added if the file lacks it.
std::size_t version_with(const sqlite::Database& database, const StudyIdentity& identity);
/// The version that the study goes on with.
std::size_t current_version(const sqlite::Database& database);
/// From now on.
void set_current_version(const sqlite::Database& database, std::size_t version);

/// Returns the number of the session.
std::int64_t add(const sqlite::Database& database, const StoredSession& session);
/// How the session ended.
void set_ending(const sqlite::Database& database, std::int64_t session, const std::string& ending);
/// In their order.
std::vector<StoredSession> all_of(const sqlite::Database& database);

}  // namespace study_sessions
}  // namespace moat
