// A rod in space only: sections as rigid bodies, with the elements of src/actio/rods between them, and time
// still continuous. Other schemes in time start from here: they have the forces of elements in common with
// the rods of the library, and nothing of their steps.
//
// The unknowns of a section are a motion of its place in space and a turn of it about its own axes, six
// numbers.
#pragma once

#include <Eigen/Dense>

#include <functional>
#include <vector>

#include "actio/numbers/errors.hpp"
#include "actio/rods/rod_shape.hpp"

namespace actio::rods {

using Six = Eigen::Matrix<double, 6, 1>;
using SixBySix = Eigen::Matrix<double, 6, 6>;

/// A matrix of blocks beside the diagonal: what sections exert on themselves and on their neighbours.
struct BlockTridiagonal {
  std::vector<SixBySix> below,  ///< by section k on section k + 1
      diagonal,                 ///< by section k on itself
      above;                    ///< by section k + 1 on section k

  /// Of zeros.
  explicit BlockTridiagonal(std::size_t rows)
      : below(rows - 1, SixBySix::Zero()),
        diagonal(rows, SixBySix::Zero()),
        above(rows - 1, SixBySix::Zero()) {}
  /// The solution, by elimination from the first row to the last; the matrix is used up.
  std::vector<Six> solve(std::vector<Six> right) {
    std::size_t const rows = diagonal.size();
    std::vector<Eigen::PartialPivLU<SixBySix>> pivots;
    for (std::size_t k = 0; k < rows; ++k) {
      if (k > 0) {
        diagonal[k] -= below[k - 1] * pivots[k - 1].solve(above[k - 1]);
        right[k] -= below[k - 1] * pivots[k - 1].solve(right[k - 1]);
      }
      pivots.emplace_back(diagonal[k]);
    }
    for (std::size_t k = rows; k-- > 0;) {
      if (k + 1 < rows) right[k] -= above[k] * right[k + 1];
      right[k] = pivots[k].solve(right[k]);
    }
    return right;
  }
};

/// What acts on the last section: a force and a moment, both in space.
struct EndLoad {
  Three<double> force{};   ///< mass x length/time^2
  Three<double> moment{};  ///< about the section
};

/// The rotation by a vector, a unit quaternion.
inline Four<double> rotation_by(Three<double> const& angle) {
  double const half = std::sqrt(bodies::dot(angle, angle)) / 2,
               part = half > 1e-4 ? std::sin(half) / half / 2 : 0.5 - half * half / 12;
  return {std::cos(half), part * angle[0], part * angle[1], part * angle[2]};
}

/// As a vector of Eigen.
inline Eigen::Vector3d vector(Three<double> const& v) { return {v[0], v[1], v[2]}; }
/// The matrix of \f$v\mapsto m\times v\f$.
inline Eigen::Matrix3d product_with(Eigen::Vector3d const& m) {
  Eigen::Matrix3d out;
  out << 0, -m[2], m[1], m[2], 0, -m[0], -m[1], m[0], 0;
  return out;
}

/// The rod. The sections are numbered from its start; the first one may be clamped.
struct SemiDiscreteRod {
  RodSection section;                       ///< of every element
  std::vector<ElementAtRest<double>> rest;  ///< the elements
  std::vector<double> share;                ///< length that a section stands for
  std::function<EndLoad(double)> load;      ///< at a time; null: none
  bool clamped = false;                     ///< whether the first section stays where it is

  /// @param shape  the rod without stresses, not a ring
  SemiDiscreteRod(RodSection const& of, RodShape const& shape) : section(of), rest(elements_at_rest(shape)) {
    share.assign(shape.sections(), 0);
    for (std::size_t k = 0; k < rest.size(); ++k)
      for (auto const at : {k, k + 1}) share[at] += 0.5 / rest[k].inverse_length;
  }
  /// Mass of a section and its moments of inertia.
  Six masses(std::size_t k) const {
    Six out;
    for (int i = 0; i < 3; ++i)
      out[i] = share[k] * section.mass, out[i + 3] = share[k] * section.inertia[static_cast<std::size_t>(i)];
    return out;
  }

