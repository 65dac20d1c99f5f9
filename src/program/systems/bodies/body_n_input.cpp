#include <Eigen/Core>

#include "program/systems/bodies/body_n_input.hpp"

#include <fmt/format.h>

#include "actio/fast_body/any_dimension/matrix_conditions.hpp"
#include "program/systems/bodies/angle_input.hpp"

namespace actio::scene {
namespace {

/// The largest entry of \f$g^Tg-1\f$, and the matrix itself.
struct Excess {
  Eigen::MatrixXd matrix;
  double largest;
  explicit Excess(Eigen::MatrixXd const& g) : matrix(g.transpose() * g) {
    matrix.diagonal().array() -= 1;
    largest = matrix.cwiseAbs().maxCoeff();
  }
};

/// The rotation or reflection that is nearest to a matrix with \f$|g^Tg-1| < 1\f$.
Eigen::MatrixXd nearest_orthogonal(Eigen::MatrixXd g) {
  for (int k = 0; k < 12; ++k) g = Eigen::MatrixXd(g - g * Excess(g).matrix / 2);
  return g;
}

/// As it is written in a scene.
std::string written(Eigen::MatrixXd const& g) {
  std::string rows;
  for (Eigen::Index i = 0; i < g.rows(); ++i) {
    std::string row;
    for (Eigen::Index j = 0; j < g.cols(); ++j) row += (j ? ", " : "") + fmt::format("{}", g(i, j));
    rows += (i ? ", [" : "[") + row + "]";
  }
  return "[" + rows + "]";
}

struct LambdaKeys : KeyTable {
  Key<std::vector<double>> lambda =
      key("lambda", numbers(fmt::format("n numbers, n from 2 to {}", most_dimensions)).in("mass x length^2"),
          needed,
          "The diagonal of Lambda: second moments of the mass along the body axes. The sum of any two is "
          "positive, and is the moment of inertia in their plane.",
          "[1, 2, 3, 4]");
} const lambda_keys{{"system"}};
struct AttitudeNKeys : KeyTable {
  AnyKey attitude =
      key("attitude", "a list of n rows of n numbers, a rotation", LeftOut{"the identity"},
          "The rotation that takes the body to space; off by at most 1e-9 it is normalised, and said.",
          "[[0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]");
} const attitude_n{{"initial"}};
AngleKeys const angular_velocity_n{
    {"initial.angular_velocity", needed,
     "The upper triangle of the body velocity g^-1 g', row by row: xi_12, xi_13, ..., xi_23, ...; a list is "
     "in radians. For n = 3: (xi_12, xi_13, xi_23) = (-w_z, w_y, -w_x).",
     "[0.1, 0.2, 0.3, 0.4, 0.5, 0.6]", "n(n-1)/2 numbers; or a table with degrees", "1/time"},
    "n(n-1)/2 numbers",
    "[5, 10, 15, 20, 25, 30]"};

}  // namespace

std::vector<Parameter> body_n_parameters() {
  return records_of({lambda_keys, attitude_n, angular_velocity_n});
}

Inertia<Eigen::Dynamic> read_lambda(SceneTable const& system) {
  auto const& key = lambda_keys.lambda;
  auto const lambda = key.read(system);
  if (lambda.size() < 2 || lambda.size() > most_dimensions)
    key.fail(system,
             fmt::format("from 2 to {} numbers are expected, found {}", most_dimensions, lambda.size()));
  try {
    return inertia_from_lambda<Eigen::Dynamic, double>(
        Eigen::Map<Eigen::VectorXd const>(lambda.data(), static_cast<Eigen::Index>(lambda.size())));
  } catch (Error const& error) {
    system.fail("lambda", error.what());
  }
}

Eigen::MatrixXd read_attitude_n(SceneTable initial, int n, std::vector<std::string>& remarks) {
  constexpr double most = 1e-9;
  if (!initial.has("attitude")) initial.set("attitude", Eigen::MatrixXd(Eigen::MatrixXd::Identity(n, n)));
  Eigen::MatrixXd g = initial.matrix("attitude", n);
  double const off = g.cwiseAbs().maxCoeff() <= 2 ? Excess(g).largest : HUGE_VAL;
  auto const& key = attitude_n.attitude;
  if (!(off <= most)) {
    // Within a half in each row the iteration finds it; a matrix of more than four rows is too long to paste.
    bool const near = n <= 4 && n * off < 0.5;
    key.fail(
        initial,
        fmt::format("a rotation is expected; the largest entry of g^T g - 1 is {:.2g} where 1e-9 is taken{}",
                    off, near ? "; normalised it is " + written(nearest_orthogonal(g)) : ""));
  }
  if (actio::bodies::detail::sign_of_determinant(g) != 1)
    key.fail(initial,
             "a rotation is expected, with determinant 1; this is a reflection, with determinant -1");
  // What rounding to 17 digits leaves of a rotation.
  if (off > 4 * std::sqrt(n) * std::numeric_limits<double>::epsilon()) {
    g = nearest_orthogonal(g);
    remarks.push_back(
        fmt::format("attitude: off a rotation by {:.2g} (the largest entry of g^T g - 1), normalised", off));
  }
  return g;
}

Eigen::MatrixXd read_velocity_n(SceneTable const& initial, int n) {
  long const size = static_cast<long>(n) * (n - 1) / 2;
  auto const upper = angular_velocity_n.read(initial, -1);
  if (upper.size() != static_cast<std::size_t>(size))
    initial.fail(
        "angular_velocity",
        fmt::format(
            "angular_velocity: the upper triangle of a matrix with {} rows is expected, {} numbers, found {}",
            n, size, upper.size()));
  return skew_matrix(upper.data(), n);
}

std::vector<double> upper_triangle(Eigen::MatrixXd const& skew) {
  std::vector<double> upper;
  for (Eigen::Index i = 0; i < skew.rows(); ++i)
    for (Eigen::Index j = i + 1; j < skew.cols(); ++j) upper.push_back(skew(i, j));
  return upper;
}
Eigen::MatrixXd skew_matrix(double const* upper, int n) {
  Eigen::MatrixXd skew = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j, ++upper) skew(i, j) = *upper, skew(j, i) = -*upper;
  return skew;
}

}  // namespace actio::scene
