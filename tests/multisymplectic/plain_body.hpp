// A body on a mesh of any shape, counted by hand: energies as sums over corners over any scalar, and forces
// as their derivatives. The meshes have no symmetry, and neither have the places of their nodes.
#pragma once

#include <boost/test/unit_test.hpp>

#include "actio/media_on_meshes/body_forces.hpp"
#include "witness/draw.hpp"

namespace actio::testing {

template <int d>
using Spot = std::array<double, d>;
template <class T>
using List = std::vector<T>;

/// A solid with a fibre along the first direction, whose stored energy goes with the square of the density.
struct Fibred {
  template <class F>
  auto operator()(F const& f) const {
    auto const stretch = f.col(0).squaredNorm() - 1.0;
    return f.squaredNorm() * 0.3 + stretch * stretch * 0.2 + 1.0 / media::small_determinant(f);
  }
};

/// A mesh, and places of its nodes at the start: both with every node moved by a part of a cell.
struct Sample {
  media::BodyMesh mesh;
  List<double> x, u;
};
template <int d>
Sample sample(media::BodyMesh mesh, Draw& draw, double width) {
  Sample out;
  for (auto& node : mesh.nodes)
    for (int a = 0; a < d; ++a) {
      out.x.push_back(1.1 * node[a] + 0.2 * node[(a + 1) % d] + 0.07 * width * draw.number<double>());
      node[a] += 0.07 * width * draw.number<double>(), out.u.push_back(draw.number<double>());
    }
  out.mesh = std::move(mesh);
  return out;
}
inline media::BodyMesh two_triangles() {
  media::BodyMesh mesh;
  mesh.shape = media::CellShape::triangle, mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.cells = {{0, 1, 2}, {3, 2, 1}};
  mesh.sides = {{"right", {{1, 3, -1, -1}}}, {"top", {{3, 2, -1, -1}}}};
  return mesh;
}
inline media::BodyMesh two_tetrahedra() {
  media::BodyMesh mesh;
  mesh.dimension = 3, mesh.shape = media::CellShape::tetrahedron;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  mesh.cells = {{0, 1, 2, 3}, {4, 2, 1, 3}};
  mesh.sides = {{"right", {media::facet_nodes(mesh, {1, 1})}}, {"top", {media::facet_nodes(mesh, {1, 2})}}};
  return mesh;
}

inline double density_at(auto const& X) {
  double sum = 1.5;
  for (std::size_t a = 0; a < X.size(); ++a) sum += 0.2 / (1.0 + double(a)) * X[a];
  return sum;
}
/// Of the fifth degree: two points of Gauss do not have its mean slope.
struct Hill {
  template <class X>
  auto operator()(X const& x) const {
    auto sum = x[0] * x[x.size() - 1] * 0.1;
    for (int a = 0; a < int(x.size()); ++a) sum = sum + x[a] * x[a] * x[a] * x[a] * x[a] * (0.2 / (a + 1.0));
    return sum;
  }
};

/// Corners, or the single point of a simplex, counted by hand.
template <int d>
struct PlainBody {
  media::BodyMesh const& mesh;
  bool simplex = media::is_simplex(mesh.shape) || d == 1;
  int corners = media::corner_count(mesh.shape), points = simplex ? 1 : corners;
  double pressure = 0, hill = 0, bowl = 0;  // the pressure from outside, and factors of two potentials

