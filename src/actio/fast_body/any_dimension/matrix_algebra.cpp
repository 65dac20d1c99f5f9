#include "actio/fast_body/any_dimension/matrix_algebra.hpp"

namespace actio::bodies {

namespace detail {

MatrixAlgebra::MatrixAlgebra(int n, Machine machine) : shape_(n), size_(full_size(shape_)) {
  bool const avx2 = machine == Machine::avx2;
  switch (shape_.blocks()) {
    case 1:
      product_ = avx2 ? &product_avx2<1> : &product_plain<1>;
      break;
    case 2:
      product_ = avx2 ? &product_avx2<2> : &product_plain<2>;
      break;
    default:
      product_ = avx2 ? &product_avx2<0> : &product_plain<0>;
  }
}

void MatrixAlgebra::subtract_transposed(double* t) const {
  pairs(t, [](FourLanes& x, FourLanes& y) {
    FourLanes const difference = x - y;
    y = -difference, x = difference;
  });
}

}  // namespace detail

}  // namespace actio::bodies
