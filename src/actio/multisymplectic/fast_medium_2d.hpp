// A medium in the plane, stepped by the fast road: the explicit multisymplectic scheme, fused.
//
//     FastBox2d const box{{200, 100}, {0.01, 0.01}};                       // free sides
//     FastMedium2d medium(neo_hookean(1, 1), box, 0.002, 1000, placement, velocity);
//     medium.step(1000);
//     auto const x = medium.places();                                      // of the nodes, row by row
//
// The discrete Lagrangian of a slab of cells between two times is
//
//     L_d = sum over nodes of (m/2)|x1-x0|^2/dt - (dt/2)(E(x0)+E(x1)), E = (vol/4) sum over corners of W(F),
//
// and its Euler-Lagrange field equations are the leapfrog: v += dt a(x), x += dt v, with v half a step back.
#pragma once

#include <algorithm>
#include <functional>

#include "actio/multisymplectic/fast_forces_2d.hpp"
#include "actio/multisymplectic/fast_rows_2d.hpp"

namespace actio {

/// A cell of a medium that would turn inside out: the state is that before the step which would do it.
struct CellInverts : OutsideDomain {
  std::array<int, 2> cell;  ///< which, along both directions
  long step;                ///< the number of the step that would do it, from 1; 0 at the start
  double time_step;         ///< its length
  double largest_step;      ///< the longest step for which small motions about the state before are stable
  /// @param which, jacobian, step_number, dt, largest  as above; J at the worst of its corners
  CellInverts(std::array<int, 2> which, double jacobian, long step_number, double dt, double largest)
      : OutsideDomain(where(which, step_number, dt, largest), "the Jacobian at its corners must be positive",
                      jacobian, 0),
        cell(which),
        step(step_number),
        time_step(dt),
        largest_step(largest) {}

 private:
  static std::string where(std::array<int, 2> which, long step_number, double dt, double largest) {
    std::string const cell = "cell (" + std::to_string(which[0]) + ", " + std::to_string(which[1]) + ")";
    if (step_number == 0) return "medium: " + cell + " is inside out at the start";
    return "medium: step " + std::to_string(step_number) + " of length " + show(dt) + " would turn " + cell +
           " inside out (the longest stable step before it is " + show(largest) + ")";
  }
};

/// A medium on a rectangle of cells, of one density, stepped explicitly.
///
/// @tparam Medium  `FastFluid`, `FastNeoHookean` or `FastStVenantKirchhoff`
template <class Medium>
class FastMedium2d {
 public:
  /// A point or a vector of the plane.
  using Point = std::array<double, 2>;

  /// @param medium     stored energy per unit mass, speed squared
  /// @param box        cells and sides
  /// @param dt         time step
  /// @param density    mass per area of the body
  /// @param placement  \f$X\mapsto\phi(X)\f$ at the start, length
  /// @param velocity   \f$X\mapsto\dot\phi(X)\f$ at the start, momentum over mass, length/time
  /// @throws OutsideDomain, NotFinite where the box is none, or dt or the density is not a positive number,
  ///   or a node is not at a finite place
  /// @throws CellInverts  with step 0, where a cell is inside out at the start
  template <class Placement, class Velocity>
  FastMedium2d(Medium const& medium, FastBox2d const& box, double dt, double density,
               Placement const& placement, Velocity const& velocity, FastOptions const& options = {})
      : medium_(medium),
        box_((box.examine(), box)),
        cell_(medium.on(box.spacing[0], box.spacing[1])),
        dt_(positive(dt, "time step")),
        density_(positive(density, "density")),
        rows_(box_, cell_, dt, options) {
    std::vector<Plane> x, v;
    for (int j = 0; j < box.nodes(1); ++j)
      for (int i = 0; i < box.nodes(0); ++i) {
        auto const place = placement(box.at(i, j)), rate = velocity(box.at(i, j));
        x.push_back({place[0], place[1]}), v.push_back({rate[0], rate[1]});
        if (!is_finite(place[0]) || !is_finite(place[1]) || !is_finite(rate[0]) || !is_finite(rate[1]))
          throw NotFinite("medium: placement and velocity of node (" + std::to_string(i) + ", " +
                          std::to_string(j) + ")");
      }
    refuse_inverted(x);
    // To half a step before the start.
    auto const a = detail::accelerations(box_, cell_, x);
    for (std::size_t k = 0; k < v.size(); ++k) v[k] = {v[k].x - dt / 2 * a[k].x, v[k].y - dt / 2 * a[k].y};
    rows_.put(x, v);
    kept_ = rows_.state();
  }

  /// So many steps on.
  /// @throws CellInverts  where a cell would turn inside out; then the state is that before this step
  /// @throws OutsideDomain  where count is negative
  void step(long count = 1) {
    if (count < 0)
      throw OutsideDomain("medium", "the number of steps must not be negative", static_cast<double>(count),
                          0);
    while (count > 0) {
      if (steps_ - kept_at_ >= between_copies) kept_ = rows_.state(), kept_at_ = steps_;
      long const some = std::min(count, kept_at_ + between_copies - steps_);
      bool const sound = rows_.advance(some);
      steps_ += some, count -= some;
      if (!sound || !rows_.examine()) find_inversion();
    }
  }

  /// The time since the start.
  double time() const { return static_cast<double>(steps_) * dt_; }
  /// How many steps have been made.
  long steps() const { return steps_; }
  /// The time step.
  double time_step() const { return dt_; }
  /// Cells and sides.
  FastBox2d const& box() const { return box_; }
  /// How many steps a pass over the rows makes.
  int levels() const { return rows_.levels(); }
  /// Memory for states and copies, bytes.
  std::size_t bytes() const { return rows_.bytes() + kept_.capacity() * sizeof(detail::Plane<detail::Quad>); }

