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

/// Rows of a shared lattice that each rank has at least. Coarser ones every rank has whole.
constexpr int fewest_rows = 16;

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

  Sides(NinePointMatrix const& m, RowShare const& rows) {
    std::vector<double> const ones(m.size(), 1.0);
    std::vector<double> sums(m.size()), selves = m.self;
    m.product(ones.data(), sums.data());
    rows.whole(std::span(sums)), rows.whole(std::span(selves));
    std::size_t open = 0;
    for (std::size_t k = 0; k < sums.size(); ++k)
      if (std::abs(sums[k]) > 1e-10 * selves[k]) ++open, pinned = k;
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
        sum += std::abs(sums[at]), self += selves[at];
      }
      walls[side] = sum <= 0.05 * self;
    }
  }
};

/// Refuses what has no hierarchy.
void require_sound(NinePointMatrix const& m, RowShare const& rows) {
  for (int axis = 0; axis < 2; ++axis) {
    if (m.cells[axis] < 2)
      throw OutsideDomain(name, "a box needs two cells along each direction", m.cells[axis], 2);
    if (m.periodic[axis] && m.cells[axis] % 4 != 0)
      throw OutsideDomain(
          name, "cells along a periodic direction must be a multiple of four; cells, less such a multiple",
          m.cells[axis] % 4, 0);
  }
  bool finite = true;
  double least = HUGE_VAL;
  for (RowRange const& of : rows.with(0, 0, m.cells[0]))
    for (auto const* part : {&m.self, &m.east, &m.north, &m.north_east, &m.north_west}) {
      Size size{part->data() + of.from, static_cast<std::size_t>(of.count())};
      run_with(Registers::plain, size);
      finite = finite && std::isfinite(size.sum);
      if (part == &m.self)
        least = std::min(least, *std::min_element(m.self.data() + of.from, m.self.data() + of.to));
    }
  if (rows.any(!finite)) throw NotFinite(name);
  least = -rows.most(-least);
  if (!(least > 0)) throw OutsideDomain(name, "the diagonal must be positive; its least entry", least, 0);
}

}  // namespace
}  // namespace detail

using namespace detail;

/// The lattices, from the finest to the coarsest.
struct TwoColourMultigrid::Hierarchy {
  RowShare rows;                           ///< of cells
  Registers registers = Registers::plain;  ///< for which cycles are compiled
  std::array<int, 2> cells{};              ///< of the box
  std::vector<Level> levels;               ///< the finest first
  Coarsest coarsest;                       ///< what is solved by factors
  double factor = 1;                       ///< by which the matrix is multiplied
  std::size_t pinned = 0;                  ///< number of the only cell whose row has a sum, if there is one
  double pin = 0;                          ///< this sum; 0: there is none
  bool has_pinned = false;                 ///< whether that cell is in a row of this rank's lattice
  bool floats = false;                     ///< whether constants are in the kernel of the matrix
  std::ptrdiff_t in_field = 0;             ///< where the cell is in a field
};

TwoColourMultigrid::TwoColourMultigrid(Registers registers, RowShare rows)
    : hierarchy_(std::make_unique<Hierarchy>()) {
  hierarchy_->registers = registers, hierarchy_->rows = std::move(rows);
}
TwoColourMultigrid::TwoColourMultigrid(TwoColourMultigrid&&) noexcept = default;
TwoColourMultigrid& TwoColourMultigrid::operator=(TwoColourMultigrid&&) noexcept = default;
TwoColourMultigrid::~TwoColourMultigrid() = default;

bool TwoColourMultigrid::can_be_coarsened(std::array<int, 2> cells, std::array<bool, 2> periodic) {
  return cells[0] >= 2 && cells[1] >= 2 && TwoColourLattice::of_cells(cells, periodic).can_be_coarsened();
}

bool TwoColourMultigrid::can_be_shared(int rows, int ranks) { return rows >= fewest_rows * ranks; }

