// The reader of scenes: what it takes, and where its complaints point.
#include <boost/test/unit_test.hpp>

#include "caught.hpp"
#include "program/document/file.hpp"

using namespace actio::scene;
using actio::testing::message_of;

namespace {

/// What is said where `use` refuses a text; empty where it takes it.
template <class Use>
std::string complaint(std::string const& text, Use const& use,
                      std::vector<std::string> const& overrides = {}) {
  return message_of([&] { use(SceneFile::parse(text, "f", overrides)); });
}
std::string complaint(std::string const& text, std::vector<std::string> const& overrides = {}) {
  return complaint(
      text, [](SceneFile const&) {}, overrides);
}
bool begins(std::string const& text, std::string const& with) { return text.starts_with(with); }

}  // namespace

BOOST_AUTO_TEST_SUITE(scene_file)

BOOST_AUTO_TEST_CASE(numbers_are_read_in_every_way_that_toml_writes_them) {
  auto const table = SceneFile::parse(
                         "[a]\nx = [1, 1.0, 1e0, 0x1, 0b1, 0o1, 1_0e-1, +1]\nbig = 9007199254740993\n"
                         "least = -9223372036854775808\n",
                         "f")
                         .section("a");
  for (double const x : table.numbers("x")) BOOST_TEST(x == 1);
  BOOST_TEST(table.number("big") == 9007199254740992.0);  // rounded as any decimal is
  BOOST_TEST(table.number("least") == -9223372036854775808.0);
}

BOOST_AUTO_TEST_CASE(sections_may_be_written_in_every_way_of_toml) {
  for (std::string const text : {"[a]\nx = 1\n", "a.x = 1\n", "a = {x = 1}\n", "\"a\".'x' = 1",
                                 "\xef\xbb\xbf[a]\r\nx = 1\r\n", "[a] # [b]\nx = 1 # y = 2"})
    BOOST_TEST(SceneFile::parse(text, "f").section("a").number("x") == 1, text);
}

BOOST_AUTO_TEST_CASE(a_wrong_value_is_pointed_at) {
  std::string const text =
      "[a]\nn = 1\nt = 'one'\nl = [1, 2, 'x']\nr = [[1, 2], [3, nan]]\nd = 1979-05-27\nb = true\n";
  auto const said = [&](auto const& use) {
    return complaint(text, [&](SceneFile const& file) { use(file.section("a")); });
  };
  BOOST_TEST(said([](auto a) { a.number("t"); }) == "f:3:5: t: a number is expected, found 'one' (a text)");
  BOOST_TEST(said([](auto a) { a.numbers("l"); }) == "f:4:12: l: a number is expected, found 'x' (a text)");
  BOOST_TEST(said([](auto a) { a.numbers("l", 2); }) == "f:4:5: l: 2 numbers are expected, found 3");
  BOOST_TEST(said([](auto a) { a.numbers("n"); }) == "f:2:5: n: a list of numbers is expected, found 1");
  BOOST_TEST(said([](auto a) { a.matrix("r", 2); }) == "f:5:18: r: a finite number is expected, found nan");
  BOOST_TEST(said([](auto a) { a.matrix("r", 3); }) == "f:5:5: r: 3 rows are expected, found 2");
  BOOST_TEST(said([](auto a) { a.matrix("l", 3); }) ==
             "f:4:6: l: a list of numbers in each row is expected, found 1");
  BOOST_TEST(said([](auto a) { a.text("d"); }) == "f:6:5: d: a text is expected, found a date or a time");
  BOOST_TEST(said([](auto a) { a.integer("n", 2, 5); }) ==
             "f:2:5: n: a whole number from 2 to 5 is expected, found 1");
  BOOST_TEST(said([](auto a) { a.integer("b", 2, 5); }) ==
             "f:7:5: b: a whole number is expected, found true");
  BOOST_TEST(said([](auto a) { a.boolean("n"); }) == "f:2:5: n: true or false is expected, found 1");
  BOOST_TEST(said([](auto a) {
               a.choice("t", "word", {"none", "two"});
             }) == "f:3:5: unknown word 'one'; did you mean 'none'? (known: none, two)");
  BOOST_TEST(said([](auto a) { a.choices("l", "word", {"x"}); }) == "f:4:6: l: a text is expected, found 1");
}