  /// Places of the nodes, row by row from below, each from the left; length.
  std::vector<Point> places() const { return points(rows_.read(false)); }
  /// Velocities of the nodes now, momentum over mass; length/time.
  std::vector<Point> velocities() const { return points(velocities_now()); }
  /// Velocities half a step ago, from the places before to the places now.
  std::vector<Point> velocities_half_a_step_ago() const { return points(rows_.read(true)); }

  /// Linear momentum, mass x length/time. With free or periodic sides it is conserved to rounding.
  Point momentum() const {
    detail::Plane<double> sum{0, 0};
    each_node([&](double mass, Plane const&, Plane const& v) { sum.x += mass * v.x, sum.y += mass * v.y; });
    return {sum.x, sum.y};
  }
  /// Angular momentum about the origin of space, mass x area/time: the discrete Noether momentum of rotations
  /// on the last slab, \f$\sum m\,x\times v\f$. With free sides it is conserved to rounding.
  double angular_momentum() const {
    double sum = 0;
    each_node([&](double mass, Plane const& x, Plane const& v) { sum += mass * detail::cross(x, v); });
    return sum;
  }
  /// Kinetic and stored energy now. The sum oscillates with the square of the time step.
  Point energies() const {
    auto const x = rows_.read(false), v = velocities_now();
    double kinetic = 0, stored = 0;
    std::size_t k = 0;
    for (int j = 0; j < box_.nodes(1); ++j)
      for (int i = 0; i < box_.nodes(0); ++i, ++k)
        kinetic += box_.share(0, i) * box_.share(1, j) * detail::dot(v[k], v[k]);
    for (int j = 0; j < box_.cells[1]; ++j)
      for (int i = 0; i < box_.cells[0]; ++i)
        stored += detail::cell_energy(medium_, box_.spacing[0], box_.spacing[1],
                                      detail::edges_of(box_, detail::corners_of(box_, i, j), x));
    return {0.5 * kinetic * density_ * box_.spacing[0] * box_.spacing[1], stored * density_};
  }
  /// Kinetic plus stored energy now.
  double energy() const { return energies()[0] + energies()[1]; }
  /// The longest time step for which small motions about the state now are stable: two over the largest
  /// frequency, which comes from below, so that the step comes from above; within a per cent.
  double largest_step() const { return 2 / detail::largest_frequency(box_, cell_, rows_.read(false)); }

 private:
  using Plane = detail::Plane<double>;
  using Register = detail::Plane<detail::Quad>;
  using Cell = decltype(std::declval<Medium const&>().on(1.0, 1.0));
  static constexpr long between_copies = 512;  // a copy costs about a step

  static double positive(double x, char const* what) {
    if (!is_finite(x)) throw NotFinite(std::string("medium: ") + what);
    if (!(x > 0)) throw OutsideDomain("medium", std::string("a positive ") + what + " is needed", x, 0);
    return x;
  }
  static std::vector<Point> points(std::vector<Plane> const& in) {
    std::vector<Point> out;
    for (auto const& p : in) out.push_back({p.x, p.y});
    return out;
  }
  std::vector<Plane> velocities_now() const {
    auto v = rows_.read(true);
    auto const a = detail::accelerations(box_, cell_, rows_.read(false));
    for (std::size_t k = 0; k < v.size(); ++k) v[k] = {v[k].x + dt_ / 2 * a[k].x, v[k].y + dt_ / 2 * a[k].y};
    return v;
  }
  template <class Visit>
  void each_node(Visit const& visit) const {
    auto const x = rows_.read(false), v = rows_.read(true);
    double const mass = density_ * box_.spacing[0] * box_.spacing[1];
    std::size_t k = 0;
    for (int j = 0; j < box_.nodes(1); ++j)
      for (int i = 0; i < box_.nodes(0); ++i, ++k)
        visit(mass * box_.share(0, i) * box_.share(1, j), x[k], v[k]);
  }

  /// The cell with the least Jacobian, and that.
  std::pair<std::array<int, 2>, double> worst_cell(std::vector<Plane> const& x) const {
    std::pair<std::array<int, 2>, double> worst{{0, 0}, HUGE_VAL};
    double const area = box_.spacing[0] * box_.spacing[1];
    for (int j = 0; j < box_.cells[1]; ++j)
      for (int i = 0; i < box_.cells[0]; ++i) {
        double d[4];
        detail::areas(detail::edges_of(box_, detail::corners_of(box_, i, j), x), d);
        for (double const one : d)
          if (!(one / area >= worst.second)) worst = {{i, j}, one / area};
        if (!(worst.second == worst.second)) return worst;
      }
    return worst;
  }
  void refuse_inverted(std::vector<Plane> const& x) const {
    auto const [cell, jacobian] = worst_cell(x);
    if (!(jacobian > 0)) throw CellInverts(cell, jacobian, 0, dt_, 0);
  }
  /// Goes back to the copy, and from there step by step to where a cell turns inside out.
  void find_inversion() {
    long const end = steps_;
    rows_.restore(kept_), steps_ = kept_at_;
    while (steps_ < end) {
      kept_ = rows_.state(), kept_at_ = steps_;
      bool const sound = rows_.advance(1);
      ++steps_;
      if (sound && rows_.examine()) continue;
      auto const [cell, jacobian] = worst_cell(rows_.read(false));
      rows_.restore(kept_), steps_ = kept_at_;
      throw CellInverts(cell, jacobian, steps_ + 1, dt_, largest_step());
    }
  }

  Medium medium_;
  FastBox2d box_;
  Cell cell_;
  double dt_, density_;
  detail::FusedRows2d<Cell> rows_;
  std::vector<Register> kept_;
  long steps_ = 0, kept_at_ = 0;
};

}  // namespace actio
