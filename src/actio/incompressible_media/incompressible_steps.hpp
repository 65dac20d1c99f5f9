// Steps of an incompressible medium, as each of the ranks that share it makes them (chapter 10C of the book).
#pragma once

#include "actio/incompressible_media/volume_examination.hpp"
#include "actio/parallel/parts_on_ranks.hpp"

namespace actio::media {

/// Steps of an incompressible medium, and the state that they leave. All ranks that share the medium call the
/// same functions: \ref IncompressibleMotion sees to it.
template <class Cell>
class IncompressibleSteps {
 public:
  static constexpr int N = Cell::space;  ///< components of a place

  /// Held by who owns it.
  virtual ~IncompressibleSteps() = default;
  IncompressibleSteps(IncompressibleSteps const&) = delete;             ///< Its parts refer to it.
  IncompressibleSteps& operator=(IncompressibleSteps const&) = delete;  ///< \copydoc IncompressibleSteps

  /// So many steps on.
  void step(long count) {
    if (count < 0)
      throw OutsideDomain("medium", "the number of steps must not be negative", static_cast<double>(count),
                          0);
    look_ahead(0);
    for (; count > 0; --count) {
      prepare();
      std::swap(state_, next_), prepared_ = whole_ = false;
      std::swap(pressures_[2], pressures_[1]), std::swap(pressures_[1], pressures_[0]);
      std::swap(pressures_[0], pressure_), ++known_, ++steps_;
      // A matrix that is old, or no longer near: to build one takes as long as some twenty rounds.
      if (age_ == 0) first_rounds_ = volumes_.rounds;
      bool const many = volumes_.rounds > std::max<double>(solving_.many_rounds, 1.5 * first_rounds_);
      age_ = many ? solving_.rebuilt_after : age_ + 1;
    }
  }
  /// Until the next step the state is that so long after the last one.
  void look_ahead(double time) {
    if (!(time > 0) && ahead_ == 0) return;
    if (ahead_ > 0) {
      state_ = std::move(kept_), ahead_ = 0, prepared_ = whole_ = false, age_ = kept_age_;
      if (volumes_.share.cell_rows.any(volumes_.built.y != kept_built_.y)) {
        SharpPlaces const built = kept_built_;
        volumes_.rebuild(built);
      }
    }
    if (!(time > 0)) return;
    State const from{state_.at, velocities_now(), 0};
    kept_built_ = volumes_.built, prepared_ = false;
    auto const age = age_;
    auto const pressure = pressure_;
    make(from, time, this->time() + time);
    pressure_ = pressure;
    kept_ = std::move(state_), state_ = std::move(next_), ahead_ = time, prepared_ = whole_ = false;
    kept_age_ = age;
  }
  /// One step of another length, and from then on steps of a third one.
  void change_step(double first, double step, long made) {
    look_ahead(first);
    state_.v = velocities_now(), state_.lag = 0;
    whole_ = false, ahead_ = 0, prepared_ = false, known_ = 0, step_ = step, steps_ = made;
    for (auto& one : pressures_) one.clear();
  }
  /// Places and velocities of all nodes on all ranks.
  void bring() const {
    if (!is_whole()) gather(state_), whole_ = true;
  }
  /// Velocities of all nodes, at the time of their places.
  std::vector<double> velocities() {
    auto v = velocities_now();
    gather(v);
    return v;
  }
  /// The pressure in each cell, on rank 0.
  std::vector<double> pressures() {
    bring();
    prepare();
    auto out = pressure_;
    volumes_.share.cell_rows.whole(std::span(out));
    if (!parts_.here()) return out;
    take_weight(out);
    if (!volumes_.pinned) return out;
    double sum = 0, volume = 0;
    for (std::size_t k = 0; k < out.size(); ++k) sum += out[k] * volumes_.kept[k], volume += volumes_.kept[k];
    for (double& one : out) one -= sum / volume;
    return out;
  }
  /// The largest modulus of A/A^0 - 1 over all cells.
  double volume_defect() const {
    std::vector<double> r;
    return volumes_.defects(state_.at, r);
  }
  /// The whole state.
  std::vector<double> remember() {
    bring_all();
    State const& last = ahead_ > 0 ? kept_ : state_;
    std::vector<double> out{
        static_cast<double>(steps_),    static_cast<double>(ahead_ > 0 ? kept_age_ : age_),
        static_cast<double>(known_),    last.lag,
        volumes_.fell_back ? 1.0 : 0.0, static_cast<double>(first_rounds_)};
    SharpPlaces const& built = ahead_ > 0 ? kept_built_ : volumes_.built;
    std::array<std::vector<double> const*, 8> const parts{&last.at.y,     &last.at.rest, &last.v,
                                                          &built.y,       &built.rest,   &pressures_[0],
                                                          &pressures_[1], &pressures_[2]};
    for (auto const* part : parts) out.insert(out.end(), part->begin(), part->end());
    return out;
  }
  /// Goes on from a state that was remembered, given on rank 0.
  void restore(std::vector<double> from) {
    if (!share().alone()) PartCall::agree(*solving_.ranks, from);
    std::size_t const n = state_.at.y.size(), cells = volumes_.kept.size();
    std::size_t const known = from.size() < 6 ? 0 : std::min(3.0, from[2]);
    if (from.size() != 6 + 5 * n + known * cells)
      throw OutsideDomain("incompressible medium", "a remembered state is that of the same mesh; numbers",
                          static_cast<double>(from.size()), static_cast<double>(6 + 5 * n + known * cells));
    steps_ = static_cast<long>(from[0]), age_ = static_cast<long>(from[1]),
    first_rounds_ = static_cast<long>(from[5]), known_ = static_cast<long>(from[2]);
    auto at = from.begin() + 6;
    auto const take = [&](std::vector<double>& part, std::size_t count) {
      part.assign(at, at + static_cast<long>(count)), at += static_cast<long>(count);
    };
    state_.lag = from[3], ahead_ = 0, prepared_ = false, whole_ = true;
    SharpPlaces built;
    take(state_.at.y, n), take(state_.at.rest, n), take(state_.v, n), take(built.y, n), take(built.rest, n);
    for (std::size_t k = 0; k < 3; ++k) take(pressures_[k], k < known ? cells : 0);
    if (from[4] != 0 && !volumes_.fell_back) volumes_.fall_back();
    volumes_.rebuild(built);
  }

