#include "actio/two_bodies/pair_method.hpp"

namespace actio::bodies {

PairMethod pair_splitting(int order) {
  if (order != 2 && order != 4)
    throw OutsideDomain("splitting of two bodies", "the order must be 2 or 4", order, order < 2 ? 2 : 4);
  return {order == 2 ? strang_splitting() : blanes_moan_splitting(), false, Rotor::exact};
}

Splitting aba_864_splitting() {
  double const a1 = 0.0711334264982231177779387300061549964174,
               a2 = 0.241153427956640098736487795326289649618, a3 = 0.521411761772814789212136078067994229991,
               a4 = -0.333698616227678005726562603400438876027;
  double const b1 = 0.183083687472197221961703757166430291072, b2 = 0.310782859898574869507522291054262796375,
               b3 = -0.0265646185119588006972121379164987592663,
               b4 = 0.0653961422823734184559721793911134363710;
  return {"ABA864", 4, {0, b1, b2, b3, b4, b3, b2, b1, 0}, {a1, a2, a3, a4, a4, a3, a2, a1}};
}

PairMethod kepler_splitting() { return {aba_864_splitting(), true, Rotor::exact}; }

PairMethod moser_veselov_pair() { return {strang_splitting(), false, Rotor::moser_veselov}; }

}  // namespace actio::bodies
