#include "actio/fast_body/any_dimension/charted_body.hpp"

namespace actio::bodies {

Eigen::MatrixXd ChartedBody::whole(int k) const {
  Eigen::MatrixXd m(size(), size());
  for (int j = 0; j < size(); ++j)
    for (int i = 0; i < size(); ++i) m(i, j) = array(k)[detail::full_entry(shape_, i, j)];
  return m;
}

}  // namespace actio::bodies
