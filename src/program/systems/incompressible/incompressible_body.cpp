// The incompressible solid (thesis, chapter 8).
#include "program/systems/incompressible/system.hpp"

namespace actio::scene {

/// The incompressible solid.
System incompressible_body_system() {
  std::string const example = R"scene([system]
kind = "incompressible_body"
mesh = { shape = "box", lower = [-1, -0.5], upper = [1, 0.5], cells = [16, 8] }
material = { name = "neo_hookean", mu = 1, kappa = 0 }
[initial]
velocity = ["1 + 0.3*X - 0.5*Y", "1 + 0.5*X - 0.3*Y"]
project = true
[run]
until = 4
every = 0.02
[output]
quantities = ["energy", "momentum", "angular_momentum", "volume_defect"]
)scene";
  return incompressible_system(
      false, "incompressible_body", "Incompressible body",
      "A hyperelastic solid that keeps the volume of every cell, as rubber nearly does, at any strain and "
      "rotation: the pressure in it is a multiplier, and no step follows its sound.",
      example);
}

}  // namespace actio::scene
