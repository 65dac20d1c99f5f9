// The real Schur form of a matrix in double, from the GNU Scientific Library: a call, where a template would
// cost every user seconds of compiling.
#pragma once

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>

#include <memory>
#include <vector>

#include "actio/numbers/errors.hpp"

namespace actio {

/// \f$A = U\,T\,U^T\f$: U orthogonal; T has blocks of one or two rows along its diagonal and nothing below.
template <class S>
struct SchurForm {
  Matrix<S> vectors;  ///< U, as columns
  Matrix<S> form;     ///< T
};

/// The real Schur form of a square matrix.
/// @throws NotFinite      where an entry is no number
/// @throws OutsideDomain  where it is not square, or empty
/// @throws NotConverged   where the QR iteration does not end
/// Accuracy: a few tens of epsilon times the size of the matrix.
SchurForm<double> schur_form(Matrix<double> const& a);
/// The same over other real numbers: include actio/linear_algebra/schur_form_in_digits.hpp, which defines it.
template <class S>
SchurForm<S> schur_form(Matrix<S> const& a);

}  // namespace actio
