#include "program/systems/media/crossing.hpp"

#include <algorithm>
#include <cmath>

namespace actio::scene {
namespace {

/// The speed of characteristics along an axis as a function of the stretch there.
template <int d>
class CharacteristicSpeed {
 public:
  CharacteristicSpeed(media::StoredEnergy<d> const& law, double density, int axis)
      : law_(law), of_weight_(law.weight(density) / density), axis_(axis) {}
  /// C(J); NaN where the medium is not stable there.
  double operator()(double J) const {
    auto F = Matrix<double, d, d>::Identity(), along = Matrix<double, d, d>::Zero();
    F(axis_, axis_) = J, along(axis_, axis_) = 1;
    return std::sqrt(law_.stress_rate(F, along)(axis_, axis_) * of_weight_);
  }
  /// C'(J).
  double slope(double J) const {
    double const h = 1e-5 * J;
    return ((*this)(J + h) - (*this)(J - h)) / (2 * h);
  }
  /// \f$C'/(2C^{3/2})\f$.
  double steepening(double J) const { return slope(J) / (2 * std::pow((*this)(J), 1.5)); }

 private:
  media::StoredEnergy<d> const& law_;
  double of_weight_;
  int axis_;
};

/// The wave at points along its axis.
struct Wave {
  std::vector<double> J, v, J_slope, v_slope;
};

/// The axis of a plane wave; -1 where the start is none.
template <int d>
int axis_of(MediumMesh const& mesh, MediumStart const& start) {
  for (int axis = 0; axis < d; ++axis) {
    bool plane = true;
    for (int sample = 0; sample < 64 && plane; ++sample) {
      std::array<double, d> X, other, x, y, v, w;
      for (std::size_t a = 0; a < d; ++a) {
        // Points that fill the box evenly, and beside each a point with the same coordinate along the axis
        // and others that no symmetry of a formula brings to the first ones.
        double const at = std::fmod((sample + 1) * std::array{0.754877666, 0.569840291, 0.430159709}[a], 1.0),
                     length = mesh.upper[a] - mesh.lower[a];
        X[a] = mesh.lower[a] + at * length;
        other[a] =
            static_cast<int>(a) == axis ? X[a] : mesh.lower[a] + std::fmod(at + 0.3819660, 1.0) * length;
      }
      start.placement(X, x.data()), start.placement(other, y.data());
      start.velocity(X, v.data()), start.velocity(other, w.data());
      for (std::size_t a = 0; a < d; ++a) {
        bool const here = static_cast<int>(a) == axis;
        double const length = mesh.upper[a] - mesh.lower[a];
        plane = plane && std::abs(x[a] - (here ? y[a] : X[a])) <= 1e-12 * (length + std::abs(x[a])) &&
                std::abs(v[a] - (here ? w[a] : 0)) <= 1e-12 * std::abs(v[a]);
      }
    }
    // At a free side across the wave the medium gives way.
    for (int a = 0; a < d; ++a)
      for (char const* const name : actio::media::detail::side_names[a])
        plane = plane && (a == axis || mesh.periodic[static_cast<std::size_t>(a)] ||
                          mesh.sides.at(name) != media::Side::free);
    if (plane) return axis;
  }
  return -1;
}

template <int d>
Wave sampled(MediumMesh const& mesh, MediumStart const& start, int axis) {
  constexpr int count = 4096;
  auto const a = static_cast<std::size_t>(axis);
  double const h = (mesh.upper[a] - mesh.lower[a]) / count;
  std::array<double, count + 1> x, v;
  for (int k = 0; k <= count; ++k) {
    std::array<double, d> X, place, rate;
    for (std::size_t i = 0; i < d; ++i) X[i] = mesh.lower[i];
    X[a] += k * h;
    start.placement(X, place.data()), start.velocity(X, rate.data());
    x[static_cast<std::size_t>(k)] = place[a], v[static_cast<std::size_t>(k)] = rate[a];
  }
  Wave out;
  for (std::size_t k = 1; k + 2 <= count; ++k) {
    out.J.push_back((x[k + 1] - x[k]) / h), out.v.push_back((v[k + 1] + v[k]) / 2);
    out.J_slope.push_back((x[k + 2] - x[k + 1] - x[k] + x[k - 1]) / (2 * h * h));
    out.v_slope.push_back((v[k + 1] - v[k]) / h);
  }
  return out;
}

/// \f$\int C\,dJ\f$ from the least J of a wave on, on a grid of J that reaches so far beyond as is needed.
template <int d>
class SpeedIntegral {
 public:
  SpeedIntegral(CharacteristicSpeed<d> const& C, double least, double most) : C_(C) {
    J_ = {least}, z_ = {0};
    while (J_.back() < most) add(J_.back() * 1.001);
  }
  double operator()(double J) const {
    auto const after =
        std::clamp(static_cast<std::size_t>(std::upper_bound(J_.begin(), J_.end(), J) - J_.begin()),
                   std::size_t{1}, J_.size() - 1);
    return z_[after - 1] + (z_[after] - z_[after - 1]) * (J - J_[after - 1]) / (J_[after] - J_[after - 1]);
  }
  /// `visit(J)` for J between those where the integral has two values.
  template <class Visit>
  void between(double low, double up, Visit const& visit) {
    double first = J_.front(), sum = 0;
    while (sum > low && first > 1e-6) sum -= C_(first * 0.9995) * 0.001 * first, first *= 0.999, visit(first);
    while (z_.back() < up && J_.back() < 1e6) add(J_.back() * 1.001);
    for (std::size_t k = 0; k < J_.size(); ++k)
      if (z_[k] >= low && z_[k] <= up) visit(J_[k]);
  }

