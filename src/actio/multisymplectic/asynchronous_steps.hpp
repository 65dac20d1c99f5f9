// Asynchronous variational steps: each cell of an unstructured mesh has a time step of its own (chapter 10 of
// the thesis; Lew, Marsden, Ortiz and West 2003, 2004).
//
// The discrete action is a sum over the flights of the nodes between the events at which their cells act, and
// over the slabs of each cell K between two of its times:
//
//     S_d = sum over flights (m/2) |x' - x|^2/(t' - t) - sum over slabs h_K (E_K(start) + E_K(end))/2.
//
// It is stationary where nodes fly freely and at every time of a cell its corners are kicked by h_K times its
// forces, h_K/2 at the start. A priority queue has the next event of each cell. Small cells take small steps,
// and only they do.
//
// Each kick has the differential of a function of the corners of one cell: so each event balances linear and
// angular momentum and the multisymplectic form, and so does every set of events in space-time. Energy is not
// conserved. Worse, a cell with a long step kicks its neighbours periodically, and where half the period of
// a fast motion beside it, pi over the frequency, goes a whole number of times into the step, these kicks
// pump the motion: resonances. Two over a cell's own largest frequency bounds its step as in a synchronous
// scheme, but does not exclude them. Steps of neighbours of like size do: a step is below pi over the
// frequencies of the neighbours where sizes grow by less than a half from cell to cell. At larger jumps in
// size there are bands of steps in which the energy grows; they are narrow and growth is slow where steps are
// far below the bound (Fong, Darve and Lew 2008).
#pragma once

#include <functional>
#include <queue>

#include "actio/meshes/simplex_geometry.hpp"
#include "actio/multisymplectic/discrete_section.hpp"

namespace actio::media {

/// The longest stable steps of the cells of a simplicial mesh, each alone: two over its largest frequency,
/// that of small motions of its corners, with the masses that this cell gives them, about the places.
///
/// The largest frequency of the body is below the largest of its cells. Here a cell's is bounded by the 128th
/// root of the trace of a power of its matrix: the step comes from below, within three per cent.
/// @param places  of the nodes, length
/// @throws as \ref simplex_geometry and \ref mass_of_corner, and what the density refuses
template <int n, int N, class L>
std::vector<double> longest_steps(L const& density, BodyMesh const& mesh, Level<double, N> const& places) {
  constexpr int size = N * (n + 1);
  std::vector<double> steps;
  for (int k = 0; k < int(mesh.cells.size()); ++k) {
    auto const cell = simplex_geometry<n>(mesh, k);
    Matrix<double, size, 1> y;
    Matrix<double, N, n + 1> at;
    for (int c = 0; c <= n; ++c) {
      at.col(c) = places[mesh.cells[k][c]];
      y.template segment<N>(N * c) = places[mesh.cells[k][c]];
    }
    auto const forces = [&]<class T>(Matrix<T, size, 1> const& z) {
      Matrix<T, N, n + 1> moved;
      for (int c = 0; c <= n; ++c) moved.col(c) = z.template segment<N>(N * c);
      auto const f = forces_on_corners(density, cell, 0.0, moved);
      Matrix<T, size, 1> all;
      for (int c = 0; c <= n; ++c) all.template segment<N>(N * c) = f.col(c);
      return all;
    };
    Matrix<double, size, size> A = derivative(forces, y).matrix;
    Matrix<double, size, 1> root;
    for (int c = 0; c <= n; ++c)
      root.template segment<N>(N * c).setConstant(std::sqrt(mass_of_corner<N>(density, cell, at, c)));
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j) A(i, j) /= root[i] * root[j];
    // The trace of A^64, with A scaled before each of six squarings.
    double logarithm = 0, power = 1;
    for (int squaring = 0; squaring < 6; ++squaring) {
      double const scale = magnitude(A);
      if (!(scale > 0)) break;
      A /= scale;
      logarithm += power * std::log(scale);
      A = (A * A).eval();
      power /= 2;
    }
    double const square = std::exp(logarithm + power * std::log(A.trace()));
    require_finite(Matrix<double, 1, 1>(A.trace()), "longest_steps: forces have no derivative");
    steps.push_back(A.trace() > 0 ? 2 / std::sqrt(square) : std::numeric_limits<double>::infinity());
  }
  return steps;
}

