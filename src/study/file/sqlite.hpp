// The database of a study: statements of SQLite with errors as exceptions. Included by .cpp files alone.
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace moat::sqlite {

class Database;

/// A prepared statement. Columns count from 0, as in SQLite.
class Statement {
 public:
  /// The database must outlive it.
  Statement(const Database& database, std::string_view text);

  /// Gives values to all parameters, in their order.
  template <class... Values>
  Statement& bind(const Values&... values) {
    int parameter = 0;
    (set(++parameter, values), ...);
    return *this;
  }
  /// Goes to the next row; false: there is none, and the statement may be bound and run again.
  bool step();
  /// Runs a statement without rows, with these values of its parameters.
  template <class... Values>
  void run(const Values&... values) {
    bind(values...);
    while (step()) {
    }
  }

  [[nodiscard]] std::int64_t integer(int column) const;
  /// NULL becomes NaN.
  [[nodiscard]] double real(int column) const;
  [[nodiscard]] std::string text(int column) const;

 private:
  void set(int parameter, std::integral auto value) { set_integer(parameter, static_cast<std::int64_t>(value)); }
  void set_integer(int parameter, std::int64_t value);
  /// NaN becomes NULL, -0 the bytes "-0.0"; real() reads all.
  void set(int parameter, double value);
  void set(int parameter, std::string_view value);

  const Database* database_;
  std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> statement_;
};

/// An open database. Throws FileError, with the file and SQLite's message, where anything fails.
class Database {
 public:
  enum class Access { read, write };
  Database(const std::filesystem::path& file, Access access);

  [[nodiscard]] Statement prepare(std::string_view text) const { return {*this, text}; }
  void run(const char* statements) const;
  /// Moves the write-ahead log into the file, so that no other file is needed to read it, not even on a disk that
  /// cannot be written. Left undone while another process reads the file.
  void become_one_file() const noexcept;
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  friend class Statement;
  void check(int code) const;

  std::filesystem::path file_;
  std::unique_ptr<sqlite3, int (*)(sqlite3*)> database_;
};

/// All or nothing: without commit() its statements are undone at its end.
class Transaction {
 public:
  explicit Transaction(const Database& database) : database_{&database} { database.run("BEGIN IMMEDIATE"); }
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  const Database* database_;
  bool open_ = true;
};

}  // namespace moat::sqlite
