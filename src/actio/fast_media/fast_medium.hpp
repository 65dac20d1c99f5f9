// A medium on a box of cells, stepped by the optimised implementation: what it is in the plane and in space
// alike. fast_medium_2d.hpp and fast_medium_3d.hpp name it for these.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "actio/fast_media/fast_forces.hpp"
#include "actio/fast_media/fast_inversion.hpp"
#include "actio/fast_media/fast_options.hpp"
#include "actio/fast_media/nodes_on_ranks.hpp"

namespace actio::media {

namespace detail {

/// The nodes of a box as the fused steps hold them; one for each kind of box.
template <class Box, class Cell>
struct FusedNodes;
/// What steps a cell of a medium in a box.
template <class Medium, class Box>
using CellOf = decltype(cell_on(std::declval<Medium const&>(), std::declval<Box const&>().spacing));
/// The nodes of a medium in a box.
template <class Medium, class Box>
using NodesOf = typename FusedNodes<Box, CellOf<Medium, Box>>::type;

/// Vectors as arrays.
inline std::array<double, 2> as_point(Plane<double> const& a) { return {a.x, a.y}; }
inline std::array<double, 3> as_point(Space<double> const& a) { return {a.x, a.y, a.z}; }
inline double as_point(double a) { return a; }
inline Plane<double> as_vector(std::array<double, 2> const& a) { return {a[0], a[1]}; }
inline Space<double> as_vector(std::array<double, 3> const& a) { return {a[0], a[1], a[2]}; }

}  // namespace detail

/// A medium on a box of cells, of one density, stepped explicitly.
///
/// \snippet media.cpp fast_medium_2d
/// @tparam Medium  \ref FastFluid, \ref FastNeoHookean or \ref FastStVenantKirchhoff
/// @tparam Box     \ref FastBox2d or \ref FastBox3d
template <class Medium, class Box>
class FastMedium {
 public:
  /// A point or a vector.
  using Point = std::array<double, Box::dimension>;
  /// All that a run needs to go on, to the last bit.
  struct State {
    std::vector<Point> places;      ///< of the nodes, in their order
    std::vector<Point> velocities;  ///< half a step ago
    long steps = 0;                 ///< that have been made
  };

  /// @param medium     stored energy per unit mass, speed squared
  /// @param box        cells and sides
  /// @param dt         time step
  /// @param density    mass per area or volume of the body
  /// @param placement  \f$X\mapsto\phi(X)\f$ at the start, length
  /// @param velocity   \f$X\mapsto\dot\phi(X)\f$ at the start, momentum over mass, length/time
  /// @param options    how it is computed
  /// @throws OutsideDomain, NotFinite where the box is none, or dt or the density is not a positive number,
  ///   or a node is not at a finite place
  /// @throws OutsideDomain  where small motions about the start are unstable with dt: measured dt, and the
  ///   longest step as \ref largest_step has it, within a few per cent
  /// @throws CellInverts  with step 0, where a cell is inside out at the start
  template <class Placement, class Velocity>
  FastMedium(Medium const& medium, Box const& box, double dt, double density, Placement const& placement,
             Velocity const& velocity, FastOptions const& options = {})
      : medium_(medium),
        box_((box.examine(), box)),
        cell_(detail::cell_on(medium, box.spacing)),
        dt_(positive(dt, "time step")),
        density_(positive(density, "density")),
        nodes_(box_, cell_, dt, options) {
    std::vector<Vector> x, v;
    auto const count = static_cast<std::size_t>(box.count());
    x.reserve(count), v.reserve(count);
    detail::for_nodes(box, [&](auto const& node, std::size_t) {
      Point const place = placement(box.at(node)), rate = velocity(box.at(node));
      require_numbers(node, place, rate);
      x.push_back(detail::as_vector(place)), v.push_back(detail::as_vector(rate));
    });
    refuse_inverted(x);
    refuse_long_step(x);
    // To half a step before the start.
    add_kick(v, x, -dt / 2);
    nodes_.put(x, v);
    nodes_.keep();
  }

  /// So many steps on.
  /// @throws CellInverts  where a cell would turn inside out; then the state is that before this step
  /// @throws OutsideDomain  where count is negative
  void step(long count = 1) {
    if (count < 0)
      throw OutsideDomain("medium", "the number of steps must not be negative", static_cast<double>(count),
                          0);
    ahead_.reset();
    while (count > 0) {
      if (steps_ - kept_at_ >= between_copies) nodes_.keep(), kept_at_ = steps_;
      long const some = std::min(count, kept_at_ + between_copies - steps_);
      bool const sound = nodes_.advance(some);
      steps_ += some, count -= some;
      if (!sound || !nodes_.examine()) find_inversion();
    }
  }

  /// Until the next step places, velocities and energies are those so long after the last step, which one
  /// step of that length reaches; the steps go on as if it had not been. Zero: those of the last step again.
  /// @throws CellInverts  where a cell would turn inside out
  void look_ahead(double time) {
    ahead_.reset();
    if (!(time > 0)) return;
    auto v = velocities_now(), x = nodes_.read(false);
    add_kick(v, x, time / 2);
    for (std::size_t k = 0; k < x.size(); ++k) x[k] = x[k] + detail::scaled_by(time, v[k]);
    refuse_inverted(x);
    add_kick(v, x, time / 2);
    ahead_.emplace(std::move(x), std::move(v));
  }

