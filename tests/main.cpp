// The main function of every unit test executable; the cases are in tests/<module>/test_*.cpp.
#define BOOST_TEST_MODULE actio
#include <boost/test/unit_test.hpp>
