#include "actio/any_group/chart_solver.hpp"

namespace actio::systems {

std::vector<double> force_at(ReducedSystem const& system, std::vector<double> const& v,
                             ReducedPoint const& at) {
  std::vector<double> inputs = v, work, out(v.size());
  inputs.insert(inputs.end(), at.vectors.begin(), at.vectors.end());
  inputs.insert(inputs.end(), at.momentum.begin(), at.momentum.end());
  inputs.push_back(at.time);
  for (auto const& held : system.force->held) inputs.push_back(held(at.time));
  system.force->components(inputs.data(), out.data(), work);
  return out;
}

ChartSolver::ChartSolver(ReducedSystem const& system, double h)
    : system_(system),
      h_(h),
      step_(system),
      moved_(system),
      legendre_(system),
      inverse_(static_cast<std::size_t>(system.dimension() * system.dimension())),
      moduli_(inverse_),
      weights_(static_cast<std::size_t>(system.dimension())),
      v_(weights_),
      residual_(weights_),
      update_(weights_),
      last_(weights_) {}

void ChartSolver::operator()(ReducedPoint& point) {
  predict();
  step_.begin_at(point.time), moved_.begin_at(Moved<double>(point.time));
  if (!(past_ > 0 && chord(point))) newton(point);
  require_in_chart();
  remember_velocity();
  // What the last residual leaves of the momentum goes with the step as the momentum does.
  step_.transport(residual_);
  for (std::size_t i = 0; i < v_.size(); ++i) point.momentum[i] = step_.after[i] - residual_[i];
  point.vectors = step_.vectors;
  point.time += h_;
}

void ChartSolver::require_in_chart() const {
  if (system_.chart == Chart::cayley || !(step_.square_of_ad() > std::numbers::pi * std::numbers::pi)) return;
  Vector<double> const v = Eigen::Map<Eigen::VectorXd const>(v_.data(), static_cast<Index>(v_.size()));
  Eigen::MatrixXd const ad = system_.algebra.ad(Vector<double>(v * h_));
  double const turn = eigenvalues_of(ad).imag().cwiseAbs().maxCoeff();
  if (!(turn < std::numbers::pi))
    throw OutsideDomain("natural chart", "a step must turn by less than half a turn; radians", turn,
                        std::numbers::pi);
}

void ChartSolver::extrapolate(int points, int from, std::vector<double>& out) const {
  std::fill(out.begin(), out.end(), 0.0);
  double weight = points;  // binomial coefficients with changing signs
  for (int k = 0; k < points; ++k) {
    auto const& old = history_[static_cast<std::size_t>(from + k)];
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += weight * old[i];
    weight *= -static_cast<double>(points - k - 1) / (k + 2);
  }
}

void ChartSolver::remember_velocity() {
  std::rotate(history_.begin(), history_.end() - 1, history_.end());
  history_[0] = v_;
  bool const growing = past_ < longest_;
  past_ = std::min(past_ + 1, longest_);
  if (growing || ++steps_ % 64 == 0) choose_points();
}

void ChartSolver::choose_points() {
  std::vector<double> guess(v_.size());
  double best = HUGE_VAL;
  for (int points = 1; points < past_; ++points) {
    extrapolate(points, 1, guess);
    double missed = 0;
    for (std::size_t i = 0; i < guess.size(); ++i) missed = std::max(missed, std::abs(guess[i] - v_[i]));
    if (missed < best) best = missed, points_ = points;
  }
  points_ = std::clamp(points_, 1, past_);
}

double ChartSolver::evaluate(ReducedPoint const& start) {
  ++evaluations_;
  if (!step_(h_, v_, start.vectors)) return HUGE_VAL;
  auto const d = v_.size();
  double largest = 0;
  for (std::size_t i = 0; i < d; ++i) {
    double const r = residual_[i] = step_.before[i] - start.momentum[i];
    if (!(r - r == 0)) return HUGE_VAL;
    double scale = std::abs(start.momentum[i]) + std::abs(step_.before[i]) + step_.sizes[i];
    for (std::size_t j = 0; j < d; ++j) scale += moduli_[i * d + j] * std::abs(v_[j]);
    if (r != 0) largest = std::max(largest, std::abs(r) / scale);
  }
  return largest;
}

bool ChartSolver::chord(ReducedPoint const& start) {
  bool fresh = !known_;
  if (fresh && !differentiate(start)) return false;
  known_ = true;
  double before = HUGE_VAL;
  for (int iteration = 0; iteration < 20; ++iteration) {
    double const size = evaluate(start);
    if (!(size < HUGE_VAL)) return false;
    bool const done = size <= tolerance_ || (size <= 64 * tolerance_ && size > before / 2);
    find_update();
    if (!done && size > before / 8) {
      if (fresh && size > before / 2) return false;
      if (!differentiate(start)) return false;
      fresh = true;
      find_update();
    } else if (iteration > 0 && !done) {
      fresh = false;
      broyden_update(inverse_, last_, weights_, update_);
    }
    move(1);
    if (done) return true;
    std::swap(last_, update_);
    before = size;
  }
  return false;
}

void ChartSolver::find_update() {
  auto const d = v_.size();
  for (std::size_t i = 0; i < d; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < d; ++j) sum -= inverse_[i * d + j] * residual_[j];
    update_[i] = sum;
  }
}

