// Every law is seen to fail: SE(2) with one primitive spoilt at a time.
#include "laws_of_the_groups.hpp"

#include <map>

namespace {

using namespace actio;

enum class Fault {
  none,
  compose,
  identity,
  inverse,
  Ad_side,
  Ad_scale,
  Ad_curved,
  bracket_sign,
  bracket_symmetric,
  bracket_jacobi,
  bracket_curved,
  near_identity,
  retract_offset,
  retract_first_order,
  exp_first_order,
  log_scale,
  restore_scale,
  restore_far,
  restore_nothing
};

/// SE(2) with a fault.
struct Spoilt : SE<2> {
  Fault fault = Fault::none;

  template <class S>
  using Matrix = actio::Matrix<S, 3, 3>;
  template <class S>
  using Vector = actio::Matrix<S, 3, 1>;

  template <class S>
  Matrix<S> identity() const {
    if (fault == Fault::identity) return cayley(hat(Vector<S>(S(1), S(0), S(0))));
    return Matrix<S>::Identity();
  }
  template <class S>
  Matrix<S> compose(Matrix<S> const& a, Matrix<S> const& b) const {
    if (fault == Fault::compose) return a * SE<2>::inverse(b);
    return a * b;
  }
  template <class S>
  Matrix<S> inverse(Matrix<S> const& a) const {
    if (fault == Fault::inverse) return a.transpose();
    return SE<2>::inverse(a);
  }
  template <class S>
  Vector<S> Ad(Matrix<S> const& a, Vector<S> const& v) const {
    Matrix<S> const back = SE<2>::inverse(a);
    if (fault == Fault::Ad_side) return vee(Matrix<S>(back * hat(v) * a));
    Vector<S> const right = vee(Matrix<S>(a * hat(v) * back));
    if (fault == Fault::Ad_scale) return right * S(2);
    if (fault == Fault::Ad_curved) return right * (S(1) + v[0] * v[0]);
    return right;
  }
  template <class S>
  Vector<S> bracket(Vector<S> const& v, Vector<S> const& w) const {
    Vector<S> right = vee(Matrix<S>(hat(v) * hat(w) - hat(w) * hat(v)));
    if (fault == Fault::bracket_sign) right = -right;
    if (fault == Fault::bracket_symmetric) right[0] += v[0] * w[0];
    if (fault == Fault::bracket_jacobi) right[1] += v[1] * w[2] - v[2] * w[1];
    if (fault == Fault::bracket_curved) right *= S(1) + v[0] * v[0] + w[0] * w[0];
    return right;
  }
  template <class S>
  Matrix<S> near_identity(Vector<S> const& v) const {
    return Matrix<S>::Identity() + hat(v) * S(fault == Fault::near_identity ? 2 : 1);
  }
  template <class S>
  Matrix<S> retract(Vector<S> const& v) const {
    if (fault == Fault::retract_offset) return cayley(hat(Vector<S>(v[0] + S(1), v[1], v[2])));
    if (fault == Fault::retract_first_order) return turned_then_shifted(cayley(hat(v)), v);
    return cayley(hat(v));
  }
  template <Real S>
  Matrix<S> exp(Vector<S> const& v) const {
    if (fault == Fault::exp_first_order) return turned_then_shifted(SE<2>::exp(v), v);
    return SE<2>::exp(v);
  }
  template <Real S>
  Vector<S> log(Matrix<S> const& a) const {
    return SE<2>::log(a) * (fault == Fault::log_scale ? ratio<S>(101, 100) : S(1));
  }
  template <Real S>
  Matrix<S> restore(Matrix<S> const& a) const {
    if (fault == Fault::restore_scale) return SE<2>::restore(a) * ratio<S>(1001, 1000);
    if (fault == Fault::restore_far) return Matrix<S>::Identity();
    if (fault == Fault::restore_nothing) return a;
    return SE<2>::restore(a);
  }

 private:
  /// The rotation of a beside the shift of v, as if the frame did not turn on the way.
  template <class S>
  static Matrix<S> turned_then_shifted(Matrix<S> a, Vector<S> const& v) {
    a(0, 2) = v[1], a(1, 2) = v[2];
    return a;
  }
};

/// The fault that is planted against each law.
std::map<std::string, Fault> const planted = {
    {"compose is associative", Fault::compose},
    {"identity is neutral", Fault::identity},
    {"inverse is inverse", Fault::inverse},
    {"Ad(gh) = Ad(g) Ad(h)", Fault::Ad_side},
    {"Ad_g xi is g xi g^-1", Fault::Ad_side},
    {"Ad preserves brackets", Fault::Ad_scale},
    {"bracket is antisymmetric", Fault::bracket_symmetric},
    {"bracket satisfies Jacobi's identity", Fault::bracket_jacobi},
    {"bracket is linear", Fault::bracket_curved},
    {"bracket is the derivative of Ad", Fault::bracket_sign},
    {"<Ad*_g mu, xi> = <mu, Ad_g xi>", Fault::Ad_curved},
    {"<ad*_xi mu, eta> = <mu, [xi, eta]>", Fault::bracket_curved},
    {"near_identity is retract of infinitesimals", Fault::near_identity},
    {"retract(0) is the identity", Fault::retract_offset},
    {"retract(-v) inverts retract(v)", Fault::retract_first_order},
    {"retract is exp to second order", Fault::retract_first_order},
    {"L* l' = Ad* R* l'", Fault::Ad_side},
    {"exp(log g) = g", Fault::log_scale},
    {"log(exp v) = v", Fault::log_scale},
    {"log(exp(v + dv)) = v + dv", Fault::log_scale},
    {"exp((s+t)v) = exp(sv) exp(tv)", Fault::exp_first_order},
    {"exp(-v) inverts exp(v)", Fault::exp_first_order},
    {"exp(v + dv) = (1 + iex(ad_v) dv) exp(v)", Fault::bracket_sign},
    {"exp(v + dv) = exp(v) (1 + iex(-ad_v) dv)", Fault::bracket_sign},
    {"restore leaves elements alone", Fault::restore_scale},
    {"restore moves by no more than the push", Fault::restore_far},
    {"restore brings back on the group", Fault::restore_nothing},
};

std::vector<laws::Finding> findings_with(Fault fault) {
  Spoilt group;
  group.fault = fault;
  return laws::check<double>(group, laws::seed);
}

}  // namespace

BOOST_AUTO_TEST_CASE(without_a_fault_all_laws_hold_and_each_has_a_control) {
  for (auto const& f : findings_with(Fault::none)) {
    BOOST_TEST(f.holds(), f.text());
    BOOST_TEST(planted.count(f.law) == 1u, "no control for: " << f.law);
  }
}

BOOST_AUTO_TEST_CASE(each_law_fails_where_its_fault_is_planted) {
  for (auto const& [law, fault] : planted) {
    bool broken = false, met = false;
    for (auto const& f : findings_with(fault))
      if (f.law == law) met = true, broken = !f.holds() && f.measured > 1000 * f.allowed;
    BOOST_TEST(met, "no such law: " << law);
    BOOST_TEST(broken, "survives its fault: " << law);
  }
}
