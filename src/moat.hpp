#pragma once
#include "base/units.hpp"
