// The commutator of an algebra and its dual by the structure constants that are not zero.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>
#include <vector>

#include "actio/groups/differential.hpp"

namespace actio::detail {

/// Whether two groups are known to have the same commutators: types without data, and equal data.
template <Group G>
bool known_to_be_same(G const& one, G const& other) {
  if constexpr (std::equality_comparable<G>)
    return one == other;
  else
    return std::is_empty_v<G>;
}

/// The matrix of \f$\mathrm{ad}_v\f$, and \f$\mathrm{ad}^*_v\,\mu\f$, on columns of coordinates, whatever the
/// group.
template <Real B>
class Commutators {
 public:
  /// A structure constant: the part of \f$[e_a, e_b]\f$ along \f$e_k\f$, where \f$a < b\f$.
  struct Constant {
    int a, b, k;
    B value;
  };

  /// Of an algebra of that dimension with these constants.
  Commutators(Index dimension, std::vector<Constant> constants) : constants_(std::move(constants)) {
    find_parts(dimension);
  }
  /// Of the algebra of a group.
  template <Group G>
  explicit Commutators(G const& group) : Commutators(group.dimension(), constants_of(group)) {}
  /// Of the algebra of the semidirect product of a group with the covectors of m numbers,
  /// \f$[(\xi, w), (\eta, u)] = ([\xi, \eta],\ \eta^Tw - \xi^Tu)\f$: coordinates of the group first.
  /// @param act  the action of the group on columns of m numbers
  template <Group G, class Act>
  Commutators(G const& group, Index m, Act const& act)
      : Commutators(group.dimension() + m, constants_of(group, m, act)) {}

  /// The matrix of \f$\mathrm{ad}_v\f$, column by column, in `out`, where every entry that is zero for all v
  /// is zero already.
  template <class V, class M>
  void ad(V const& v, M& out) const {
    auto* const entries = out.data();
    for (auto const& e : first_parts_) entries[e.at] = v[e.a] * e.value;
    for (auto const& e : other_parts_) entries[e.at] += v[e.a] * e.value;
  }
  /// \f$\mathrm{ad}^*_v\,\mu\f$ in `out`.
  template <class V>
  void ad_star(V const& v, V const& mu, V& out) const {
    for (Index k = 0; k < out.size(); ++k) out[k] = typename V::Scalar(0);
    for (auto const& c : constants_) {
      auto const part = mu[c.k] * c.value;
      out[c.b] += v[c.a] * part, out[c.a] -= v[c.b] * part;
    }
  }

 private:
  template <Group G>
  static std::vector<Constant> constants_of(G const& group) {
    std::vector<Constant> out;
    int const n = group.dimension();
    auto const unit = [&](int k) {
      Coordinates<G, B> e = Coordinates<G, B>::Zero(n);
      e[k] = B(1);
      return Velocity<G, B>{group, e};
    };
    for (int a = 0; a < n; ++a)
      for (int b = a + 1; b < n; ++b) {
        auto const c = actio::bracket(unit(a), unit(b)).coordinates;
        for (int k = 0; k < n; ++k)
          if (c[k] != B(0)) out.push_back({a, b, k, c[k]});
      }
    return out;
  }
  template <Group G, class Act>
  static std::vector<Constant> constants_of(G const& group, Index m, Act const& act) {
    auto out = constants_of(group);
    int const n = group.dimension();
    for (int first = 0; first < n; first += batch) {
      auto const near = moved_left(identity<B>(group), first);
      for (Index j = 0; j < m; ++j) {
        Matrix<Moved<B>, Dynamic, 1> unit = Matrix<Moved<B>, Dynamic, 1>::Zero(m);
        unit[j] = Moved<B>(B(1));
        Matrix<Moved<B>, Dynamic, 1> const moved = act(near, unit);
        for (int a = 0; a < batch && first + a < n; ++a)
          for (Index i = 0; i < m; ++i)
            if (moved[i].part[a] != B(0))
              out.push_back({first + a, n + static_cast<int>(i), n + static_cast<int>(j), -moved[i].part[a]});
      }
    }
    return out;
  }
  /// What a coordinate adds to an entry of the matrix of ad, and where.
  struct Part {
    int at, a;
    B value;
  };
  void find_parts(Index size) {
    std::vector<bool> there(static_cast<std::size_t>(size * size));
    auto const add = [&](int row, int column, int a, B const& value) {
      int const at = row + static_cast<int>(size) * column;
      (there[static_cast<std::size_t>(at)] ? other_parts_ : first_parts_).push_back({at, a, value});
      there[static_cast<std::size_t>(at)] = true;
    };
    for (auto const& c : constants_) add(c.k, c.b, c.a, c.value), add(c.k, c.a, c.b, -c.value);
  }

  std::vector<Constant> constants_;
  std::vector<Part> first_parts_, other_parts_;  // of each entry; of those that have several
};

}  // namespace actio::detail