bool ChartSolver::differentiate(ReducedPoint const& start) {
  int const d = system_.dimension();
  Eigen::MatrixXd derivative(d, d);
  std::vector<Moved<double>> v(v_.begin(), v_.end()), a(start.vectors.begin(), start.vectors.end());
  for (int first = 0; first < d; first += batch) {
    auto const each = [&](auto const& visit) {
      for (int k = 0; k < batch && first + k < d; ++k) visit(k, static_cast<std::size_t>(first + k));
    };
    each([&](int k, std::size_t i) { v[i].part[static_cast<std::size_t>(k)] = 1; });
    ++evaluations_;
    if (!moved_(Moved<double>(h_), v, a)) return false;
    each([&](int k, std::size_t i) {
      v[i].part[static_cast<std::size_t>(k)] = 0;
      for (int r = 0; r < d; ++r)
        derivative(r, static_cast<Eigen::Index>(i)) =
            moved_.before[static_cast<std::size_t>(r)].part[static_cast<std::size_t>(k)];
    });
  }
  using Rows = Eigen::Map<Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>;
  Rows(moduli_.data(), d, d) = derivative.cwiseAbs();
  Eigen::VectorXd const units = units_of(derivative);
  for (int i = 0; i < d; ++i) weights_[static_cast<std::size_t>(i)] = 1 / (units[i] * units[i]);
  InverseInUnits const inverse(derivative, units);
  regular_ = inverse.condition;
  Rows(inverse_.data(), d, d) = inverse.matrix;
  return regular_ > 0x1p-50;
}

void ChartSolver::newton(ReducedPoint const& start) {
  known_ = false;
  v_ = past_ > 0 ? history_[0] : v_;
  legendre_.solve(start.momentum, start.vectors, v_);
  std::vector<double> sizes;
  if (!differentiate(start)) fail(sizes);
  double size = evaluate(start);
  for (int iteration = 0; iteration < 60 && size < HUGE_VAL; ++iteration) {
    sizes.push_back(size);
    double const before = size;
    bool const done = size <= tolerance_;
    if (!done && !differentiate(start)) break;
    find_update();
    std::vector<double> const from = v_;
    for (double fraction = 1; fraction > 1e-6; fraction /= 2) {
      v_ = from;
      move(fraction);
      if (done) break;
      size = evaluate(start);
      if (size < before) break;
    }
    if (done || (size <= 64 * tolerance_ && size > before / 2)) return void(known_ = true);
    if (!(size < before)) break;
  }
  fail(sizes);
}

void ChartSolver::fail(std::vector<double> const& sizes) const {
  if (regular_ <= 0x1p-50)
    throw Singular("natural chart", "the Lagrangian must be regular for this step; condition", regular_,
                   0x1p-50);
  throw NotConverged("natural chart", sizes, tolerance_);
}

}  // namespace actio::systems
