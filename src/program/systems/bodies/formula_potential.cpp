#include <Eigen/Core>

#include "program/systems/bodies/formula_potential.hpp"

#include <algorithm>

#include "actio/formula/tape_derivatives.hpp"
#include "actio/groups/rotations.hpp"
#include "program/systems/formula.hpp"

namespace actio::scene {
namespace {

std::vector<std::string> const& variables() {
  static std::vector<std::string> const names{"r11", "r12", "r13", "r21", "r22",
                                              "r23", "r31", "r32", "r33", "t"};
  return names;
}
std::vector<int> const entries{0, 1, 2, 3, 4, 5, 6, 7, 8};

using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

/// \f$V(R\exp\hat\eta)\f$ to second order, from the first and the second derivatives by the entries of R,
/// these the upper triangle row by row.
Eigen::Matrix3d along_turns(bodies::NineEntries const& rotation, double const* first, double const* second) {
  Eigen::Map<Rows const> const R(rotation.data()), G(first);
  Eigen::Matrix<double, 9, 9> H;
  for (int i = 0; i < 9; ++i)
    for (int j = i; j < 9; ++j) H(i, j) = H(j, i) = *second++;
  Eigen::Matrix<double, 9, 3> turned;  // column a: the entries of R hat(e_a)
  for (int a = 0; a < 3; ++a) {
    Rows const change = R * SO<3>::hat(Eigen::Vector3d(Eigen::Vector3d::Unit(a)));
    turned.col(a) = Eigen::Map<Eigen::Matrix<double, 9, 1> const>(change.data());
  }
  Eigen::Matrix3d const P = G.transpose() * R;
  return turned.transpose() * H * turned + (P + P.transpose()) / 2 - P.trace() * Eigen::Matrix3d::Identity();
}

}  // namespace

/// The formula and its derivatives.
struct FormulaPotential::Tapes {
  Tape slope,       ///< value, and first derivatives by the entries
      curvature,    ///< value, first and second derivatives by the entries
      second_rate;  ///< value, first and second derivative by the time
};

FormulaPotential::FormulaPotential(std::string const& text, TextPlace const& place) {
  Tape const value = scene_formula(text, variables(), {}, place, "potential").value;
  for (int i = 0; i < 10; ++i) uses_[static_cast<std::size_t>(i)] = value.depends_on(i);
  try {
    tapes_ = std::make_shared<Tapes const>(
        Tapes{with_gradient(value, entries), with_hessian(value, entries), with_hessian(value, {9})});
  } catch (Error const& error) {
    place.fail(text, 0, "potential: " + std::string(error.what()));
  }
}

double FormulaPotential::operator()(bodies::NineEntries const& rotation, double time,
                                    bodies::NineEntries& slope) const {
  double x[10], y[10];
  std::ranges::copy(rotation, x), x[9] = time;
  tapes_->slope(x, y, work_);
  std::copy_n(y + 1, 9, slope.begin());
  return y[0];
}
Eigen::Matrix3d FormulaPotential::curvature(bodies::NineEntries const& rotation, double time) const {
  double x[10], y[1 + 9 + 45];
  std::ranges::copy(rotation, x), x[9] = time;
  tapes_->curvature(x, y, work_);
  return along_turns(rotation, y + 1, y + 10);
}
ChangeInTime FormulaPotential::change(bodies::NineEntries const& rotation, double until,
                                      double enough) const {
  std::vector<double> x(rotation.begin(), rotation.end());
  x.push_back(0);
  // As many intervals as take about a tenth of a second.
  auto const operations = static_cast<double>(tapes_->second_rate.instructions.size());
  return change_in_time(tapes_->second_rate, std::move(x), until, enough,
                        std::clamp(static_cast<int>(1e6 / (operations + 1)), 100, 4000));
}

std::size_t FormulaPotential::operations_of_slope() const { return tapes_->slope.instructions.size(); }
std::size_t FormulaPotential::operations_of_curvature() const {
  return tapes_->curvature.instructions.size();
}

int FormulaPotential::axis() const {
  int found = -1;
  for (std::size_t row = 0; row < 3; ++row)
    if (uses_[3 * row] || uses_[3 * row + 1] || uses_[3 * row + 2]) {
      if (found >= 0) return -1;
      found = static_cast<int>(row);
    }
  return found;
}

}  // namespace actio::scene
