// A rod at one time, and at later ones by the step control of somebody else's code.
#pragma once

#include "witness/reference_solution.hpp"
#include "witness/semi_discrete_rod.hpp"

namespace actio::rods {

/// A rod at one time, in other schemes.
struct RodMotion {
  RodShape shape;             ///< where it is
  std::vector<Six> velocity;  ///< of places in space, then angular velocities in the axes of the sections

  /// @param of  the rod, at rest
  static RodMotion at_rest(RodShape const& of) { return {of, std::vector<Six>(of.sections(), Six::Zero())}; }
  /// Linear momentum, then angular momentum about the origin.
  Six momentum(SemiDiscreteRod const& rod) const {
    Six out = Six::Zero();
    for (std::size_t k = 0; k < velocity.size(); ++k) {
      Six const p = rod.masses(k).cwiseProduct(velocity[k]);
      auto const turn = turned(shape.attitudes[k], {p[3], p[4], p[5]});
      auto const lever = cross(shape.places[k], {p[0], p[1], p[2]});
      out.head<3>() += p.head<3>();
      for (std::size_t i = 0; i < 3; ++i) out[static_cast<Index>(i) + 3] += turn[i] + lever[i];
    }
    return out;
  }
  /// Kinetic and strain energy together.
  double energy(SemiDiscreteRod const& rod) const {
    double out = 0;
    for (std::size_t k = 0; k < velocity.size(); ++k)
      out += rod.masses(k).cwiseProduct(velocity[k]).dot(velocity[k]) / 2;
    for (std::size_t k = 0; k < rod.rest.size(); ++k) {
      auto const strain = element_strain(shape.element(k), rod.rest[k]);
      out += (bodies::dot(times(rod.section.stretching, strain.Gamma), strain.Gamma) +
              bodies::dot(times(rod.section.bending, strain.kappa), strain.kappa)) /
             rod.rest[k].inverse_length / 2;
    }
    return out;
  }

  /// The motion at a later time, by step control near rounding.
  /// @param relative  as in \ref reference_solution
  RodMotion later(SemiDiscreteRod const& rod, double from, double to, double relative) const {
    using Vector = Matrix<double, Dynamic, 1>;
    auto const unpack = [&](auto const& y) {
      RodMotion out = *this;
      for (std::size_t k = 0; k < velocity.size(); ++k) {
        auto const at = static_cast<Index>(13 * k);
        for (std::size_t i = 0; i < 3; ++i) out.shape.places[k][i] = y[at + static_cast<Index>(i)];
        double norm = 0;
        for (int i = 3; i < 7; ++i) norm += y[at + i] * y[at + i];
        for (std::size_t i = 0; i < 4; ++i)
          out.shape.attitudes[k][i] = y[at + 3 + static_cast<Index>(i)] / std::sqrt(norm);
        for (int i = 0; i < 6; ++i) out.velocity[k][i] = y[at + 7 + i];
      }
      return out;
    };
    auto const rate = [&](double time, Vector const& y) {
      RodMotion const now = unpack(y);
      auto const forces = rod.forces(now.shape, time);
      Vector out(y.size());
      for (std::size_t k = 0; k < forces.size(); ++k) {
        auto const at = static_cast<Index>(13 * k);
        Six const &v = now.velocity[k], m = rod.masses(k);
        Three<double> const w{v[3], v[4], v[5]}, across = cross({m[3] * w[0], m[4] * w[1], m[5] * w[2]}, w);
        auto const q = bodies::compose(now.shape.attitudes[k], {0, w[0] / 2, w[1] / 2, w[2] / 2});
        for (int i = 0; i < 3; ++i) {
          auto const j = static_cast<std::size_t>(i);
          out[at + i] = v[i], out[at + 7 + i] = forces[k][i] / m[i];
          out[at + 10 + i] = (forces[k][i + 3] + across[j]) / m[i + 3];
        }
        for (int i = 0; i < 4; ++i) out[at + 3 + i] = q[static_cast<std::size_t>(i)];
      }
      return out;
    };
    Vector y(static_cast<Index>(13 * velocity.size()));
    for (std::size_t k = 0; k < velocity.size(); ++k) {
      auto const at = static_cast<Index>(13 * k);
      for (std::size_t i = 0; i < 3; ++i) y[at + static_cast<Index>(i)] = shape.places[k][i];
      for (std::size_t i = 0; i < 4; ++i) y[at + 3 + static_cast<Index>(i)] = shape.attitudes[k][i];
      for (int i = 0; i < 6; ++i) y[at + 7 + i] = velocity[k][i];
    }
    return unpack(reference_solution(rate, y, from, to, relative));
  }
};

}  // namespace actio::rods
