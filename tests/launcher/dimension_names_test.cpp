#include "launcher/dimension_names.hpp"

#include <gtest/gtest.h>

namespace moat::launcher {
namespace {

TEST(DimensionNames, ReplaceExponents) {
  EXPECT_EQ(with_dimension_names("from 'moat::Quantity<1, 2, -2>' to 'moat::Required<moat::Quantity<1, 0, 0> >'"),
            "from 'Force' to 'Mass'");
  EXPECT_EQ(with_dimension_names("'Quantity<1,-1,-2>' and moat::Moat<moat::HertzDamp>"),
            "'HertzStiffness' and Moat<HertzDamp>");
  EXPECT_EQ(with_dimension_names("'moat::Required<moat::PerStorey<moat::Quantity<1, 0, 0> > >'"), "'PerStorey<Mass >'");
  EXPECT_EQ(with_dimension_names("moat::Quantity<2, 2, 0>"), "quantity in kg^2 m");
}

TEST(DimensionNames, LeaveExponentsThatNoDimensionHas) {
  for (const char* type : {"Quantity<5, 2, 5555555555550>", "Quantity<-99999999999999999999999, 0, 0>"})
    EXPECT_EQ(with_dimension_names(type), type);
}

TEST(DimensionNames, DescribeATypeInASentence) {
  EXPECT_EQ(described("moat::Quantity<1, 2, -2>"), "a force [N]");
  EXPECT_EQ(described("const moat::Required<moat::Quantity<0, 2, 0> >"), "a length [m]");
  EXPECT_EQ(described("double"), "a number without unit");
  EXPECT_EQ(described("int"), "a number without unit");
  EXPECT_EQ(described("moat::NodeId"), "a NodeId");
  EXPECT_EQ(described("moat::ImpactRecorder"), "an ImpactRecorder");
  EXPECT_EQ(described("moat::Required<moat::PerStorey<moat::Quantity<1, 0, 0> > >"), "a mass [kg], or one per storey,");
  EXPECT_EQ(described("<brace-enclosed initializer list>"), "a list in braces");
}

}  // namespace
}  // namespace moat::launcher