BOOST_AUTO_TEST_CASE(a_missing_key_is_missed_at_its_section_and_a_missing_section_at_the_last_line) {
  auto const number = [](SceneFile const& file) { file.section("a").number("x"); };
  BOOST_TEST(complaint("\n[a]\ny = 1\n", number) == "f:2:1: [a] needs 'x'");
  BOOST_TEST(complaint("[b]\ny = 1\n", number) == "f:2:1: [a] needs 'x'");
  BOOST_TEST(complaint("[b]\ny = 1", number) == "f:2:1: [a] needs 'x'");
  BOOST_TEST(complaint("", number) == "f:1:1: [a] needs 'x'");
  BOOST_TEST(complaint("[b]\ny = 1\n", number, {"a.y=1"}) == "f:2:1: [a] needs 'x'");
}

BOOST_AUTO_TEST_CASE(the_first_unknown_key_is_pointed_at) {
  auto const allow = [](SceneFile const& file) { file.section("a").allow({"title", "seed"}); };
  BOOST_TEST(complaint("[a]\nseed = 1\nzebra = 1\naple = 2\n", allow) ==
             "f:3:1: unknown key of [a] 'zebra' (known: title, seed)");
  BOOST_TEST(complaint("[a]\n  titel = 1\n", allow) ==
             "f:2:3: unknown key of [a] 'titel'; did you mean 'title'? (known: title, seed)");
  BOOST_TEST(complaint("[a]\n\"\\u001b[31m\" = 1\n", allow) ==
             "f:2:1: unknown key of [a] '\\u001b[31m' (known: title, seed)");
  BOOST_TEST(complaint("a.b.c = 1\n", allow) == "f:1:3: unknown key of [a] 'b' (known: title, seed)");
  BOOST_TEST(complaint("[a]\n" + std::string(100000, 'k') + " = 1\n", allow).size() < 200u);
}

BOOST_AUTO_TEST_CASE(a_section_that_is_no_table_is_pointed_at) {
  auto const section = [](SceneFile const& file) { file.section("a"); };
  BOOST_TEST(complaint("a = 1\n", section) == "f:1:5: a: a section [a] is expected, found 1");
  BOOST_TEST(complaint("\n[[a]]\nx = 1\n", section) ==
             "f:2:1: a: a section [a] is expected, found a list of 1");
}

BOOST_AUTO_TEST_CASE(an_override_is_pointed_at_in_its_argument) {
  auto const number = [](SceneFile const& file) { file.section("a").positive("x"); };
  std::string const text = "[a]\nx = 1\n";
  BOOST_TEST(complaint(text, number, {"a.x=2"}) == "");
  BOOST_TEST(complaint(text, number, {"a.x=-2"}) ==
             "--set a.x=-2:1:5: x: a number > 0 is expected, found -2");
  BOOST_TEST(complaint(text, number, {"a.x=two"}) ==
             "--set a.x=two:1:5: x: a number is expected, found 'two' (a text)");
  BOOST_TEST(complaint(text, number, {"a.x = 1e999"}).starts_with("--set a.x = 1e999:1:7: "));
  BOOST_TEST(complaint(text, number, {"a.x.y=1"}) ==
             "--set a.x.y=1:1:3: 'x' is no table, so nothing in it can be set");
  BOOST_TEST(complaint(text, number, {"a=1"}) == "--set a=1:1:3: a: a section [a] is expected, found 1");
  BOOST_TEST(complaint(text, {"a.x"}) == "--set a.x:1:1: KEY=VALUE is expected, for example method.step=0.1");
  BOOST_TEST(complaint(text, {"a.x=1\n[b]"}) == "--set a.x=1\\u000a[b]:1:6: one line is expected");
  BOOST_TEST(complaint(text, [](SceneFile const& file) { file.allow({"a"}); }, {"b.x=1"}) ==
             "--set b.x=1:1:1: unknown section 'b' (known: a)");
  BOOST_TEST(complaint(text, {std::string(100000, 'k')}).size() < 200u);
}

