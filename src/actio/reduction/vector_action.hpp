// The action of an algebra of matrices on vectors by the entries of its basis that are not zero.
#pragma once

#include <utility>
#include <vector>

#include "actio/groups/differential.hpp"
#include "actio/reduction/linear_entries.hpp"

namespace actio::detail {

/// \f$\xi a\f$, its matrix and the torque \f$\langle w, \cdot\,a\rangle\f$, on columns of coordinates,
/// whatever the group.
template <Real B>
class VectorAction {
 public:
  /// An entry of the matrix by which a basis vector of the algebra acts.
  struct Entry {
    Index direction, row, column;
    B value;
  };

  /// On no vector.
  VectorAction() = default;
  /// On columns of m numbers by these matrices.
  VectorAction(Index m, std::vector<Entry> entries) : entries_(std::move(entries)) {
    for (auto const& e : entries_) dual_.add(e.column + m * e.row, e.direction, e.value);
  }
  /// Of the algebra of a group on columns of m numbers.
  /// @param act  the action of the group
  template <Group G, class Act>
  VectorAction(G const& group, Index m, Act const& act) : VectorAction(m, entries_of(group, m, act)) {}

  /// Adds the torque \f$\langle w, \cdot\,a\rangle\f$ to the rate of a momentum, and writes that of a vector,
  /// \f$-\xi a\f$.
  template <class V, class U>
  void add_rates(V const& xi, U const& w, U const& a, V& momentum, U& vector) const {
    for (Index k = 0; k < a.size(); ++k) vector[k] = typename U::Scalar(0);
    for (auto const& e : entries_) {
      auto const part = a[e.column] * e.value;
      momentum[e.direction] += w[e.row] * part, vector[e.row] -= xi[e.direction] * part;
    }
  }
  /// Adds c times a torque to a momentum.
  template <class U, class V>
  void add_torque(U const& w, U const& a, B const& c, V& momentum) const {
    for (auto const& e : entries_) momentum[e.direction] += w[e.row] * a[e.column] * (e.value * c);
  }
  /// The transposed matrix of \f$a\mapsto\xi a\f$ in `out`, where entries that are zero for all \f$\xi\f$ are
  /// zero already.
  template <class V, class M>
  void dual_matrix(V const& xi, M& out) const { dual_.write(xi, out); }

 private:
  template <Group G, class Act>
  static std::vector<Entry> entries_of(G const& group, Index m, Act const& act) {
    std::vector<Entry> out;
    int const n = group.dimension();
    for (int first = 0; first < n; first += batch) {
      auto const near = moved_left(identity<B>(group), first);
      for (Index j = 0; j < m; ++j) {
        Matrix<Moved<B>, Dynamic, 1> unit = Matrix<Moved<B>, Dynamic, 1>::Zero(m);
        unit[j] = Moved<B>(B(1));
        Matrix<Moved<B>, Dynamic, 1> const moved = act(near, unit);
        for (int a = 0; a < batch && first + a < n; ++a)
          for (Index i = 0; i < m; ++i)
            if (moved[i].part[a] != B(0)) out.push_back({first + a, i, j, moved[i].part[a]});
      }
    }
    return out;
  }

  std::vector<Entry> entries_;
  LinearEntries<B> dual_;
};

}  // namespace actio::detail
