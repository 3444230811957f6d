#include "study/file/sqlite.hpp"

#include <sqlite3.h>

#include <cmath>
#include <utility>

#include "base/error.hpp"

namespace moat::sqlite {
namespace {

[[noreturn]] void fail(sqlite3* database, const std::filesystem::path& file, int code) {
  const std::string reason = database != nullptr ? sqlite3_errmsg(database) : sqlite3_errstr(code);
  const int kind = code & 0xff;
  std::string advice = "Give another file, or repair this one.";
  if (kind == SQLITE_FULL || kind == SQLITE_IOERR)
    advice = "All finished cases are intact. Make room on the disk and run the same command again.";
  if (kind == SQLITE_CANTOPEN || kind == SQLITE_READONLY || kind == SQLITE_PERM)
    advice = "Give a file in a folder that exists and can be written.";
  if (kind == SQLITE_NOTADB) advice = "This is no study of moat. Give another file.";
  if (kind == SQLITE_CORRUPT) advice = "The file is damaged: restore a copy, or remove it and start again.";
  throw FileError{"study " + file.string() + ": " + reason + ". " + advice};
}

}  // namespace

Statement::Statement(sqlite3* database, const std::filesystem::path& file, std::string_view text)
    : database_{database}, file_{file} {
  const int code = sqlite3_prepare_v2(database, text.data(), static_cast<int>(text.size()), &statement_, nullptr);
  if (code != SQLITE_OK) fail(database, file_, code);
}

Statement::Statement(Statement&& other) noexcept
    : database_{other.database_}, file_{std::move(other.file_)}, statement_{std::exchange(other.statement_, nullptr)} {}

Statement::~Statement() { sqlite3_finalize(statement_); }

Statement& Statement::bind(int parameter, std::int64_t value) {
  if (const int code = sqlite3_bind_int64(statement_, parameter, value); code != SQLITE_OK)
    fail(database_, file_, code);
  return *this;
}

Statement& Statement::bind(int parameter, double value) {
  // SQLite drops the sign of a number that is zero, and keeps that of bytes.
  const bool negative_zero = value == 0.0 && std::signbit(value);
  const int code = std::isnan(value) ? sqlite3_bind_null(statement_, parameter)
                   : negative_zero   ? sqlite3_bind_blob(statement_, parameter, "-0.0", 4, SQLITE_STATIC)
                                     : sqlite3_bind_double(statement_, parameter, value);
  if (code != SQLITE_OK) fail(database_, file_, code);
  return *this;
}

Statement& Statement::bind(int parameter, std::string_view value) {
  const int code =
      sqlite3_bind_text(statement_, parameter, value.data(), static_cast<int>(value.size()), SQLITE_TRANSIENT);
  if (code != SQLITE_OK) fail(database_, file_, code);
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(statement_);
  if (code == SQLITE_ROW) return true;
  sqlite3_reset(statement_);
  if (code != SQLITE_DONE) fail(database_, file_, code);
  return false;
}

void Statement::run() {
  while (step()) {
  }
}

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(statement_, column); }

double Statement::real(int column) const {
  return sqlite3_column_type(statement_, column) == SQLITE_NULL ? std::nan("")
                                                                : sqlite3_column_double(statement_, column);
}

std::string Statement::text(int column) const {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
  return text != nullptr ? std::string{text, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))} : "";
}

Database::Database(const std::filesystem::path& file, Access access) : file_{file} {
  const int flags = (access == Access::read ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE) |
                    SQLITE_OPEN_NOMUTEX;
  if (const int code = sqlite3_open_v2(file.c_str(), &database_, flags, nullptr); code != SQLITE_OK) {
    try {
      fail(database_, file_, code);
    } catch (...) {
      sqlite3_close(database_);
      throw;
    }
  }
  constexpr int milliseconds_to_wait_for_a_reader = 10000;
  sqlite3_busy_timeout(database_, milliseconds_to_wait_for_a_reader);
}

Database::~Database() { sqlite3_close_v2(database_); }

Statement Database::prepare(std::string_view text) const { return {database_, file_, text}; }

void Database::run(const char* statements) const {
  if (const int code = sqlite3_exec(database_, statements, nullptr, nullptr, nullptr); code != SQLITE_OK)
    fail(database_, file_, code);
}

void Database::become_one_file() const noexcept {
  constexpr int milliseconds_to_wait = 500;
  sqlite3_busy_timeout(database_, milliseconds_to_wait);
  sqlite3_exec(database_, "PRAGMA journal_mode = DELETE", nullptr, nullptr, nullptr);
}

Transaction::~Transaction() { undo(); }

void Transaction::undo() {
  if (!std::exchange(open_, false)) return;
  try {
    database_->run("ROLLBACK");
  } catch (...) {
    // SQLite rolled back by itself, as it does on a full disk.
  }
}

void Transaction::commit() {
  database_->run("COMMIT");
  open_ = false;
}

}  // namespace moat::sqlite
