#include "study/file/sqlite.hpp"

#include <sqlite3.h>

#include <cmath>

#include "base/error.hpp"

namespace moat::sqlite {

Statement::Statement(const Database& database, std::string_view text)
    : database_{&database}, statement_{nullptr, sqlite3_finalize} {
  sqlite3_stmt* prepared = nullptr;
  database_->check(
      sqlite3_prepare_v2(database.database_.get(), text.data(), static_cast<int>(text.size()), &prepared, nullptr));
  statement_.reset(prepared);
}

void Statement::set_integer(int parameter, std::int64_t value) {
  database_->check(sqlite3_bind_int64(statement_.get(), parameter, value));
}

void Statement::set(int parameter, double value) {
  // SQLite drops the sign of a number that is zero, and keeps that of bytes.
  const bool negative_zero = value == 0.0 && std::signbit(value);
  database_->check(std::isnan(value) ? sqlite3_bind_null(statement_.get(), parameter)
                   : negative_zero   ? sqlite3_bind_blob(statement_.get(), parameter, "-0.0", 4, SQLITE_STATIC)
                                     : sqlite3_bind_double(statement_.get(), parameter, value));
}

void Statement::set(int parameter, std::string_view value) {
  database_->check(
      sqlite3_bind_text(statement_.get(), parameter, value.data(), static_cast<int>(value.size()), SQLITE_TRANSIENT));
}

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  sqlite3_reset(statement_.get());
  if (code != SQLITE_DONE) database_->check(code);
  return false;
}

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }

double Statement::real(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL ? std::nan("")
                                                                      : sqlite3_column_double(statement_.get(), column);
}

std::string Statement::text(int column) const {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  return text == nullptr ? ""
                         : std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column)));
}

Database::Database(const std::filesystem::path& file, Access access)
    : file_{file}, database_{nullptr, sqlite3_close_v2} {
  const int flags = (access == Access::read ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE) |
                    SQLITE_OPEN_NOMUTEX;
  sqlite3* opened = nullptr;
  const int code = sqlite3_open_v2(file.c_str(), &opened, flags, nullptr);
  database_.reset(opened);
  check(code);
  constexpr int milliseconds_to_wait_for_a_reader = 10000;
  sqlite3_busy_timeout(opened, milliseconds_to_wait_for_a_reader);
}

void Database::check(int code) const {
  if (code == SQLITE_OK) return;
  const std::string reason = database_ != nullptr ? sqlite3_errmsg(database_.get()) : sqlite3_errstr(code);
  const int kind = code & 0xff;
  std::string advice = "Give another file, or repair this one.";
  if (kind == SQLITE_FULL || kind == SQLITE_IOERR)
    advice = "All finished cases are intact. Make room on the disk and run the same command again.";
  if (kind == SQLITE_CANTOPEN || kind == SQLITE_READONLY || kind == SQLITE_PERM)
    advice = "Give a file in a folder that exists and can be written.";
  if (kind == SQLITE_NOTADB) advice = "This is no study of moat. Give another file.";
  if (kind == SQLITE_CORRUPT) advice = "The file is damaged: restore a copy, or remove it and start again.";
  throw FileError{"study " + file_.string() + ": " + reason + ". " + advice};
}

void Database::run(const char* statements) const {
  check(sqlite3_exec(database_.get(), statements, nullptr, nullptr, nullptr));
}

void Database::become_one_file() const noexcept {
  constexpr int milliseconds_to_wait = 500;
  sqlite3_busy_timeout(database_.get(), milliseconds_to_wait);
  sqlite3_exec(database_.get(), "PRAGMA journal_mode = DELETE", nullptr, nullptr, nullptr);
}

Transaction::~Transaction() {
  if (!open_) return;
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
