// What the examples of the reference have in common.
//
// The lines between two marks `// [NAME]` are shown in the book with the function or the class that they are
// about. Each file is a suite of the test `test_examples`; `assert` fails the test where it does not hold.
#pragma once

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#undef assert
#define assert(condition) BOOST_CHECK(condition)
