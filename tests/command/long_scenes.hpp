// Scenes that take about a second, one of each kind of steps.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "command.hpp"

namespace command {

/// Some tenths of a second of steps, with attitude.
inline std::map<std::string, std::string> const steps{{"order", "2"},
                                                      {"step", "0.25"},
                                                      {"until", "6000000.0"},
                                                      {"every", "500.0"},
                                                      {"quantities", "[\"attitude\", \"energy\"]"}};

/// A scene of about a second.
struct Long {
  char const* name;
  std::string scene;
};
inline std::vector<Long> const& long_scenes() {
  static std::vector<Long> const scenes{
      {"rigid_body, order 2, with attitude", apophis(steps)},
      {"rigid_body, exact", apophis({{"until", "50000.0"},
                                     {"every", "0.25"},
                                     {"quantities", "[\"attitude\", \"spatial_momentum\"]"}})},
      {"rigid_body, natural chart of order 4", apophis({{"name", "\"natural_chart\""},
                                                        {"order", "4"},
                                                        {"until", "100000.0"},
                                                        {"every", "2.5"},
                                                        {"quantities", "[\"attitude\", \"energy\"]"}})},
      {"rigid_body_n",
       "[system]\nkind = \"rigid_body_n\"\nlambda = [1, 2, 3, 4, 5.5]\n[initial]\n"
       "angular_velocity = [0.1, 0.2, 0.3, 0.4, 0.5, -0.1, 0.2, 0.7, -0.3, 0.1]\n[method]\norder = 4\n"
       "step = 0.1\n[run]\nuntil = 8000\nevery = 0.8\n[output]\n"
       "quantities = [\"attitude\", \"momentum\", \"casimir\"]\n"},
      {"heavy_top",
       "[system]\nkind = \"heavy_top\"\nmass = 1\ninertia = [0.6, 0.8, 1]\ncentre_of_mass = [0.1, 0, 0.5]\n"
       "gravity = [0, 0, -9.81]\n[initial]\nangular_velocity = [0.1, 2, 5]\n[method]\norder = 4\n"
       "step = 0.001\n[run]\nuntil = 1000\nevery = 0.05\n[output]\n"
       "quantities = [\"attitude\", \"body_momentum\", \"energy\"]\n"},
      {"rigid_body in a potential that depends on time",
       "[system]\nkind = \"rigid_body\"\ninertia = [0.6, 0.8, 1]\n[system.torque]\n"
       "potential = \"-r33*(1 + 0.5*cos(3*t)) + 0.2*r12^2\"\n[initial]\nangular_velocity = [0.1, 2, 5]\n"
       "[method]\norder = 4\nstep = 0.01\n[run]\nuntil = 2000\nevery = 0.5\n[output]\n"
       "quantities = [\"attitude\", \"body_momentum\", \"energy\"]\n"},
      {"euler_poincare, with a carried vector and a tangent map",
       "[system]\nkind = \"euler_poincare\"\ngroup = \"SO(3)\"\n"
       "lagrangian = \"(w1^2 + 2*w2^2 + 3*w3^2)/2 - gravity3 - 0.1*gravity1^2\"\n"
       "advected = { gravity = [0, 0, -1] }\n[initial]\nvelocity = [0.7, 1, 0.2]\n[method]\norder = 2\n"
       "step = 0.01\n[run]\nuntil = 250\nevery = 0.5\n[output]\n"
       "quantities = [\"velocity\", \"energy\", \"configuration\", \"gravity\", \"tangent_map\"]\n"},
      {"euler_poincare, Galerkin",
       "[system]\nkind = \"euler_poincare\"\ngroup = \"SE(2)\"\n"
       "lagrangian = \"(w^2 + v1^2 + 6*v2^2)/2 + 0.1*w^4\"\n[initial]\nvelocity = [0.7, 1, 0.2]\n[method]\n"
       "name = \"galerkin\"\norder = 4\nstep = 0.1\n[run]\nuntil = 600\nevery = 1\n[output]\n"
       "quantities = [\"velocity\", \"energy\", \"spatial_momentum\"]\n"},
      {"two_bodies, with what is followed on the way",
       "[system]\nkind = \"two_bodies\"\norder = 2\nprimary = { ellipsoid = [400, 395, 340], density = "
       "2170 }\n"
       "secondary = { ellipsoid = [85, 73, 63], density = 2400 }\n[initial]\nposition = [1195, 0, 0]\n"
       "velocity = [0, 0.17, 0]\nsecondary.angular_velocity = [1e-5, 0, 1.4e-4]\n[method]\nstep = "
       "900\n[run]\n"
       "until = 1800000\nevery = 3600\n[output]\n"
       "quantities = [\"position\", \"attitude_2\", \"precession\", \"lyapunov\", \"energy\"]\n"},
      {"incompressible_fluid, a tank",
       "[system]\nkind = \"incompressible_fluid\"\n"
       "mesh = { lower = [0, 0], upper = [1, 0.7], cells = [20, 14] }\n"
       "boundary = { left = \"sliding\", right = \"sliding\", bottom = \"sliding\" }\n"
       "load = { gravity = \"9.81*y\" }\n[initial]\nproject = true\n"
       "velocity = [\"-0.05*sin(pi*X)\", \"0.05*pi*Y*cos(pi*X)\"]\n[method]\nstep = 0.001\n"
       "[run]\nuntil = 4\nevery = 0.01\n"
       "[output]\nquantities = [\"energy\", \"circulation\", \"min_jacobian\"]\n"
       "snapshots = [\"pressure\"]\nsnapshot_every = 1\n"},
      {"fluid_on_sphere",
       "[system]\nkind = \"fluid_on_sphere\"\nmesh = { cells = 10 }\n[initial]\n"
       "stream = \"-0.3*z + 0.1*x*y\"\n[method]\nstep = 0.0005\n[run]\nuntil = 1.5\nevery = 0.005\n"
       "[output]\nquantities = [\"energy\", \"angular_momentum\", \"circulation\", \"iterations\"]\n"
       "snapshots = [\"pressure\"]\nsnapshot_every = 0.5\n"},
      {"rod, loaded and held",
       "[system]\nkind = \"rod\"\nrod = { length = 1, elements = 30, section = { EA = 90, GA = 40, EI = 0.1, "
       "GJ = 0.1, rA = 1, rI = 0.01 } }\nboundary = { start = \"clamped\" }\n"
       "load = { gravity = [0, 0, -1], end_force = [\"0\", \"0.1*sin(3*t)\", \"0\"] }\n[method]\n"
       "step = 0.002\n[run]\nuntil = 300\n"
       "every = 0.5\n[output]\nquantities = [\"end_place\", \"energy\", \"noether_balance\"]\n"
       "snapshots = [\"contact_force\"]\nsnapshot_every = 300\n"},
      {"rod, unshearable",
       "[system]\nkind = \"rod\"\nrod = { length = 1, elements = 30, constraint = \"unshearable\", section "
       "= { EI = 0.1, GJ = 0.1, rA = 1, rI = 1e-3 } }\nboundary = { start = \"pinned\" }\n"
       "load = { gravity = [0, 0, -1] }\n[method]\nstep = 0.00125\n[run]\nuntil = 100\n"
       "every = 0.5\n[output]\n"
       "quantities = [\"end_place\", \"energy\", \"constraint_residual\"]\n"},
      {"vorticity_sphere",
       "[system]\nkind = \"vorticity_sphere\"\nN = 12\nrotation = 0.7\n[initial]\n"
       "harmonics = [[2, 1, 0.9, -0.3], [3, 0, -0.5, 0], [4, 3, 0.4, 0.6], [1, 1, 0.2, 0.1]]\n[method]\n"
       "step = 0.05\n[run]\nuntil = 250\nevery = 0.5\n[output]\n"
       "quantities = [\"energy\", \"angular_momentum\", \"casimirs\", \"spectrum\"]\n"},
      {"vorticity_sphere, Lie-Poisson of order 4",
       "[system]\nkind = \"vorticity_sphere\"\nN = 12\n[initial]\nstate = \"random\"\n[method]\n"
       "name = \"lie_poisson\"\norder = 4\nstep = 0.05\n[run]\nuntil = 50\nevery = 0.5\n[output]\n"
       "quantities = [\"energy\", \"extrema\"]\n"},
      {"vorticity_sphere, a layer",
       "[system]\nkind = \"vorticity_sphere\"\nN = 12\nrotation = 0.7\ndeformation = 0.4\n[initial]\n"
       "state = \"random\"\n[method]\nname = \"energy_casimir\"\nstep = 0.05\n[run]\nuntil = 250\n"
       "every = 0.5\n[output]\nquantities = [\"energy\", \"histogram\", \"splitting\"]\n"},
      {"vorticity_torus",
       "[system]\nkind = \"vorticity_torus\"\nN = 17\n[initial]\nstate = \"random\"\n[method]\n"
       "step = 0.05\n[run]\nuntil = 250\nevery = 0.5\n[output]\n"
       "quantities = [\"energy\", \"casimirs\", \"spectrum\", \"eigenvalue_drift\"]\n"
       "snapshots = [\"u\"]\nsnapshot_every = 250\n"},
      {"vorticity_torus, a layer of order 4 to rounding",
       "[system]\nkind = \"vorticity_torus\"\nN = 13\ndeformation = 0.4\n[initial]\n"
       "vorticity = \"sin(x) + cos(2*y)*cos(x)\"\n[method]\nname = \"lie_poisson\"\norder = 4\n"
       "precision = \"double\"\nstep = 0.1\n[run]\nuntil = 100\nevery = 0.5\n[output]\n"
       "quantities = [\"energy\", \"extrema\"]\n"},
      {"barotropic_fluid, a periodic box by fused steps",
       "[system]\nkind = \"barotropic_fluid\"\n"
       "mesh = { shape = \"box\", lower = [0, 0], upper = [1, 1], cells = [19, "
       "18], periodic = [true, true] }\nmaterial = { name = \"polytropic_gas\", K = 1, gamma = 1.4 }\n"
       "[initial]\nplacement = [\"X + 0.02*sin(2*pi*X)\", \"Y\"]\n[method]\nstep = 0.01\n[run]\n"
       "until = 500\nevery = 1\n[output]\nquantities = [\"energy\", \"momentum\", \"min_jacobian\"]\n"},
      {"elastic_body, a box in space by fused steps",
       "[system]\nkind = \"elastic_body\"\n"
       "mesh = { shape = \"box\", lower = [0, 0, 0], upper = [1, 1, 1], cells = [9, 8, 7], "
       "periodic = [true, false, false] }\nmaterial = { name = \"neo_hookean\", mu = 1, kappa = 2 }\n"
       "[initial]\nvelocity = [\"0.3*sin(2*pi*X)\", \"0.2*Z\", \"-0.2*Y\"]\n[method]\nstep = 0.02\n[run]\n"
       "until = 40\nevery = 0.4\n[output]\nquantities = [\"energy\", \"momentum\"]\n"},
      {"barotropic_fluid with viscosity",
       "[system]\nkind = \"barotropic_fluid\"\n"
       "mesh = { shape = \"box\", lower = [0, 0], upper = [1, 1], cells = [9, "
       "8], periodic = [true, true] }\nmaterial = { name = \"polytropic_gas\", K = 1, gamma = 1.4 }\n"
       "[initial]\nvelocity = [\"0.3*sin(2*pi*X)\", \"0\"]\n[method]\nstep = 0.01\n"
       "viscosity = { linear = 0.5, quadratic = 2 }\n[run]\nuntil = 50\nevery = 0.5\n[output]\n"
       "quantities = [\"energy\", \"dissipated\"]\n"},
      {"elastic_body on a disc that falls, order 4",
       "[system]\nkind = \"elastic_body\"\nmesh = { shape = \"disc\", radius = 1, cells = [2, 4] }\n"
       "material = { name = \"neo_hookean\", mu = 1, kappa = 2 }\nload = { gravity = \"0.1*y\" }\n"
       "[initial]\nplacement = [\"1.1*X\", \"Y\"]\n[method]\norder = 4\nstep = 0.02\n[run]\nuntil = 60\n"
       "every = 0.2\n[output]\nquantities = [\"energy\", \"angular_momentum\"]\n"},
  };
  return scenes;
}

}  // namespace command