  /// The time since the start.
  double time() const { return static_cast<double>(steps_) * dt_; }
  /// How many steps have been made.
  long steps() const { return steps_; }
  /// The time step.
  double time_step() const { return dt_; }
  /// Cells and sides.
  Box const& box() const { return box_; }
  /// How many steps a pass over the nodes makes.
  int levels() const { return nodes_.levels(); }
  /// Memory for states and copies, bytes.
  std::size_t bytes() const { return nodes_.bytes(); }

  /// Places of the nodes, the first direction fastest; length.
  std::vector<Point> places() const { return ahead_ ? points(ahead_->first) : places_of_last_step(); }
  /// Velocities of the nodes now, momentum over mass; length/time.
  std::vector<Point> velocities() const { return points(ahead_ ? ahead_->second : velocities_now()); }
  /// Places of the nodes at the last step, length.
  std::vector<Point> places_of_last_step() const { return points(nodes_.read(false)); }
  /// Velocities half a step ago, from the places before to the places now.
  std::vector<Point> velocities_half_a_step_ago() const { return points(nodes_.read(true)); }
  /// The state now, for \ref go_on_from.
  State state() const { return {places_of_last_step(), velocities_half_a_step_ago(), steps_}; }
  /// Goes on from a state: the run from there is that of the medium that it was taken from, bit for bit.
  /// @throws OutsideDomain  where it has not as many nodes as the box, or a negative number of steps
  /// @throws NotFinite      where a place or a velocity is no number
  /// @throws CellInverts    with step 0, where a cell of it is inside out
  void go_on_from(State const& state) {
    auto const needed = static_cast<std::size_t>(box_.count());
    for (std::size_t const found : {state.places.size(), state.velocities.size()})
      if (found != needed)
        throw OutsideDomain("medium: state", "it has a position and a velocity for each node of the box",
                            static_cast<double>(found), static_cast<double>(needed));
    if (state.steps < 0)
      throw OutsideDomain("medium: state", "the number of steps must not be negative",
                          static_cast<double>(state.steps), 0);
    std::vector<Vector> x, v;
    x.reserve(needed), v.reserve(needed);
    detail::for_nodes(box_, [&](auto const& node, std::size_t k) {
      require_numbers(node, state.places[k], state.velocities[k]);
      x.push_back(detail::as_vector(state.places[k])), v.push_back(detail::as_vector(state.velocities[k]));
    });
    refuse_inverted(x);
    nodes_.put(x, v), ahead_.reset();
    steps_ = kept_at_ = state.steps, nodes_.keep();
  }

  /// Linear momentum, mass x length/time. With free or periodic sides it is conserved to rounding.
  Point momentum() const {
    Vector sum{};
    each_node([&](double mass, Vector const&, Vector const& v) { sum = sum + detail::scaled_by(mass, v); });
    return detail::as_point(sum);
  }
  /// Angular momentum about the origin of space, mass x area/time, a number in the plane: the discrete
  /// Noether momentum of rotations on the last slab, \f$\sum m\,x\times v\f$. With free sides it is conserved
  /// to rounding.
  auto angular_momentum() const {
    decltype(cross(Vector{}, Vector{})) sum{};
    each_node([&](double mass, Vector const& x, Vector const& v) {
      sum = sum + cross(detail::scaled_by(mass, x), v);
    });
    return detail::as_point(sum);
  }
  /// Kinetic and stored energy now. The sum oscillates with the square of the time step.
  std::array<double, 2> energies() const {
    // Velocities first: they take more room while they are made.
    auto const v = ahead_ ? ahead_->second : velocities_now(),
               x = ahead_ ? ahead_->first : nodes_.read(false);
    double kinetic = 0, stored = 0;
    detail::for_nodes(
        box_, [&](auto const& node, std::size_t k) { kinetic += node_share(node) * dot(v[k], v[k]); });
    auto const u = displacements(x);
    detail::for_indices(box_.cells, [&](auto const& cell) {
      stored += detail::cell_energy_of_displacement(
          medium_, box_.spacing, detail::edges_of(box_, detail::corners_of(box_, cell), u, true));
    });
    return {0.5 * kinetic * density_ * box_.measure(), stored * density_};
  }
  /// Kinetic plus stored energy now.
  double energy() const { return energies()[0] + energies()[1]; }
  /// The longest time step for which small motions about the state now are stable: two over the largest
  /// frequency, which comes from below, so that the step comes from above; within a per cent.
  double largest_step() const { return 2 / detail::largest_frequency(box_, cell_, nodes_.read(false)); }

 private:
  using Cell = detail::CellOf<Medium, Box>;
  using Nodes = detail::NodesOf<Medium, Box>;
  using Vector = detail::VectorOf<Box, double>;
  static constexpr long between_copies = 512;  // a copy costs about a step