/// A body of simplices that is stepped cell by cell.
/// @tparam S  scalar of places and velocities; over dual numbers they carry a first variation. Times are
///            plain numbers, so that all scalars see the same events.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
class AsynchronousSteps {
 public:
  /// What happens at one time: the corners of a cell are kicked by `weight` times its forces.
  struct Event {
    int cell;       ///< which cell
    double time;    ///< when
    double weight;  ///< half a step at the start, and a step later; time
  };

  /// @param density     of first jets, of the kind \f$\tfrac\rho2|v|^2 - U(x, y, F)\f$
  /// @param mesh        simplices, as \ref require_body_mesh accepts them
  /// @param steps       of the cells, time; each below the \ref longest_steps at the start
  /// @param places      of the nodes at time 0, length
  /// @param velocities  at time 0, momentum over mass, length/time
  /// @param held        empty, or for each node: bit a where component a of its velocity never changes
  /// @throws NotABodyMesh, OutsideDomain  where these do not fit together; StepTooLong with the longest step;
  ///         and what the density refuses
  AsynchronousSteps(L density, BodyMesh const& mesh, std::vector<double> steps, Level<S, N> places,
                    Level<S, N> velocities, std::vector<unsigned> held = {})
      : density_(std::move(density)),
        steps_(std::move(steps)),
        x_(std::move(places)),
        v_(std::move(velocities)),
        held_(std::move(held)),
        since_(x_.size(), 0.0),
        mass_(x_.size(), 0.0),
        count_(mesh.cells.size(), 0) {
    if (held_.empty()) held_.assign(mesh.nodes.size(), 0);
    for (auto const size : {x_.size(), v_.size(), held_.size()})
      require_size("node", size, mesh.nodes.size());
    require_size("cell", steps_.size(), mesh.cells.size());
    require_body_mesh(mesh);
    for (int k = 0; k < int(mesh.cells.size()); ++k) {
      cells_.push_back(simplex_geometry<n>(mesh, k));
      std::copy_n(mesh.cells[k].begin(), n + 1, corners_.emplace_back().begin());
    }
    Level<double, N> plain;
    for (auto const& x : x_) plain.push_back(x.unaryExpr([](S const& entry) { return base_value(entry); }));
    auto const longest = longest_steps<n, N>(density_, mesh, plain);
    for (int k = 0; k < int(cells_.size()); ++k) {
      auto const where = "asynchronous steps, " + mesh.cell_name(k);
      if (!is_finite(steps_[k]) || !(steps_[k] > 0))
        throw OutsideDomain(where, "a step is a positive number", steps_[k], 0);
      if (steps_[k] > longest[k]) throw StepTooLong(where, steps_[k], longest[k]);
      for (int c = 0; c <= n; ++c)
        mass_[corners_[k][c]] += mass_of_corner<N>(density_, cells_[k], columns(plain, k), c);
      queue_.emplace(0.0, k);
    }
  }

  /// The event that comes next.
  Event next() const {
    auto const [time, cell] = queue_.top();
    return {cell, time, count_[cell] == 0 ? steps_[cell] / 2 : steps_[cell]};
  }
  /// Lets the next event happen. Of events at one time cells with lower numbers come first.
  /// @throws what the density refuses, a cell turned inside out for instance; then nothing has happened
  Event step() {
    Event const event = next();
    int const k = event.cell;
    // [asynchronous_steps]
    auto const f = forces_on_corners(density_, cells_[k], event.time, places_of(k, event.time));
    for (int c = 0; c <= n; ++c) {
      int const node = corners_[k][c];
      x_[node] = place(node, event.time);
      since_[node] = event.time;
      for (int a = 0; a < N; ++a)
        if (!(held_[node] >> a & 1)) v_[node][a] += f(a, c) * (event.weight / mass_[node]);
    }
    // [asynchronous_steps]
    queue_.pop();
    queue_.emplace(++count_[k] * steps_[k], k);
    ++events_;
    return event;
  }
  /// All events up to a time, that time included.
  /// @throws NotFinite where the time is none; and as \ref step
  void run(double until) {
    if (!is_finite(until)) throw NotFinite("asynchronous steps, the time to run to");
    while (queue_.top().first <= until) step();
  }

