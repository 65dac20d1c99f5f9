// Groups that are the same under two names agree in every primitive.
#include "laws_of_more_groups.hpp"
#include "refused.hpp"

using namespace actio;

namespace {

double const eps = epsilon<double>();
using Column = actio::Vector<double>;
using Square = actio::Matrix<double>;
using Tables = std::vector<Square>;

/// What the primitives of a group make of two velocities, v and w, one after the other.
template <class G>
Tables results(G const& group, Column const& some_v, Column const& some_w) {
  Coordinates<G, double> const v = some_v, w = some_w;
  Storage<G, double> const a = primitive::retract(group, v);
  Tables found = {group.hat(v),
                  group.vee(a),
                  a,
                  primitive::inverse(group, a),
                  primitive::Ad(group, a, w),
                  primitive::bracket(group, v, w)};
  Storage<G, double> const e = primitive::exp(group, v);
  found.insert(found.end(), {e, primitive::log_of<G, double>(group, e), primitive::restore(group, e)});
  return found;
}
/// Equal to `roundings` of the size of the numbers.
void same(std::string const& what, Tables const& a, Tables const& b, double roundings) {
  static char const* const names[] = {"hat",     "vee", "retract", "inverse", "Ad",
                                      "bracket", "exp", "log",     "restore"};
  BOOST_TEST_REQUIRE(a.size() == b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    double const difference = to_double(magnitude((a[k] - b[k]).eval())),
                 allowed = roundings * eps * (1 + to_double(magnitude(a[k])));
    BOOST_TEST(difference <= allowed,
               what << ", " << names[k] << ": " << difference << ", allowed " << allowed);
  }
}
/// Both are a few roundings off, and logarithms of general matrices a few tens.
template <class G, class H>
void agree(std::string const& what, G const& g, H const& h) {
  Draw draw(3);
  for (int k = 0; k < 3; ++k) {
    Column const v = draw.vector<double>(g.dimension()), w = draw.vector<double>(g.dimension());
    same(what, results(g, v, w), results(h, v, w), 64);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(groups_that_are_the_same_agree_in_every_primitive) {
  agree("SO(3) |x R^3 and SE(3)", SemidirectProduct<SO<3>, 3>{}, SE<3>{});
  agree("SL(2) of its family and by itself", SL<>(2), SL2{});
  agree("Sp(2) and SL(2)", Sp<>(2), SL2{});
  agree("U(1) and SO(2)", U<>(1), SO<2>{});
  agree("SL(3) of fixed and of chosen order", SL<3>{}, SL<>(3));
}

BOOST_AUTO_TEST_CASE(motions_next_to_half_a_turn_are_as_good_as_those_of_SE3) {
  using G = SemidirectProduct<SO<3>, 3>;
  double const angle = laws::nearly_pi<double>();
  Coordinates<G, double> v;
  v << laws::turning(angle), 1, 2, -3;
  auto const g = exp(velocity(G{}, v));
  // The drift of the shift is a map with condition pi/2 there.
  BOOST_TEST(magnitude((log(g).coordinates - v).eval()) < 64 * eps * 3);
  v.head<3>() *= M_PI / angle;
  BOOST_CHECK_EXCEPTION(log(exp(velocity(G{}, v))), OutsideDomain,
                        [](OutsideDomain const& e) { return e.measured > 3.14; });
}

namespace {

/// The complex matrix ((w + ix, y + iz), (-y + iz, w - ix)) of a quaternion, as a real one: i, j and k become
/// the basis of SU(2) as matrices.
Square matrix_of(actio::Vector<double, 4> const& q) {
  Square a(4, 4);
  a << q[0], q[2], -q[1], -q[3], -q[2], q[0], -q[3], q[1], q[1], q[3], q[0], q[2], q[3], -q[1], -q[2], q[0];
  return a;
}
/// The quaternion (1, v/2) is near 1 in the direction v: half the coordinates.
Column halved(Coordinates<SU2, double> const& v) { return v / 2; }

}  // namespace

BOOST_AUTO_TEST_CASE(quaternions_and_matrices_of_SU2_are_one_group) {
  SU<> const matrices(2);
  Draw draw(5);
  for (int k = 0; k < 3; ++k) {
    auto const v = draw.velocity<double>(SU2{}), w = draw.velocity<double>(SU2{});
    auto const p = retract(v), q = retract(w);
    auto const two = results(matrices, halved(v.coordinates), halved(w.coordinates));
    Tables one = {matrices.hat(halved(v.coordinates)),
                  matrices.vee(matrix_of(p.value)),
                  matrix_of(p.value),
                  matrix_of(inverse(p).value),
                  halved(Ad(p, w).coordinates),
                  halved(bracket(v, w).coordinates)};
    one.insert(one.end(),
               {matrix_of(exp(v).value), halved(log(exp(v)).coordinates), matrix_of(restore(exp(v)).value)});
    same("SU(2)", one, two, 64);
    same("product", {matrix_of((p * q).value)}, {matrix_of(p.value) * matrix_of(q.value)}, 64);
  }
}

BOOST_AUTO_TEST_CASE(the_chart_of_SU2_is_twice_as_wide_as_that_of_SO3) {
  SU<> const matrices(2);
  auto const turn = velocity(SU2{}, laws::turning(4.0));
  same("a turn by 4", {halved(turn.coordinates)},
       {log(exp(velocity(matrices, halved(turn.coordinates)))).coordinates}, 64);
  // A whole turn is -1, where both charts end.
  auto const whole = velocity(SU2{}, laws::turning(2 * M_PI));
  CHECK_REFUSED(log(exp(whole)), OutsideDomain);
  CHECK_REFUSED(log(exp(velocity(matrices, halved(whole.coordinates)))), OutsideDomain);
}
