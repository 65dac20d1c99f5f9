// A Lagrangian given as a formula, as a callable on velocities and vectors: what the generic implementation
// takes.
#pragma once

#include <memory>

#include "actio/any_group/reduced_system.hpp"
#include "actio/any_group/span_of_matrices.hpp"
#include "actio/groups/group.hpp"

namespace actio::systems {

/// l(v, a) of a system, at every scalar. A copy has its own work space for each call.
struct TapeLagrangian {
  std::shared_ptr<ReducedSystem const> system;  ///< whose Lagrangian it is

  /// Energy, at a velocity of a group with the coordinates of the system, without vectors.
  template <Group G, Scalar S>
  S operator()(Velocity<G, S> const& v) const { return (*this)(v, Matrix<S, Dynamic, 1>(0)); }
  /// The same with the carried vectors, one after the other.
  template <Group G, Scalar S>
  S operator()(Velocity<G, S> const& v, Matrix<S, Dynamic, 1> const& a) const {
    thread_local std::vector<S> work;
    S value(0);
    std::vector<S> inputs(v.coordinates.data(), v.coordinates.data() + v.coordinates.size());
    inputs.insert(inputs.end(), a.data(), a.data() + a.size());
    system->lagrangian(inputs.data(), &value, work);
    return value;
  }
};

/// The force of a system over one step, as a callable of the time since its start, velocity, vectors and
/// momentum.
class TapeForce {
 public:
  /// @param start, h  of the step, time
  /// @throws OutsideDomain  where the force has components of the other side
  TapeForce(std::shared_ptr<ReducedSystem const> system, double start, double h)
      : system_(std::move(system)), start_(start) {
    if (system_->force->across)
      throw OutsideDomain("TapeForce", "there must be no force in components of the other side; how many", 1,
                          0);
    for (auto const& input : system_->force->held) held_.push_back(input(start + h / 2));
  }
  template <Group G, Scalar S>
  Momentum<G, S> operator()(double since, Velocity<G, S> const& v, Matrix<S, Dynamic, 1> const& a,
                            Momentum<G, S> const& p) const {
    std::vector<S> inputs, work;
    auto const add = [&inputs](auto const& column) {
      inputs.insert(inputs.end(), column.data(), column.data() + column.size());
    };
    add(v.coordinates), add(a), add(p.components);
    inputs.push_back(S(start_ + since));
    for (double const u : held_) inputs.push_back(S(u));
    Momentum<G, S> out = p;
    system_->force->components(inputs.data(), out.components.data(), work);
    return out;
  }

 private:
  std::shared_ptr<ReducedSystem const> system_;
  double start_;
  std::vector<double> held_;
};

/// The same with its vectors held fixed. Its differentials are formulas, too.
struct HeldTape {
  ReducedSystem const& system;             ///< whose Lagrangian it is
  Matrix<double, Dynamic, 1> const& held;  ///< the vectors, one after the other

  /// The values of one of the tapes of the system at a velocity.
  std::vector<double> const& values(Tape const& tape, Coordinates<SpanOfMatrices, double> const& v) const;
};

/// A tape with vectors that outlive what is returned.
inline HeldTape holding(TapeLagrangian const& l, Matrix<double, Dynamic, 1> const& a) {
  return {*l.system, a};
}
/// The momentum of a velocity.
/// @throws NotFinite  where the Lagrangian or its differential is no number
Momentum<SpanOfMatrices, double> gradient(HeldTape const& l, Velocity<SpanOfMatrices, double> const& v);
/// \f$\partial^2l/\partial v^2\f$.
/// @throws NotFinite  where an entry is no number
Matrix<double> hessian(HeldTape const& l, Velocity<SpanOfMatrices, double> const& v);
/// \f$\partial l/\partial a\f$.
/// @throws NotFinite  where it is no number
Matrix<double, Dynamic, 1> slope_in_vector(TapeLagrangian const& l, Velocity<SpanOfMatrices, double> const& v,
                                           Matrix<double, Dynamic, 1> const& a);

/// How a group of matrices acts on several vectors, one below the other.
struct EachVector {
  /// The matrix times each of them.
  template <class E, class S>
  Matrix<S, Dynamic, 1> operator()(E const& g, Matrix<S, Dynamic, 1> const& all) const {
    Index const n = g.value.rows();
    Matrix<S, Dynamic, 1> moved = Matrix<S, Dynamic, 1>::Zero(all.size());
    for (Index first = 0; first < all.size(); first += n)
      for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j) moved[first + i] += g.value(i, j) * all[first + j];
    return moved;
  }
};

}  // namespace actio::systems
