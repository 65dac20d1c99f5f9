#include "malformed_scenes.hpp"


namespace command {
namespace {

/// What another value is, that a key does not take, and where in it the fault begins.
struct Wrong {
  char const* value;
  char const* says;
  unsigned offset = 0;
};

/// No number, or none that is finite.
constexpr Wrong no_number[] = {{"'fast'", "a number is expected, found 'fast'"},
                               {"true", "found true"},
                               {"[1]", "found a list"},
                               {"{a = 1}", "found a table"},
                               {"1979-05-27", "a date"},
                               {"nan", "finite"},
                               {"inf", "finite"},
                               {"-inf", "finite"},
                               {"1e999", "1e999"},
                               {"123456789012345678901234567890", "64 bits"},
                               {"0xffffffffffffffffff", ""}};
constexpr Wrong no_positive[] = {
    {"0", "> 0"}, {"-0.0", "> 0"}, {"-1", "> 0"}, {"-1e-300", "> 0"}, {"1e-999", "> 0"}};
/// No value at all; where exactly TOML ends is not said.
constexpr char const* no_value[] = {"",
                                    "=",
                                    "1 2",
                                    "tru",
                                    "1.",
                                    ".5",
                                    "1e",
                                    "01",
                                    "1__0",
                                    "0x",
                                    "+-1",
                                    "[1, 2",
                                    "[1, , 2]",
                                    "{a = 1,}",
                                    "{a = 1",
                                    "\"open",
                                    "'open",
                                    "\"\\x41\"",
                                    "\"\\ud800\"",
                                    "\"\\U00110000\"",
                                    "\"a\x01z\"",
                                    "\"a\x7fz\"",
                                    "\"a\xffz\"",
                                    "\"\xc0\xaf\"",
                                    "\"\xed\xa0\x80\"",
                                    "1979-13-01",
                                    "[1] []",
                                    "\"a\" \"b\"",
                                    "12:00:99",
                                    "word",
                                    "\xf0\x9f\x8c\x8d"};

using Scenes = std::vector<Malformed>;

/// Another value for a key that may be left out.
Malformed with_or_more(GoodScene const& scene, std::string const& section, std::string const& key,
                       std::string const& value, std::string const& says, unsigned offset = 0) {
  if (scene.has(key)) return scene.with(key, value, says, offset);
  return scene.with_line(section, key + " = " + value, static_cast<unsigned>(key.size()) + 4 + offset, says);
}

void add_values(Scenes& out, GoodScene const& scene) {
  for (char const* key : {"until", "every", "step", "mass"}) {
    if (!scene.has(key)) continue;
    for (auto const& w : no_number) out.push_back(scene.with(key, w.value, w.says));
    for (auto const& w : no_positive) out.push_back(scene.with(key, w.value, w.says));
  }
  for (char const* key : {"attitude", "angular_velocity", "centre_of_mass", "gravity"}) {
    if (!scene.has(key)) continue;
    for (Wrong const& w : {Wrong{"[]", "found 0"},
                           {"1", "a list of numbers is expected"},
                           {"[1, 2]", "found 2"},
                           {"'x'", "list"},
                           {"[1, 0, 0, 0, 0, 0, 0]", "found 7"}})
      out.push_back(scene.with(key, w.value, w.says));
  }
  for (Wrong const& w :
       {Wrong{"5", "a text is expected"}, {"['a']", "found a list of 1"}, {"1979-05-27", "a date"}}) {
    out.push_back(scene.with("title", w.value, w.says));
    out.push_back(scene.with("kind", w.value, w.says));
  }
}

void add_syntax(Scenes& out, GoodScene const& scene) {
  for (char const* value : no_value) {
    Malformed fault = scene.with("until", value);
    fault.column = 0;
    // A list that does not end is missed behind it.
    if (std::string_view(value) == "[1, 2") fault.line = 0;
    out.push_back(fault);
  }
  for (char const* line :
       {"until 5", "until", "= 5", "[run", "[[run]", "[]", "[run]]", "[a.]", "[.a]", "\"open = 1", "a. = 1",
        "\xc3\xa9 = 1", "a\x1b[31m = 1", "*", "until = 1 # \x01\nuntil = 2"})
    out.push_back(scene.with_line("output", line, 0));
  std::string dots = "a";
  for (int k = 0; k < 100000; ++k) dots += ".a";
  out.push_back(scene.with_line("output", dots + " = 1", 64, "joined by dots"));
  out.push_back(scene.with_line("output", "a = " + std::string(100000, '['), 0, "depth"));
  out.push_back(scene.with_line("output", "a = " + std::string(100000, '{'), 0));
  out.push_back(scene.with_line("output", "a = \"\"\"", 5, "never ends"));
  out.push_back(scene.with_line("output", "a = '''b''", 5, "never ends"));
}

void add_names(Scenes& out, GoodScene const& scene) {
  out.push_back(scene.with("kind", "\"rigid_bdy\"", "did you mean 'rigid_body'?"));
  out.push_back(scene.with("kind", "\"\"", "unknown system"));
  out.push_back(scene.with("kind", "\"\\u001b[2J\"", "\\u001b[2J"));
  out.push_back(scene.with("quantities", "[\"enrgy\"]", "did you mean 'energy'?", 1));
  out.push_back(scene.with("quantities", "[\"energy\", \"casmir\"]", "did you mean 'casimir'?", 11));
  out.push_back(scene.with("quantities", "[\"energy\", \"energy\"]", "twice", 11));
  out.push_back(scene.with("quantities", "[]", "at least one quantity"));
  out.push_back(scene.with("quantities", "\"energy\"", "a list of texts"));
  out.push_back(scene.with("quantities", "[[\"energy\"]]", "a text is expected", 1));
  out.push_back(scene.with("quantities", "[\"" + std::string(100000, 'e') + "\"]", "unknown quantity", 1));
  out.push_back(with_or_more(scene, "output", "formats", "[\"cvs\"]", "did you mean 'csv'?", 1));
  out.push_back(with_or_more(scene, "output", "formats", "[]", "at least one format"));
  out.push_back(with_or_more(scene, "output", "plots", "1", "true or false"));
  out.push_back(scene.with_line("output", "quantites = []", 1, "did you mean 'quantities'?"));
  out.push_back(scene.with_line("run", "untill = 1", 1, "did you mean 'until'?"));
  out.push_back(scene.with_line("system", "knd = 1", 1, "did you mean 'kind'?"));
  out.push_back(scene.with_line("system", "\"k\xc3\xafnd\" = 1", 1, "k\xc3\xafnd"));
  out.push_back(scene.with_line("initial", "atitude = [1, 0, 0, 0]", 1, "did you mean 'attitude'?"));
  out.push_back(scene.with_line("initial", "\"\\u001b]0;x\\u0007\" = 1", 1, "\\u001b]0;x\\u0007"));
  out.push_back(scene.with_line("method", "ordr = 2", 1, "did you mean 'order'?"));
  if (scene.has("step")) out.push_back(scene.with_line_instead("step", "step.size = 2", 1, "found a table"));
  out.push_back(scene.with_line("scene", "seeds = 2", 1, "did you mean 'seed'?"));
  for (char const* seed : {"1.0", "-1", "'x'"})
    out.push_back(with_or_more(scene, "scene", "seed", seed, "whole number"));
  if (scene.has("body")) out.push_back(scene.with("body", "\"apophiss\"", "did you mean 'apophis'?"));
  if (scene.has("name")) out.push_back(scene.with("name", "\"runge_kutta\"", "unknown method"));
  if (scene.has("order"))
    for (char const* order : {"3", "0", "-2", "1000", "2.0", "\"exactly\"", "[2]", "true"})
      out.push_back(scene.with("order", order));
}

void add_sections(Scenes& out, GoodScene const& scene) {
  for (char const* section : {"scene", "system", "initial", "method", "run", "output"}) {
    std::string const name = section;
    if (scene.has("[" + name + "]")) {
      // twice
      out.push_back(scene.with_line("output", "[" + name + "]", 1));
      out.push_back(scene.with_line_instead("[" + name + "]", "[[" + name + "]]", 1,
                                            "a section [" + name + "] is expected"));
    }
    out.push_back(scene.overridden(name, "3", "a section [" + name + "] is expected, found 3"));
  }
  out.push_back(scene.with_line("output", "[sytem]", 2, "unknown section 'sytem'; did you mean 'system'?"));
  out.push_back(scene.without_section("system", "[system] needs 'kind'"));
  out.push_back(scene.without_section("run", "[run] needs 'until'"));
  out.push_back(scene.without_section("output", "[output] needs 'quantities'"));
  for (char const* key : {"kind", "until", "quantities"}) out.push_back(scene.without(key));
  for (char const* key : {"angular_velocity", "mass", "gravity", "centre_of_mass", "inertia", "lambda"})
    if (scene.has(key)) out.push_back(scene.without(key));
}

void add_times(Scenes& out, GoodScene const& scene) {
  auto const at = [&](std::string const& list, std::string const& says, unsigned offset) {
    Malformed fault = scene.with_line_instead("every", "at = " + list, 6 + offset, says);
    out.push_back(fault);
  };
  at("[]", "at least one time", 0);
  at("[0, 1, 1]", "later than the one before", 7);
  at("[0, 1, 0.5]", "later than the one before", 7);
  at("[-1, 1]", "found -1", 1);
  at("[0, 1e9]", "found 1000000000", 4);
  at("[0, nan]", "finite", 4);
  at("5", "a list of numbers", 0);
  out.push_back(scene.with_line("run", "at = [0, 1]", 6, "exclude each other"));
  out.push_back(scene.with("every", "1e-30", "2^53"));
  if (scene.has("step") && !scene.is_exact()) {
    out.push_back(scene.with("step", "0.0123456789", "the nearest step that would do is "));
    out.push_back(scene.with("step", "1e-30", "2^53"));
  }
}

void add_bodies(Scenes& out, GoodScene const& scene) {
  if (scene.has("attitude")) {
    out.push_back(scene.with("attitude", "[1.000000002, 0, 0, 0]", "normalised it is [1, 0, 0, 0]"));
    out.push_back(scene.with("attitude", "[3, 0, 4, 0]", "normalised it is [0.6, 0, 0.8, 0]"));
    out.push_back(scene.with("attitude", "[0, 0, 0, 0]", "its length is 0"));
    out.push_back(scene.with("attitude", "[1, 0, inf, 0]", "finite", 7));
    out.push_back(scene.with("angular_velocity", "[1e300, 1e300, 1e300]", "too large"));
    out.push_back(scene.with("angular_velocity", "[1, 'x', 1]", "a number is expected", 4));
    out.push_back(scene.with_line("initial", "angular_momentum = [1, 0, 0]", 20, "exclude each other"));
  }
  auto const inertia = [&](std::string const& value, std::string const& says, unsigned offset = 0) {
    if (scene.has("inertia"))
      out.push_back(scene.with("inertia", value, says, offset));
    else if (scene.has("body"))
      out.push_back(scene.with_line_instead("body", "inertia = " + value, 11 + offset, says));
  };
  inertia("[1, 2, 3.1]", "triangle inequality");
  inertia("[1, 2, -1]", "inertia: ");
  inertia("[0, 1, 1]", "inertia: ");
  inertia("[[1, 0.1, 0], [0, 1, 0], [0, 0, 1]]", "symmetric");
  inertia("[[1, 0, 0], [0, 1, 0]]", "3 rows are expected, found 2");
  inertia("[[1, 0, 0], [0, 1], [0, 0, 1]]", "3 numbers are expected, found 2", 12);
  inertia("[[1, 0, 0], [0, nan, 0], [0, 0, 1]]", "finite", 16);
  inertia("[1, 2, [3]]", "a number is expected", 7);
  inertia("[1, 2]", "3 numbers are expected, found 2");
  if (scene.has("body"))
    out.push_back(scene.with_line("system", "inertia = [1, 1, 1]", 11, "exclude each other"));
  if (scene.has("lambda"))
    for (char const* lambda :
         {"[]", "[1]", "[1, -2, 3, 4]", "[1, 2, 'x', 4]", "[1, nan, 3, 4]", "[[1]]", "4"}) {
      Malformed fault = scene.with("lambda", lambda);
      fault.column = 0;
      out.push_back(fault);
    }
}

void add_overrides(Scenes& out, GoodScene const& scene) {
  out.push_back(scene.overridden("run.until", "-1", "> 0"));
  out.push_back(scene.overridden("run.until", "1e999", "1e999"));
  out.push_back(scene.overridden("run.until", "soon", "found 'soon'"));
  out.push_back(scene.overridden("run.until.x", "1", ""));
  out.back().column = 5;
  out.push_back(scene.overridden("rnu.until", "1", "did you mean 'run'?"));
  out.back().column = 1;
  out.push_back(
      scene.overridden("output.quantities", "[\"energy\", \"enrgy\"]", "did you mean 'energy'?", 11));
  out.push_back(scene.overridden("scene.title", "\"open", ""));
  out.back().column = 0;
  out.push_back(scene.overridden("scene.title", "two words", "", 1));
  out.push_back(scene.overridden("system.kind", "rigid_bodi", "did you mean 'rigid_body'?"));
  out.push_back(scene.overridden("run.at", "[1, 1]", "exclude each other"));
  for (char const* argument : {"run.until", "=1", "run.until=1\nx=2", "run.\x1b[31m=1", "run.\xff=1", ""})
    out.push_back({scene.name + ", --set alone", scene.text(), {argument}, 0, 0});
}

/// Files that are no scene at all.
void add_files(Scenes& out, GoodScene const& scene, std::mt19937& random) {
  out.push_back({"nothing", "", {}, 1, 1, "[system] needs 'kind'"});
  out.push_back({"blank lines", "\n\n \n", {}, 3, 1, "[system] needs 'kind'"});
  out.push_back({"a mark of the order of bytes alone", "\xef\xbb\xbf", {}, 1, 1, "[system] needs 'kind'"});
  out.push_back({"a comment", "# nothing\n", {}, 1, 1, "[system] needs 'kind'"});
  out.push_back({"a program",
                 std::string("\x7f"
                             "ELF\2\1\1\0\0\0\0\0",
                             12),
                 {},
                 1,
                 0});
  out.push_back({"a compressed file", std::string("\x1f\x8b\x08\0\0\0\0\0\0\x03", 10), {}, 1, 0});
  out.push_back({"JSON", "{\"system\": {\"kind\": \"rigid_body\"}}\n", {}, 1, 1});
  out.push_back({"a carriage return alone", "a = 1\rb = 2\n", {}, 1, 0});
  out.push_back({"zeros", std::string(100000, '\0'), {}, 1, 0});
  out.push_back({"as large as a scene may be",
                 scene.text() + std::string((4 << 20) - scene.text().size(), '\n'),
                 {},
                 0,
                 0});
  out.back().text.replace(out.back().text.size() - 8, 8, "[a]\nb=1\n");
  out.push_back(
      {"20 MB of numbers", "x = [" + std::string(20 << 20, '1') + "]\n", {}, 0, 0, "4194304 bytes"});
  std::string wide;
  for (char const c : scene.text()) wide += {c, '\0'};
  out.push_back({"two bytes a letter", "\xff\xfe" + wide, {}, 1, 0});
  for (int k = 0; k < 8; ++k) {
    std::string noise = "\x01";
    while (noise.size() < 2000) noise += static_cast<char>(random());
    out.push_back({"noise", noise, {}, 1, 0});
  }
}

}  // namespace

std::vector<Malformed> malformed_scenes(std::vector<GoodScene> const& scenes, unsigned seed) {
  std::mt19937 random(seed);
  Scenes out;
  for (auto const& scene : scenes) {
    add_values(out, scene), add_names(out, scene), add_sections(out, scene), add_times(out, scene),
        add_bodies(out, scene), add_overrides(out, scene);
    for (char const byte : {'\x01', '\0', '\x7f', '\xff', '\x0c'})
      out.push_back(scene.with_byte(byte, random));
  }
  // The reader of TOML knows no systems: one scene is as good as another.
  add_syntax(out, scenes.front());
  add_files(out, scenes.front(), random);
  return out;
}

}  // namespace command
