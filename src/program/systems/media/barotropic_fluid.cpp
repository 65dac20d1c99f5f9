// The compressible fluid whose pressure is a function of its density (thesis, chapters 6 to 10).
#include "program/systems/media/system.hpp"

namespace actio::scene {

/// The compressible fluid.
System barotropic_fluid_system() {
  std::string const example = R"scene([system]
kind = "barotropic_fluid"
mesh = { shape = "box", lower = [0, 0], upper = [1, 1], cells = [16, 16], periodic = [true, true] }
material = { name = "polytropic_gas", K = 1, gamma = 2 }
[initial]
placement = ["X + 0.02*sin(2*pi*X)/(2*pi)", "Y"]
velocity = ["0", "0"]
[run]
until = 2
every = 0.01
[output]
quantities = ["energy", "momentum", "min_jacobian"]
)scene";
  return medium_system(
      true, "barotropic_fluid", "Barotropic fluid",
      "A compressible fluid without friction whose pressure is a function of its density, followed "
      "particle by particle: a gas in a box, or against vacuum, on cells that move with it.",
      example);
}

}  // namespace actio::scene
