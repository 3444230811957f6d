#include "output/files/table.hpp"

#include "output_testing.hpp"

namespace moat {
namespace {

TEST(Table, FindsAColumnByQuantityAndPlace) {
  const Table table{{{"time", "", "s", {0.0, 1.0}}, {"drift", "storey 1", "m", {2.0, 3.0}}}};
  EXPECT_EQ(table.values("time"), (std::vector<double>{0.0, 1.0}));
  EXPECT_EQ(table.values("drift", "storey 1")[1], 3.0);
}

TEST(Table, SaysWhichColumnsThereAre) {
  const Table table{{{"drift", "storey 1", "m", {2.0}}, {"drift", "storey 2", "m", {2.0}}}};
  EXPECT_EQ(testing_output::message_of<InputError>([&] { (void)table.values("drift", "roof"); }),
            "Table: there is no column \"drift\" of \"roof\". The quantity has columns of \"storey 1\", \"storey 2\".");
  EXPECT_EQ(testing_output::message_of<InputError>([&] { (void)table.values("tilt", "roof"); }),
            "Table: there is no column \"tilt\" of \"roof\". No column has this quantity.");
}

}  // namespace
}  // namespace moat
