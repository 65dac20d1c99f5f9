// The groups that come in families: the retraction of a span, the factors of a product, and faults that the
// laws find.
#include "laws_of_more_groups.hpp"
#include "refused.hpp"

using namespace actio;

namespace {

using laws::from_span;
using WholeMatrix = SpannedGroup::WholeMatrix;
double const eps = epsilon<double>();

}  // namespace

BOOST_AUTO_TEST_CASE(a_span_finds_its_retraction) {
  auto const chosen = [](auto const& group) { return from_span("", group).retraction(); };
  for (bool const by_cayley :
       {chosen(SO<3>{}) == Retraction::cayley, chosen(SO<4>{}) == Retraction::cayley,
        chosen(SE<3>{}) == Retraction::cayley, chosen(Aff1{}) == Retraction::cayley,
        chosen(SL2{}) == Retraction::cayley, chosen(GL<2>{}) == Retraction::cayley,
        chosen(Heisenberg{}) == Retraction::cayley, chosen(U<>(3)) == Retraction::cayley,
        chosen(SU<>(2)) == Retraction::cayley, chosen(Sp<>(4)) == Retraction::cayley,
        chosen(SemidirectProduct{Sp<>(4)}) == Retraction::cayley})
    BOOST_TEST(by_cayley);
  for (bool const by_factors :
       {chosen(SL<>(3)) == Retraction::elementary, chosen(SL<>(4)) == Retraction::elementary,
        chosen(SU<>(3)) == Retraction::elementary,
        chosen(DirectProduct{SU<>(3), U<>(1)}) == Retraction::elementary,
        chosen(SemidirectProduct{SL<>(3)}) == Retraction::elementary})
    BOOST_TEST(by_factors);
  // The choice can be made by hand, where it does no harm.
  BOOST_TEST((from_span("SO(3)", SO<3>{}, Retraction::elementary).retraction() == Retraction::elementary));
  BOOST_CHECK_EXCEPTION(from_span("SL(3)", SL<>(3), Retraction::cayley), OutsideDomain,
                        [](OutsideDomain const& e) { return e.measured > e.bound; });
  // diag(1, 1, -2) spans a group of its own, whose algebra does not contain its cube: no rational map from
  // these powers leads into it.
  WholeMatrix weights = WholeMatrix::Zero(3, 3);
  weights.diagonal() << 1, 1, -2;
  BOOST_CHECK_EXCEPTION(SpannedGroup("weights", {weights}), OutsideDomain,
                        [](OutsideDomain const& e) { return e.measured == 1 && e.bound == 0; });
  // A Jordan block of four rows needs its cube beside it.
  WholeMatrix shift = WholeMatrix::Zero(4, 4);
  shift(0, 1) = shift(1, 2) = shift(2, 3) = 1;
  CHECK_REFUSED(SpannedGroup("shift", {shift}), OutsideDomain);
  BOOST_TEST((SpannedGroup("shift and its cube", {shift, WholeMatrix(shift * shift * shift)}).retraction() ==
              Retraction::cayley));
}

BOOST_AUTO_TEST_CASE(a_product_is_the_pair_of_its_factors) {
  using Product = DirectProduct<SO<3>, SE<2>>;
  Draw draw(17);
  auto const gh = draw.element<double>(Product{}), other = draw.element<double>(Product{});
  auto const [g, h] = factors(gh);
  auto const [g2, h2] = factors(other);
  BOOST_TEST(magnitude((element_of_product(g, h).value - gh.value).eval()) == 0);
  BOOST_TEST(magnitude((element_of_product(g * g2, h * h2).value - (gh * other).value).eval()) < 4 * eps);
  auto const v = log(gh);
  BOOST_TEST(magnitude((v.coordinates.head<3>() - log(g).coordinates).eval()) == 0);
  BOOST_TEST(magnitude((v.coordinates.tail<3>() - log(h).coordinates).eval()) == 0);
  BOOST_TEST(magnitude(bracket(basis_velocity<double>(Product{}, 1), basis_velocity<double>(Product{}, 4))
                           .coordinates) == 0);
}

namespace {

enum class Fault { none, lopsided, forward_only, unscaled_restore, transposed };

/// SL(3) with a fault.
struct Spoilt : SL<> {
  Fault fault;
  explicit Spoilt(Fault f) : SL<>(3), fault(f) {}

  template <class S>
  Matrix<S> retract(Vector<S> const& v) const {
    Matrix<S> g = SL<>::retract(v);
    // Both factors on the left, or only the first half of the way.
    if (fault == Fault::lopsided) {
      S const inverse = S(1) / determinant_by_elimination(cayley(Matrix<S>(hat(v) / S(2))));
      g.row(0) *= inverse;
      g.col(0) /= inverse;
    }
    if (fault == Fault::forward_only) {
      g = Matrix<S>::Identity(3, 3);
      for (int a = 0; a < 8; ++a) {
        Vector<S> along = Vector<S>::Zero(8);
        along[a] = v[a];
        g = (g * cayley(hat(along))).eval();
      }
    }
    return g;
  }
  template <class S>
  Matrix<S> inverse(Matrix<S> const& a) const {
    if (fault == Fault::transposed) return a.transpose();
    return inverse_matrix(a);
  }
  template <Real S>
  Vector<S> log(Matrix<S> const& a) const { return logarithm_in_algebra<Spoilt, S>(*this, a); }
  template <Real S>
  Matrix<S> restore(Matrix<S> const& a) const {
    return fault == Fault::unscaled_restore ? a : SL<>::restore(a);
  }
};

/// Whether the laws over double hold, but for those with that word in their names, one of which is broken by
/// far.
bool breaks_only_laws_of(std::string const& word, Fault fault) {
  bool met = false;
  for (auto const& f : laws::check<double>(Spoilt(fault), laws::seed)) {
    bool const expected = f.law.find(word) != std::string::npos;
    if (!f.holds() && !expected) return false;
    met = met || (expected && f.measured > 1000 * f.allowed);
  }
  return met;
}

}  // namespace

BOOST_AUTO_TEST_CASE(faults_in_a_family_are_found_by_the_laws) {
  for (auto const& f : laws::check<double>(Spoilt(Fault::none), laws::seed)) BOOST_TEST(f.holds(), f.text());
  BOOST_TEST(breaks_only_laws_of("retract(-v)", Fault::lopsided));
  BOOST_TEST(breaks_only_laws_of("retract", Fault::forward_only));
  BOOST_TEST(!breaks_only_laws_of("inverse", Fault::none));
  // These break more than one: what is not restored has no logarithm.
  for (Fault const fault : {Fault::unscaled_restore, Fault::transposed}) {
    int broken = 0;
    for (auto const& f : laws::check<double>(Spoilt(fault), laws::seed)) broken += !f.holds();
    BOOST_TEST(broken > 0);
  }
}
