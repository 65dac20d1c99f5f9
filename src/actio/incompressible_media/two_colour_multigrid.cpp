// In a unit of its own
#include "actio/incompressible_media/two_colour_multigrid.hpp"

#include <Eigen/SparseCholesky>

#include <cmath>
#include <limits>

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
    double const least = factors.info() == Eigen::Success ? factors.vectorD().minCoeff() : 0;
    if (!(least > 0))
      throw Singular(name, "the matrix must be positive definite; least pivot on the coarsest lattice", least,
                     0);
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

struct TwoColourMultigrid::Hierarchy {
  Registers registers = Registers::plain;
  std::array<int, 2> cells{};
  std::vector<Level> levels;
  Coarsest coarsest;
  double factor = 1;                ///< by which the matrix is multiplied
  std::size_t pinned = 0;           ///< number of the only cell whose row has a sum, if there is one
  double pin = 0;                   ///< this sum; 0: there is none
  std::ptrdiff_t pinned_place = 0;  ///< where the cell is in a field
  bool singular = false;            ///< whether constants are in the kernel of the matrix, without the pin
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

  // Rows with a sum: none or one for a box that is closed, and many along a free side.
  std::vector<double> const ones(matrix.size(), 1.0);
  std::vector<double> sums(matrix.size());
  matrix.product(ones.data(), sums.data());
  std::size_t open = 0;
  for (std::size_t k = 0; k < sums.size(); ++k)
    if (std::abs(sums[k]) > 1e-10 * matrix.self[k]) ++open, h.pinned = k;
  h.singular = open <= 1;
  h.pin = open == 1 ? sums[h.pinned] : 0;
  if (open == 1) cells.pinned = h.pinned, cells.pin = h.pin, sums[h.pinned] = 0;
  Walls walls;
  for (int side = 0; side < 4; ++side) {
    int const axis = side / 2, across = side % 2 ? matrix.cells[axis] - 1 : 0;
    double sum = 0, self = 0;
    for (int k = 1; k < matrix.cells[1 - axis] - 1; ++k) {
      std::size_t const at = axis == 0 ? matrix.at(across, k) : matrix.at(k, across);
      sum += std::abs(sums[at]), self += matrix.self[at];
    }
    walls[side] = sum <= 0.05 * self;
  }

  std::vector<CoarseMatrix> coarse;
  std::size_t number = 0;
  auto const go_on = [&](auto const& m) {
    if (h.levels.size() <= number) h.levels.emplace_back();
    Level& level = h.levels[number++];
    level.take(m, h.factor);
    if (count(m.lattice) <= few || !m.lattice.can_be_coarsened()) {
      h.coarsest.take(m, h.factor, h.singular);
      return false;
    }
    Interpolation const p(m.lattice, walls);
    level.join(p);
    CoarseMatrix next = coarsened(m, p);
    coarse.push_back(std::move(next));
    return true;
  };
  bool more = go_on(cells);
  while (more) {
    CoarseMatrix const m = std::move(coarse.back());
    more = go_on(m);
  }
  h.levels.resize(number);
  h.pinned_place = cells.place(h.pinned);
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
  Transfer<true> take{finest.lattice, finest.r.data(), r, h.cells[0], h.cells[1], scale};
  run_with(h.registers, take);
  // S = S' + pin e e^T with S' 1 = 0: the equations add up to pin times the pressure of the pinned cell.
  if (h.pin != 0) finest.r[h.pinned_place] = static_cast<float>(scale * (r[h.pinned] - size.sum));
  Cycle cycle{h.levels, h.coarsest};
  run_with(h.registers, cycle);
  Transfer<false> give{finest.lattice, finest.x.data(), delta, h.cells[0], h.cells[1], h.factor / scale};
  if (h.pin != 0) give.more = size.sum / h.pin - give.factor * static_cast<double>(finest.x[h.pinned_place]);
  run_with(h.registers, give);
}

}  // namespace actio::media
