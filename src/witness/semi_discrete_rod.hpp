// A rod in space only: sections as rigid bodies, with the elements of src/actio/rods between them, and time
// still continuous. Other schemes in time start from here.
//
// The unknowns of a section are a motion of its place in space and a turn of it about its own axes, six
// numbers. Derivatives of forces are those of dual numbers.
#pragma once

#include <Eigen/Dense>

#include <functional>
#include <vector>

#include "actio/numbers/dual.hpp"
#include "actio/rods/rod_shape.hpp"
#include "witness/reference_solution.hpp"

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

/// The rod. The sections are numbered from its start; the first one may be clamped.
struct SemiDiscreteRod {
  RodSection section;                         ///< of every element
  std::vector<ElementAtRest<double>> rest;    ///< the elements
  std::vector<double> share;                  ///< length that a section stands for
  std::function<EndLoad(double)> load;        ///< at a time; null: none
  bool clamped = false;                       ///< whether the first section stays where it is

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

  /// Forces in space and moments in the axes of the sections at the ends of an element, the first one's first.
  template <class T>
  std::array<T, 12> element(std::size_t k, Three<T> const& x0, Four<T> const& q0, Three<T> const& x1,
                            Four<T> const& q1) const {
    auto const of = [](Three<double> const& v) { return Three<T>{T(v[0]), T(v[1]), T(v[2])}; };
    auto const e = RelativePlacement<T>::of(q0, q1, bodies::plus(x1, times(T(-1.0), x0)));
    auto const strain = element_strain(
        e, ElementAtRest<T>{T(rest[k].inverse_length), of(rest[k].Gamma), of(rest[k].kappa)});
    auto const force = element_force(e, times(of(section.stretching), strain.Gamma),
                                     times(of(section.bending), strain.kappa));
    Three<T> const f = turned(q0, force.n);
    return {f[0],  f[1],  f[2],  force.first[0],   force.first[1],   force.first[2],
            -f[0], -f[1], -f[2], -force.second[0], -force.second[1], -force.second[2]};
  }

  /// Forces and moments on the sections of a shape at a time.
  /// @param derivative  if given, to it -d(forces)/d(motions and turns of sections) is added
  std::vector<Six> forces(RodShape const& at, double time, BlockTridiagonal* derivative = nullptr) const {
    std::vector<Six> out(at.sections(), Six::Zero());
    for (std::size_t k = 0; k < rest.size(); ++k) {
      if (!derivative) {
        auto const both = element<double>(k, at.places[k], at.attitudes[k], at.places[k + 1],
                                          at.attitudes[k + 1]);
        for (int i = 0; i < 12; ++i)
          out[k + static_cast<std::size_t>(i / 6)][i % 6] += both[static_cast<std::size_t>(i)];
        continue;
      }
      using T = Dual<double, 12>;
      std::array<Three<T>, 2> x;
      std::array<Four<T>, 2> q;
      for (std::size_t side = 0; side < 2; ++side) {
        for (std::size_t i = 0; i < 3; ++i)
          x[side][i] = at.places[k + side][i], x[side][i].part[6 * side + i] = 1;
        for (std::size_t i = 0; i < 4; ++i) q[side][i] = at.attitudes[k + side][i];
        for (std::size_t axis = 0; axis < 3; ++axis) {
          Four<double> turn{};
          turn[axis + 1] = 0.5;
          turn = bodies::compose(at.attitudes[k + side], turn);
          for (std::size_t i = 0; i < 4; ++i) q[side][i].part[6 * side + 3 + axis] = turn[i];
        }
      }
      auto const both = element<T>(k, x[0], q[0], x[1], q[1]);
      SixBySix* const blocks[4] = {&derivative->diagonal[k], &derivative->above[k], &derivative->below[k],
                                   &derivative->diagonal[k + 1]};
      for (int i = 0; i < 12; ++i) {
        auto const& force = both[static_cast<std::size_t>(i)];
        out[k + static_cast<std::size_t>(i / 6)][i % 6] += force.value;
        for (int j = 0; j < 12; ++j)
          (*blocks[2 * (i / 6) + j / 6])(i % 6, j % 6) -= force.part[static_cast<std::size_t>(j)];
      }
    }
    if (load) {
      auto const [force, moment] = load(time);
      Three<double> const m = bodies::turned_back(at.attitudes.back(), moment);
      for (std::size_t i = 0; i < 3; ++i)
        out.back()[static_cast<Index>(i)] += force[i], out.back()[static_cast<Index>(i) + 3] += m[i];
      // A turn of the section turns the moment back in its axes.
      if (derivative) derivative->diagonal.back().bottomRightCorner<3, 3>() -= product_with(m);
    }
    return out;
  }
  /// The matrix of \f$v\mapsto m\times v\f$.
  static Eigen::Matrix3d product_with(Three<double> const& m) {
    Eigen::Matrix3d out;
    out << 0, -m[2], m[1], m[2], 0, -m[0], -m[1], m[0], 0;
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
      shape.attitudes[k] =
          bodies::compose(shape.attitudes[k], rotation_by({by[k][3], by[k][4], by[k][5]}));
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
};

/// A rod at one time, in other schemes.
struct RodMotion {
  RodShape shape;             ///< where it is
  std::vector<Six> velocity;  ///< of places in space, then angular velocities in the axes of the sections

