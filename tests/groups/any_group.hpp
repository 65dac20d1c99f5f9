// A group of which only the scalars are known at compile time: the laws are compiled once for each scalar,
// not for each group.
#pragma once

#include <memory>

#include "actio/groups/differential.hpp"

namespace actio::laws {

template <class T>
using AnyVector = actio::Matrix<T, Dynamic, 1>;
template <class T>
using AnyMatrix = actio::Matrix<T, Dynamic, Dynamic>;

/// The primitives of a group at one scalar, behind virtual functions.
template <class T>
struct AlgebraicPrimitives {
  virtual AnyMatrix<T> identity(T*) const = 0;
  virtual AnyMatrix<T> compose(AnyMatrix<T> const&, AnyMatrix<T> const&) const = 0;
  virtual AnyMatrix<T> inverse(AnyMatrix<T> const&) const = 0;
  virtual AnyVector<T> Ad(AnyMatrix<T> const&, AnyVector<T> const&) const = 0;
  virtual AnyVector<T> bracket(AnyVector<T> const&, AnyVector<T> const&) const = 0;
  virtual AnyMatrix<T> retract(AnyVector<T> const&) const = 0;
  virtual AnyMatrix<T> near_identity(AnyVector<T> const&) const = 0;
  virtual ~AlgebraicPrimitives() = default;
};
template <class T>
struct ExponentialPrimitives {
  virtual AnyMatrix<T> exp(AnyVector<T> const&) const = 0;
  virtual AnyVector<T> log(AnyMatrix<T> const&) const = 0;
  virtual AnyMatrix<T> restore(AnyMatrix<T> const&) const = 0;
  virtual ~ExponentialPrimitives() = default;
};

template <class G, class Base, class T>
struct AlgebraicPart : Base, AlgebraicPrimitives<T> {
  using Base::Base;
  using Matrix = AnyMatrix<T>;
  using Vector = AnyVector<T>;
  using Stored = Storage<G, T>;
  using Column = Coordinates<G, T>;
  Matrix identity(T*) const override { return primitive::identity<T>(this->group); }
  Matrix compose(Matrix const& a, Matrix const& b) const override {
    return primitive::compose(this->group, Stored(a), Stored(b));
  }
  Matrix inverse(Matrix const& a) const override { return primitive::inverse(this->group, Stored(a)); }
  Vector Ad(Matrix const& a, Vector const& v) const override {
    return primitive::Ad(this->group, Stored(a), Column(v));
  }
  Vector bracket(Vector const& v, Vector const& w) const override {
    return primitive::bracket(this->group, Column(v), Column(w));
  }
  Matrix retract(Vector const& v) const override { return primitive::retract(this->group, Column(v)); }
  Matrix near_identity(Vector const& v) const override {
    return primitive::near_identity(this->group, Column(v));
  }
};
template <class G, class Base, class T>
struct ExponentialPart : Base, ExponentialPrimitives<T> {
  using Base::Base;
  using Stored = Storage<G, T>;
  AnyMatrix<T> exp(AnyVector<T> const& v) const override {
    return primitive::exp(this->group, Coordinates<G, T>(v));
  }
  AnyVector<T> log(AnyMatrix<T> const& a) const override {
    return primitive::log_of<G, T>(this->group, Stored(a));
  }
  AnyMatrix<T> restore(AnyMatrix<T> const& a) const override {
    return primitive::restore(this->group, Stored(a));
  }
};

/// Infinitesimals to first order, in the batches of `differential.hpp`, and to second order.
template <class S>
using First = Moved<S>;
template <class S>
using Second = Dual<Dual<S, 1>, 1>;

/// Any group at the scalars S, First<S> and Second<S>.
template <Scalar S>
struct AnyGroup {
  static constexpr int dim = Dynamic;
  template <class T>
  using Value = AnyMatrix<T>;

  template <Group G>
  explicit AnyGroup(G const& group) : dimension_(group.dimension()) {
    using Algebraic = AlgebraicPart<G, AlgebraicPart<G, AlgebraicPart<G, Holder<G>, S>, First<S>>, Second<S>>;
    if constexpr (Real<S>) {
      auto const all =
          std::make_shared<ExponentialPart<G, ExponentialPart<G, Algebraic, S>, First<S>>>(group);
      algebraic = {all.get(), all.get(), all.get()};
      exponential = {all.get(), all.get()};
      owner = all;
    } else {
      auto const all = std::make_shared<Algebraic>(group);
      algebraic = {all.get(), all.get(), all.get()};
      owner = all;
    }
  }

  int dimension() const { return dimension_; }
  template <class T>
  AnyMatrix<T> identity() const { return at<T>().identity(static_cast<T*>(nullptr)); }
  template <class T>
  AnyMatrix<T> compose(AnyMatrix<T> const& a, AnyMatrix<T> const& b) const { return at<T>().compose(a, b); }
  template <class T>
  AnyMatrix<T> inverse(AnyMatrix<T> const& a) const { return at<T>().inverse(a); }
  template <class T>
  AnyVector<T> Ad(AnyMatrix<T> const& a, AnyVector<T> const& v) const { return at<T>().Ad(a, v); }
  template <class T>
  AnyVector<T> bracket(AnyVector<T> const& v, AnyVector<T> const& w) const { return at<T>().bracket(v, w); }
  template <class T>
  AnyMatrix<T> retract(AnyVector<T> const& v) const { return at<T>().retract(v); }
  template <class T>
  AnyMatrix<T> near_identity(AnyVector<T> const& v) const { return at<T>().near_identity(v); }
  template <class T>
  AnyMatrix<T> exp(AnyVector<T> const& v) const {
    return std::get<ExponentialPrimitives<T> const*>(exponential)->exp(v);
  }
  template <class T>
  AnyVector<T> log(AnyMatrix<T> const& a) const {
    return std::get<ExponentialPrimitives<T> const*>(exponential)->log(a);
  }
  template <class T>
  AnyMatrix<T> restore(AnyMatrix<T> const& a) const {
    return std::get<ExponentialPrimitives<T> const*>(exponential)->restore(a);
  }

 private:
  template <class G>
  struct Holder {
    explicit Holder(G const& g) : group(g) {}
    G group;
  };
  template <class T>
  AlgebraicPrimitives<T> const& at() const { return *std::get<AlgebraicPrimitives<T> const*>(algebraic); }

  int dimension_;
  std::shared_ptr<void const> owner;
  std::tuple<AlgebraicPrimitives<S> const*, AlgebraicPrimitives<First<S>> const*,
             AlgebraicPrimitives<Second<S>> const*>
      algebraic;
  std::tuple<ExponentialPrimitives<S> const*, ExponentialPrimitives<First<S>> const*> exponential;
};

}  // namespace actio::laws