 protected:
  /// @param mesh, reference, density, held, solving  as for \ref VolumeSteps
  IncompressibleSteps(BodyMesh const& mesh, SharpPlaces const& reference, std::vector<double> const& density,
                      std::vector<typename VolumeSteps<Cell>::Allowance> const& held, double step,
                      VolumeSolving const& solving)
      : parts_(solving.ranks, solving.told),
        volumes_(mesh, reference, density, held, solving),
        reference_jacobians_(volumes_.volumes.corner_jacobians(reference.y)),
        step_(step),
        mesh_(mesh),
        solving_(solving) {
    if (!is_finite(step)) throw NotFinite("incompressible medium: time step");
    if (!(step > 0)) throw OutsideDomain("incompressible medium", "a time step is positive", step, 0);
  }

  /// Places and velocities at the start.
  /// @param project  whether what changes volumes is taken from them; if not it is refused
  /// @throws StartChangesVolumes
  void start(std::vector<double> y, std::vector<double> v, bool project) {
    std::vector<double> r, none(y.size(), 0);
    SharpPlaces at{std::move(y), none};
    double const off = volumes_.defects(at, r);
    double const bound = 1e-6;
    if (!(off <= bound) && !project) {
      volumes_.share.cell_rows.whole(std::span(r));
      refuse_placement(mesh_, volumes_, r, bound);
    }
    if (off > solving_.tolerance) {
      std::vector<double> P(volumes_.kept.size(), 0), way = none;
      SharpPlaces const from = at;
      volumes_.rebuild(at);
      volumes_.solve([&](std::vector<double>& now, SharpPlaces& to) { move(from, 1, 0, now, to); }, 1, 1,
                     from, P, way, at);
      gather(at.y), gather(at.rest);
    }
    state_ = {std::move(at), std::move(v), 0};
    volumes_.rebuild(state_.at);
    tangent(state_.at.y, 0, state_.v);
    auto const given = state_.v;
    volumes_.volumes.slopes(state_.at, whole_slopes_, volumes_.volumes.all());
    if (!project) require_volumes_kept(volumes_, whole_slopes_, state_.v, bound);
    volumes_.project(whole_slopes_, state_.v);
    volumes_.share.node_rows.whole(std::span(state_.v));
    for (std::size_t k = 0; k < given.size(); k += N) {
      double square = 0;
      for (int a = 0; a < N; ++a) square += std::pow(state_.v[k + a] - given[k + a], 2);
      projected_ = std::max(projected_, std::sqrt(square));
    }
    whole_ = true;
    refuse_folds(mesh_, volumes_.volumes, reference_jacobians_, {state_.at.y, state_.at.y, 0, 0});
  }

  /// Forces on the nodes that this rank moves, at places y and time t, without pressures; those of held nodes
  /// projected.
  /// @return whether there are any
  virtual bool forces(std::vector<double> const& y, double t, std::vector<double>& f) const = 0;
  /// Places at time t, of the nodes that this rank moves, from those a time h before and velocities between;
  /// on a curved target it corrects the velocities.
  virtual void move(SharpPlaces const& from, double h, double t, std::vector<double>& v,
                    SharpPlaces& to) const = 0;
  /// Makes velocities such as nodes at y may have at time t.
  virtual void tangent(std::vector<double> const& y, double t, std::vector<double>& v) const = 0;
  /// Takes from multipliers the part that carries what is not pressure of the medium: its weight.
  virtual void take_weight(std::vector<double>& pressure) const = 0;

  /// What of the mesh this rank steps.
  MeshShare const& share() const { return volumes_.share; }
  /// The time of the last step.
  double time() const { return static_cast<double>(steps_) * step_; }
  /// The time of the state: that of the last step, or of what was looked ahead to.
  double time_of_state() const { return time() + ahead_; }
  /// Whether this rank has places and velocities of all nodes.
  bool is_whole() const { return share().alone() || whole_; }

