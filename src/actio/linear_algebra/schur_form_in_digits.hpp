// The real Schur form over numbers that are not double, by Eigen's QR iteration: a unit that takes logarithms
// of rotations in five and more dimensions in many digits includes this; no other unit has to compile it.
#pragma once

#include <boost/multiprecision/eigen.hpp>

#include <Eigen/Eigenvalues>

#include "actio/linear_algebra/schur_form.hpp"

namespace actio {

template <class S>
SchurForm<S> schur_form(Matrix<S> const& a) {
  require_finite(a, "schur_form");
  using Square = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;
  Square const given = a;
  Eigen::RealSchur<Square> const schur(given);
  if (schur.info() != Eigen::Success)
    throw NotConverged("schur_form: QR iteration", {}, to_double(epsilon<S>()));
  return {Matrix<S>(schur.matrixU()), Matrix<S>(schur.matrixT())};
}

}  // namespace actio
