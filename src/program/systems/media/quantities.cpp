#include "program/systems/media/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "program/systems/media/points.hpp"

namespace actio::scene {
namespace {

using Kind = Quantity::Kind;

/// The square of the speed of sound along a dilation of the undeformed body.
template <int d>
double sound_squared(media::StoredEnergy<d> const& law, double density) {
  Matrix<double, d, d> const one = Matrix<double, d, d>::Identity(), P = law.stress(one),
                             rate = law.stress_rate(one, one);
  double sum = 0;
  for (int k = 0; k < d; ++k) sum += rate(k, k) - (d - 1) * P(k, k);
  return std::max(0.0, sum / (d * d) * law.weight(density) / density);
}

/// Places and velocities of the nodes, read once for all quantities of a row, and only where one needs them.
template <int d>
class Observed {
 public:
  using Place = std::array<double, d>;
  explicit Observed(MediumView<d> const& medium) : medium_(medium) {}
  MediumView<d> const& medium() const { return medium_; }
  MediumMotion<d> const& motion() const { return *medium_.motion; }
  std::vector<Place> const& places() {
    forget_older();
    if (x_.empty()) x_ = motion().places();
    return x_;
  }
  std::vector<Place> const& velocities() {
    forget_older();
    if (v_.empty()) v_ = motion().velocities();
    return v_;
  }
  /// `visit(mass, place, velocity)` of each node; of two and one dimensions the other components are zero.
  template <class Visit>
  void for_nodes(Visit const& visit) {
    // They take more room while they are made than places do.
    velocities(), places();
    for (std::size_t k = 0; k < x_.size(); ++k) {
      std::array<double, 3> x{}, v{};
      std::copy_n(x_[k].begin(), d, x.begin()), std::copy_n(v_[k].begin(), d, v.begin());
      visit(motion().mass(k), x, v);
    }
  }
  /// The speed of sound in the body where it is not deformed, of the mean density: what moves by much less
  /// than that, over a rounding, is at rest.
  double sound() {
    if (sound_) return *sound_;
    auto const& cells = motion().cells();
    std::size_t const apart = 1 + cells.nodes() / 1000;
    double mass = 0, sum = 0;
    for (std::size_t k = 0; k < cells.nodes(); k += apart)
      mass += motion().mass(k), sum += motion().mass(k) * medium_.density(cells.reference(k));
    return sound_.emplace(sum > 0 ? std::sqrt(sound_squared(*medium_.law, sum / mass)) : 0);
  }
  /// The unit of something that is linear in the velocities.
  /// @param per_speed  what it is made of, for each unit of velocity
  QuantityGraph::Unit unit(double terms, double per_speed) {
    return {terms, rounding * per_speed * sound(), per_speed * sound()};
  }
  /// Of energies. What is stored where nothing moves is rounding, of terms that cancel.
  QuantityGraph::Unit unit(media::BodyEnergies const& e) {
    double mass = 0;
    for (std::size_t k = 0; k < motion().cells().nodes(); ++k) mass += motion().mass(k);
    double const at_rest = mass * sound() * sound(), sum = e.kinetic + std::abs(e.stored) + std::abs(e.loads);
    bool const rests = e.kinetic <= rounding * rounding * at_rest && sum <= 1e-13 * at_rest;
    return {rests ? 0 : sum, 0, at_rest};
  }

 private:
  void forget_older() {
    std::pair const now{motion().steps(), motion().ahead()};
    if (seen_ != now) x_ = {}, v_ = {}, seen_ = now;
  }
  /// Forces are rounded to 1e-16 of the stiffness, and these roundings are added up over many steps.
  static constexpr double rounding = 1e-12;

