// The laws of the larger groups in fifty and a hundred digits. The unit tests hold the same laws over the rationals and in double, and those of the small
// groups and of the motions of space in many digits, too; these take two minutes to compile.
#define BOOST_TEST_NO_MAIN
#define BOOST_TEST_ALTERNATIVE_INIT_API
#include <boost/test/unit_test.hpp>

// The argument of `./run stress`, where figures would go, is not one of Boost.Test's.
int main(int, char** argv) {
  return boost::unit_test::unit_test_main([] { return true; }, 1, argv);
}
