#include "actio/groups/odd_power_closure.hpp"

namespace actio {

bool OddPowerClosure::of_all_elements() const {
  std::int64_t coordinate = 20240131;
  Remainders a = Remainders::Zero(basis.front().rows(), basis.front().cols());
  for (WholeMatrix const& e : basis) {
    coordinate = coordinate * 48271 % prime;
    for (Index i = 0; i < a.rows(); ++i)
      for (Index j = 0; j < a.cols(); ++j) a(i, j) = (a(i, j) + coordinate * e(i, j)) % prime;
  }
  return in_span(product(product(a, a), a));
}

int OddPowerClosure::that_leave() const {
  int leaving = 0;
  for (WholeMatrix const& e : basis) {
    Remainders power = e.cast<std::int64_t>();
    Remainders const square = product(power, power);
    bool stays = true;
    for (Index k = 1; stays && k < e.rows(); ++k) stays = in_span(power = product(power, square));
    leaving += !stays;
  }
  return leaving;
}

OddPowerClosure::Remainders OddPowerClosure::product(Remainders const& a, Remainders const& b) {
  Remainders c = Remainders::Zero(a.rows(), b.cols());
  for (Index i = 0; i < a.rows(); ++i)
    for (Index j = 0; j < b.cols(); ++j)
      for (Index k = 0; k < a.cols(); ++k) c(i, j) = (c(i, j) + a(i, k) * b(k, j)) % prime;
  return c;
}

bool OddPowerClosure::in_span(Remainders const& a) const {
  std::vector<std::int64_t> v(basis.size(), 0);
  for (SpanEntry const& e : projection)
    v[e.direction] = (v[e.direction] + a(e.row, e.column) * (e.coefficient % prime)) % prime;
  Remainders left = a;
  for (Index i = 0; i < a.rows(); ++i)
    for (Index j = 0; j < a.cols(); ++j) left(i, j) = a(i, j) * (denominator % prime) % prime;
  for (SpanEntry const& e : entries)
    left(e.row, e.column) = (left(e.row, e.column) - v[e.direction] * e.coefficient) % prime;
  for (Index i = 0; i < a.rows(); ++i)
    for (Index j = 0; j < a.cols(); ++j)
      if (left(i, j) != 0) return false;
  return true;
}

}  // namespace actio