  /// Forces on the sections of a shape, in space, and moments, in their axes, at a time.
  /// @param derivative  if given, to it -d(forces)/d(motions and turns of sections) is added
  std::vector<Six> forces(RodShape const& at, double time, BlockTridiagonal* derivative = nullptr) const {
    std::vector<Six> out(at.sections(), Six::Zero());
    for (std::size_t k = 0; k < rest.size(); ++k) {
      auto const e = at.element(k);
      auto const strain = element_strain(e, rest[k]);
      auto const N = times(section.stretching, strain.Gamma), M = times(section.bending, strain.kappa);
      auto const force = element_force(e, N, M);
      auto const f = vector(turned(at.attitudes[k], force.n));
      out[k].head<3>() += f, out[k].tail<3>() += vector(force.first);
      out[k + 1].head<3>() -= f, out[k + 1].tail<3>() -= vector(force.second);
      if (!derivative) continue;
      SixBySix* const blocks[4] = {&derivative->diagonal[k], &derivative->above[k], &derivative->below[k],
                                   &derivative->diagonal[k + 1]};
      auto const d = differential(k, e, N, M, vector(force.n), at);
      for (int side = 0; side < 2; ++side)
        *blocks[side] -= d.middleCols<6>(6 * side).topRows<6>(),
            blocks[2 + side]->topRows<3>() += d.middleCols<6>(6 * side).topRows<3>(),
            blocks[2 + side]->bottomRows<3>() += d.middleCols<6>(6 * side).bottomRows<3>();
    }
    if (load) {
      auto const [force, moment] = load(time);
      Three<double> const m = bodies::turned_back(at.attitudes.back(), moment);
      for (std::size_t i = 0; i < 3; ++i)
        out.back()[static_cast<Index>(i)] += force[i], out.back()[static_cast<Index>(i) + 3] += m[i];
      // A turn of the section turns the moment back in its axes.
      if (derivative) derivative->diagonal.back().bottomRightCorner<3, 3>() -= product_with(vector(m));
    }
    return out;
  }
  /// Takes the unknowns of a clamped section out of the equations.
  void hold(BlockTridiagonal& matrix, std::vector<Six>& right) const {
    if (!clamped) return;
    matrix.diagonal.front().setIdentity(), matrix.above.front().setZero(), right.front().setZero();
  }
  /// Moves and turns the sections of a shape.
  static void move(RodShape& shape, std::vector<Six> const& by) {
    for (std::size_t k = 0; k < by.size(); ++k) {
      for (std::size_t i = 0; i < 3; ++i) shape.places[k][i] += by[k][static_cast<Index>(i)];
      shape.attitudes[k] = bodies::compose(shape.attitudes[k], rotation_by({by[k][3], by[k][4], by[k][5]}));
    }
  }

  /// The shape in equilibrium under the load of time 1, which grows in equal parts from that of time 0.
  /// @throws NotConverged  where Newton's method ends in no equilibrium
  RodShape equilibrium(RodShape shape, int parts) const {
    for (int part = 1; part <= parts; ++part) {
      std::vector<double> sizes;
      for (double size = HUGE_VAL; size > 1e-10;) {
        BlockTridiagonal matrix(shape.sections());
        auto right = forces(shape, static_cast<double>(part) / parts, &matrix);
        hold(matrix, right);
        auto const by = matrix.solve(right);
        move(shape, by);
        size = 0;
        for (auto const& one : by) size = std::max(size, one.tail<3>().cwiseAbs().maxCoeff());
        sizes.push_back(size);
        if (!(size < 1e3) || sizes.size() > 40) throw NotConverged("equilibrium of a rod", sizes, 1e-10);
      }
    }
    return shape;
  }

 private:
  /// The differential of the force and the moment on the first section of an element, and of the moment on
  /// the second one with the opposite sign, by motions and turns of the first section, then of the second
  /// one.
  Eigen::Matrix<double, 9, 12> differential(std::size_t k, RelativePlacement<double> const& e,
                                            Three<double> const& N, Three<double> const& M,
                                            Eigen::Vector3d const& n, RodShape const& at) const {
    using Matrix3 = Eigen::Matrix3d;
    Matrix3 const one = Matrix3::Identity(), W = product_with(vector(e.w)), P = product_with(vector(e.eps)),
                  Nx = product_with(vector(N));
    Eigen::Vector3d const w = vector(e.w), p = vector(M) - P * vector(N) / 2;
    auto const turn = [](Four<double> const& q) {
      return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
    };
    Matrix3 const R = turn(at.attitudes[k]), E = R.transpose() * turn(at.attitudes[k + 1]);
    double const by = rest[k].inverse_length;
    // By w and by eps: of N, of the force, of p = M - eps x N/2.
    Matrix3 const C = by * Matrix3(vector(section.stretching).asDiagonal()), N_w = C * P / 2,
                  N_eps = C * (one - W / 2), n_w = (one + W / 2) * N_w - Nx / 2,
                  n_eps = (one + W / 2) * N_eps,
                  p_w = by * Matrix3(vector(section.bending).asDiagonal()) - P * N_w / 2,
                  p_eps = Nx / 2 - P * N_eps / 2;
    // The moments are T(w) p + eps x n and T(-w) p.
    Matrix3 const straight = one + w * w.transpose() / 4, bent = product_with(p) / 2,
                  T_w = (w.dot(p) * one + w * p.transpose()) / 4;
    Eigen::Matrix<double, 9, 3> by_w, by_eps;
    by_w << n_w, (straight + W / 2) * p_w + T_w - bent + P * n_w, (straight - W / 2) * p_w + T_w + bent;
    by_eps << n_eps, (straight + W / 2) * p_eps + P * n_eps - product_with(n), (straight - W / 2) * p_eps;
    // By motions and turns; then the force in space.
    Matrix3 const w_turn = straight - W / 2;
    Eigen::Matrix<double, 9, 12> out;
    out << -by_eps * R.transpose(), by_eps * P - by_w * w_turn, by_eps * R.transpose(), by_w * (w_turn * E);
    out.block<3, 3>(0, 3) -= product_with(n);
    out.topRows<3>() = (R * out.topRows<3>()).eval();
    return out;
  }
};

}  // namespace actio::rods
