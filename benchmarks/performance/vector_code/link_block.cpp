// Compiled by vector_code.cpp to ask the compiler which loops it turns into vector code; LAW is given there.
#include "elements/link_block.hpp"

#include <memory>

#include "materials/bilinear.hpp"
#include "materials/linear.hpp"
#include "materials/viscous.hpp"

std::unique_ptr<moat::ElementBlock> make_block() { return std::make_unique<moat::LinkBlock<moat::LAW>>(); }