  /// How many events have happened.
  long events() const { return events_; }
  /// The nodes at the corners of a cell.
  std::array<int, n + 1> const& corners(int cell) const { return corners_[cell]; }
  /// The mass of a node.
  double mass(int node) const { return mass_[node]; }
  /// The velocity with which a node flies since the last event at it.
  Matrix<S, N, 1> const& velocity(int node) const { return v_[node]; }
  /// Where a node is at a time between the last event at it and the next one, if it flies freely.
  Matrix<S, N, 1> place(int node, double time) const { return x_[node] + v_[node] * S(time - since_[node]); }

  /// The velocities of all nodes at a time, with what the cells have given for times to come taken back, and
  /// what they owe added: \f$v - \sum_K(t_K + h_K/2 - t)f_K/m\f$ with the last times \f$t_K\f$ of the cells.
  /// @param time  no event lies between the last ones and it
  /// Accuracy: second order in the steps; the velocities of flights are of first order.
  Level<S, N> velocities(double time) const {
    auto v = v_;
    for (int k = 0; k < int(cells_.size()); ++k) {
      if (count_[k] == 0) continue;
      double const ahead = (count_[k] - 0.5) * steps_[k] - time;
      auto const f = forces_on_corners(density_, cells_[k], time, places_of(k, time));
      for (int c = 0; c <= n; ++c)
        for (int a = 0; a < N; ++a)
          if (int const node = corners_[k][c]; !(held_[node] >> a & 1))
            v[node][a] -= f(a, c) * (ahead / mass_[node]);
    }
    return v;
  }
  /// Kinetic plus stored energy at a time, as in \ref velocities; the synchronous scheme's to second order.
  S energy(double time) const {
    S sum(0);
    auto const v = velocities(time);
    for (std::size_t node = 0; node < v.size(); ++node) sum += v[node].squaredNorm() * (mass_[node] / 2);
    for (int k = 0; k < int(cells_.size()); ++k)
      sum += stored_energy(density_, cells_[k], time, places_of(k, time));
    return sum;
  }

 private:
  L density_;
  std::vector<double> steps_;
  Level<S, N> x_, v_;
  std::vector<unsigned> held_;
  std::vector<double> since_, mass_;  // of nodes: the time of x_, and the mass
  std::vector<long> count_;           // of cells: how many events
  std::vector<SimplexGeometry<n>> cells_;
  std::vector<std::array<int, n + 1>> corners_;
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> queue_;
  long events_ = 0;

  static void require_size(std::string const& what, std::size_t size, std::size_t wanted) {
    if (size != wanted)
      throw OutsideDomain("asynchronous steps", "each " + what + " has its entry; entries", double(size),
                          double(wanted));
  }
  template <class T>
  Matrix<T, N, n + 1> columns(Level<T, N> const& level, int cell) const {
    Matrix<T, N, n + 1> y;
    for (int c = 0; c <= n; ++c) y.col(c) = level[corners_[cell][c]];
    return y;
  }
  Matrix<S, N, n + 1> places_of(int cell, double time) const {
    Matrix<S, N, n + 1> y;
    for (int c = 0; c <= n; ++c) y.col(c) = place(corners_[cell][c], time);
    return y;
  }
};

/// \ref AsynchronousSteps of a density on a mesh of dimension n.
/// @throws as its constructor
template <int n, class S, int N, class L>
AsynchronousSteps<S, n, N, L> asynchronous_steps(L const& density, BodyMesh const& mesh,
                                                 std::vector<double> const& steps,
                                                 std::vector<Matrix<S, N, 1>> const& places,
                                                 std::vector<Matrix<S, N, 1>> const& velocities,
                                                 std::vector<unsigned> const& held = {}) {
  return {density, mesh, steps, places, velocities, held};
}

}  // namespace actio::media