  static double positive(double x, char const* what) {
    if (!is_finite(x)) throw NotFinite(std::string("medium: ") + what);
    if (!(x > 0)) throw OutsideDomain("medium", std::string("a positive ") + what + " is needed", x, 0);
    return x;
  }
  template <class Node>
  static void require_numbers(Node const& node, Point const& place, Point const& rate) {
    bool finite = true;
    for (std::size_t i = 0; i < place.size(); ++i)
      finite = finite && is_finite(place[i]) && is_finite(rate[i]);
    if (finite) return;
    std::string name;
    for (int const i : node) name += (name.empty() ? "(" : ", ") + std::to_string(i);
    throw NotFinite("medium: placement and velocity of node " + name + ")");
  }
  static std::vector<Point> points(std::vector<Vector> const& in) {
    std::vector<Point> out;
    out.reserve(in.size());
    for (auto const& p : in) out.push_back(detail::as_point(p));
    return out;
  }
  /// Adds so much time of the accelerations at x.
  void add_kick(std::vector<Vector>& v, std::vector<Vector> const& x, double time) const {
    auto const a = detail::accelerations(box_, cell_, x);
    for (std::size_t k = 0; k < v.size(); ++k) v[k] = v[k] + detail::scaled_by(time, a[k]);
  }
  std::vector<Vector> velocities_now() const {
    auto v = nodes_.read(true);
    add_kick(v, nodes_.read(false), dt_ / 2);
    return v;
  }
  /// How far nodes are from where they are in the body: of small strains without loss.
  std::vector<Vector> displacements(std::vector<Vector> x) const {
    detail::for_nodes(
        box_, [&](auto const& node, std::size_t k) { x[k] = x[k] - detail::as_vector(box_.at(node)); });
    return x;
  }
  template <class Node>
  double node_share(Node const& node) const {
    double share = 1;
    for (int d = 0; d < Box::dimension; ++d) share *= box_.share(d, node[d]);
    return share;
  }
  template <class Visit>
  void each_node(Visit const& visit) const {
    auto const x = nodes_.read(false), v = nodes_.read(true);
    double const mass = density_ * box_.measure();
    detail::for_nodes(box_,
                      [&](auto const& node, std::size_t k) { visit(mass * node_share(node), x[k], v[k]); });
  }

  /// The least Jacobian of a cell; a NaN is the least.
  double least_jacobian(std::array<int, Box::dimension> const& cell, std::vector<Vector> const& x) const {
    double least = HUGE_VAL;
    for (double const one : detail::corner_volumes(detail::edges_of(box_, detail::corners_of(box_, cell), x)))
      if (least == least && !(one / box_.measure() >= least)) least = one / box_.measure();
    return least;
  }
  /// The cell with the least Jacobian, and that.
  std::pair<std::array<int, Box::dimension>, double> worst_cell(std::vector<Vector> const& x) const {
    std::pair<std::array<int, Box::dimension>, double> worst{{}, HUGE_VAL};
    detail::for_indices(box_.cells, [&](auto const& cell) {
      if (!(worst.second == worst.second)) return;
      if (double const least = least_jacobian(cell, x); !(least >= worst.second)) worst = {cell, least};
    });
    return worst;
  }
  void refuse_inverted(std::vector<Vector> const& x) const {
    auto const [cell, jacobian] = worst_cell(x);
    if (!(jacobian > 0)) throw CellInverts(cell, jacobian);
  }
  void refuse_long_step(std::vector<Vector> const& x) const {
    double const bound = detail::bound_of_stable_steps(box_, cell_, x);
    if (dt_ > bound)
      throw OutsideDomain("medium: time step", "small motions about the start are stable up to the bound",
                          dt_, bound);
  }
  /// Goes back to the copy, and from there step by step to where a cell turns inside out.
  void find_inversion() {
    long const end = steps_;
    nodes_.restore(), steps_ = kept_at_;
    while (steps_ < end) {
      nodes_.keep(), kept_at_ = steps_;
      bool const sound = nodes_.advance(1);
      ++steps_;
      if (sound && nodes_.examine()) continue;
      auto const [cell, jacobian] = worst_cell(nodes_.read(false));
      nodes_.restore(), steps_ = kept_at_;
      throw CellInverts(cell, jacobian, steps_ + 1, dt_, least_jacobian(cell, nodes_.read(false)),
                        largest_step());
    }
  }

  Medium medium_;
  Box box_;
  Cell cell_;
  double dt_, density_;
  detail::NodesOnRanks<Nodes> nodes_;
  std::optional<std::pair<std::vector<Vector>, std::vector<Vector>>> ahead_;  // places and velocities
  long steps_ = 0, kept_at_ = 0;
};

/// The part of a medium on a rank other than the first, for \ref share_parts: of the same medium, box and
/// options as the \ref FastMedium of rank 0.
template <class Medium, class Box>
std::unique_ptr<RankPart> medium_part(Medium const& medium, Box const& box, double dt,
                                        FastOptions const& options) {
  return std::make_unique<detail::PartOf<detail::NodesOf<Medium, Box>>>(
      box, detail::cell_on(medium, box.spacing), dt, options);
}

}  // namespace actio::media
