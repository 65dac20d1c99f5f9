// Scenes of bodies in n dimensions, and their tables.
#pragma once

#include <sstream>
#include <stdexcept>

#include "square.hpp"

namespace command {

inline std::string listed(Numbers const& numbers) {
  std::ostringstream out;
  out.precision(17);
  for (double const x : numbers) out << (out.tellp() > 0 ? ", " : "[") << x;
  return out.str() + "]";
}
inline std::string listed(Square const& rows) {
  std::string out;
  for (auto const& row : rows) out += (out.empty() ? "[" : ", ") + listed(row);
  return out + "]";
}
inline std::string number(double x) {
  std::string const text = listed(Numbers{x});
  return text.substr(1, text.size() - 2);
}

/// A body, how it turns, and what is wanted of it.
struct BodyN {
  Numbers lambda, velocity;
  std::string method = "moser_veselov", step = {}, until = "2", every = "0.5", quantities = "\"momentum\"",
              attitude = {}, order = {};
  int n() const { return static_cast<int>(lambda.size()); }
  std::string text() const {
    return "[system]\nkind = \"rigid_body_n\"\nlambda = " + listed(lambda) +
           "\n[initial]\nangular_velocity = " + listed(velocity) + "\n" +
           (attitude.empty() ? "" : "attitude = " + attitude + "\n") + "[method]\nname = \"" + method +
           "\"\n" + (order.empty() ? "" : "order = " + order + "\n") +
           (step.empty() ? "" : "step = " + step + "\n") + "[run]\nuntil = " + until + "\nevery = " + every +
           "\n[output]\nquantities = [" + quantities + "]\n";
  }
};
inline BodyN body_in_four(std::string method = "moser_veselov") {
  return {{1, 2, 3, 4}, {0.9, -0.2, 0.3, 0.1, 0.4, -0.5}, std::move(method)};
}
inline BodyN body_in_eight(std::string method = "moser_veselov") {
  BodyN body{{}, {}, std::move(method)};
  for (int i = 0; i < 8; ++i) body.lambda.push_back(1 + i / 4.0);
  for (int a = 0; a < 28; ++a) body.velocity.push_back(0.3 * std::sin(1 + 2 * a));
  return body;
}

/// The table of a scene that runs.
inline Table table_of(std::string const& scene) {
  Folder const folder;
  auto const outcome = actio({"run", folder.write("body.toml", scene), "--out", folder / "out"});
  if (outcome.status != 0) throw std::runtime_error(outcome.err);
  return read_csv(folder / "out/series.csv");
}

}  // namespace command
