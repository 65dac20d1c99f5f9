#include "program/systems/incompressible/sphere_start.hpp"

#include <cmath>

#include "actio/formula/tape_derivatives.hpp"
#include "program/document/key.hpp"
#include "program/systems/formula.hpp"

namespace actio::scene {
namespace {

struct SphereStartKeys : KeyTable {
  AnyKey velocity =
      key("velocity", "three texts, each a formula in x, y, z", LeftOut{"or initial.stream"},
          "The components of the velocity at the point x, y, z of the unit sphere. What points out of the "
          "sphere or changes the area of a cell is taken from it, and a remark says how much.",
          "[\"-y\", \"x\", \"0\"]");
  AnyKey stream =
      key("stream", "a text, a formula in x, y, z", LeftOut{"or initial.velocity"},
          "A stream function psi on the unit sphere, smooth: the velocity is x cross grad psi. -0.5*z "
          "turns about the third axis with the angular velocity 0.5, as in vorticity_sphere.",
          "\"-0.5*z + 0.1*x*y\"");
} const keys{{"initial"}};

std::vector<std::string> const variables{"x", "y", "z"};

}  // namespace

std::vector<Parameter> sphere_start_records() { return keys.records(); }

SphereStart::SphereStart(SceneFile const& file)
    : initial_(file.section("initial")), stream_(keys.stream.given(file)) {
  key_ = stream_ ? keys.stream.name() : keys.velocity.name();
  if (stream_ && keys.velocity.given(file))
    keys.stream.fail(file, "initial.velocity says the same: one of them is enough");
  if (!stream_ && !keys.velocity.given(file))
    throw SceneError(initial_.place(), "initial.velocity or initial.stream is needed: how the fluid starts");
  if (stream_) {
    std::string const text = initial_.formula(key_);
    auto const place = initial_.text_place(key_);
    Tape const value = scene_formula(text, variables, {}, place, key_).value;
    try {
      tape_ = with_gradient(value, {0, 1, 2});
    } catch (Error const& error) {
      place.fail(text, 0, key_ + ": " + error.what());
    }
    return;
  }
  auto const texts = initial_.formulas(key_);
  if (texts.size() != 3)
    keys.velocity.fail(file, fmt::format("three formulas in x, y, z are expected, found {}", texts.size()));
  std::vector<Tape> parts;
  for (std::size_t k = 0; k < 3; ++k)
    parts.push_back(
        scene_formula(texts[k], variables, {}, initial_.text_place(key_, k), key_, for_values).value);
  tape_ = joined(parts);
}

std::array<double, 3> SphereStart::operator()(std::array<double, 3> const& x) const {
  thread_local std::vector<double> work;
  double out[4];
  tape_(x.data(), out, work);
  std::array<double, 3> v{out[0], out[1], out[2]};
  if (stream_)
    for (std::size_t a = 0; a < 3; ++a) {
      std::size_t const b = (a + 1) % 3, c = (a + 2) % 3;
      v[a] = x[b] * out[1 + c] - x[c] * out[1 + b];
    }
  for (double const one : v)
    if (!std::isfinite(one))
      initial_.fail(key_, fmt::format("{}: a finite velocity is expected, found {} at x = {}, y = {}, z = {}",
                                      key_, std::isnan(one) ? std::abs(one) : one, x[0], x[1], x[2]));
  return v;
}

}  // namespace actio::scene
