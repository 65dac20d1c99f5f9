#include "actio/fast_body/space/body_batch.hpp"

namespace actio::bodies {

namespace detail {

Eigen::Vector4d frame_quaternion(Three<double> const& u, Three<double> const& w) {
  Three<double> const x{u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]};
  double const a = u[0], b = w[1], c = x[2];
  // The largest of the four first: its square is at least 1/4 of the sum.
  Eigen::Vector4d q;
  if (a + b + c > 0)
    q = {1 + a + b + c, w[2] - x[1], x[0] - u[2], u[1] - w[0]};
  else if (a >= b && a >= c)
    q = {w[2] - x[1], 1 + a - b - c, u[1] + w[0], u[2] + x[0]};
  else if (b >= c)
    q = {x[0] - u[2], u[1] + w[0], 1 - a + b - c, w[2] + x[1]};
  else
    q = {u[1] - w[0], u[2] + x[0], w[2] + x[1], 1 - a - b + c};
  return q.normalized();
}

}  // namespace detail

BodyBatch::BodyBatch(double h, Machine machine) : h_(h), machine_(machine) {
  if (!is_finite(h)) throw NotFinite("batch: step");
  if (h == 0) throw OutsideDomain("batch", "the step must differ from zero", 0, 0);
}

BodyBatch::BodyBatch(std::vector<Inertia<3>> const& inertias,
                     std::vector<Momentum<SO<3>, double>> const& momenta,
                     std::vector<Element<SU2, double>> const& attitudes, double h, Machine machine)
    : BodyBatch(h, machine) {
  if (momenta.size() != inertias.size() || attitudes.size() != inertias.size())
    throw OutsideDomain(
        "batch", "as many momenta and attitudes as bodies are needed; the length that is off",
        static_cast<double>(momenta.size() != inertias.size() ? momenta.size() : attitudes.size()),
        static_cast<double>(inertias.size()));
  for (std::size_t i = 0; i < inertias.size(); ++i) try {
      add(inertias[i], momenta[i], attitudes[i]);
    } catch (BodyRefused const& why) {
      refused_.push_back(why);
      leave_out();
    }
}

std::size_t BodyBatch::add(Inertia<3> const& inertia, Momentum<SO<3>, double> const& momentum,
                           Element<SU2, double> const& attitude) {
  try {
    inertia_from_moments(inertia.moments);
    FreeBody const body(inertia, momentum, attitude);
    put(body, body.step_parameters(h_));
  } catch (BodyRefused const&) {
    throw;
  } catch (Error const& error) {
    throw BodyRefused(size(), error.what());
  }
  return size() - 1;
}

Element<SU2, double> BodyBatch::attitude(std::size_t i) const {
  Cold const& c = cold(i);
  require_attitudes();
  auto const n = static_cast<double>(steps_ - c.since);
  double const turned = n * c.twist, lost = std::fma(n, c.twist, -turned);
  Eigen::Vector4d const twist(std::cos(turned) - lost * std::sin(turned),
                              std::sin(turned) + lost * std::cos(turned), 0, 0);
  Eigen::Vector4d q =
      SU2::compose<double>(SU2::compose<double>(c.frame, twist), SU2::inverse<double>(frame(i)));
  if (q[0] < 0) q = -q;
  return c.body->state({normalized(entry(lanes_[i / 4].u, i % 4)), {q[0], q[1], q[2], q[3]}}).attitude;
}

Eigen::Vector4d BodyBatch::frame(std::size_t i) const {
  Three<double> const u = normalized(entry(lanes_[i / 4].u, i % 4));
  Three<double> w = entry(lanes_[i / 4].w, i % 4);
  double const beside = dot(u, w);
  for (int k = 0; k < 3; ++k) w[k] -= beside * u[k];
  return detail::frame_quaternion(u, normalized(w));
}

BodyBatch::Cold const& BodyBatch::cold(std::size_t i) const {
  if (i >= size())
    throw OutsideDomain("batch", "no such body; index", static_cast<double>(i), static_cast<double>(size()));
  if (!cold_[i].body)
    for (auto const& why : refused_)
      if (why.index == i) throw why;
  return cold_[i];
}

void BodyBatch::leave_out() {
  std::size_t const i = size();
  if (i % 4 == 0) lanes_.emplace_back();
  detail::FreeLanes& lanes = lanes_[i / 4];
  for (int l = static_cast<int>(i % 4); l < 4; ++l)
    for (int k = 0; k < 3; ++k) {
      lanes.u[k].set(l, k == 0), lanes.w[k].set(l, k == 1);
      lanes.stretch[k].set(l, 1), lanes.shear[k].set(l, 0), lanes.delta[k].set(l, 0), lanes.sum[k].set(l, 0);
      lanes.product.set(l, 0), lanes.newton.set(l, 1);
    }
  cold_.push_back({nullptr, {1, 0, 0, 0}, 0, steps_});
}

void BodyBatch::put(FreeBody const& body, StepParameters<double> const& parameters) {
  Three<double> const& u = body.start().direction;
  // At right angles to u: the part of the axis that is farthest from it.
  int const far = std::abs(u[0]) <= std::abs(u[1]) && std::abs(u[0]) <= std::abs(u[2]) ? 0
                  : std::abs(u[1]) <= std::abs(u[2])                                   ? 1
                                                                                       : 2;
  Three<double> w{-u[far] * u[0], -u[far] * u[1], -u[far] * u[2]};
  w[far] += 1;
  w = normalized(w);
  Three<double> const& stretch = parameters.stretch;
  Three<double> const& d = parameters.delta;
  double const product = d[0] * d[1] * d[2], newton = 1 / (1 + d[0] * d[1] + d[1] * d[2] + d[2] * d[0]);
  if (!std::isfinite(dot(stretch, stretch) + dot(parameters.gap, parameters.gap) + product + newton))
    throw NotFinite("free body: parameters of a step");
  leave_out();
  std::size_t const i = size() - 1;
  int const l = static_cast<int>(i % 4);
  detail::FreeLanes& lanes = lanes_[i / 4];
  lanes.product.set(l, product), lanes.newton.set(l, newton);
  for (int k = 0; k < 3; ++k) {
    lanes.u[k].set(l, u[k]), lanes.w[k].set(l, w[k]);
    lanes.stretch[k].set(l, stretch[k]), lanes.shear[k].set(l, parameters.gap[k]),
        lanes.delta[k].set(l, d[k]);
    lanes.sum[k].set(l, d[(k + 1) % 3] + d[(k + 2) % 3]);
    lanes.gentle = lanes.gentle && std::abs(parameters.delta[k]) <= 1;
  }
  auto const& q = body.start().attitude;
  cold_[i].body = std::make_shared<FreeBody const>(body);
  cold_[i].frame = SU2::compose<double>({q[0], q[1], q[2], q[3]}, frame(i));
  cold_[i].twist = std::atan2(parameters.sin_twist, parameters.cos_twist);
}

}  // namespace actio::bodies