  template <class T>
  Matrix<T, d, d> edges(List<T> const& x, int cell, int p) const {
    Matrix<T, d, d> out;
    auto const at = [&](int b, int i) {
      bool const beyond = !mesh.wraps.empty() && (mesh.wraps[cell][b] >> i & 1);
      return x[std::size_t(mesh.cells[cell][b] * d + i)] + (beyond ? mesh.periods[i] : 0.0);
    };
    for (int k = 0; k < d; ++k)
      for (int i = 0; i < d; ++i)
        out(i, k) = simplex ? at(k + 1, i) - at(0, i) : at(p | 1 << k, i) - at(p & ~(1 << k), i);
    return out;
  }
  List<double> reference() const {
    List<double> out;
    for (auto const& node : mesh.nodes) out.insert(out.end(), node.begin(), node.begin() + d);
    return out;
  }
  /// The slope of the multilinear map of a box-like cell at u in the unit cube, and those of the hat
  /// functions of its corners in the body.
  struct Slopes {
    Matrix<double, d, d> map = Matrix<double, d, d>::Zero();
    Matrix<double, d, 1 << d> hats = Matrix<double, d, 1 << d>::Zero();
    double jacobian = 0;
  };
  Slopes slopes(int cell, Spot<3> const& u) const {
    Slopes out;
    Matrix<double, d, 1 << d> by_u;
    for (int b = 0; b < 1 << d; ++b)
      for (int i = 0; i < d; ++i) {
        by_u(i, b) = b >> i & 1 ? 1 : -1;
        for (int k = 0; k < d; ++k)
          if (k != i) by_u(i, b) *= b >> k & 1 ? u[std::size_t(k)] : 1 - u[std::size_t(k)];
        for (int a = 0; a < d; ++a)
          out.map(a, i) += media::corner_place(mesh, cell, b)[std::size_t(a)] * by_u(i, b);
      }
    out.hats = inverse_matrix(out.map).transpose() * by_u, out.jacobian = media::small_determinant(out.map);
    return out;
  }
  /// f at points of the unit cube, with their weights: the corners (0), or as many of Gauss' along each axis.
  template <class F>
  static void each_point_of_rule(int count, F const& f) {
    double const two = std::sqrt(1.0 / 12), three = std::sqrt(0.15);
    List<double> const at = count == 0   ? List<double>{0, 1}
                            : count == 2 ? List<double>{0.5 - two, 0.5 + two}
                                         : List<double>{0.5 - three, 0.5, 0.5 + three};
    List<double> const of = count == 3 ? List<double>{5.0 / 18, 8.0 / 18, 5.0 / 18} : List<double>{0.5, 0.5};
    std::size_t const n = at.size(), all = d == 1 ? n : d == 2 ? n * n : n * n * n;
    for (std::size_t k = 0; k < all; ++k) {
      std::size_t const i[] = {k % n, k / n % n, k / n / n};
      f(Spot<3>{at[i[0]], at[i[1]], at[i[2]]}, of[i[0]] * (d > 1 ? of[i[1]] : 1) * (d > 2 ? of[i[2]] : 1));
    }
  }
  /// The volume of a box-like cell, and the integrals of the slopes of its hat functions, by a rule.
  std::pair<double, Matrix<double, d, 1 << d>> integrals(int cell, int rule) const {
    std::pair<double, Matrix<double, d, 1 << d>> out{0, Matrix<double, d, 1 << d>::Zero()};
    each_point_of_rule(rule, [&](Spot<3> const& u, double w) {
      auto const s = slopes(cell, u);
      out.first += w * s.jacobian, out.second += s.hats * (w * s.jacobian);
    });
    return out;
  }
  /// By what volumes of corners are multiplied: two points of Gauss have the volume of a cell.
  double ratio(int cell) const { return simplex ? 1 : integrals(cell, 2).first / integrals(cell, 0).first; }
  double volume(int cell, int p) const {
    double const parts[] = {1, 2, 4, 6, 8};
    return media::small_determinant(edges(reference(), cell, p)) / parts[int(mesh.shape)] * ratio(cell);
  }
  /// The mean of a density that is linear in X, or of its square, under the hat function of a corner; of all
  /// (b = -1) on a line or a simplex.
  double mean(int cell, int b, int power) const {
    // The mean of a product of hat functions by exponents: of x^m (1-x)^n it is m! n!/(m+n+1)!.
    double const factorial[] = {1, 1, 2, 6, 24, 120, 720};
    auto const product = [&](List<int> const& hats) {
      double out = 1;
      if (media::is_simplex(mesh.shape)) {
        out = factorial[d] / factorial[std::size_t(d) + hats.size()];
        for (int c = 0; c < corners; ++c) out *= factorial[std::count(hats.begin(), hats.end(), c)];
      } else
        for (int k = 0; k < d; ++k) {
          long const up = std::count_if(hats.begin(), hats.end(), [&](int c) { return c >> k & 1; }),
                     all = long(hats.size());
          out *= factorial[up] * factorial[all - up] / factorial[all + 1];
        }
      return out;
    };
    List<int> const with = b < 0 ? List<int>{} : List<int>{b};
    auto const rho = [&](int c) {
      auto const X = media::corner_place(mesh, cell, c);
      Spot<d> at;
      for (int a = 0; a < d; ++a) at[a] = X[a];
      return density_at(at);
    };
    double sum = 0;
    for (int c = 0; c < corners; ++c)
      for (int e = 0; e < (power == 2 ? corners : 1); ++e) {
        List<int> hats = with;
        hats.push_back(c);
        if (power == 2) hats.push_back(e);
        sum += rho(c) * (power == 2 ? rho(e) : 1) * product(hats);
      }
    return sum / product(with);
  }
  /// What the integral over a box-like cell of a density that is linear in X, or of its square, has of the
  /// sum over its corners.
  double share(int cell, int power) const {
    if (simplex) return 1;
    double sum = 0, exact = 0;
    for (int b = 0; b < corners; ++b) sum += volume(cell, b) * mean(cell, b, power);
    each_point_of_rule(3, [&](Spot<3> const& u, double w) {
      Spot<d> X{};
      for (int b = 0; b < corners; ++b) {
        double hat = 1;
        for (int k = 0; k < d; ++k) hat *= b >> k & 1 ? u[std::size_t(k)] : 1 - u[std::size_t(k)];
        for (std::size_t a = 0; a < d; ++a) X[a] += hat * media::corner_place(mesh, cell, b)[a];
      }
      exact += w * slopes(cell, u).jacobian * std::pow(density_at(X), power);
    });
    return exact / sum;
  }
  double weight(int cell, int p) const {
    return volume(cell, p) * mean(cell, simplex ? -1 : p, 2) * share(cell, 2);
  }
  List<double> masses() const {
    List<double> out(mesh.nodes.size(), 0);
    for (int cell = 0; cell < int(mesh.cells.size()); ++cell)
      for (int b = 0; b < corners; ++b)
        out[std::size_t(mesh.cells[cell][b])] +=
            (simplex ? volume(cell, 0) / corners : volume(cell, b)) * mean(cell, b, 1) * share(cell, 1);
    return out;
  }
  /// From the edges of a point; of box-like cells all points have as much more as makes the mean over the
  /// cell that of the multilinear map.
  template <class T>
  Matrix<T, d, d> gradient(List<T> const& x, int cell, int p) const {
    Matrix<T, d, d> F = edges(x, cell, p) * inverse_matrix(edges(reference(), cell, p)).template cast<T>();
    if (simplex) return F;
    auto const exact = integrals(cell, 2), found = integrals(cell, 0);
    Matrix<double, d, 1 << d> const more = (exact.second - found.second * ratio(cell)) * (1 / exact.first);
    for (int b = 0; b < corners; ++b)
      for (int a = 0; a < d; ++a)
        for (int i = 0; i < d; ++i)
          F(a, i) = F(a, i) +
                    (corner(x, cell, b)[std::size_t(a)] - corner(x, cell, 0)[std::size_t(a)]) * more(i, b);
    return F;
  }
  /// Stored energy, that of the outside pressure and of the potential.
  template <class T>
  T energy(List<T> const& x) const {
    T sum(0.0);
    for (int cell = 0; cell < int(mesh.cells.size()); ++cell)
      for (int p = 0; p < points; ++p) {
        auto const F = gradient(x, cell, p);
        sum = sum + Fibred{}(F)*weight(cell, p) + media::small_determinant(F) * (pressure * volume(cell, p));
      }
    auto const m = masses();
    for (std::size_t k = 0; k < m.size(); ++k) {
      Matrix<T, d, 1> at;
      for (int a = 0; a < d; ++a) at[a] = x[k * d + std::size_t(a)];
      sum = sum + Hill{}(at) * (hill * m[k]) + at.squaredNorm() * (bowl * m[k]);
    }
    return sum;
  }
  /// Minus the derivative of the energy by each place.
  template <class T>
  List<T> forces(List<T> const& x) const {
    List<T> f;
    List<Dual<T>> moved;
    for (T const& one : x) moved.emplace_back(one);
    for (std::size_t k = 0; k < x.size(); ++k) {
      moved[k] = variable(x[k]);
      f.push_back(-rate_of(energy(moved)));
      moved[k] = Dual<T>(x[k]);
    }
    return f;
  }
  /// The vectors of area of a facet at its corners, outwards: half of an edge, a third of a triangle, of
  /// a quadrilateral the integral of the hat function.
  List<std::pair<int, Spot<d>>> areas(List<double> const& x, std::array<int, 4> const& facet) const {
    int const n = int(std::count_if(facet.begin(), facet.end(), [](int node) { return node >= 0; }));
    // The cell that has all of its nodes, and where these are as corners of that cell.
    List<Spot<3>> at;
    Spot<3> middle{};
    for (int cell = 0; int(at.size()) < n; ++cell) {
      at.clear(), middle = {};
      for (int k = 0; k < n; ++k)
        for (int b = 0; b < corners; ++b)
          if (mesh.cells[cell][b] == facet[k]) at.push_back(corner(x, cell, b));
      for (int b = 0; b < corners; ++b)
        for (std::size_t a = 0; a < 3; ++a) middle[a] += corner(x, cell, b)[a] / corners;
    }
    List<std::pair<int, Spot<d>>> out;
    for (int k = 0; k < n; ++k) {
      Spot<3> const o = at[k], p = at[(k + 1) % n], q = at[(k + n - 1) % n];
      Spot<3> area{1, 0, 0};
      if (d == 2) area = {(p[1] - o[1]) / 2, (o[0] - p[0]) / 2, 0};
      if (d == 3)
        for (std::size_t i = 0, j = 1, l = 2; i < 3; ++i, j = (j + 1) % 3, l = (l + 1) % 3)
          area[i] = ((p[j] - o[j]) * (q[l] - o[l]) - (p[l] - o[l]) * (q[j] - o[j])) / 6;
      if (d == 3 && n == 4) area = area_with_hat(at, k);
      double outwards = 0;
      for (std::size_t i = 0; i < 3; ++i) outwards += area[i] * (o[i] - middle[i]);
      Spot<d> with_sign;
      for (std::size_t i = 0; i < d; ++i) with_sign[i] = outwards > 0 ? area[i] : -area[i];
      out.emplace_back(facet[k], with_sign);
    }
    return out;
  }
  /// The integral of a corner's hat function over a quadrilateral, as a vector, by points of Gauss.
  static Spot<3> area_with_hat(List<Spot<3>> const& at, int k) {
    Spot<3> area{};
    double const off = std::sqrt(1.0 / 12);
    for (double const s : {0.5 - off, 0.5 + off})
      for (double const t : {0.5 - off, 0.5 + off}) {
        double const hat[] = {(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t};
        Spot<3> by_s, by_t;
        for (std::size_t i = 0; i < 3; ++i)
          by_s[i] = (at[1][i] - at[0][i]) * (1 - t) + (at[2][i] - at[3][i]) * t,
          by_t[i] = (at[3][i] - at[0][i]) * (1 - s) + (at[2][i] - at[1][i]) * s;
        for (std::size_t i = 0, j = 1, l = 2; i < 3; ++i, j = (j + 1) % 3, l = (l + 1) % 3)
          area[i] += hat[k] / 4 * (by_s[j] * by_t[l] - by_s[l] * by_t[j]);
      }
    return area;
  }
  template <class T>
  std::array<T, 3> corner(List<T> const& x, int cell, int b) const {
    std::array<T, 3> out{};
    for (int a = 0; a < d; ++a) {
      bool const beyond = !mesh.wraps.empty() && (mesh.wraps[cell][b] >> a & 1);
      out[std::size_t(a)] =
          x[std::size_t(mesh.cells[cell][b] * d + a)] + (beyond ? mesh.periods[std::size_t(a)] : 0.0);
    }
    return out;
  }
};

inline double apart(List<double> const& a, List<double> const& b) {
  BOOST_REQUIRE(a.size() == b.size());
  double worst = 0;
  for (std::size_t k = 0; k < a.size(); ++k) worst = std::max(worst, std::abs(a[k] - b[k]));
  return worst;
}
inline List<double> plus(List<double> a, List<double> const& b, double by) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] += by * b[k];
  return a;
}

/// A body of each shape, with and without a seam.
template <class F>
void on_every_shape(F const& f) {
  Draw draw(3);
  f.template operator()<1>(sample<1>(media::box_mesh({0}, {1}, {4}), draw, 0.25));
  f.template operator()<1>(sample<1>(media::box_mesh({0}, {1}, {3}, {true}), draw, 0.3));
  f.template operator()<2>(sample<2>(two_triangles(), draw, 1));
  f.template operator()<2>(sample<2>(media::box_mesh({0, 0}, {1, 0.7}, {3, 2}), draw, 0.3));
  f.template operator()<2>(sample<2>(media::box_mesh({0, 0}, {1, 0.7}, {3, 2}, {true, false}), draw, 0.3));
  f.template operator()<3>(sample<3>(two_tetrahedra(), draw, 1));
  f.template operator()<3>(sample<3>(media::box_mesh({0, 0, 0}, {1, 0.7, 0.9}, {2, 1, 2}), draw, 0.4));
  f.template operator()<3>(
      sample<3>(media::box_mesh({0, 0, 0}, {0.7, 1, 0.9}, {1, 3, 1}, {false, true, false}), draw, 0.3));
}

}  // namespace actio::testing
