// The records of the keys of [system] and [initial] of a flow on the sphere.
#include "program/systems/sphere/input.hpp"
#include "program/systems/sphere/named_states.hpp"

namespace actio::scene {
namespace {

std::string const other_starts = "or initial.harmonics or initial.file";

/// That of the table of a named state.
Parameter table(std::string const& name, std::string const& meaning, std::string const& example) {
  return {"initial." + name, "a table", other_starts, meaning, "", example};
}

std::vector<Parameter> parameters_of_sphere() {
  return {
      {"system.N", "a whole number, 2 or more", "needed",
       "The size of the matrices: functions have the degrees 0 to N - 1. Time grows with N^3 "
       "and memory with N^2; interactions of waves of the degree l are those of the sphere but "
       "for a part of about l^4/(6 N^2).",
       "", "64"},
      {"system.rotation", "a number", "0",
       "The angular velocity of the sphere about the pole. The flow is told relative to the sphere, d "
       "zeta/dt + u . grad(zeta + 2 rotation cos(theta)) = 0.",
       "1/time", "1.0"},
  };
}

std::vector<Parameter> parameters_of_start() {
  return {
      {"initial.harmonics", "a list of rows of four numbers: l, m, re, im",
       "or initial.file or initial.state",
       "The coefficients of the vorticity relative to the sphere, in orthonormal complex spherical "
       "harmonics with the Condon-Shortley phase. 0 <= m <= l, 1 <= l < N; those of -m follow, since the "
       "field is real. What is left out is zero.",
       "1/time", "[[5, 3, 0.2, 0.1], [1, 0, 0.5, 0.0]]"},
      {"initial.file", "a text, the path of a file beside the scene", "or initial.harmonics or initial.state",
       "The same as a file with the heading l,m,re,im, as snapshots write it: every order of "
       "every degree up to the last one.",
       "", "\"vorticity.csv\""},
      {"initial.state", "a text", other_starts,
       "A flow by its name; its parameters are in a table of that name, for instance [initial.random] with "
       "lmax = 10, and where there is such a table it names the state.",
       "", "\"random\"", names_of_states()},
  };
}

std::vector<Parameter> parameters_of_waves() {
  return {
      table("rossby_haurwitz",
            "A wave of one degree on a zonal rotation, for which the exact motion is known: relative to "
            "the sphere it turns about the pole with the angular velocity a - ((2 + gamma) a + 2 "
            "rotation)/(l (l + 1) + gamma), a = zonal_rate; gamma is zero but for a layer.",
            "{ degree = 5, order = 4 }"),
      {"initial.rossby_haurwitz.degree", "a whole number, 1 to N - 1", "5", "The degree l of the wave.", "",
       "5"},
      {"initial.rossby_haurwitz.order", "a whole number, 0 to the degree", "4, or the degree", "Its order m.",
       "", "4"},
      {"initial.rossby_haurwitz.amplitude", "a number", "1",
       "The coefficient of Y_lm, as in initial.harmonics.", "1/time", "1"},
      {"initial.rossby_haurwitz.zonal_rate", "a number", "0",
       "The angular velocity a of the rotation that the fluid has beside that of the sphere.", "1/time",
       "0.5"},
      table("rossby_haurwitz_4",
            "The wave with four crests of Williamson's case 6, of the degree 5 and the order 4: the "
            "Laplacian of psi is 2 a sin(phi) - 30 K sin(phi) cos(phi)^4 cos(4 lambda).",
            "{ amplitude = 1 }"),
      {"initial.rossby_haurwitz_4.amplitude", "a number",
       "0.1076 of the rotation, as in case 6; without one 1", "K.", "1/time", "1"},
      {"initial.rossby_haurwitz_4.zonal_rate", "a number",
       "0.1076 of the rotation, as in case 6; without one 1", "a.", "1/time", "1"},
  };
}

/// Energy and enstrophy of a random flow.
std::vector<Parameter> parameters_of_strength(std::string const& state) {
  std::string const name = "initial." + state;
  return {
      {name + ".energy", "a number, 0 or more", "or " + name + ".enstrophy; with neither, 1",
       "The energy of the flow.", "1/time^2", "1"},
      {name + ".enstrophy", "a number, 0 or more", "or " + name + ".energy",
       "Its enstrophy, in the place of the energy.", "1/time^2", "10"},
  };
}

std::vector<Parameter> parameters_of_random_flow() {
  return {
      table("random", "Random coefficients, normally distributed, from scene.seed.", "{ lmax = 10 }"),
      {"initial.random.lmin", "a whole number, 1 to lmax", "1", "The first degree.", "", "2"},
      {"initial.random.lmax", "a whole number, 1 to N - 1", "10, or N - 1", "The last degree.", "", "10"},
      {"initial.random.slope", "an exponent, -100 to 100", "0",
       "The energy in the degree l is on average proportional to this power of l.", "", "-3"},
  };
}

std::vector<Parameter> parameters_of_ring() {
  return {
      table("ring",
            "Random coefficients around one degree, from which turbulence grows: the energy in the degree "
            "l is on average proportional to exp(-(l - degree)^2/(2 width^2)).",
            "{ degree = 12 }"),
      {"initial.ring.degree", "a whole number, 1 to N - 1", "N/4", "The degree in the middle.", "", "12"},
      {"initial.ring.width", "a real > 0, in degrees l", "1", "How far the energy reaches on either side.",
       "", "2"},
  };
}

std::vector<Parameter> parameters_of_jet() {
  return {
      table("zonal_jet",
            "A jet towards the east along a circle of latitude, with the profile of Galewsky, Scott and "
            "Polvani (2004); theirs has the speed 0.1722 in units of the rotation.",
            "{ speed = 1, perturbation = 0.1 }"),
      {"initial.zonal_jet.speed", "a number", "1", "The largest velocity, in radii of the sphere.", "1/time",
       "1"},
      {"initial.zonal_jet.south", "a number from -pi/2 to pi/2", "pi/7", "The latitude where the jet begins.",
       "radians", "0.4487989505128276"},
      {"initial.zonal_jet.north", "a number from -pi/2 to pi/2", "5 pi/14", "The latitude where it ends.",
       "radians", "1.121997376282069"},
      {"initial.zonal_jet.perturbation", "a number", "0",
       "The height p of a patch on the jet, which the Laplacian of psi has besides: p cos(phi) exp(-(3 "
       "lambda)^2) exp(-(15 (phi - pi/4))^2).",
       "1/time", "0.1"},
  };
}

std::vector<Parameter> parameters_of_vortices() {
  return {
      table("blobs", "Rounded patches of vorticity; their mean is taken out.",
            "{ rows = [[0, 0.4, 0.3, 1], [0.9, 0.4, 0.3, 1]] }"),
      {"initial.blobs.rows", "a list of rows of four numbers: longitude, latitude, width, strength",
       "three blobs",
       "For each the vorticity strength exp(-(1 - cos(gamma))/width^2) at the angle gamma from its centre.",
       "radians, and 1/time", "[[0, 0.4, 0.3, 1], [0.9, 0.4, 0.3, 1]]"},
      table("point_vortices",
            "Vortices as narrow as matrices of the size N have them, about 1/sqrt(N) "
            "radians; their mean is taken out.",
            "{ rows = [[0, 0.4, 1], [1, -0.2, 1]] }"),
      {"initial.point_vortices.rows", "a list of rows of three numbers: longitude, latitude, circulation",
       "three vortices", "For each where it is, and the integral of its vorticity.", "radians, and 1/time",
       "[[0, 0.4, 1], [1, -0.2, 1]]"},
  };
}

}  // namespace

std::vector<Parameter> vorticity_parameters() {
  std::vector<Parameter> all;
  for (auto&& part :
       {parameters_of_sphere(), hamiltonian_parameters(), parameters_of_start(), parameters_of_waves(),
        parameters_of_random_flow(), parameters_of_strength("random"), parameters_of_ring(),
        parameters_of_strength("ring"), parameters_of_jet(), parameters_of_vortices()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace actio::scene
