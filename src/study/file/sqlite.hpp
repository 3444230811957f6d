// The database of a study: statements of SQLite with errors as exceptions. Included by .cpp files alone.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace moat::sqlite {

/// A prepared statement. Parameters and columns count from 1 and 0, as in SQLite.
class Statement {
 public:
  Statement(sqlite3* database, const std::filesystem::path& file, std::string_view text);
  ~Statement();
  Statement(Statement&& other) noexcept;
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  Statement& bind(int parameter, std::int64_t value);
  /// NaN becomes NULL, -0 the bytes "-0.0"; real() reads all.
  Statement& bind(int parameter, double value);
  Statement& bind(int parameter, std::string_view value);
  /// Goes to the next row; false: there is none, and the statement may be bound and run again.
  bool step();
  /// Runs a statement without rows to its end.
  void run();

  [[nodiscard]] std::int64_t integer(int column) const;
  /// NULL becomes NaN.
  [[nodiscard]] double real(int column) const;
  [[nodiscard]] std::string text(int column) const;

 private:
  sqlite3* database_;
  std::filesystem::path file_;
  sqlite3_stmt* statement_ = nullptr;
};

/// An open database. Throws FileError, with the file and SQLite's message, where anything fails.
class Database {
 public:
  enum class Access { read, write };
  Database(const std::filesystem::path& file, Access access);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  [[nodiscard]] Statement prepare(std::string_view text) const;
  void run(const char* statements) const;
  /// Moves the write-ahead log into the file, so that no other file is needed to read it, not even on a disk that
  /// cannot be written. Left undone while another process reads the file.
  void become_one_file() const noexcept;
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;
  sqlite3* database_ = nullptr;
};

/// All or nothing: without commit() its statements are undone at its end.
class Transaction {
 public:
  explicit Transaction(const Database& database) : database_{&database} { database.run("BEGIN IMMEDIATE"); }
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();
  /// Undoes its statements at once.
  void undo();

 private:
  const Database* database_;
  bool open_ = true;
};

}  // namespace moat::sqlite
