// In a unit of its own
#include "actio/incompressible_media/two_colour_multigrid.hpp"

#include <Eigen/SparseCholesky>

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "actio/incompressible_media/two_colour_level.hpp"
#include "actio/incompressible_media/two_colour_transfer.hpp"
#include "actio/numbers/errors.hpp"

namespace actio::media {

namespace detail {
namespace {

constexpr char const* name = "multigrid for pressures";

/// Cells below which a lattice is solved by its Cholesky factors.
constexpr int few = 80;

/// The factors of the coarsest matrix.
struct Coarsest {
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors;
  std::vector<std::ptrdiff_t> place;  ///< of each cell, in a field
  Eigen::VectorXd right, found;

  template <class Matrix>
  void take(Matrix const& m, double factor, bool singular) {
    auto const& lattice = m.lattice;
    place.clear();
    std::vector<int> number(lattice.room(2), -1);
    lattice.each_site([&](Diagonals s) {
      for (int c = 0; c < 2; ++c)
        if (lattice.holds(c, s)) {
          number[static_cast<std::size_t>(lattice.at(2, s, c))] = static_cast<int>(place.size());
          place.push_back(lattice.at(2, s, c));
        }
    });
    std::vector<Eigen::Triplet<double>> entries;
    lattice.each_site([&](Diagonals s) {
      for (int c = 0; c < 2; ++c) {
        if (!lattice.holds(c, s)) continue;
        int const row = number[static_cast<std::size_t>(lattice.at(2, s, c))];
        entries.emplace_back(row, row, factor * m.self(s, c) * (singular && row == 0 ? 2 : 1));
        m.each_entry(s, c, [&](int d, int du, int dv, double a) {
          if (a == 0) return;
          Diagonals const other = lattice.wrapped({s.u + du, s.v + dv});
          entries.emplace_back(row, number[static_cast<std::size_t>(lattice.at(2, other, d))], factor * a);
        });
      }
    });
    auto const n = static_cast<Eigen::Index>(place.size());
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    factors.compute(matrix);
    bool const found_factors = factors.info() == Eigen::Success;
    double const least = found_factors ? factors.vectorD().minCoeff() / factors.vectorD().maxCoeff() : 0;
    // A zero that rounding has made positive is no pivot.
    if (!(least > 1e-10))
      throw Singular(
          name,
          "only constants may be in the kernel of the matrix; least pivot on the coarsest lattice, "
          "relative to the largest",
          least, 1e-10);
    right.resize(n), found.resize(n);
  }
  void solve(std::vector<float> const& r, std::vector<float>& x) {
    for (std::size_t k = 0; k < place.size(); ++k) right[static_cast<Eigen::Index>(k)] = r[place[k]];
    found = factors.solve(right);
    for (std::size_t k = 0; k < place.size(); ++k)
      x[place[k]] = static_cast<float>(found[static_cast<Eigen::Index>(k)]);
  }
};

/// One V-cycle.
struct Cycle {
  std::vector<Level>& levels;
  Coarsest& coarsest;

  [[gnu::always_inline]] void operator()() {
    std::size_t const last = levels.size() - 1;
    for (std::size_t l = 0; l < last; ++l) {
      levels[l].sweep_from_zero();
      levels[l].restrict_to(levels[l + 1]);
    }
    coarsest.solve(levels[last].r, levels[last].x);
    for (std::size_t l = last; l-- > 0;) {
      levels[l].interpolate_from(levels[l + 1]);
      levels[l].sweep_back();
    }
  }
};

/// How many cells a lattice has.
int count(TwoColourLattice const& lattice) {
  int sum = 0;
  lattice.each_site([&](Diagonals s) { sum += lattice.holds(0, s) + lattice.holds(1, s); });
  return sum;
}
/// What is at the sides of a box, as the sums of the rows of its matrix show.
struct Sides {
  Walls walls{};
  std::size_t pinned = 0;  ///< number of the only cell whose row has a sum, if there is one
  double pin = 0;          ///< this sum; 0: there is none
  bool closed = false;     ///< whether constants are in the kernel of the matrix, without the pin

