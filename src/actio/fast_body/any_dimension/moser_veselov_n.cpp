#include "actio/fast_body/any_dimension/moser_veselov_n.hpp"

namespace actio::bodies {

FastMoserVeselov::FastMoserVeselov(Inertia<Eigen::Dynamic> inertia, double step, Sweeps sweeps,
                                   Machine machine)
    : inertia_(std::move(inertia)),
      step_(step),
      shape_(inertia_.group.n),
      lambda_(4 * static_cast<std::size_t>(shape_.blocks())),
      inverse_(detail::half_size(shape_)) {
  if (!is_finite(step)) throw NotFinite("Moser-Veselov: step");
  if (step == 0) throw OutsideDomain("Moser-Veselov", "the step must differ from zero", 0, 0);
  rule_ = {sweeps, 0, inertia_.lambda.minCoeff() < 0};
  for (int j = 0; j < shape_.n; ++j) lambda_.data()[j] = inertia_.lambda[j] / step;
  for (int j = 0; j < shape_.n; ++j)
    for (int i = 0; i < j; ++i) set_plane(j, i);
  carry_out_ = detail::choose_step(shape_.n, machine);
}

RotatingBody FastMoserVeselov::release(Rotation const& g, BodyMomentum const& pi) const {
  detail::require_rotation(g.value, shape_.n, "Moser-Veselov: attitude");
  if (pi.components.size() != inertia_.moments.size())
    throw OutsideDomain(
        "Moser-Veselov", "a momentum with a component for each moment of inertia is needed; components",
        static_cast<double>(pi.components.size()), static_cast<double>(inertia_.moments.size()));
  if (!is_finite(pi.components)) throw NotFinite("Moser-Veselov: body momentum");
  RotatingBody body(shape_.n);
  body.set_attitude(g.value);
  body.set_momentum(inertia_.group.hat(pi.components));
  return body;
}

FastMoserVeselov::Rotation FastMoserVeselov::last_relative_motion(RotatingBody const& body) const {
  Rotation f = identity<double>(inertia_.group);
  if (body.past_ == 0) return f;
  double const *const square = body.past(0), *const momentum = body.half(RotatingBody::momentum_);
  for (int j = 0; j < shape_.n; ++j)
    for (int i = j; i < shape_.n; ++i) {
      std::ptrdiff_t const at = detail::half_entry(shape_, i, j);
      double const half = square[at] / 2, slope = lambda_.data()[j] - lambda_.data()[i];
      double const turn = inverse_.data()[at] * (momentum[at] - slope * half);
      f.value(i, j) -= half + turn;
      if (i != j) f.value(j, i) -= half - turn;
    }
  return f;
}

void FastMoserVeselov::set_plane(int i, int j) {
  double const sum = lambda_.data()[i] + lambda_.data()[j], inverse = 1 / sum;
  if (!is_finite(sum) || !is_finite(inverse) || !(std::abs(sum) >= std::numeric_limits<double>::min()))
    throw NotFinite("Moser-Veselov: inertia over step");
  inverse_.data()[detail::half_entry(shape_, i, j)] = inverse;
  if (i / 4 == j / 4) inverse_.data()[detail::half_entry(shape_, j, i)] = inverse;
  double const a = inertia_.lambda[i] / (inertia_.lambda[i] + inertia_.lambda[j]), b = 1 - a;
  rule_.spread = std::max(rule_.spread, a * a + b * b);
}

void FastMoserVeselov::advance(RotatingBody& body, bool with_attitude) const {
  using detail::Stage;
  if (body.size() != shape_.n)
    throw OutsideDomain("Moser-Veselov",
                        "a body in as many dimensions as there are Lambda is needed; dimensions", body.size(),
                        shape_.n);
  detail::FixedPointStep const s{body, {lambda_.data(), inverse_.data()}, rule_};
  if (body.scheme_ == RotatingBody::next_scheme) body.scheme_ = id_;
  if (body.scheme_ != id_) carry_out_(s, Stage::prepare, shape_.n), body.scheme_ = id_;
  if (carry_out_(s, with_attitude ? Stage::step_with_attitude : Stage::step, shape_.n)) return;
  body.scheme_ = 0;  // should this fail too, the body is as it was and the next step begins anew
  if (!body.solved_ || !on_branch_of_identity(s)) {
    if (shape_.n <= largest_for_newton)
      by_newton(s);
    else
      by_mixing(s);
  }
  carry_out_(s, with_attitude ? Stage::finish_with_attitude : Stage::finish, shape_.n);
  body.scheme_ = id_;
}

void FastMoserVeselov::by_newton(detail::FixedPointStep const& s) const {
  auto f = MoserVeselov<Eigen::Dynamic>(inertia_, step_).relative_motion(s.body.momentum()).value;
  for (int j = 0; j < shape_.n; ++j)
    for (int i = 0; i < shape_.n; ++i)
      s.motion()[detail::full_entry(shape_, i, j)] = f.value(i, j) - (i == j);
  carry_out_(s, detail::Stage::square, shape_.n);
  s.body.sweeps_ = 1;
}

void FastMoserVeselov::by_mixing(detail::FixedPointStep const& s) const {
  std::vector<double> x(s.body.half_size_, 0.0), residual(x.size());
  std::vector<double> seen;
  Anderson anderson(8);
  constexpr int most = 400;
  double before = HUGE_VAL;
  for (s.body.sweeps_ = 1; s.body.sweeps_ <= most; ++s.body.sweeps_) {
    std::copy(x.begin(), x.end(), s.guess());
    detail::relative_motion(shape_, s.inertia, s.guess(), s.momentum(), s.motion());
    carry_out_(s, detail::Stage::square, shape_.n);
    detail::Defect const d = detail::defect(shape_, s.square(), s.guess());
    s.body.defect_ = d.change, seen.push_back(s.body.defect());
    if (!(d.square < 1e30)) break;
    if (s.body.sweeps_ == 40) refuse_beyond(s.body);
    if (rule_.at_rounding(d, HUGE_VAL, d.change > before / 4 ? 16 : 1)) {
      if (on_branch_of_identity(s)) return;
      break;
    }
    before = d.change;
    for (std::size_t k = 0; k < x.size(); ++k) residual[k] = s.square()[k] - x[k];
    anderson.mix(x, residual);
  }
  refuse_beyond(s.body);
  throw NotConverged("Moser-Veselov", seen, std::numeric_limits<double>::epsilon());
}

bool FastMoserVeselov::on_branch_of_identity(detail::FixedPointStep const& s) const {
  auto const f = [&](int i, int j) { return s.motion()[detail::full_entry(shape_, i, j)] + (i == j); };
  Eigen::MatrixXd x(shape_.n, shape_.n);
  if (!rule_.any_negative) {
    // A positive definite symmetric part of f settles it, and is cheaper.
    for (int j = 0; j < shape_.n; ++j)
      for (int i = 0; i < shape_.n; ++i) x(i, j) = f(i, j) + f(j, i);
    if (detail::positive_definite(x)) return true;
  }
  double const unit = magnitude(inertia_.lambda);
  for (int j = 0; j < shape_.n; ++j)
    for (int i = 0; i < shape_.n; ++i) x(i, j) = f(j, i) * (inertia_.lambda[j] / unit);
  Eigen::VectorXd const real = real_parts_of_eigenvalues(x);
  return real[0] + real[1] > -1e-7;
}

}  // namespace actio::bodies
