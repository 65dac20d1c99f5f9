// The laws of the larger groups in a hundred digits. The unit tests hold the same laws over the rationals, in 16 and in 50 digits, and those of the small
// groups in a hundred, too; these take a minute to compile.
#define BOOST_TEST_NO_MAIN
#define BOOST_TEST_ALTERNATIVE_INIT_API
#include <boost/test/unit_test.hpp>

// The argument of `./run stress`, where figures would go, is not one of Boost.Test's.
int main(int, char** argv) {
  return boost::unit_test::unit_test_main([] { return true; }, 1, argv);
}
