// The hyperelastic solid (thesis, chapters 6 to 10).
#include "program/systems/media/system.hpp"

namespace actio::scene {

/// The hyperelastic solid.
System elastic_body_system() {
  std::string const example = R"scene([system]
kind = "elastic_body"
mesh = { shape = "box", lower = [-1, -0.5], upper = [1, 0.5], cells = [16, 8] }
material = { name = "neo_hookean", mu = 1, kappa = 2 }
[initial]
placement = ["X", "Y"]
velocity = ["1 - 0.5*Y", "1 + 0.5*X + 0.2*Y"]
[run]
until = 4
every = 0.02
[output]
quantities = ["energy", "momentum", "angular_momentum", "min_jacobian"]
)scene";
  return medium_system(false, "elastic_body", "Elastic body",
                       "A hyperelastic solid at any strain and rotation, on cells that move with it.",
                       example);
}

}  // namespace actio::scene
