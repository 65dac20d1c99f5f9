#include "actio/scene/systems/vorticity_motion.hpp"

#include "actio/scene/systems/vorticity_products.hpp"
#include "actio/scene/systems/vorticity_stepped.hpp"

#ifdef ACTIO_COMPILED_STEPS
// In compiled_layer_steps.cpp.
extern template class actio::VorticityStep<actio::HelmholtzStream>;
#endif

namespace actio::scene {
namespace {

/// The frame about the pole in which W changes least. Where W changes at all it does turn, be it ever so
/// slowly: in a frame at rest a step has no correction that would keep the angular momentum along the axis.
/// @param fast  a rate, 1/time
TurningFrame frame_about_pole(QuantizedSphere const& sphere, SphereStream const& stream,
                              SkewHermitian<> const& w, double fast) {
  TurningFrame frame;
  SkewHermitian<> const turned = frame.turn(sphere, w), moves = commutator(stream.solve(w), w);
  double const size = inner_product(turned, turned);
  if (size > 1e-26 * inner_product(w, w)) frame.rate = -inner_product(moves, turned) / (sphere.hbar() * size);
  if (frame.rate == 0 && norm(moves) > 0) frame.rate = 1e-9 * fast;
  return frame;
}

}  // namespace

template <class Real>
void remember_matrix(CheckpointStream& stream, SkewHermitian<Real>& w, int n) {
  typename SkewHermitian<Real>::Part half(n, n);
  if (!stream.reading()) {
    half = w.real.template triangularView<Eigen::StrictlyUpper>();
    half.template triangularView<Eigen::Lower>() = w.imaginary;
  }
  std::span<Real> numbers(half.data(), static_cast<std::size_t>(half.size()));
  stream(numbers);
  if (!stream.reading()) return;
  w = SkewHermitian<Real>(n);
  w.imaginary.template triangularView<Eigen::Lower>() = half;
  w.real.template triangularView<Eigen::StrictlyLower>() = -half.transpose();
  mirror_lower(w);
}
/// In double precision.
template void remember_matrix(CheckpointStream&, SkewHermitian<double>&, int);

StateDistance VorticityMotion::distance(Motion const& other) const {
  auto const& w = absolute_vorticity();
  return {0, norm(w - dynamic_cast<VorticityMotion const&>(other).absolute_vorticity()), norm(w)};
}

SphereStream::SphereStream(int n, SphereHamiltonian const& hamiltonian)
    : stream_([&]() -> Kind {
        if (hamiltonian.layer()) return HelmholtzStream(n, hamiltonian.gamma);
        return SphereLaplacian(n);
      }()) {}
SkewHermitian<> SphereStream::solve(SkewHermitian<> const& w) const {
  return std::visit([&](auto const& stream) { return stream.solve(w); }, stream_);
}

SphereFlow::SphereFlow(SphereHamiltonian const& of_flow, double rotation_of_sphere,
                       SkewHermitian<> const& relative, Conserved conserved,
                       std::vector<std::string>& remarks)
    : sphere(static_cast<int>(relative.size())),
      hamiltonian(of_flow),
      stream(sphere.n, hamiltonian),
      rotation(rotation_of_sphere),
      start(relative + planetary_vorticity(sphere, rotation_of_sphere)),
      frame(conserved == Conserved::energy_casimir && rotation != 0
                ? frame_about_pole(sphere, stream, start, turning_back())
                : calmest_frame(sphere, stream, start)),
      products(products_of_flow(start, remarks)) {}

double SphereFlow::fastest_turning() const {
  SkewHermitian<> p = stream.solve(start);
  add_spin(sphere, frame.rate * sphere.hbar() * frame.axis, p);
  return FastVorticityStep<>::spectral_radius(p) / sphere.hbar();
}

double SphereScheme::longest() const {
  double longest = 0;
  for (double const fraction : fractions) longest = std::max(longest, std::abs(fraction));
  return longest;
}

std::unique_ptr<VorticityMotion> stepped_vorticity(std::shared_ptr<SphereFlow const> flow,
                                                   SphereScheme const& scheme, double step) {
  auto const with = [&]<class Step, class Stream>() -> std::unique_ptr<VorticityMotion> {
    return std::make_unique<SteppedVorticity<Step, Stream>>(std::move(flow), scheme, step);
  };
  if (flow->hamiltonian.layer())
    return with.template operator()<VorticityStep<HelmholtzStream>, HelmholtzStream>();
  if (scheme.to_rounding) return with.template operator()<VorticityStep<>, SphereLaplacian>();
  return with.template operator()<FastVorticityStep<>, SphereLaplacian>();
}

double longest_vorticity_step(std::shared_ptr<SphereFlow const> const& flow, SphereScheme const& scheme,
                              double step) {
  double h = step;
  for (int k = 0; k < 40; ++k) try {
      stepped_vorticity(flow, scheme, h)->advance(8);
      return h;
    } catch (NotContracting const& error) {
      h = error.largest > 0 ? std::min(0.8 * h, error.largest) : 0.5 * h;
    }
  return 0;
}

}  // namespace actio::scene