BOOST_AUTO_TEST_CASE(a_table_takes_the_place_of_a_table_however_the_scene_writes_it) {
  for (std::string const text : {"[a]\nb = { x = 1, c = { y = 2 } }\n", "[a.b]\nx = 1\n[a.b.c]\ny = 2\n",
                                 "a.b.x = 1\na.b.c.y = 2\n", "[a]\nb.x = 1\nb.c = { y = 2 }\n"}) {
    auto const changed = [&](std::vector<std::string> const& set) {
      SceneTable const b = SceneFile::parse(text, "f", set).section("a.b");
      return b.name() + (b.has("x") ? " x" : "") + (b.has("c") ? " c" : "") +
             (b.inside("c").has("y") ? " y" : "") + (b.inside("c").has("z") ? " z" : "");
    };
    BOOST_TEST(changed({}) == "a.b x c y", text);
    BOOST_TEST(changed({"a.b={}"}) == "a.b", text);
    BOOST_TEST(changed({"a.b={x = 3}"}) == "a.b x", text);
    BOOST_TEST(changed({"a={b = {c = {z = 1}}}"}) == "a.b c z", text);
    BOOST_TEST(changed({"a.b.c={}"}) == "a.b x c", text);
    BOOST_TEST(changed({"a.b.c={z = 1}"}) == "a.b x c z", text);
    BOOST_TEST(changed({"a.b.c.z=1"}) == "a.b x c y z", text);
    BOOST_TEST(changed({"a.b={}", "a.b.c.z=1"}) == "a.b c z", text);
    BOOST_TEST(changed({"!a.b.c"}) == "a.b x", text);
    BOOST_TEST(changed({"a.b.x={y = 1}"}) == "a.b x c y", text);
  }
}

BOOST_AUTO_TEST_CASE(the_last_override_of_a_key_holds) {
  auto const file = SceneFile::parse("[a]\nx = 1\ny = 2\n", "f", {"a.x=3", "a={x = 4, z = 'w'}", "a.t=word"});
  BOOST_TEST(file.section("a").number("x") == 4);
  BOOST_TEST(!file.section("a").has("y"));
  BOOST_TEST(file.section("a").text("z") == "w");
  BOOST_TEST(file.section("a").text("t") == "word");
}

BOOST_AUTO_TEST_CASE(what_is_no_toml_is_pointed_at) {
  BOOST_TEST(begins(complaint("[a]\nx = 1\nx = 2\n"), "f:3:"));
  BOOST_TEST(begins(complaint("[a]\n[b]\n[a]\n"), "f:3:1: "));
  BOOST_TEST(begins(complaint("[a]\nx = 1e999\n"), "f:2:5: "));
  BOOST_TEST(begins(complaint("[a]\n\"\xc3\xa9\" = 123456789012345678901\n"), "f:2:7: "));
  BOOST_TEST(begins(complaint("[a]\nx = \"open\ny = 1\n"), "f:2:"));
  BOOST_TEST(begins(complaint(std::string("[a]\nx = \"\0\"\n", 11)), "f:2:"));
  BOOST_TEST(complaint("[a]\nx = \"\xc3\xa9\xff\"\n") == "f:2:7: UTF-8 is expected, found the byte 0xff");
  BOOST_TEST(complaint("[a]\n\xc3") == "f:2:1: UTF-8 is expected, found the byte 0xc3");
  BOOST_TEST(complaint("[a]\nx = 1\n y = \"\"\"\nabc\n\n") == "f:3:6: this text in three quotes never ends");
  BOOST_TEST(complaint("[a]\nx = '''\nabc\\'''\ny = '''") == "f:4:5: this text in three quotes never ends");
}

BOOST_AUTO_TEST_CASE(what_would_take_long_or_deep_is_refused) {
  std::string dots = "a";
  for (int k = 0; k < 1000000; ++k) dots += ".a";
  BOOST_TEST(complaint("\n " + dots + " = 1\n") == "f:2:65: at most 32 names may be joined by dots");
  BOOST_TEST(complaint("[" + dots + "]\n") == "f:1:65: at most 32 names may be joined by dots");
  BOOST_TEST(begins(complaint("x = {" + dots + " = 1}\n"), "f:1:"));
  BOOST_TEST(begins(complaint("x = " + std::string(1000000, '[')), "f:1:"));
  BOOST_TEST(complaint(std::string(5 << 20, '\n')) == "f: a scene has at most 4194304 bytes");
  BOOST_TEST(complaint("x = [" + std::string(1000000, ' ') + "]\ns = \"a.b.c\" # " + dots) == "");
}

BOOST_AUTO_TEST_CASE(a_file_that_is_none_is_refused_at_once) {
  auto const said = [](std::string const& path) { return message_of([&] { SceneFile::read(path); }); };
  BOOST_TEST(said("/dev/zero") == "/dev/zero: a scene is expected, this is no ordinary file");
  BOOST_TEST(said("/") == "/: a scene is expected, this is a folder");
  BOOST_TEST(said("") == "'': there is no such file");
  BOOST_TEST(said("/no/such\n") == "/no/such\\u000a: there is no such file");
}

BOOST_AUTO_TEST_SUITE_END()
