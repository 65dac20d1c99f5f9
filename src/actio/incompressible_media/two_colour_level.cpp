#include "actio/incompressible_media/two_colour_level.hpp"

namespace actio::media::detail {

namespace {

/// Parts of rows of a field of two numbers a site, with the room around their sites.
std::span<float> parts(std::vector<float>& field, TwoColourLattice const& lattice, int row, int p,
                       int count) {
  auto const from = static_cast<std::size_t>(lattice.part(2, row, p, 0) - lanes / 2);
  return std::span(field).subspan(from, static_cast<std::size_t>(2 * lattice.stride() * count));
}

}  // namespace

std::vector<StoredEntry> const& stored_entries(bool of_cells) {
  static std::vector<StoredEntry> const cells{{0, 0, 1, 0}, {0, 0, 0, 1},  {1, 1, 1, 0}, {1, 1, 0, 1},
                                              {0, 1, 0, 0}, {0, 1, -1, 0}, {0, 1, 0, 1}, {0, 1, -1, 1}};
  static std::vector<StoredEntry> const sites = [] {
    std::vector<StoredEntry> all;
    for (int c = 0; c < 2; ++c)
      for (auto [du, dv] : {std::array{1, 0}, {0, 1}, {1, 1}, {1, -1}}) all.push_back({c, c, du, dv});
    for (int du = -1; du <= 1; ++du)
      for (int dv = -1; dv <= 1; ++dv) all.push_back({0, 1, du, dv});
    return all;
  }();
  return of_cells ? cells : sites;
}

template <class Matrix>
void Level::take(Matrix const& m, double factor, RowShare const& shared) {
  lattice = m.lattice, share = shared;
  auto const& stored = stored_entries(std::is_same_v<Matrix, CellMatrix>);
  numbers = 2 + static_cast<int>(stored.size());
  matrix.assign(lattice.room(numbers), 0.0f);
  for (auto* field : {&r, &x, &rest}) field->assign(lattice.room(2), 0.0f);
  rows.assign(static_cast<std::size_t>(in_row(lattice.high() + 2, 0, 2 * lanes)), 0.0f);
  // Which number of a site an entry is.
  int number[2][2][3][3] = {};
  for (std::size_t n = 0; n < stored.size(); ++n) {
    auto const& e = stored[n];
    number[e.from][e.to][e.du + 1][e.dv + 1] = 2 + static_cast<int>(n);
  }
  std::ptrdiff_t const stride = lattice.stride();
  float* const data = matrix.data();
  bool const closed = lattice.periodic[0] || lattice.periodic[1];
  RowRange const seen{own().from - 2, own().to + 2};
  lattice.each_site(seen, [&](Diagonals s) {
    std::ptrdiff_t const here = lattice.at(numbers, s, 0);
    for (int c = 0; c < 2; ++c) {
      if (!lattice.holds(c, s)) continue;
      data[here + c * stride] = static_cast<float>(1 / (factor * m.self(s, c)));
      m.each_entry(s, c, [&](int d, int du, int dv, double a) {
        if (int const n = number[c][d][du + 1][dv + 1]; n != 0)
          data[here + n * stride] = static_cast<float>(factor * a);
        if (!closed) return;
        // The other one of the pair may be out of the lattice, beyond the end of a period.
        Diagonals const other{s.u + du, s.v + dv}, back = lattice.wrapped(other);
        if (int const n = number[d][c][1 - du][1 - dv]; n != 0 && (back.u != other.u || back.v != other.v))
          data[lattice.at(numbers, other, n)] = static_cast<float>(factor * a);
      });
    }
  });
  // The terms of each part, for the site that is its first.
  for (int row = 0; row < 4; ++row)
    for (int p = 0; p < 2; ++p) {
      Diagonals const s = Diagonals::of(2 * p + (row & 1), row);
      for (int c = 0; c < 2; ++c) {
        auto const turn = [](Diagonals at, int colour) {
          return 4 * ((at.u + at.v) & 1) + 2 * (at.u & 1) + colour;
        };
        Terms before, after;
        auto const add = [&](int d, int du, int dv, int n, bool here) {
          Diagonals const other{s.u + du, s.v + dv};
          Terms& t = turn(other, d) < turn(s, c) ? before : after;
          t.term[static_cast<std::size_t>(t.count++)] = {
              lattice.at(numbers, here ? s : other, n) - lattice.part(numbers, row, p, 0),
              lattice.at(2, other, d) - lattice.at(2, s, c)};
        };
        for (std::size_t n = 0; n < stored.size(); ++n) {
          auto const& e = stored[n];
          if (e.from == c) add(e.to, e.du, e.dv, 2 + static_cast<int>(n), true);
          if (e.to == c) add(e.from, -e.du, -e.dv, 2 + static_cast<int>(n), false);
        }
        Terms& t = terms[row][p][c];
        t = before, t.before = before.count;
        for (int n = 0; n < after.count; ++n) t.term[static_cast<std::size_t>(t.count++)] = after.term[n];
      }
    }
}

template void Level::take(CellMatrix const&, double, RowShare const&);
template void Level::take(CoarseMatrix const&, double, RowShare const&);

void Level::join(Interpolation const& p) {
  Level next;
  next.lattice = p.coarse;
  // From the first site of each kind.
  for (int part = 0; part < 2; ++part) {
    Diagonals const s = Diagonals::of(2 * part, 0);
    int n = 0;
    for (auto [du, dv] :
         {std::array{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}})
      children[part][n++] = lattice.at(2, {s.u + du, s.v + dv}, 0) - lattice.at(2, s, 0);
  }
  for (int row = 0; row < 4; ++row)
    for (int part = 0; part < 2; ++part) {
      PartParents& parent = parents[row][part];
      parent.count = 0;
      Interpolation::each_parent(Diagonals::of(2 * part + (row & 1), row), [&](Diagonals s, double) {
        parent.place[parent.count++] = next.in_row(s, 0) - next.in_row(row >> 1, 0, 0);
      });
    }
  rim.clear();
  // Copies of rows are beyond the ends of a period.
  TwoColourLattice upper = p.coarse;
  upper.periodic[1] = upper.periodic[1] && share.alone();
  int const period = share.alone() || !lattice.periodic[1] ? 0 : lattice.to[0];
  RowRange const seen{own().from - 2, own().to + 2};
  lattice.each_site(seen, [&](Diagonals s) {
    if (!p.at_the_rim(s)) return;
    int const turns = s.row() < seen.from ? 1 : s.row() >= seen.to ? -1 : 0;
    Diagonals const here = Diagonals::of(s.column(), s.row() + turns * period);
    for (int c = 0; c < 2; ++c) {
      Shares const share_of = p.of(s, c);
      if (!lattice.holds(c, s) || (share_of.own == 1 && share_of.other == 0)) continue;
      Interpolation::each_parent(here, [&](Diagonals parent, double w) {
        for (int d = 0; d < 2; ++d) {
          double const more = w * (d == c ? share_of.own - 1 : share_of.other);
          Diagonals const to = upper.wrapped(parent);
          if (more != 0 && p.coarse.holds(d, parent))
            rim.push_back(
                {lattice.at(2, here, c), next.in_row(to, d), here.row(), to.row(), static_cast<float>(more)});
        }
      });
    }
  });
}

void Level::settle(std::vector<float>& field) const {
  if (share.alone() || !lattice.periodic[1]) return;
  int const rows = lattice.to[0];
  auto const put = [&](int from, int to) {
    std::ranges::copy(parts(field, lattice, from, 0, 4), parts(field, lattice, to, 0, 4).begin());
  };
  if (own().from == 0) put(-2, rows - 2);
  if (own().to == rows) put(rows, 0);
}

void Level::close_periodic(std::vector<float>& field, int j, int p, int c) const {
  float* const part = field.data() + lattice.part(2, j, p, c);
  int const half = lattice.sites() / 2, rows = lattice.to[0];
  if (lattice.periodic[0]) {
    if (p == 0)
      part[half] = part[0];
    else
      part[-1] = part[half - 1];
  }
  if (!lattice.periodic[1] || (j >= 2 && j < rows - 2)) return;
  // Four rows at least: a row is copied above or below, or both.
  for (int const to : {j + rows, j - rows})
    if (to >= -2 && to < rows + 2)
      std::memcpy(field.data() + lattice.part(2, to, p, c) - 1, part - 1,
                  sizeof(float) * static_cast<std::size_t>(lattice.stride() - 1));
}

void Level::close_rows(RowRange const& of) {
  int const sites = lattice.sites(), high = lattice.high();
  for (int c = 0; c < 2; ++c) {
    if (lattice.periodic[0])
      for (int j = of.from; j < of.to; ++j)
        rows[in_row(j, c, -1)] = rows[in_row(j, c, sites - 1)],
                          rows[in_row(j, c, sites)] = rows[in_row(j, c, 0)];
    if (lattice.periodic[1] && of.count() == high)
      for (auto [to, from] : {std::array{-1, high - 1}, {high, 0}})
        std::memcpy(&rows[in_row(to, c, -1)], &rows[in_row(from, c, -1)],
                    sizeof(float) * static_cast<std::size_t>(sites + 2));
  }
}

void Level::copy_class(int parity, int q) {
  if (share.alone()) return;
  RowRange const mine = own();
  // One of two rows is of this class.
  auto const one = [&](int of_two) {
    int const row = of_two + ((of_two + parity) & 1);
    return parts(x, lattice, row, lattice.part_of_class(row, q), 1);
  };
  share.swap(one(mine.from), one(mine.to), one(mine.to - 2), one(mine.from - 2));
}

void Level::copy_rows(std::vector<float>& field) const {
  if (share.alone()) return;
  RowRange const mine = own();
  auto const two = [&](int row) { return parts(field, lattice, row, 0, 4); };
  share.swap(two(mine.from), two(mine.to), two(mine.to - 2), two(mine.from - 2));
}

void Level::give_whole(Level& next) const {
  if (share.alone()) return;
  std::vector<int> cuts;
  for (int const cut : share.cuts()) cuts.push_back(halved(cut));
  RowShare(share.ranks(), cuts, share.round()).whole(parts(next.r, next.lattice, 0, 0, 2 * cuts.back()));
}

}  // namespace actio::media::detail
