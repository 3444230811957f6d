// The files that a program and its threads have read.

#include "base/files_read.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace moat {
namespace {

const FileRead first{"/b/first", "1"}, second{"/a/second", "2"}, changed{"/b/first", "3"};

TEST(FilesRead, BelongToTheInnermostCollectionOfTheirThread) {
  note_file_read(first);
  {
    const FilesOfThisThread outer;
    note_file_read(second);
    {
      const FilesOfThisThread inner;
      note_file_read(first);
      note_file_read(changed);
      note_file_read(first);
      EXPECT_EQ(inner.files(), (std::vector{first, changed}));
    }
    std::thread{[] {
      const FilesOfThisThread other;
      note_file_read(changed);
      EXPECT_EQ(other.files(), std::vector{changed});
    }}.join();
    EXPECT_EQ(outer.files(), std::vector{second});
  }
  EXPECT_EQ(files_read_by_program(), std::vector{first});
  note_file_read(second);
  note_file_read(changed);
  EXPECT_EQ(files_read_by_program(), (std::vector{second, changed})) << "in the order of their paths, the last content";
}

}  // namespace
}  // namespace moat