void TwoColourMultigrid::build(NinePointMatrix const& matrix) {
  Hierarchy& h = *hierarchy_;
  h.cells = matrix.cells;
  if (h.rows.alone()) h.rows = RowShare(nullptr, matrix.cells[1], matrix.periodic[1]);
  require_sound(matrix, h.rows);
  CellMatrix cells(matrix);
  // A power of two brings the largest entry near 1.
  double largest = 0;
  for_each(h.rows.with(0, 0, h.cells[0]),
           [&](std::size_t k) { largest = std::max(largest, matrix.self[k]); });
  h.factor = std::ldexp(1.0, -std::ilogb(h.rows.most(largest)));

  Sides const sides(matrix, h.rows);
  h.pinned = cells.pinned = sides.pinned, h.pin = cells.pin = sides.pin, h.in_field = cells.place(h.pinned);
  h.floats = sides.closed && sides.pin == 0;
  std::vector<int> cuts = h.rows.cuts();
  cuts.front() = cells.lattice.low(), cuts.back() = cells.lattice.high();
  RowShare rows(h.rows.ranks(), cuts, h.rows.round());
  std::size_t number = 0;
  auto const go_on = [&](auto const& m) -> std::optional<CoarseMatrix> {
    if (h.levels.size() <= number) h.levels.emplace_back();
    Level& level = h.levels[number++];
    level.take(m, h.factor, rows);
    if (count(m.lattice) <= few || !m.lattice.can_be_coarsened()) {
      h.coarsest.take(m, h.factor, sides.closed);
      return {};
    }
    Interpolation const p(m.lattice, sides.walls);
    level.join(p);
    auto next = coarsened(m, p, level.own_of_next());
    for (int& cut : cuts) cut = Level::halved(cut);
    rows = RowShare(rows.ranks(), cuts, rows.round());
    std::span const entries(next.sites);
    if (rows.fewest() >= fewest_rows)
      rows.exchange(entries, 2);
    else
      rows.whole(entries), cuts = {cuts.front(), cuts.back()}, rows = RowShare(nullptr, cuts, rows.round());
    return next;
  };
  for (auto next = go_on(cells); next;) next = go_on(*next);
  h.levels.resize(number);
  Level const& finest = h.levels.front();
  int const row = Level::row_of(finest.lattice, h.in_field);
  h.has_pinned = row >= finest.own().from && row < finest.own().to;
}

void TwoColourMultigrid::apply(double const* r, double* delta) {
  Hierarchy& h = *hierarchy_;
  Level& finest = h.levels.front();
  std::size_t const count = static_cast<std::size_t>(h.cells[0]) * static_cast<std::size_t>(h.cells[1]);
  Size const size = size_of(r, h.rows, h.cells[0], h.registers);
  if (size.largest == 0 || !std::isfinite(size.sum)) {
    std::fill_n(delta, count,
                size.largest == 0 && size.sum == 0 ? 0.0 : std::numeric_limits<double>::quiet_NaN());
    return;
  }
  double const scale = std::ldexp(1.0, -std::ilogb(size.largest));
  double const cells = static_cast<double>(count);
  Ranges const given = h.rows.with(0, 1, 1), found = h.rows.with(1, 1, 1);
  Transfer<true> take{finest.lattice, finest.r.data(), r, h.cells[0], h.cells[1], given, scale};
  if (h.floats) take.more = -size.sum / cells;
  run_with(h.registers, take);
  // S = S' + pin e e^T with S' 1 = 0: the equations add up to pin times the pressure of the pinned cell.
  if (h.pin != 0 && h.has_pinned) finest.r[h.in_field] = static_cast<float>(scale * (r[h.pinned] - size.sum));
  Cycle cycle{h.levels, h.coarsest};
  run_with(h.registers, cycle);
  finest.settle(finest.x);
  Transfer<false> give{finest.lattice, finest.x.data(), delta,           h.cells[0],
                       h.cells[1],     found,           h.factor / scale};
  if (h.pin != 0) {
    // Of the rank that has it.
    double const here = h.has_pinned ? static_cast<double>(finest.x[h.in_field]) : -HUGE_VAL;
    give.more = size.sum / h.pin - give.factor * (h.rows.alone() ? here : h.rows.ranks()->most(here));
  }
  run_with(h.registers, give);
  if (!h.floats) return;
  double const mean = size_of(delta, h.rows, h.cells[0], h.registers).sum / cells;
  for_each(h.rows.with(1, 1, h.cells[0]), [&](std::size_t k) { delta[k] -= mean; });
}

}  // namespace actio::media
