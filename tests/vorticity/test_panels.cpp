// Who multiplies what: the panels of a product, the threads that take them, and the blocks of a symmetric
// flow.
#include <Eigen/Core>

#include <atomic>
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <mutex>
#include <set>

#include "actio/skew_matrices/blas_products.hpp"
#include "actio/skew_matrices/bracket_blocks.hpp"
#include "flows.hpp"
#include "loops_blas.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::random_matrix;

namespace {

/// The columns of the panels, and the threads by which they were multiplied.
std::mutex noted;
std::vector<int> widths;
std::set<std::thread::id> threads;
std::atomic<int> now = 0;
bool expected = false;  ///< whether a second thread is to come

void note_columns(char const*, char const*, int const*, int const* n, int const*, double const*,
                  double const*, int const*, double const*, int const*, double const*, double*, int const*) {
  std::lock_guard const lock(noted);
  widths.push_back(*n), threads.insert(std::this_thread::get_id());
}
/// Waits until as many as are asked for are at work, or for a while.
void meet(int others, std::chrono::milliseconds most) {
  ++now;
  for (auto const end = std::chrono::steady_clock::now() + most;
       now < others && std::chrono::steady_clock::now() < end;)
    std::this_thread::yield();
}
/// The panels of a product stay at work until there are two of them, or for a while.
void meet_in_panels(char const* ta, char const* tb, int const* m, int const* n, int const* k,
                    double const* alpha, double const* a, int const* lda, double const* b, int const* ldb,
                    double const* beta, double* c, int const* ldc) {
  note_columns(ta, tb, m, n, k, alpha, a, lda, b, ldb, beta, c, ldc);
  // A product that is not to be shared waits in vain.
  meet(2, std::chrono::milliseconds(expected ? 10000 : 20));
}

/// The panels of a product of matrices of the size n.
std::vector<int> panels(int n, bool half, Reach reach = {}) {
  Eigen::MatrixXd const a = Eigen::MatrixXd::Zero(n, n);
  Eigen::MatrixXd out(n, n);
  widths.clear();
  BlasProducts const products({&note_columns, nullptr});
  half ? products.multiply_lower(a, a, out, reach) : products.multiply(a, a, out, reach);
  return widths;
}
/// As many panels of a width as there are, and a narrower one for what is left.
std::vector<int> cut(int n, int width) {
  std::vector<int> all;
  for (int first = 0; first < n; first += width) all.push_back(std::min(width, n - first));
  return all;
}

/// Notes what is asked of the products of the blocks.
struct NotedBlocks : ProductsBy<NotedBlocks> {
  mutable std::vector<Eigen::Index> sizes;
  mutable std::vector<Reach> reaches;
  template <class Part>
  void whole(Part const& a, Part const& b, Part& out, Reach reach) const {
    sizes.push_back(a.rows()), reaches.push_back(reach);
    out = a * b;
  }
  template <class Part>
  void lower(Part const& a, Part const& b, Part& out, Reach reach) const { whole(a, b, out, reach); }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(panels_and_blocks)

// The least multiple of 8, but not below 32, of which eight cover the columns.
BOOST_AUTO_TEST_CASE(a_panel_is_an_eighth_of_the_columns) {
  for (int n = 1; n < 1200; ++n) {
    int const width = BlasProducts::panel(n);
    BOOST_TEST(width % 8 == 0);
    BOOST_TEST((width >= 32 && 8 * width >= n));
    BOOST_TEST((width == 32 || 8 * (width - 8) < n));
  }
}

BOOST_AUTO_TEST_CASE(products_are_cut_into_the_panels_that_suit_their_size) {
  // Alone below the size that is shared; two panels together, or four where the product is of middle size.
  for (auto const& [n, width] : {std::pair(3, 3),
                                 {127, 127},
                                 {128, 64},
                                 {150, 64},
                                 {255, 64},
                                 {256, 128},
                                 {300, 160},
                                 {512, 256},
                                 {513, 144},
                                 {600, 160}})
    BOOST_TEST(panels(n, false) == cut(n, width), boost::test_tools::per_element());
  // Each by itself where little of the factors is near the diagonal: less than half of the columns.
  BOOST_TEST(panels(300, false, {70, 79}) == cut(300, 40), boost::test_tools::per_element());
  BOOST_TEST(panels(300, false, {70, 80}) == cut(300, 160), boost::test_tools::per_element());
  BOOST_TEST(panels(127, false, {1, 2}) == cut(127, 127), boost::test_tools::per_element());
  // Half of a product by panels, whatever its size.
  for (auto const& [n, width] : {std::pair(3, 32), {64, 32}, {127, 32}, {300, 40}, {512, 64}})
    BOOST_TEST(panels(n, true) == cut(n, width), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(each_piece_of_work_is_done_once_by_as_many_threads_as_were_asked_for) {
  for (int team : {1, 2, 4}) {
    PanelThreads workers(team);
    for (int count : {0, 1, 2, 3, 17}) {
      std::vector<int> done(20, 0);
      workers.run(count, [&](int k) { ++done[static_cast<std::size_t>(k)]; });
      for (int k = 0; k < 20; ++k) BOOST_TEST(done[static_cast<std::size_t>(k)] == (k < count ? 1 : 0));
    }
    // As many as the team meet, and one more does not come.
    std::atomic<bool> met = true;
    now = 0;
    workers.run(team, [&](int) {
      meet(team, std::chrono::seconds(10));
      if (now < team) met = false;
    });
    BOOST_TEST(met);
    now = 0;
    std::set<std::thread::id> workers_seen;
    workers.run(team + 1, [&](int) {
      {
        std::lock_guard const lock(noted);
        workers_seen.insert(std::this_thread::get_id());
      }
      meet(team + 1, std::chrono::milliseconds(20));
    });
    BOOST_TEST(workers_seen.size() <= static_cast<std::size_t>(team));
  }
}

BOOST_AUTO_TEST_CASE(products_from_128_on_are_shared_and_smaller_ones_are_the_callers) {
  for (int n : {127, 128}) {
    Eigen::MatrixXd const a = Eigen::MatrixXd::Zero(n, n);
    Eigen::MatrixXd out(n, n);
    BlasProducts const shared({&meet_in_panels, nullptr}, 2);
    threads.clear(), now = 0, expected = n >= 128;
    shared.multiply_lower(a, a, out);
    BOOST_TEST(threads.size() == (n < 128 ? 1u : 2u));
    if (n < 128) BOOST_TEST(threads.contains(std::this_thread::get_id()));
  }
}

BOOST_AUTO_TEST_CASE(the_blocks_of_a_symmetric_flow_are_its_rows_by_their_rest) {
  for (int n : {2, 10, 11, 12})
    for (int fold : {1, 2, 3, 5, 11, 20}) {
      auto const noted_blocks = std::make_shared<NotedBlocks>();
      SymmetricProducts const products(fold, noted_blocks);
      SkewHermitian<> const a = symmetric_part(random_matrix(n, 1), fold),
                            b = symmetric_part(random_matrix(n, 2), fold);
      std::vector<Eigen::Index> sizes;
      for (int rest = 0; rest < std::min(fold, n); ++rest) sizes.push_back((n - 1 - rest) / fold + 1);
      for (bool half : {false, true}) {
        Eigen::MatrixXd out;
        noted_blocks->sizes.clear(), noted_blocks->reaches.clear();
        Reach const reach{9, 4};
        half ? products.multiply_lower(a.real, b.imaginary, out, reach)
             : products.multiply(a.real, b.imaginary, out, reach);
        BOOST_TEST((out - a.real * b.imaginary).cwiseAbs().maxCoeff() <= 1e-15 * n);
        BOOST_TEST(noted_blocks->sizes == sizes, boost::test_tools::per_element());
        // Of what is so far from the diagonal the blocks have every k-th.
        for (Reach const& r : noted_blocks->reaches) BOOST_TEST((r.left == 9 / fold && r.right == 4 / fold));
      }
    }
}

// What counts as zero goes with the largest entry of either part.
BOOST_AUTO_TEST_CASE(a_symmetry_does_not_depend_on_the_unit) {
  int const n = 13, fold = 3;
  for (double unit : {1e-8, 1.0, 1e8})
    for (bool real : {false, true}) {
      SkewHermitian<> w(n);
      (real ? w.real : w.imaginary)(fold, 0) = -4 * unit;
      (real ? w.real : w.imaginary)(2 * fold, 0) = unit;
      (real ? w.imaginary : w.real)(4, 3) = 2e-6 * unit;
      mirror_lower(w);
      BOOST_TEST(symmetry_of(w) == 1);
      BOOST_TEST(symmetry_of(w, 0.4e-6) == 1);
      BOOST_TEST(symmetry_of(w, 0.6e-6) == fold);
      BOOST_TEST(symmetry_of(w, 0.5) == fold);
    }
}

BOOST_AUTO_TEST_SUITE_END()
