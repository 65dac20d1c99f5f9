#include <Eigen/Core>

#include "program/systems/sphere/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "actio/vorticity/averaged_steps.hpp"
#include "program/systems/sphere/products.hpp"
#include "program/systems/sphere/stepped.hpp"

// In compiled_layer_steps.cpp.
extern template class actio::sphere::VorticityStep<actio::sphere::HelmholtzStream>;

namespace actio::scene {
namespace {

/// The frame about the pole in which W changes least. Where W changes at all it does turn, be it ever so
/// slowly: in a frame at rest a step has no correction that would keep the angular momentum along the axis.
/// @param fast  a rate, 1/time
sphere::TurningFrame frame_about_pole(sphere::QuantizedSphere const& sphere, SphereStream const& stream,
                                      sphere::SkewHermitian<> const& w, double fast) {
  sphere::TurningFrame frame;
  sphere::SkewHermitian<> const turned = frame.turn(sphere, w),
                                moves = sphere::commutator(stream.solve(w), w);
  double const size = sphere::inner_product(turned, turned);
  if (size > 1e-26 * sphere::inner_product(w, w))
    frame.rate = -sphere::inner_product(moves, turned) / (sphere.hbar() * size);
  if (frame.rate == 0 && sphere::norm(moves) > 0) frame.rate = 1e-9 * fast;
  return frame;
}

}  // namespace

template <class Real>
void remember_matrix(CheckpointStream& stream, sphere::SkewHermitian<Real>& w, int n) {
  typename sphere::SkewHermitian<Real>::Part half(n, n);
  if (!stream.reading()) {
    half = w.real.template triangularView<Eigen::StrictlyUpper>();
    half.template triangularView<Eigen::Lower>() = w.imaginary;
  }
  std::span<Real> numbers(half.data(), static_cast<std::size_t>(half.size()));
  stream(numbers);
  if (!stream.reading()) return;
  w = sphere::SkewHermitian<Real>(n);
  w.imaginary.template triangularView<Eigen::Lower>() = half;
  w.real.template triangularView<Eigen::StrictlyLower>() = -half.transpose();
  sphere::mirror_lower(w);
}
/// In double precision.
template void remember_matrix(CheckpointStream&, sphere::SkewHermitian<double>&, int);

StateDistance VorticityMotion::distance(Motion const& other) const {
  auto const w = vorticity_but_for_rotation();
  return {0, sphere::norm(w - dynamic_cast<VorticityMotion const&>(other).vorticity_but_for_rotation()),
          sphere::norm(w)};
}

SphereStream::SphereStream(int n, SphereHamiltonian const& hamiltonian)
    : stream_([&]() -> Kind {
        if (hamiltonian.layer()) return sphere::HelmholtzStream(n, hamiltonian.gamma);
        if (hamiltonian.averaged()) return sphere::AveragedStream(n, hamiltonian.length, hamiltonian.metric);
        return sphere::SphereLaplacian(n);
      }()) {}
sphere::SkewHermitian<> SphereStream::solve(sphere::SkewHermitian<> const& w) const {
  return std::visit([&](auto const& stream) { return stream.solve(w); }, stream_);
}

SphereFlow::SphereFlow(SphereHamiltonian const& of_flow, double rotation_of_sphere,
                       sphere::SkewHermitian<> const& relative, sphere::Conserved conserved,
                       std::vector<std::string>& remarks)
    : sphere(static_cast<int>(relative.size())),
      hamiltonian(of_flow),
      stream(sphere.n, hamiltonian),
      rotation(rotation_of_sphere),
      start(relative + sphere::planetary_vorticity(sphere, rotation_of_sphere)),
      frame(conserved == sphere::Conserved::energy_casimir && rotation != 0
                ? frame_about_pole(sphere, stream, start, turning_back())
                : sphere::calmest_frame(sphere, stream, start)),
      products(products_of_flow(start, remarks)) {
  take_apart(relative, conserved);
  if (!apart.is_there()) return;
  if (double const other = sphere::norm(apart.flow); other > 0)
    remarks.push_back(
        fmt::format("what turns as a whole has {:.2g} times the vorticity of the rest of the flow, so that "
                    "the steps are made of the rest, in double precision",
                    std::abs(apart.background.vorticity) * std::sqrt(sphere.n / 3.0) / other));
}

/// b X with X = i hbar S_3 has the norm b sqrt(N/3).
void SphereFlow::take_apart(sphere::SkewHermitian<> const& relative, sphere::Conserved conserved) {
  // A function own . x.
  auto const of_degree_1 = [&](sphere::SkewHermitian<> const& w) {
    return Eigen::Vector3d(sphere::spin_components(sphere, w) / (sphere.spin_square() * sphere.hbar()));
  };
  Eigen::Vector3d const pole = Eigen::Vector3d::UnitZ(), own = of_degree_1(relative),
                        all = own + 2 * rotation * pole;
  bool const about_pole = conserved == sphere::Conserved::energy_casimir && rotation != 0;
  Eigen::Vector3d const axis = about_pole ? pole : Eigen::Vector3d(all.normalized());
  auto const held = [&](Eigen::Vector3d const& r) { return about_pole ? Eigen::Vector3d(r[2] * pole) : r; };
  double const b = axis.dot(all);
  // What of the first subtraction is rounding the second one takes away; and where that is all, there is no
  // flow.
  sphere::SkewHermitian<> rest = relative;
  for (int k = 0; k < 2; ++k) sphere::add_spin(sphere, -sphere.hbar() * held(of_degree_1(rest)), rest);
  if (sphere::norm(rest) <= sphere.n * std::numeric_limits<double>::epsilon() * sphere::norm(relative))
    rest = sphere::SkewHermitian<>(sphere.n);
  if (!(std::abs(b) * std::sqrt(sphere.n / 3.0) > fast * sphere::norm(rest))) return;
  apart.relative = held(own);
  if (double const sine = axis.cross(pole).norm(); sine > 0)
    apart.upright = {std::atan2(sine, axis[2]), axis.cross(pole) / sine};
  else if (axis[2] < 0)
    apart.upright.angle() = M_PI;
  if (apart.upright.angle() != 0)
    rest = sphere::Turning(sphere, apart.upright.axis())(apart.upright.angle(), rest);
  apart.flow = std::move(rest);
  apart.background = {b, conserved == sphere::Conserved::lie_poisson ? 0 : calmest_stream(b)};
  // Beside bX the stream function of all has -bX/divisor(1), which the frame takes away but for its part.
  frame = {pole, apart.background.stream + hamiltonian.frame_rate(b / 2)};
}

double SphereFlow::calmest_stream(double b) const {
  auto const turned = [&](sphere::SkewHermitian<> const& w) { return sphere::spin_commutator(sphere, 2, w); };
  sphere::SkewHermitian<> const p = stream.solve(apart.flow), turns = turned(apart.flow);
  double const size = sphere.hbar() * sphere::inner_product(turns, turns);
  if (!(size > 0)) return 0;
  sphere::SkewHermitian<> const moves = sphere::commutator(p, apart.flow) - b * sphere.hbar() * turned(p);
  return -sphere::inner_product(moves, turns) / size;
}

double SphereFlow::fastest_turning() const {
  if (apart.is_there()) {
    sphere::SkewHermitian<> p = stream.solve(apart.flow);
    sphere::add_spin(sphere, sphere.hbar() * apart.background.stream * Eigen::Vector3d::UnitZ(), p);
    // What is not in the flow yet turns, too: waves of degree 2 by b/6. The frame of the Lie-Poisson form
    // does not turn with the waves that are there.
    bool const waves_turn = apart.background.stream == 0;
    return std::max(sphere::FastVorticityStep<>::spectral_radius(p) / sphere.hbar(),
                    std::abs(apart.background.vorticity) / (waves_turn ? 2 : 6));
  }
  sphere::SkewHermitian<> p = stream.solve(start);
  sphere::add_spin(sphere, frame.rate * sphere.hbar() * frame.axis, p);
  return sphere::FastVorticityStep<>::spectral_radius(p) / sphere.hbar();
}

std::unique_ptr<VorticityMotion> stepped_vorticity(std::shared_ptr<SphereFlow const> flow,
                                                   SphereScheme const& scheme, double step) {
  auto const with = [&]<class Step, class Stream>() -> std::unique_ptr<VorticityMotion> {
    return std::make_unique<SteppedVorticity<Step, Stream>>(flow, scheme, step);
  };
  if (flow->hamiltonian.layer())
    return with
        .template operator()<sphere::VorticityStep<sphere::HelmholtzStream>, sphere::HelmholtzStream>();
  auto const with_stream = [&]<class Stream>() {
    if (scheme.to_rounding || flow->apart.is_there())
      return with.template operator()<sphere::VorticityStep<Stream>, Stream>();
    return with.template operator()<sphere::FastVorticityStep<Stream>, Stream>();
  };
  if (flow->hamiltonian.averaged()) return with_stream.template operator()<sphere::AveragedStream>();
  return with_stream.template operator()<sphere::SphereLaplacian>();
}

}  // namespace actio::scene