  /// Where nodes are, and how fast.
  struct State {
    SharpPlaces at;         ///< places
    std::vector<double> v;  ///< velocities
    double lag = 0;         ///< velocities are those so long before the places: half a step, or zero
  };
  PartsOnRanks parts_;                       ///< of the medium
  VolumeSteps<Cell> volumes_;                ///< of its cells, and their pressures
  std::vector<double> reference_jacobians_;  ///< at the corners of its cells
  mutable State state_;                      ///< now; rows of others are copied when they are asked for
  double step_;                              ///< the time step
  long steps_ = 0;                           ///< that have been made
  double projected_ = 0;                     ///< by how much the start was changed

 private:
  BodyMesh const& mesh_;
  VolumeSolving solving_;
  State next_, kept_;                            // after the next step, and before a look ahead
  mutable bool whole_ = false;                   // whether state_ has the rows of others
  SharpPlaces kept_built_;                       // places of the matrix when it was looked ahead
  std::vector<double> forces_, whole_slopes_;    // room
  std::vector<double> pressure_, pressures_[3];  // of the step from the state, of the last three
  long known_ = 0, age_ = 0, kept_age_ = 0;      // pressures of steps; steps with one matrix
  long first_rounds_ = 0;                        // of the first of these
  bool prepared_ = false;                        // next_ and pressure_ are those of the next step
  double ahead_ = 0;                             // how long after the last step the state is

  void prepare() {
    if (prepared_) return;
    if (age_ >= solving_.rebuilt_after) volumes_.rebuild(state_.at), age_ = 0;
    make(state_, step_, time_of_state() + step_);
    prepared_ = true;
  }
  /// next_ and pressure_: a step of length h from a state to time t.
  void make(State const& from, double h, double t) {
    guess();
    double const scale = from.lag + h / 2;
    next_.v.resize(from.v.size()), next_.lag = h / 2;
    bool const any = forces(from.at.y, t - h, forces_);
    for_each(share().moved, [&](std::size_t node) {
      for (std::size_t k = N * node; k < N * (node + 1); ++k)
        next_.v[k] = any ? from.v[k] + scale * forces_[k] / volumes_.masses[node] : from.v[k];
    });
    volumes_.set_slopes(from.at);
    volumes_.solve([&](std::vector<double>& v, SharpPlaces& to) { move(from.at, h, t, v, to); }, scale, h,
                   from.at, pressure_, next_.v, next_.at);
    if (share().cell_rows.any(!(volumes_.volumes.least_jacobian(next_.at.y, share().cells) > 0))) {
      auto before = from.at.y;
      share().node_rows.whole(std::span(before)), share().node_rows.whole(std::span(next_.at.y));
      refuse_folds(mesh_, volumes_.volumes, reference_jacobians_, {before, next_.at.y, t - h, h});
    }
    share_rows(next_.at);
  }
  /// The rows of neighbours that the next step looks at.
  void share_rows(SharpPlaces& at) const {
    for (auto* part : {&at.y, &at.rest}) share().node_rows.exchange(std::span(*part), MeshShare::copied);
  }
  /// Places and velocities, and what else is remembered, of all nodes and cells on all ranks.
  void bring_all() {
    gather(state_), gather(kept_), whole_ = true;
    for (auto* of : {&volumes_.built, &kept_built_})
      for (auto* part : {&of->y, &of->rest}) gather(*part);
    for (auto& one : pressures_)
      if (!one.empty()) share().cell_rows.whole(std::span(one));
  }
  void gather(State& state) const { gather(state.at.y), gather(state.at.rest), gather(state.v); }
  void gather(std::vector<double>& of_nodes) const {
    if (!of_nodes.empty()) share().node_rows.whole(std::span(of_nodes));
  }
  /// The parabola through the last three pressures, or what is known of it.
  void guess() {
    pressure_.resize(volumes_.kept.size());
    for_each(share().near, [&](std::size_t k) {
      if (known_ == 0) return void(pressure_[k] = 0);
      double const p = pressures_[0][k];
      if (known_ == 1) return void(pressure_[k] = p);
      double const q = pressures_[1][k];
      pressure_[k] = known_ == 2 ? 2 * p - q : 3 * (p - q) + pressures_[2][k];
    });
  }
  /// Velocities at the time of the places.
  std::vector<double> velocities_now() {
    auto v = state_.v;
    if (state_.lag == 0) return v;
    if (forces(state_.at.y, time_of_state(), forces_))
      for_each(share().moved, [&](std::size_t node) {
        for (std::size_t k = N * node; k < N * (node + 1); ++k)
          v[k] += state_.lag * forces_[k] / volumes_.masses[node];
      });
    tangent(state_.at.y, time_of_state(), v);
    volumes_.set_slopes(state_.at);
    volumes_.volumes.slopes(state_.at, whole_slopes_, share().cells);
    volumes_.project(whole_slopes_, v);
    return v;
  }
};

}  // namespace actio::media
