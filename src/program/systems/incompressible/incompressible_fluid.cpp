// The incompressible fluid (thesis, chapter 8).
#include "program/systems/incompressible/system.hpp"

namespace actio::scene {

/// The incompressible fluid.
System incompressible_fluid_system() {
  std::string const example = R"scene([system]
kind = "incompressible_fluid"
mesh = { shape = "box", lower = [0, 0], upper = [1, 0.7], cells = [16, 11] }
boundary = { left = "sliding", right = "sliding", bottom = "sliding" }
load = { gravity = "9.81*y" }
[initial]
velocity = ["-0.1*sin(pi*X)", "0.1*pi*Y*cos(pi*X)"]
project = true
[run]
until = 2
every = 0.02
[output]
quantities = ["energy", "volume_defect", "min_jacobian"]
)scene";
  return incompressible_system(
      true, "incompressible_fluid", "Incompressible fluid",
      "A fluid without friction and without sound: the volume of every cell is kept, and the pressure is "
      "what keeps it. It sloshes, turns in a box, or flies as a drop, on cells that move with it.",
      example);
}

}  // namespace actio::scene
