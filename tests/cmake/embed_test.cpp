// moat_embed() of cmake/MoatEmbed.cmake.
#include <gtest/gtest.h>

#include <embedded/both_texts.hpp>
#include "run_program.hpp"

namespace moat {
namespace {

TEST(Embed, KeepsEveryCharacterOfTheFilesInTheirOrder) {
  const std::string folder = MOAT_SOURCE_DIR "/tests/cmake/";
  EXPECT_EQ(embedded::both_texts,
            testing::text_of(folder + "embedded_text_1.txt") + testing::text_of(folder + "embedded_text_2.txt"));
}

}  // namespace
}  // namespace moat
