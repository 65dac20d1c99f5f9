#include "actio/groups/spanned_group.hpp"

#include "actio/numbers/multiprecision.hpp"

namespace actio {

SpannedGroup::SpannedGroup(std::string name_of_group, std::vector<WholeMatrix> basis, Retraction choice) {
  if (basis.empty()) throw OutsideDomain("SpannedGroup", "at least one basis matrix is needed", 0, 1);
  for (WholeMatrix const& e : basis)
    if (e.rows() != basis.front().rows() || e.cols() != basis.front().rows())
      throw OutsideDomain("SpannedGroup", "square basis matrices of one size are needed; columns and size",
                          static_cast<double>(e.cols()), static_cast<double>(basis.front().rows()));
  for (WholeMatrix const& e : basis)
    if (int const largest = largest_entry(e); largest > 1000)
      throw OutsideDomain("SpannedGroup",
                          "entries of basis matrices up to 1000 are needed, scale them; largest", largest,
                          1000);
  auto made = std::make_shared<Data>();
  made->name = std::move(name_of_group);
  made->basis = std::move(basis);
  find_projection(*made);
  data = made;
  check_closed();
  choose_retraction(*made, choice);
}

void SpannedGroup::find_projection(Data& d) {
  // The dual basis solves Gram's system; over the rationals it is exact, and one denominator serves all.
  int const n = static_cast<int>(d.basis.front().rows()), dims = static_cast<int>(d.basis.size());
  actio::Matrix<rational, Dynamic, Dynamic> gram(dims, dims);
  for (int a = 0; a < dims; ++a)
    for (int b = 0; b < dims; ++b) {
      long sum = 0;
      for (Index i = 0; i < n * n; ++i) sum += static_cast<long>(d.basis[a](i)) * d.basis[b](i);
      gram(a, b) = rational(sum);
    }
  auto const inverse = inverse_matrix(gram, "SpannedGroup: basis matrices must be linearly independent");
  boost::multiprecision::mpz_int common = 1;
  for (int a = 0; a < dims; ++a)
    for (int b = 0; b < dims; ++b)
      common = boost::multiprecision::lcm(common, boost::multiprecision::mpz_int(denominator(inverse(a, b))));
  if (common > 1'000'000'000'000)
    throw OutsideDomain("SpannedGroup",
                        "the projection on the span must have a denominator up to 1e12; it has",
                        common.convert_to<double>(), 1e12);
  d.denominator = common.convert_to<long>();
  for (int a = 0; a < dims; ++a)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        if (d.basis[a](i, j) != 0) d.entries.push_back({a, i, j, d.basis[a](i, j)});
        rational sum = 0;
        for (int b = 0; b < dims; ++b) sum += inverse(a, b) * d.basis[b](i, j);
        sum *= d.denominator;
        if (sum != 0) d.projection.push_back({a, i, j, numerator(sum).convert_to<long>()});
      }
}

void SpannedGroup::choose_retraction(Data& d, Retraction choice) {
  OddPowerClosure const odd_powers{d.basis, d.entries, d.projection, d.denominator};
  bool const cayley_keeps = choice != Retraction::elementary && odd_powers.of_all_elements();
  if (choice == Retraction::cayley && !cayley_keeps)
    throw OutsideDomain(
        "SpannedGroup",
        "for Cayley's transform cubes of elements of the algebra must be in the algebra; broken conditions",
        1, 0);
  d.retraction = cayley_keeps ? Retraction::cayley : Retraction::elementary;
  if (cayley_keeps) return;
  if (int const leaving = odd_powers.that_leave(); leaving > 0)
    throw OutsideDomain(
        "SpannedGroup",
        "odd powers of the basis matrices must be in their span, another basis may do; matrices that fail",
        leaving, 0);
}

void SpannedGroup::check_closed() const {
  for (auto const& a : data->basis)
    for (auto const& b : data->basis) {
      int const n = matrix_size();
      actio::Matrix<double, Dynamic, Dynamic> commutator(n, n);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          long sum = 0;
          for (int k = 0; k < n; ++k)
            sum += static_cast<long>(a(i, k)) * b(k, j) - static_cast<long>(b(i, k)) * a(k, j);
          commutator(i, j) = static_cast<double>(sum);
        }
      auto const inside = hat(vee(commutator));
      double outside = 0;
      for (Index i = 0; i < n * n; ++i) outside = std::max(outside, std::abs(inside(i) - commutator(i)));
      if (!(outside < 1e-9))
        throw OutsideDomain("SpannedGroup", "commutators of basis matrices must stay in their span; distance",
                            outside, 0);
    }
}

}  // namespace actio