  explicit Sides(NinePointMatrix const& m) {
    std::vector<double> const ones(m.size(), 1.0);
    std::vector<double> sums(m.size());
    m.product(ones.data(), sums.data());
    std::size_t open = 0;
    for (std::size_t k = 0; k < sums.size(); ++k)
      if (std::abs(sums[k]) > 1e-10 * m.self[k]) ++open, pinned = k;
    closed = open <= 1;
    if (open == 1) pin = std::exchange(sums[pinned], 0.0);
    for (std::size_t side = 0; side < 4; ++side) {
      std::size_t const axis = side / 2;
      int const across = side % 2 ? m.cells[axis] - 1 : 0, along = m.cells[1 - axis];
      // Corners belong to two sides.
      int const corner = along > 2 ? 1 : 0;
      double sum = 0, self = 0;
      for (int k = corner; k < along - corner; ++k) {
        std::size_t const at = axis == 0 ? m.at(across, k) : m.at(k, across);
        sum += std::abs(sums[at]), self += m.self[at];
      }
      walls[side] = sum <= 0.05 * self;
    }
  }
};

/// Refuses what has no hierarchy.
void require_sound(NinePointMatrix const& m) {
  for (int axis = 0; axis < 2; ++axis) {
    if (m.cells[axis] < 2)
      throw OutsideDomain(name, "a box needs two cells along each direction", m.cells[axis], 2);
    if (m.periodic[axis] && m.cells[axis] % 4 != 0)
      throw OutsideDomain(
          name, "cells along a periodic direction must be a multiple of four; cells, less such a multiple",
          m.cells[axis] % 4, 0);
  }
  for (auto const* part : {&m.self, &m.east, &m.north, &m.north_east, &m.north_west}) {
    Size size{part->data(), part->size()};
    run_with(Registers::plain, size);
    if (!std::isfinite(size.sum)) throw NotFinite(name);
  }
  double const least = *std::min_element(m.self.begin(), m.self.end());
  if (!(least > 0)) throw OutsideDomain(name, "the diagonal must be positive; its least entry", least, 0);
}

}  // namespace
}  // namespace detail

using namespace detail;

/// The lattices, from the finest to the coarsest.
struct TwoColourMultigrid::Hierarchy {
  Registers registers = Registers::plain;  ///< for which cycles are compiled
  std::array<int, 2> cells{};              ///< of the box
  std::vector<Level> levels;               ///< the finest first
  Coarsest coarsest;                       ///< what is solved by factors
  double factor = 1;                       ///< by which the matrix is multiplied
  std::size_t pinned = 0;                  ///< number of the only cell whose row has a sum, if there is one
  double pin = 0;                          ///< this sum; 0: there is none
  bool floats = false;                     ///< whether constants are in the kernel of the matrix
  std::ptrdiff_t in_field = 0;             ///< where the cell is in a field
};

TwoColourMultigrid::TwoColourMultigrid(Registers registers) : hierarchy_(std::make_unique<Hierarchy>()) {
  hierarchy_->registers = registers;
}
TwoColourMultigrid::TwoColourMultigrid(TwoColourMultigrid&&) noexcept = default;
TwoColourMultigrid& TwoColourMultigrid::operator=(TwoColourMultigrid&&) noexcept = default;
TwoColourMultigrid::~TwoColourMultigrid() = default;

bool TwoColourMultigrid::can_be_coarsened(std::array<int, 2> cells, std::array<bool, 2> periodic) {
  return cells[0] >= 2 && cells[1] >= 2 && TwoColourLattice::of_cells(cells, periodic).can_be_coarsened();
}

void TwoColourMultigrid::build(NinePointMatrix const& matrix) {
  require_sound(matrix);
  Hierarchy& h = *hierarchy_;
  h.cells = matrix.cells;
  CellMatrix cells(matrix);
  // A power of two brings the largest entry near 1.
  h.factor = std::ldexp(1.0, -std::ilogb(*std::max_element(matrix.self.begin(), matrix.self.end())));

  Sides const sides(matrix);
  h.pinned = cells.pinned = sides.pinned, h.pin = cells.pin = sides.pin, h.in_field = cells.place(h.pinned);
  h.floats = sides.closed && sides.pin == 0;

  std::size_t number = 0;
  auto const go_on = [&](auto const& m) -> std::optional<CoarseMatrix> {
    if (h.levels.size() <= number) h.levels.emplace_back();
    Level& level = h.levels[number++];
    level.take(m, h.factor);
    if (count(m.lattice) <= few || !m.lattice.can_be_coarsened()) {
      h.coarsest.take(m, h.factor, sides.closed);
      return {};
    }
    Interpolation const p(m.lattice, sides.walls);
    level.join(p);
    return coarsened(m, p);
  };
  for (auto next = go_on(cells); next;) next = go_on(*next);
  h.levels.resize(number);
}

void TwoColourMultigrid::apply(double const* r, double* delta) {
  Hierarchy& h = *hierarchy_;
  Level& finest = h.levels.front();
  std::size_t const count = static_cast<std::size_t>(h.cells[0]) * static_cast<std::size_t>(h.cells[1]);
  Size size{r, count};
  run_with(h.registers, size);
  if (size.largest == 0 || !std::isfinite(size.sum)) {
    std::fill_n(delta, count,
                size.largest == 0 && size.sum == 0 ? 0.0 : std::numeric_limits<double>::quiet_NaN());
    return;
  }
  double const scale = std::ldexp(1.0, -std::ilogb(size.largest));
  double const cells = static_cast<double>(count);
  Transfer<true> take{finest.lattice, finest.r.data(), r, h.cells[0], h.cells[1], scale};
  if (h.floats) take.more = -size.sum / cells;
  run_with(h.registers, take);
  // S = S' + pin e e^T with S' 1 = 0: the equations add up to pin times the pressure of the pinned cell.
  if (h.pin != 0) finest.r[h.in_field] = static_cast<float>(scale * (r[h.pinned] - size.sum));
  Cycle cycle{h.levels, h.coarsest};
  run_with(h.registers, cycle);
  Transfer<false> give{finest.lattice, finest.x.data(), delta, h.cells[0], h.cells[1], h.factor / scale};
  if (h.pin != 0) give.more = size.sum / h.pin - give.factor * static_cast<double>(finest.x[h.in_field]);
  run_with(h.registers, give);
  if (!h.floats) return;
  Size found{delta, count};
  run_with(h.registers, found);
  for (std::size_t k = 0; k < count; ++k) delta[k] -= found.sum / cells;
}

}  // namespace actio::media
