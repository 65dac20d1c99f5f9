// A flow on the sphere in steps: of order 2, or symmetric compositions of them.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <variant>

#include "actio/quantized_sphere/helmholtz_stream.hpp"
#include "actio/vorticity/fast_vorticity_step.hpp"
#include "program/systems/sphere/hamiltonian.hpp"
#include "program/systems/sphere/motion.hpp"
#include "program/systems/sphere/scheme.hpp"

namespace actio::scene {

/// The map from the vorticity to the stream function of a Hamiltonian.
class SphereStream {
 public:
  /// For matrices of the size n.
  SphereStream(int n, SphereHamiltonian const& hamiltonian);
  /// P of W.
  sphere::SkewHermitian<> solve(sphere::SkewHermitian<> const& w) const;
  /// The same one, of a kind that is known: `SphereLaplacian`, `HelmholtzStream` or `AveragedStream`.
  template <class Stream>
  Stream const& as() const { return std::get<Stream>(stream_); }

 private:
  using Kind = std::variant<sphere::SphereLaplacian, sphere::HelmholtzStream, sphere::AveragedStream>;
  Kind stream_;
};

/// A flow on a sphere that turns fast, apart from what turns as a whole
/// (quantized_sphere/zonal_background.hpp). It is stepped along axes of which the third is that of the frame.
struct ApartFromPlanet {
  sphere::ZonalBackground background;  ///< what turns as a whole, about the axis of the frame
  sphere::SkewHermitian<> flow;        ///< the rest at the start, along the axes of the steps
  Eigen::Vector3d relative;  ///< r in the part r . x of the relative vorticity that the background holds, at
                             ///< the start, along the axes of the sphere; along fixed axes it stays
  Eigen::AngleAxisd upright{0, Eigen::Vector3d::UnitX()};  ///< turns the axis of the frame to the third one

  /// Whether there is one.
  bool is_there() const { return background.is_there(); }
};

/// A flow, the frame that it is stepped in, and the frame that it is told in.
struct SphereFlow {
  sphere::QuantizedSphere sphere;  ///< of the matrices
  SphereHamiltonian hamiltonian;   ///< of the flow
  SphereStream stream;             ///< that of the Hamiltonian
  double rotation;                 ///< of the sphere, 1/time
  sphere::SkewHermitian<> start;   ///< the absolute vorticity
  sphere::TurningFrame frame;      ///< in which it is stepped
  ApartFromPlanet apart;           ///< what is stepped in the place of it, where the sphere turns fast
  sphere::Products products;       ///< of the matrices of a step

  /// The frame turns about the angular momentum, at the rate at which the flow changes least. For the
  /// energy-Casimir form on a sphere that rotates it turns about the pole: that form keeps the energy of the
  /// absolute motion and the angular momentum along the axis of the frame, and it takes both, along the pole,
  /// to keep energy and enstrophy relative to the sphere.
  /// @param relative  the vorticity relative to the sphere
  /// @param remarks   what a user might want to know of it
  SphereFlow(SphereHamiltonian const& of_flow, double rotation_of_sphere,
             sphere::SkewHermitian<> const& relative, sphere::Conserved conserved,
             std::vector<std::string>& remarks);

  /// From so many times the vorticity of the rest on, what turns as a whole is kept apart. In their sum a
  /// step in single precision rounds the flow as many times as much; and it would not hold energy and
  /// momentum any more: the eigenvalues that belong to them in the Gram matrix of `OrbitMove` are smaller
  /// than the others by about the square, and from some 300 times on they fall below its cut-off.
  static constexpr double fast = 16;
  /// With what the first step begins.
  sphere::SkewHermitian<> const& first_state() const { return apart.is_there() ? apart.flow : start; }

  /// The rate at which the free flow turns back about the pole, seen from the sphere; 1/time.
  double turning_back() const { return hamiltonian.frame_rate(rotation); }
  /// \f$|P - Q|_2/\hbar\f$, the fastest turning of a vector by the equations of motion, 1/time: estimated by
  /// the method of Lanczos.
  double fastest_turning() const;

 private:
  void take_apart(sphere::SkewHermitian<> const& relative, sphere::Conserved conserved);
  /// The part that the stream function has along the third axis in the frame in which the flow changes least.
  double calmest_stream(double b) const;
};

/// A flow from its start, in steps.
std::unique_ptr<VorticityMotion> stepped_vorticity(std::shared_ptr<SphereFlow const> flow,
                                                   SphereScheme const& scheme, double step);

}  // namespace actio::scene