  MediumView<d> medium_;
  std::optional<double> sound_;
  std::vector<Place> x_, v_;
  std::pair<long, double> seen_{-1, 0};  // the steps, and the time since, after which they were read
};

template <int d>
using Seen = std::shared_ptr<Observed<d>>;

double length_of(std::array<double, 3> const& a) { return std::hypot(a[0], a[1], a[2]); }

template <int d>
void define_momentum(QuantityGraph& graph, Seen<d> const& seen) {
  std::vector<std::string> ends{"_x", "_y", "_z"};
  ends.resize(d);
  graph.define(
      "momentum", ends,
      [seen](auto, double* out) {
        std::fill_n(out, d, 0.0);
        seen->for_nodes([&](double m, auto const&, auto const& v) {
          for (std::size_t a = 0; a < d; ++a) out[a] += m * v[a];
        });
      },
      [seen](auto, double const*, std::size_t) {
        double sum = 0, mass = 0;
        seen->for_nodes([&](double m, auto const&, auto const& v) { sum += m * length_of(v), mass += m; });
        return seen->unit(sum, mass);
      });
}
template <int d>
void define_angular_momentum(QuantityGraph& graph, Seen<d> const& seen) {
  // On a line there is none: the zero has a column all the same.
  graph.define(
      "angular_momentum",
      d == 3 ? std::vector<std::string>{"_x", "_y", "_z"} : std::vector<std::string>{"_z"},
      [seen](auto, double* out) {
        double sum[3] = {};
        seen->for_nodes([&](double m, auto const& x, auto const& v) {
          for (std::size_t a = 0; a < 3; ++a) {
            std::size_t const b = (a + 1) % 3, c = (a + 2) % 3;
            sum[a] += m * (x[b] * v[c] - x[c] * v[b]);
          }
        });
        std::copy_n(d == 3 ? sum : sum + 2, d == 3 ? 3 : 1, out);
      },
      [seen](auto, double const*, std::size_t) {
        double sum = 0, arms = 0;
        seen->for_nodes([&](double m, auto const& x, auto const& v) {
          sum += m * length_of(x) * length_of(v), arms += m * length_of(x);
        });
        return seen->unit(sum, arms);
      });
}

template <int d>
void define_energy(QuantityGraph& graph, Seen<d> const& seen) {
  graph.define(
      "energy", {""}, [seen](auto, double* out) { *out = seen->motion().energies().total(); },
      [seen](auto, double const*, std::size_t) { return seen->unit(seen->motion().energies()); });
}

template <int d>
double circulation_along(Observed<d>& seen, MaterialLoop<d> const& loop) {
  auto const &v = seen.velocities(), &x = seen.places();
  double sum = 0;
  for (std::size_t k = 1; k < loop.stops.size(); ++k) {
    auto const &a = loop.stops[k - 1], &b = loop.stops[k];
    for (int i = 0; i < d; ++i)
      sum += 0.5 * (v[a.node][i] + v[b.node][i]) * (x[b.node][i] + b.beyond[i] - x[a.node][i] - a.beyond[i]);
  }
  return sum;
}

template <int d>
void define_circulation(QuantityGraph& graph, Seen<d> const& seen,
                        std::vector<MaterialLoop<d>> const& loops) {
  std::vector<std::string> ends;
  for (auto const& loop : loops) ends.push_back(loop.name.empty() ? "" : "_" + loop.name);
  if (ends.empty()) ends = {""};
  graph.define(
      "circulation", ends,
      [seen, loops](auto, double* out) {
        for (auto const& loop : loops) *out++ = circulation_along(*seen, loop);
      },
      [seen, loops](auto, double const*, std::size_t which) {
        auto const &x = seen->places(), &v = seen->velocities();
        auto const& stops = loops[which].stops;
        double sum = 0, length = 0;
        for (std::size_t k = 1; k < stops.size(); ++k) {
          auto const &a = stops[k - 1], &b = stops[k];
          std::array<double, d> edge;
          for (int i = 0; i < d; ++i) edge[i] = x[b.node][i] + b.beyond[i] - x[a.node][i] - a.beyond[i];
          sum += 0.5 * (size_of(v[a.node]) + size_of(v[b.node])) * size_of(edge), length += size_of(edge);
        }
        return seen->unit(sum, length);
      });
}

/// Of the balance over the cells of space-time, and of the cells themselves.
template <int d>
void define_checks(QuantityGraph& graph, Seen<d> const& seen, double step) {
  graph.define("noether_balance", {""}, [seen, step](auto, double* out) {
    auto const &v = seen->velocities(), &x = seen->places();
    *out = noether_residual(seen->medium(), x, v, step);
  });
  graph.define("min_jacobian", {""}, [seen](auto, double* out) {
    *out = least_jacobian(seen->motion().cells(), seen->places()).first;
  });
}

}  // namespace

std::vector<Quantity> sums_of_body(bool fluid) {
  std::string const loss = " The steps of conserve = form keep it to the square of the step.";
  return {
      {"energy", Kind::scalar, "The kinetic energy, the stored one, and that of loads." + loss,
       "E = \\sum\\tfrac m2|v|^2 + \\int\\rho W + \\int\\rho V", "energy"},
      {"momentum", Kind::vector, "The linear momentum, which the steps keep to rounding.",
       "\\int\\rho\\,\\dot\\phi", "mass x length/time", "thm_9_1_1"},
      {"angular_momentum", Kind::vector,
       "The angular momentum about the origin of space, in the plane its component across it. "
       "The steps keep it to rounding.",
       "\\int\\rho\\,\\phi\\times\\dot\\phi", "mass x length^2/time"},
      {"circulation", Kind::scalar,
       std::string(
           "The circulation of the velocity along each of system.loops, a side being run through with "
           "the body at the left (the edge of a hole clockwise); where these are left out along the "
           "outermost closed row of nodes of a body in the plane, counterclockwise, or the row that "
           "goes once around a periodic box. ") +
           (fluid ? "In the continuum the motion of a barotropic fluid conserves it; on a mesh it does "
                    "so to the order of the scheme."
                  : "A solid does not conserve it."),
       "\\oint\\dot\\phi\\cdot d\\phi", "length^2/time"},
  };
}

std::vector<Quantity> medium_quantities(bool fluid) {
  auto all = sums_of_body(fluid);
  all.insert(all.begin() + 1, {"dissipated", Kind::scalar,
                               "The energy that method.viscosity has taken since the start: energy and this "
                               "together are constant to the square of the step. Zero without viscosity.",
                               "\\int_0^t\\!\\int q\\,|\\dot J|", "energy"});
  all.push_back(
      {"noether_balance", Kind::scalar,
       "How far the discrete Noether currents of translations and turns are from adding up to zero over a "
       "cell of space-time, the largest over the cells of the last step, relative to the sum of their "
       "moduli: zero but for rounding. Relabelling and translations of time are no symmetries of a mesh; "
       "circulation and energy tell of them.",
       "\\max\\frac{|\\sum_l J^l(\\xi)|}{\\sum_l|J^l(\\xi)|}", "1"});
  all.push_back({"min_jacobian", Kind::scalar,
                 "The least Jacobian of the placement over all cells: a run ends before it reaches zero.",
                 "\\min J", "1"});
  return all;
}

namespace {
template <int d>
void define_sums(QuantityGraph& graph, Seen<d> const& seen, std::vector<MaterialLoop<d>> const& loops) {
  define_energy<d>(graph, seen);
  auto const known = graph.known();
  // On the sphere there is none.
  if (std::ranges::find(known, "momentum", &Quantity::name) != known.end()) define_momentum<d>(graph, seen);
  define_angular_momentum<d>(graph, seen);
  define_circulation<d>(graph, seen, loops);
}
}  // namespace

template <int d>
void define_sums(QuantityGraph& graph, MediumView<d> const& medium,
                 std::vector<MaterialLoop<d>> const& loops) {
  define_sums<d>(graph, std::make_shared<Observed<d>>(medium), loops);
}
template <int d>
void define_medium(QuantityGraph& graph, MediumView<d> const& medium,
                   std::vector<MaterialLoop<d>> const& loops, double step) {
  auto const seen = std::make_shared<Observed<d>>(medium);
  MediumMotion<d> const& motion = *medium.motion;
  define_sums<d>(graph, seen, loops);
  graph.define("dissipated", {""}, [&motion](auto, double* out) { *out = motion.dissipated(); });
  define_checks<d>(graph, seen, step);
}
/// \copydoc define_medium
template void define_medium(QuantityGraph& graph, MediumView<1> const& medium,
                            std::vector<MaterialLoop<1>> const& loops, double step);
/// \copydoc define_medium
template void define_medium(QuantityGraph& graph, MediumView<2> const& medium,
                            std::vector<MaterialLoop<2>> const& loops, double step);
/// \copydoc define_medium
template void define_medium(QuantityGraph& graph, MediumView<3> const& medium,
                            std::vector<MaterialLoop<3>> const& loops, double step);
/// \copydoc define_sums
template void define_sums(QuantityGraph& graph, MediumView<2> const& medium,
                          std::vector<MaterialLoop<2>> const& loops);
/// \copydoc define_sums
template void define_sums(QuantityGraph& graph, MediumView<3> const& medium,
                          std::vector<MaterialLoop<3>> const& loops);

}  // namespace actio::scene