 private:
  void add(double J) {
    double const step = J - J_.back();
    z_.push_back(z_.back() + step * C_(J_.back() + step / 2)), J_.push_back(J);
  }
  CharacteristicSpeed<d> const& C_;
  std::vector<double> J_, z_;
};

double largest(std::vector<double> const& of) {
  double out = 0;
  for (double const one : of) out = std::max(out, std::abs(one));
  return out;
}

/// The largest aY that a start allows, or that it has where it is a simple wave.
template <int d>
std::pair<double, bool> largest_rate(Wave const& wave, CharacteristicSpeed<d> const& C) {
  std::size_t const n = wave.J.size();
  auto const [least, most] = std::minmax_element(wave.J.begin(), wave.J.end());
  SpeedIntegral<d> integral(C, *least * 0.999, *most * 1.001);
  std::vector<double> r_slope, s_slope, Y;
  double r[2] = {HUGE_VAL, -HUGE_VAL}, s[2] = {HUGE_VAL, -HUGE_VAL}, Y_range[2] = {0, 0};
  for (std::size_t k = 0; k < n; ++k) {
    double const speed = C(wave.J[k]), z = integral(wave.J[k]);
    r_slope.push_back(wave.v_slope[k] - speed * wave.J_slope[k]);
    s_slope.push_back(wave.v_slope[k] + speed * wave.J_slope[k]);
    for (double const slope : {r_slope.back(), s_slope.back()}) {
      Y_range[0] = std::min(Y_range[0], std::sqrt(speed) * slope);
      Y_range[1] = std::max(Y_range[1], std::sqrt(speed) * slope);
    }
    r[0] = std::min(r[0], wave.v[k] - z), r[1] = std::max(r[1], wave.v[k] - z);
    s[0] = std::min(s[0], wave.v[k] + z), s[1] = std::max(s[1], wave.v[k] + z);
  }
  double const right = largest(r_slope), left = largest(s_slope);
  double rate = 0;
  if (std::min(left, right) <= 1e-4 * std::max(left, right)) {
    auto const& slope = left < right ? r_slope : s_slope;
    for (std::size_t k = 0; k < n; ++k)
      rate = std::max(rate, C.steepening(wave.J[k]) * std::sqrt(C(wave.J[k])) * slope[k]);
    return {rate, true};
  }
  integral.between((s[0] - r[1]) / 2, (s[1] - r[0]) / 2, [&](double J) {
    double const a = C.steepening(J);
    rate = std::max({rate, a * Y_range[0], a * Y_range[1]});
  });
  return {rate, false};
}

}  // namespace

template <int d>
std::optional<Crossing> crossing_of_characteristics(MediumMesh const& mesh, MediumStart const& start,
                                                    media::StoredEnergy<d> const& law) {
  if (mesh.shape != "box" || !start.uniform) return {};
  int const axis = axis_of<d>(mesh, start);
  if (axis < 0) return {};
  double density = 0;
  start.density(std::array<double, d>{}, &density);
  Wave const wave = sampled<d>(mesh, start, axis);
  // A placement may fold between the nodes; a wave that has folded has crossed already.
  if (!std::ranges::all_of(wave.J, [](double J) { return J > 0 && std::isfinite(J); })) return {};
  auto const [rate, simple] = largest_rate<d>(wave, CharacteristicSpeed<d>(law, density, axis));
  // Differences of formulas leave some 1e-8.
  if (!(rate > 1e-7) || !std::isfinite(rate)) return {};
  return Crossing{1 / rate, simple && mesh.periodic[static_cast<std::size_t>(axis)]};
}
/// Along a line.
template std::optional<Crossing> crossing_of_characteristics<1>(MediumMesh const&, MediumStart const&,
                                                                media::StoredEnergy<1> const&);
/// In the plane.
template std::optional<Crossing> crossing_of_characteristics<2>(MediumMesh const&, MediumStart const&,
                                                                media::StoredEnergy<2> const&);
/// In space.
template std::optional<Crossing> crossing_of_characteristics<3>(MediumMesh const&, MediumStart const&,
                                                                media::StoredEnergy<3> const&);

}  // namespace actio::scene
