#include "program/systems/rods/quantities.hpp"

#include <algorithm>
#include <cmath>

namespace actio::scene {
namespace {

using Vector = rods::Three<double>;
using Kind = Quantity::Kind;

double modulus(Vector const& v) { return std::hypot(v[0], v[1], v[2]); }
Vector minus(Vector const& a, Vector const& b) { return rods::plus_times(a, -1.0, b); }

/// Linear and angular momentum of a frame, and the moduli of what they are sums of.
struct Momenta {
  rods::Impulse sum;
  double linear = 0, angular = 0;
};
Momenta momenta_of(RodMotion const& motion) {
  auto const& frame = motion.frame();
  auto const& constants = motion.rod().constants();
  Momenta out;
  for (std::size_t k = 0; k < frame.places.size(); ++k) {
    auto const p = rods::times(constants.share[k] * constants.section.mass, frame.velocities[k]);
    auto const own = rods::turned(frame.attitudes[k], frame.body_momenta[k]);
    out.sum.add(frame.places[k], p);
    out.sum.angular = bodies::plus(out.sum.angular, own);
    out.linear += modulus(p), out.angular += modulus(frame.places[k]) * modulus(p) + modulus(own);
  }
  return out;
}

/// What momenta are off from those at the start and what came from outside, over what they are sums of.
double noether_balance(RodMotion const& motion) {
  auto const now = motion.rod().momentum(), &from = motion.at_start(), &by = motion.rod().impulse();
  auto const moduli = momenta_of(motion);
  auto const off = [](Vector const& a, Vector const& b, Vector const& c, double size) {
    Vector const gap = minus(minus(a, b), c);
    double const worst = std::max({std::abs(gap[0]), std::abs(gap[1]), std::abs(gap[2])}),
                 unit = size + modulus(b) + modulus(c);
    return worst > 0 ? worst / unit : 0;
  };
  return std::max(off(now.linear, from.linear, by.linear, moduli.linear),
                  off(now.angular, from.angular, by.angular, moduli.angular));
}

std::vector<Quantity> of_the_shape() {
  std::vector<Quantity> out;
  for (std::string const end : {"start", "middle", "end"})
    out.push_back({end + "_place", Kind::vector,
                   end == "middle"
                       ? "Where the section in the middle is; of an even number of sections the one "
                         "behind the middle."
                       : "Where the " + end + " of the rod is; of a ring the " +
                             (end == "start" ? "first" : "last") + " section.",
                   end == "start" ? "x_0"
                   : end == "end" ? "x_n"
                                  : "x_{n/2}",
                   "length", "", Quantity::Shown::as_trajectory});
  for (std::string const end : {"start", "end"})
    out.push_back(
        {end + "_attitude", Kind::quaternion,
         "The unit quaternion, scalar first, that takes the axes of the section at the " + end + " to space.",
         end == "start" ? "q_0" : "q_n", "1"});
  out.push_back(
      {"largest_strains", Kind::list,
       "The largest moduli over all elements of stretch, shear, twist and bend, less those at rest.",
       "\\max|\\Gamma_1|, \\max|\\Gamma_{2,3}|, \\max|\\kappa_1|, \\max|\\kappa_{2,3}|",
       "1, 1, 1/length, 1/length"});
  for (auto const& [name, what, formula, unit] :
       {std::tuple{"contact_force", "force", "R n", "mass length/time^2"},
        {"contact_moment", "moment about the middle of an element", "R m", "mass length^2/time^2"}})
    out.push_back(
        {name, Kind::list,
         std::string("The ") + what +
             " with which the rod beyond acts on that before, in space: in the first element, in the "
             "middle one and in the last.",
         formula, unit});
  return out;
}

std::vector<Quantity> of_sums() {
  return {
      {"kinetic_energy", Kind::scalar, "The kinetic energy of places and turns.",
       "\\tfrac12\\sum_a\\left(m_a|v_a|^2+\\langle M_a,J_a^{-1}M_a\\rangle\\right)", "energy"},
      {"strain_energy", Kind::scalar, "The energy of stretch, shear, twist and bend.",
       "\\tfrac12\\sum_aD_a\\left(\\langle C_N\\Gamma,\\Gamma\\rangle+\\langle C_M\\kappa,\\kappa\\rangle"
       "\\right)",
       "energy"},
      {"potential_energy", Kind::scalar, "That of gravity; it is zero for a rod at the origin.",
       "-\\sum_am_a\\langle g,x_a\\rangle", "energy"},
      Quantity{
          "energy", Kind::scalar,
          "Kinetic energy, strain energy and that of gravity. The steps keep it to the square of the step; "
          "loads and ends that are moved do work.",
          "E", "energy"}
          .from({"kinetic_energy", "strain_energy", "potential_energy"}),
      {"momentum", Kind::vector, "The linear momentum.", "\\sum_am_av_a", "mass length/time"},
      {"angular_momentum", Kind::vector,
       "The angular momentum about the origin, that of the turning sections included, in space.",
       "\\sum_a\\left(x_a\\times m_av_a+R_aM_a\\right)", "energy x time"},
      {"noether_balance", Kind::scalar,
       "The largest component of linear and angular momentum less those at the start and what loads, "
       "supports and gravity have given since, over the sum of the moduli of their parts: zero but for "
       "rounding.",
       "", "1"},
      {"step_limit", Kind::scalar, "The longest step with which small waves along the rod are stable.",
       "2/\\max\\Omega", "time"},
      {"constraint_residual", Kind::scalar,
       "The largest stretch or shear of a rod with constraint = \"unshearable\"; of another one 0.",
       "\\max|\\Gamma-\\Gamma_0|", "1"},
  };
}

void define_shape(QuantityGraph& graph, RodMotion const& motion) {
  std::size_t const sections = motion.rod().sections(), elements = motion.rod().elements();
  auto const put = [](auto const& from, double* to) { std::ranges::copy(from, to); };
  for (auto const& [end, k] :
       {std::pair<std::string, std::size_t>{"start", 0}, {"middle", sections / 2}, {"end", sections - 1}}) {
    graph.define(end + "_place", column_ends(Kind::vector),
                 [&motion, k, put](auto, double* x) { put(motion.frame().places[k], x); });
    if (end != "middle")
      graph.define(end + "_attitude", column_ends(Kind::quaternion),
                   [&motion, k, put](auto, double* q) { put(motion.frame().attitudes[k], q); });
  }
  graph.define("largest_strains", {"_stretch", "_shear", "_twist", "_bend"}, [&motion](auto, double* out) {
    std::fill(out, out + 4, 0);
    for (auto const& [Gamma, kappa] : motion.frame().strains) {
      double const here[] = {std::abs(Gamma[0]), std::hypot(Gamma[1], Gamma[2]), std::abs(kappa[0]),
                             std::hypot(kappa[1], kappa[2])};
      for (std::size_t i = 0; i < 4; ++i) out[i] = std::max(out[i], here[i]);
    }
  });
  std::vector<std::string> ends;
  for (std::string const at : {"_start", "_middle", "_end"})
    for (std::string const& axis : column_ends(Kind::vector)) ends.push_back(at + axis);
  std::array<std::size_t, 3> const which{0, elements / 2, elements - 1};
  graph.define("contact_force", ends, [&motion, which, put](auto, double* out) {
    for (std::size_t i = 0; i < 3; ++i) put(motion.frame().contact_force[which[i]], out + 3 * i);
  });
  graph.define("contact_moment", ends, [&motion, which, put](auto, double* out) {
    for (std::size_t i = 0; i < 3; ++i) put(motion.frame().contact_moment[which[i]], out + 3 * i);
  });
}

}  // namespace

std::vector<Quantity> rod_quantities() {
  auto all = of_the_shape();
  for (auto& quantity : of_sums()) all.push_back(std::move(quantity));
  return all;
}

void define_rod(QuantityGraph& graph, RodMotion const& motion, double longest_step) {
  define_shape(graph, motion);
  auto const energies = [&motion] { return motion.rod().energies(motion.frame()); };
  graph.define("kinetic_energy", {""}, [energies](auto, double* E) { *E = energies().kinetic; });
  graph.define("strain_energy", {""}, [energies](auto, double* E) { *E = energies().strain; });
  graph.define("potential_energy", {""}, [energies](auto, double* E) { *E = energies().gravity; });
  graph.define(
      "energy", {""}, [](auto needs, double* E) { *E = needs[0][0] + needs[1][0] + needs[2][0]; },
      [](auto needs, double const*, std::size_t) {
        return std::abs(needs[0][0]) + std::abs(needs[1][0]) + std::abs(needs[2][0]);
      });
  graph.define(
      "momentum", column_ends(Kind::vector),
      [&motion](auto, double* p) { std::ranges::copy(momenta_of(motion).sum.linear, p); },
      [&motion](auto, double const*, std::size_t) { return momenta_of(motion).linear; });
  graph.define(
      "angular_momentum", column_ends(Kind::vector),
      [&motion](auto, double* p) { std::ranges::copy(momenta_of(motion).sum.angular, p); },
      [&motion](auto, double const*, std::size_t) { return momenta_of(motion).angular; });
  graph.define("noether_balance", {""}, [&motion](auto, double* out) { *out = noether_balance(motion); });
  graph.define("step_limit", {""}, [longest_step](auto, double* h) { *h = longest_step; });
  graph.define("constraint_residual", {""},
               [&motion](auto, double* out) { *out = motion.rod().constraint_residual(); });
}

}  // namespace actio::scene
