// The commutator of an algebra and its dual by the structure constants that are not zero.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>
#include <vector>

#include "actio/groups/differential.hpp"
#include "actio/reduction/linear_entries.hpp"

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
    Index a, b, k;
    B value;
  };

  /// Of an algebra of that dimension with these constants.
  Commutators(Index dimension, std::vector<Constant> constants) : constants_(std::move(constants)) {
    for (auto const& c : constants_)
      ad_.add(c.k + dimension * c.b, c.a, c.value), ad_.add(c.k + dimension * c.a, c.b, B(-c.value));
  }
  /// Of the algebra of a group.
  template <Group G>
  explicit Commutators(G const& group) : Commutators(group.dimension(), constants_of(group)) {}

  /// The matrix of \f$\mathrm{ad}_v\f$, column by column, in `out`, where every entry that is zero for all v
  /// is zero already.
  template <class V, class M>
  void ad(V const& v, M& out) const { ad_.write(v, out); }
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

  std::vector<Constant> constants_;
  LinearEntries<B> ad_;
};

}  // namespace actio::detail
