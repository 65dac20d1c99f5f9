// The laws on a reader's own groups: one written down in twenty lines, one given by a basis.
#include "laws_of_the_groups.hpp"

namespace {

/// The similarities of the plane, x -> s R x + t. Coordinates (rate of growth, rate of turning, velocity).
struct Similarities : actio::Matrices<3, 4> {
  template <class V>
  static auto hat(V const& v) {
    actio::Matrix<typename V::Scalar, 3, 3> a = actio::Matrix<typename V::Scalar, 3, 3>::Zero();
    a(0, 0) = a(1, 1) = v[0];
    a(1, 0) = v[1], a(0, 1) = -v[1];
    a(0, 2) = v[2], a(1, 2) = v[3];
    return a;
  }
  template <class M>
  static auto vee(M const& a) {
    using S = typename M::Scalar;
    return actio::Matrix<S, 4, 1>((a(0, 0) + a(1, 1)) / S(2), (a(1, 0) - a(0, 1)) / S(2), a(0, 2), a(1, 2));
  }
};

/// The similarities with a slip in `vee` that a reader could make.
struct Slip : Similarities {
  template <class M>
  static auto vee(M const& a) {
    using S = typename M::Scalar;
    return actio::Matrix<S, 4, 1>((a(0, 0) + a(1, 1)) / S(2), (a(0, 1) - a(1, 0)) / S(2), a(0, 2), a(1, 2));
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_group_written_by_a_reader_keeps_the_laws) {
  actio::laws::hold<double>("similarities of the plane", Similarities{},
                            {{actio::Vector<double, 4>(-1, 2, 3, 4)}});
  actio::WithArithmetic const rationals(actio::Arithmetic::rationals());
  actio::laws::hold<actio::Number>("similarities of the plane", Similarities{});
}

BOOST_AUTO_TEST_CASE(a_slip_of_a_reader_is_found) {
  int broken = 0;
  for (auto const& f : actio::laws::check<double>(Slip{}, actio::laws::seed)) broken += !f.holds();
  BOOST_TEST(broken > 0);
}

BOOST_AUTO_TEST_CASE(groups_given_by_a_basis_keep_the_laws) {
  using M = actio::SpannedGroup::WholeMatrix;
  M stretch(2, 2), shift(2, 2);
  stretch << 1, 0, 0, 0;
  shift << 0, 1, 0, 0;
  actio::laws::hold<double>("Aff(1) from its span", actio::SpannedGroup("Aff(1)", {stretch, shift}));
  // A basis that is neither orthogonal nor of unit size.
  actio::laws::hold<double>("Aff(1) from another basis",
                            actio::SpannedGroup("Aff(1)", {M(2 * stretch + shift), M(3 * shift - stretch)}));
}
