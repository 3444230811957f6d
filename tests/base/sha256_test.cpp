#include "base/sha256.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "in_folder.hpp"

namespace moat {
namespace {

// FIPS 180-2, appendix B.
TEST(Sha256, IsThatOfTheStandard) {
  EXPECT_EQ(sha256_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

using Sha256OfFile = testing::InFolder;

TEST_F(Sha256OfFile, IsThatOfItsContent) {
  const std::string path = (folder / "abc").string();
  std::ofstream{path} << "abc";
  EXPECT_EQ(sha256_of_file(path), sha256_of("abc"));
  std::remove(path.c_str());
  EXPECT_FALSE(sha256_of_file(path));
  EXPECT_FALSE(sha256_of_file(folder)) << "a folder";
}

}  // namespace
}  // namespace moat