  /// @param of  the rod, at rest
  static RodMotion at_rest(RodShape const& of) { return {of, std::vector<Six>(of.sections(), Six::Zero())}; }
  /// Linear momentum, then angular momentum about the origin.
  Six momentum(SemiDiscreteRod const& rod) const {
    Six out = Six::Zero();
    for (std::size_t k = 0; k < velocity.size(); ++k) {
      Six const p = rod.masses(k).cwiseProduct(velocity[k]);
      auto const turn = turned(shape.attitudes[k], {p[3], p[4], p[5]});
      auto const lever = cross(shape.places[k], {p[0], p[1], p[2]});
      out.head<3>() += p.head<3>();
      for (std::size_t i = 0; i < 3; ++i) out[static_cast<Index>(i) + 3] += turn[i] + lever[i];
    }
    return out;
  }
  /// Kinetic and strain energy together.
  double energy(SemiDiscreteRod const& rod) const {
    double out = 0;
    for (std::size_t k = 0; k < velocity.size(); ++k)
      out += rod.masses(k).cwiseProduct(velocity[k]).dot(velocity[k]) / 2;
    for (std::size_t k = 0; k < rod.rest.size(); ++k) {
      auto const strain = element_strain(shape.element(k), rod.rest[k]);
      out += (bodies::dot(times(rod.section.stretching, strain.Gamma), strain.Gamma) +
              bodies::dot(times(rod.section.bending, strain.kappa), strain.kappa)) /
             rod.rest[k].inverse_length / 2;
    }
    return out;
  }

  /// The motion at a later time, by step control near rounding.
  /// @param relative  as in \ref reference_solution
  RodMotion later(SemiDiscreteRod const& rod, double from, double to, double relative) const {
    using Vector = Matrix<double, Dynamic, 1>;
    auto const unpack = [&](auto const& y) {
      RodMotion out = *this;
      for (std::size_t k = 0; k < velocity.size(); ++k) {
        auto const at = static_cast<Index>(13 * k);
        for (std::size_t i = 0; i < 3; ++i) out.shape.places[k][i] = y[at + static_cast<Index>(i)];
        double norm = 0;
        for (int i = 3; i < 7; ++i) norm += y[at + i] * y[at + i];
        for (std::size_t i = 0; i < 4; ++i)
          out.shape.attitudes[k][i] = y[at + 3 + static_cast<Index>(i)] / std::sqrt(norm);
        for (int i = 0; i < 6; ++i) out.velocity[k][i] = y[at + 7 + i];
      }
      return out;
    };
    auto const rate = [&](double time, Vector const& y) {
      RodMotion const now = unpack(y);
      auto const forces = rod.forces(now.shape, time);
      Vector out(y.size());
      for (std::size_t k = 0; k < forces.size(); ++k) {
        auto const at = static_cast<Index>(13 * k);
        Six const &v = now.velocity[k], m = rod.masses(k);
        Three<double> const w{v[3], v[4], v[5]}, across = cross({m[3] * w[0], m[4] * w[1], m[5] * w[2]}, w);
        auto const q = bodies::compose(now.shape.attitudes[k], {0, w[0] / 2, w[1] / 2, w[2] / 2});
        for (int i = 0; i < 3; ++i) {
          auto const j = static_cast<std::size_t>(i);
          out[at + i] = v[i], out[at + 7 + i] = forces[k][i] / m[i];
          out[at + 10 + i] = (forces[k][i + 3] + across[j]) / m[i + 3];
        }
        for (int i = 0; i < 4; ++i) out[at + 3 + i] = q[static_cast<std::size_t>(i)];
      }
      return out;
    };
    Vector y(static_cast<Index>(13 * velocity.size()));
    for (std::size_t k = 0; k < velocity.size(); ++k) {
      auto const at = static_cast<Index>(13 * k);
      for (std::size_t i = 0; i < 3; ++i) y[at + static_cast<Index>(i)] = shape.places[k][i];
      for (std::size_t i = 0; i < 4; ++i) y[at + 3 + static_cast<Index>(i)] = shape.attitudes[k][i];
      for (int i = 0; i < 6; ++i) y[at + 7 + i] = velocity[k][i];
    }
    return unpack(reference_solution(rate, y, from, to, relative));
  }
};

}  // namespace actio::rods
