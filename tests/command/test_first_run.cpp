#include <boost/test/unit_test.hpp>

#include "command.hpp"

BOOST_AUTO_TEST_SUITE(first_run)

BOOST_AUTO_TEST_CASE(a_scene_leaves_a_table_with_the_rows_that_were_asked_for) {
  command::Folder const folder;
  auto const outcome = command::actio({"run", folder.write("apophis.toml", command::apophis())});
  BOOST_TEST(outcome.status == 0, outcome.err);
  auto const table = command::read_csv(folder / "apophis/series.csv");
  BOOST_TEST(table.columns == (std::vector<std::string>{"t", "body_momentum_x", "body_momentum_y",
                                                        "body_momentum_z", "energy"}),
             boost::test_tools::per_element());
  BOOST_TEST(table.rows.size() == 101u);
  BOOST_TEST(table["t"][3] == 3 * 0.25);
}

BOOST_AUTO_TEST_CASE(a_mistyped_quantity_is_pointed_at) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis({{"quantities", "[\"enrgy\"]"}}));
  auto const outcome = command::actio({"run", scene});
  BOOST_TEST(outcome.status == 2);
  BOOST_TEST(outcome.err ==
             scene + ":22:15: unknown quantity 'enrgy'; did you mean 'energy'? (actio list quantities)\n");
}

BOOST_AUTO_TEST_SUITE_END()
