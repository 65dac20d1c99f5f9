// What is written back is read again as the same, to the last bit.
#include <Eigen/Core>

#include <toml++/toml.h>

#include <bit>
#include <random>

#include <boost/test/unit_test.hpp>

#include "program/document/file.hpp"

using namespace actio::scene;

namespace {

constexpr unsigned seed = 1971;

/// A text that no writer expects.
std::string any_text(std::mt19937& random) {
  static std::string const single = "a\"'\\\n\t\r\x01\x1f\x7f#=[]{}. 1";
  static std::vector<std::string> const longer{
      "\xc3\xa9", "\xe2\x80\xa8", "\xf0\x9f\x8c\x8d", "\xc2\x85", "\xef\xbb\xbf",
      "\"\"\"",   "'''",          "\\u0041",          "nan",      "--set"};
  std::string out;
  for (auto k = random() % 6; k > 0; --k) {
    auto const piece = random() % (single.size() + longer.size());
    out += piece < single.size() ? single.substr(piece, 1) : longer[piece - single.size()];
  }
  return out;
}

/// A finite double of any size, plain ones among them.
double any_number(std::mt19937_64& random) {
  static double const plain[] = {0.0,
                                 -0.0,
                                 1.0,
                                 -1.0,
                                 0.1,
                                 5e-324,
                                 2.2250738585072014e-308,
                                 1.7976931348623157e308,
                                 -1.7976931348623157e308,
                                 9007199254740993.0,
                                 1e15,
                                 1e16,
                                 1e-5,
                                 1e22,
                                 123456.789};
  if (random() % 4 == 0) return plain[random() % std::size(plain)];
  for (;;)
    if (double const x = std::bit_cast<double>(random()); std::isfinite(x)) return x;
}

bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

}  // namespace

BOOST_AUTO_TEST_SUITE(scene_writer)

BOOST_AUTO_TEST_CASE(every_double_comes_back_bit_for_bit) {
  BOOST_TEST_MESSAGE("seed " << seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 2000; ++k) {
    double const x = any_number(random);
    std::vector<double> const list{any_number(random), any_number(random)};
    Eigen::MatrixXd const matrix =
        Eigen::Matrix2d{{any_number(random), any_number(random)}, {any_number(random), any_number(random)}};
    auto const file = SceneFile::parse("", "f");
    auto table = file.section("a");
    table.set("x", x), table.set("list", list), table.set("matrix", matrix);
    auto const back = SceneFile::parse(file.written(), "f").section("a");
    BOOST_REQUIRE(same(back.number("x"), x));
    BOOST_REQUIRE((same(back.numbers("list")[0], list[0]) && same(back.numbers("list")[1], list[1])));
    for (Eigen::Index i = 0; i < 4; ++i) BOOST_REQUIRE(same(back.matrix("matrix", 2)(i), matrix(i)));
  }
}

BOOST_AUTO_TEST_CASE(every_text_and_every_key_comes_back) {
  BOOST_TEST_MESSAGE("seed " << seed);
  std::mt19937 random(seed);
  for (int k = 0; k < 2000; ++k) {
    std::string const key = any_text(random), text = any_text(random), section = any_text(random);
    auto const file = SceneFile::parse("", "f");
    auto table = file.section(section);
    table.set(key, text), table.set(key + "s", std::vector<std::string>{text, text + "x"}),
        table.set(key + "b", true), table.set(key + "i", long(random()) - 1000);
    auto const back = SceneFile::parse(file.written(), "f");
    BOOST_REQUIRE_EQUAL(back.section(section).text(key), text);
    BOOST_REQUIRE_EQUAL(back.section(section).choices(key + "s", "text", {text, text + "x"}).size(), 2u);
    BOOST_REQUIRE_EQUAL(back.written(), file.written());
  }
}

BOOST_AUTO_TEST_CASE(every_kind_of_value_comes_back) {
  for (std::string const text : {
           "a = 1\nb = 'root'\n[c]\nd = 1979-05-27T07:32:00.5-07:00\ne = 1979-05-27\nf = 07:32:00\n"
           "g = 1979-05-27T07:32:00\n",
           "[a.b.c]\nx = 1\n[a]\ny = 2\n[a.b]\nz = [[1, 2], ['x', [true]], []]\n",
           "[[a]]\nx = 1\n[[a]]\ny = {z = {}, \"k k\" = [{}, {w = inf}]}\n",
           "a.\"b.c\".'d\"' = -inf\n\"\" = 0x7fffffffffffffff\n",
           "[a]\n[b.c]\n[d]\n",
       }) {
    auto const file = SceneFile::parse(text, "f");
    BOOST_TEST((toml::parse(file.written()) == toml::parse(text)), text << "\n-- was written as --\n"
                                                                        << file.written());
    BOOST_TEST(SceneFile::parse(file.written(), "f").written() == file.written());
  }
}

BOOST_AUTO_TEST_CASE(keys_of_the_file_come_first_then_overrides_then_defaults) {
  auto const file =
      SceneFile::parse("[run]\nuntil = 1\n[scene]\nz = 1\na = 2\n", "f", {"scene.b=3", "scene.z=4"});
  file.section("scene").set("d", 5L), file.section("scene").set("c", 6L);
  BOOST_TEST(file.written() == "[scene]\na = 2\nb = 3\nz = 4\nd = 5\nc = 6\n\n[run]\nuntil = 1\n");
}

BOOST_AUTO_TEST_SUITE_END()
