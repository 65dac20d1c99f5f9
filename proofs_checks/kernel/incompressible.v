(** * Incompressible media

Sections 8.2 and 8.3: the density with the constraint \f$J = 1\f$ and its multiplier \f$\lambda = \sqrt{\det
G}\,P\f$ (8.2), its momenta (8.4), the equation of motion (8.7), and fluids. Body and space have one dimension
\f$n\f$, any, and any metrics; the equations of motion hold off the constraint too. *)

From mathcomp Require Import all_ssreflect fingroup perm all_algebra.
From actio Require Import matrices ring_identities derivations fields continuum stresses fluids.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Incompressible.

Variables (R : comUnitRingType) (n : nat).
Variables (v : 'I_n -> 'I_n.+1 -> R) (d_y : 'I_n -> derivation R) (d_v : 'I_n -> 'I_n.+1 -> derivation R)
          (D : 'I_n.+1 -> derivation R).
Variables (rho : R) (g : 'M[R]_n) (root_g root_G W : R) (W_g : 'M[R]_n).
Hypothesis medium : is_medium v d_y d_v D rho root_G g W W_g.
Hypothesis root_of_g : root_g ^+ 2 = \det g.
Hypothesis unit_g : root_g \is a GRing.unit.
Hypothesis root_g_v : forall a mu, d_v a mu root_g = 0.

(** The material pressure, and the multiplier \f$\lambda = \sqrt{\det G}\,P\f$ (8.2), which does not depend on
the fields and their derivatives. *)
Variable P : R.
Definition multiplier : R := P * root_G.
Hypothesis multiplier_y : forall a, d_y a multiplier = 0.
Hypothesis multiplier_v : forall a mu, d_v a mu multiplier = 0.

Let F := gradient_matrix v.
Let J := jacobian F root_g root_G.
Let areas := area_transformation F root_g root_G.
Let D_body (k : 'I_n) := D (along_body k).

(** The density \f$L_\Phi = L + \lambda\,(J - 1)\f$ (8.3). C++: `actio::IncompressibleDensity`,
`incompressible/incompressible_density.hpp`. *)
Definition incompressible_density : R := medium_density v rho root_G g W + multiplier * (J - 1).

Lemma derivative_of_constraint (d : derivation R) : d multiplier = 0 ->
  d (multiplier * (J - 1)) = multiplier * d J.
Proof. by move=> constant; rewrite leibniz constant mul0r add0r raddfB /= derivative_of_one subr0. Qed.

(** ** The momenta of an incompressible medium

(8.4): \f$p_a{}^0 = \rho\,g_{ab}v^b{}_0\sqrt{\det G}\f$ and
\f$p_a{}^j = \bigl(P\,J\,(v^{-1})^j{}_a - \rho\,\frac{\partial W}{\partial v^a{}_j}\bigr)\sqrt{\det G}\f$. *)
Theorem eq_8_4 a :
  momentum d_v incompressible_density a ord0 = time_momentum rho root_G g (velocity_of v) a
  /\ forall j, momentum d_v incompressible_density a (along_body j)
      = (P * areas j a - rho * energy_slope d_v W a j) * root_G.
Proof.
rewrite /momentum /incompressible_density; split=> [|j]; rewrite raddfD /= derivative_of_constraint //.
  rewrite (jacobian_in_velocity medium root_g_v) mulr0 addr0; exact: (eq_6_4 medium a).1.
rewrite (jacobian_in_gradient medium root_g_v) [X in X + _](_ : _ = space_momentum rho root_G (energy_slope
  d_v W) a j).
  rewrite /space_momentum /multiplier -/areas; ring_identity.
exact: (eq_6_4 medium a).2.
Qed.

(** The work of \f$J\,(v^{-1})^j{}_a\f$ on the gradient: \f$J\,(v^{-1})^j{}_a\,v^a{}_j = nJ\f$. *)
Lemma work_of_areas : \sum_a \sum_j areas j a * gradient_of v a j = n%:R * J.
Proof.
have -> : \sum_a \sum_j areas j a * gradient_of v a j = root_g / root_G * \tr (\adj F *m F).
  rewrite exchange_big /mxtrace mulr_sumr; apply: eq_bigr => j _; rewrite mxE mulr_sumr.
  by apply: eq_bigr => a _; rewrite /areas /area_transformation [X in X * _ = _]mxE [F a j]mxE mulrA.
rewrite mul_adj_mx mxtrace_scalar /J /jacobian -mulr_natl; ring_identity.
Qed.

(** ** The affine momentum of an incompressible medium

\f$\Pi = \bigl[-\frac12\rho\,g_{ab}v^a{}_0v^b{}_0 + \rho\,\frac{\partial W}{\partial v^a{}_j}v^a{}_j - \rho W
- P\,(J(n-1) + 1)\bigr]\sqrt{\det G}\f$, off the constraint. *)
Theorem claim_8_2_affine_momentum :
  affine_momentum v d_v incompressible_density
  = (- (2%:R^-1 * rho * speed_squared g (velocity_of v))
     + rho * (\sum_a \sum_j energy_slope d_v W a j * gradient_of v a j) - rho * W
     - P * (J * (n%:R - 1) + 1)) * root_G.
Proof.
rewrite /affine_momentum.
have -> : \sum_a \sum_mu momentum d_v incompressible_density a mu * v a mu
  = \sum_a time_momentum rho root_G g (velocity_of v) a * velocity_of v a
    + (P * (n%:R * J) - rho * (\sum_a \sum_j energy_slope d_v W a j * gradient_of v a j)) * root_G.
  have -> : (P * (n%:R * J) - rho * (\sum_a \sum_j energy_slope d_v W a j * gradient_of v a j)) * root_G
    = \sum_a \sum_j (P * areas j a - rho * energy_slope d_v W a j) * root_G * gradient_of v a j.
    rewrite -work_of_areas !mulr_sumr -sumrB mulr_suml; apply: eq_bigr => a _.
    rewrite !mulr_sumr -sumrB mulr_suml; apply: eq_bigr => j _; ring_identity.
  rewrite -big_split; apply: eq_bigr => a _; rewrite big_ord_recl (eq_8_4 a).1; congr (_ + _).
  by apply: eq_bigr => j _; rewrite (eq_8_4 a).2.
rewrite power_of_momentum ?(two_is_unit medium) // /incompressible_density /medium_density /density.
rewrite /kinetic /potential /multiplier; ring_identity.
Qed.

(** ** The field equation of the multiplier

(8.6): \f$\frac{\partial L_\Phi}{\partial\lambda} - \frac{\partial}{\partial x^\mu}\frac{\partial
L_\Phi}{\partial\beta_\mu} = J - 1\f$. The derivations are those in \f$\lambda\f$ and in its derivatives
\f$\beta_\mu\f$, on which the density does not depend. *)
Theorem eq_8_6 (d_lambda : derivation R) (d_beta : 'I_n.+1 -> derivation R) :
    d_lambda multiplier = 1 -> d_lambda (medium_density v rho root_G g W) = 0 -> d_lambda J = 0 ->
    (forall mu, d_beta mu incompressible_density = 0) ->
  d_lambda incompressible_density - \sum_mu D mu (d_beta mu incompressible_density) = J - 1.
Proof.
move=> own L_free J_free cyclic; rewrite big1 => [|mu _]; last by rewrite cyclic raddf0.
rewrite subr0 /incompressible_density raddfD /= L_free add0r leibniz own mul1r raddfB /= J_free.
by rewrite derivative_of_one subr0 mulr0 addr0.
Qed.

(** *** The equation of motion *)

Hypothesis mixed : forall k a i, D_body k (gradient_of v a i) = D_body i (gradient_of v a k).

(** ** The terms in which the metric of space is differentiated

Section 8.2: the term \f$\frac{\partial}{\partial y^b}\bigl(P\,J\,(v^{-1})^j{}_a\sqrt{\det G}\bigr)\,
\frac{\partial y^b}{\partial x^j}\f$ of the divergence of the momenta is
\f$\lambda\,\frac{\partial\Phi}{\partial y^a} = \frac P2\,J\,g^{bc}\,\frac{\partial g_{bc}}{\partial y^a}
\sqrt{\det G}\f$, and they cancel in (8.5). *)
Theorem claim_8_2_metric_terms_cancel a :
  \sum_j \sum_b d_y b (areas j a * multiplier) * gradient_of v b j = multiplier * d_y a (J - 1)
  /\ multiplier * d_y a (J - 1) = 2%:R^-1 * P * J * \tr (invmx g *m derivative_of (d_y a) g) * root_G.
Proof.
have placeJ := jacobian_in_place medium root_of_g unit_g a.
split; last first.
  rewrite raddfB /= derivative_of_one subr0 placeJ /multiplier; ring_identity.
have unit_G := volume_is_unit medium.
have slope b j : d_y b (areas j a * multiplier) = (\adj F) j a * d_y b root_g / root_G * multiplier.
  have adjugate : d_y b ((\adj F) j a) = 0.
    rewrite mxE derivative_of_cofactor big1 // => m _; rewrite big1 // => s _.
    by have /matrixP /(_ m (s m)) := gradient_in_place medium b; rewrite mxE [in RHS]mxE => ->;
      rewrite mul0r mulr0.
  rewrite leibniz multiplier_y mulr0 addr0 /areas /area_transformation mxE !leibniz adjugate
    derivative_of_inverse //.
  rewrite (body_y medium b).2; ring_identity.
have -> : \sum_j \sum_b d_y b (areas j a * multiplier) * gradient_of v b j
  = multiplier / root_G * (\sum_b (F *m \adj F) b a * d_y b root_g).
  rewrite exchange_big mulr_sumr; apply: eq_bigr => b _; rewrite mxE mulr_suml mulr_sumr; apply: eq_bigr =>
    j _.
  rewrite slope [F b j]mxE; ring_identity.
rewrite mul_mx_adj (bigD1 a) //= big1 => [|b ne]; last by rewrite mxE (negbTE ne) mul0r.
rewrite mxE eqxx addr0 mulr1n raddfB /= derivative_of_one subr0 /J /jacobian !leibniz derivative_of_inverse
  //.
rewrite (body_y medium a).2 derivative_of_determinant (gradient_in_place medium a) mulmx0 mxtrace0;
  ring_identity.
Qed.

(** ** The equation of motion with stored energy and pressure

(8.7): the Euler-Lagrange derivative of \f$L_\Phi\f$ is \f$-\sqrt{\det G}\f$ times the difference of the two
sides of
\f[ \rho\,g_{ab}\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b - \frac{1}{\sqrt{\det G}}\frac{\partial}{\partial x^k}
\Bigl(\rho\,\frac{\partial W}{\partial v^a{}_k}\sqrt{\det G}\Bigr) = -\rho\,\frac{\partial W}{\partial
g_{bc}}\frac{\partial g_{bc}}{\partial y^a} - \frac{\partial P}{\partial x^k}(v^{-1})^k{}_a\,J , \f]
for every \f$J\f$, on the constraint or off it. *)
Lemma pressure_in_field_equations a :
  euler_lagrange d_y d_v D incompressible_density a
  = euler_lagrange d_y d_v D (medium_density v rho root_G g W) a - root_G * (\sum_k D_body k P * areas k a).
Proof.
rewrite /euler_lagrange !big_ord_recl (eq_8_4 a).1 (eq_6_4 medium a).1.
rewrite [d_y a incompressible_density]raddfD /= derivative_of_constraint //.
have := field_equation_of_pressure medium root_of_g unit_g mixed P a; rewrite -/J -/areas => pressure.
have -> : \sum_(k < n) D (lift ord0 k) (momentum d_v incompressible_density a (lift ord0 k))
  = \sum_k D_body k (P * areas k a * root_G)
    + \sum_(k < n) D (lift ord0 k) (momentum d_v (medium_density v rho root_G g W) a (lift ord0 k)).
  rewrite -big_split; apply: eq_bigr => k _; rewrite -!/(along_body k) (eq_8_4 a).2 (eq_6_4 medium a).2.
  rewrite /= /D_body -raddfD /=; congr (D _ _); rewrite /space_momentum; ring_identity.
have -> : root_G * (\sum_k D_body k P * areas k a) = - (P * root_G * d_y a J - \sum_k D_body k (P * areas k
  a * root_G)).
  by rewrite pressure opprK.
rewrite /multiplier; ring_identity.
Qed.

Theorem eq_8_7 a :
  euler_lagrange d_y d_v D incompressible_density a
  = - (root_G * (rho * (\sum_b g a b * acceleration v d_y D g b)
      - root_G^-1 * (\sum_k D_body k (rho * energy_slope d_v W a k * root_G))
      + rho * (\sum_b \sum_c W_g b c * d_y a (g b c)) + \sum_k D_body k P * areas k a)).
Proof. rewrite pressure_in_field_equations (eq_6_13 medium) -/D_body; ring_identity. Qed.

(** (8.8): the same with constant metrics. *)
Theorem eq_8_8 a :
    (forall e b c, d_y e (g b c) = 0) -> (forall k, D_body k root_G = 0) ->
  euler_lagrange d_y d_v D incompressible_density a
  = - (root_G * (rho * (\sum_b g a b * D ord0 (velocity_of v b)) - \sum_k D_body k (rho * energy_slope d_v W
    a k)
      + \sum_k D_body k P * areas k a)).
Proof.
move=> constant_g constant_G; rewrite pressure_in_field_equations (eq_6_15 medium) // -/D_body; ring_identity.
Qed.

(** ** What else cancels where the momenta of the pressure are differentiated

Section 8.2, as in (6.17): in the divergence of \f$\lambda\,\partial J/\partial v\f$ the derivatives of
\f$\det v\f$ and of \f$v^{-1}\f$ cancel each other, and those of \f$\sqrt{\det G}\f$ in \f$\lambda\f$ cancel
those of the root in \f$J\f$: derivatives of \f$P\f$ and of \f$\sqrt{\det g}\f$ are left. *)
Theorem claim_8_2_other_cancellations a :
  \sum_k D_body k (multiplier * areas k a)
  = root_G * (\sum_k D_body k P * areas k a) + P * (\sum_k (\adj F) k a * D_body k root_g).
Proof.
have unit_G := volume_is_unit medium.
have gradient := gradient_of_section mixed.
have := first_and_middle_line root_g unit_G gradient P a; rewrite /first_line /middle_line -/areas => lines.
have -> : \sum_k D_body k (multiplier * areas k a)
          = root_G * - (root_G^-1 * \sum_k D_body k (- (P * areas k a * root_G))).
  rewrite mulrN mulrA mulrV // mul1r -sumrN; apply: eq_bigr => k _; rewrite raddfN opprK /multiplier.
  by congr (D_body k _); ring_identity.
rewrite lines mulrDr; congr (_ + _).
have -> : root_G * (P / root_G * \sum_k (\adj F) k a * D_body k root_g)
          = root_G / root_G * (P * \sum_k (\adj F) k a * D_body k root_g) by ring_identity.
by rewrite divrr // mul1r.
Qed.

(** ** Ideal incompressible fluids

(8.9), and with the mass density (section 8.3): where the stored energy is constant, the equation of motion is
\f[ \rho(x)\,g_{ab}\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b =
-\frac{\partial P}{\partial x^k}\,J\,(F^{-1})^k{}_a . \f]
For \f$\rho = 1\f$ it is (8.9); a mass density that varies stays beside the acceleration. *)
Theorem claim_8_3_inhomogeneous_density a :
    (forall b k, energy_slope d_v W b k = 0) -> d_y a W = 0 ->
  euler_lagrange d_y d_v D incompressible_density a
  = - (root_G * (rho * (\sum_b g a b * acceleration v d_y D g b) + \sum_k D_body k P * areas k a)).
Proof.
move=> constant_v constant_y; rewrite eq_8_7 -(energy_y medium) constant_y [X in root_G^-1 * X]big1 => [|k _].
  ring_identity.
by rewrite constant_v mulr0 mul0r raddf0.
Qed.

Theorem eq_8_9 a : rho = 1 -> (forall b k, energy_slope d_v W b k = 0) -> d_y a W = 0 ->
  euler_lagrange d_y d_v D incompressible_density a
  = - (root_G * (\sum_b g a b * acceleration v d_y D g b + \sum_k D_body k P * areas k a)).
Proof. by move=> one constant_v constant_y; rewrite claim_8_3_inhomogeneous_density // one mul1r. Qed.

(** ** Only the sum of the two pressures moves the fluid

(8.12): with a stored energy \f$W(J, x)\f$ and a multiplier as well, the pressure in the equation of motion is
\f$P_W + P_\lambda\f$, \f$P_W = -\rho\,\partial W/\partial J\f$. *)
Theorem eq_8_12 W_J a :
    (forall b k, d_v b (along_body k) W = W_J * d_v b (along_body k) J) ->
    (forall b, d_y b W = W_J * d_y b J) ->
  euler_lagrange d_y d_v D incompressible_density a
  = - (root_G * (rho * (\sum_b g a b * acceleration v d_y D g b)
                 + \sum_k D_body k (material_pressure rho W_J + P) * areas k a)).
Proof.
move=> chain_v chain_y.
rewrite pressure_in_field_equations (eq_6_18 medium root_of_g unit_g root_g_v mixed a chain_v chain_y)
  -/areas -/D_body.
have -> : \sum_k D_body k (material_pressure rho W_J + P) * areas k a
          = \sum_k D_body k (material_pressure rho W_J) * areas k a + \sum_k D_body k P * areas k a.
  by rewrite -big_split; apply: eq_bigr => k _; rewrite raddfD mulrDl.
ring_identity.
Qed.

(** With density 1 the two pressures push together, and the acceleration is that of the vector
\f$\dot\phi\f$. *)
Theorem claim_8_3_combined_pressure_equation W_J a : rho = 1 ->
    (forall b k, d_v b (along_body k) W = W_J * d_v b (along_body k) J) ->
    (forall b, d_y b W = W_J * d_y b J) ->
  euler_lagrange d_y d_v D incompressible_density a
  = - (root_G * (\sum_b g a b * acceleration v d_y D g b
                 + \sum_k D_body k (material_pressure rho W_J + P) * areas k a)).
Proof. by move=> one chain_v chain_y; rewrite (eq_8_12 a chain_v chain_y) one mul1r. Qed.

(** Where the volume is held, \f$J = 1\f$, the pressure of the stored energy of a homogeneous fluid is the
same for all particles: \f$\partial_kP = \partial_kP_\lambda\f$. *)
Theorem claim_8_3_potential_pressure W_J W_JJ k : D_body k rho = 0 ->
    D_body k W_J = W_JJ * D_body k J -> J = 1 ->
  D_body k (material_pressure rho W_J + P) = D_body k P.
Proof.
move=> homogeneous chain held; rewrite raddfD /= /material_pressure raddfN /= leibniz homogeneous chain held.
by rewrite derivative_of_one mul0r !mulr0 addr0 oppr0 add0r.
Qed.

(** ** The equation with the pressure in space

(8.11): where \f$P = p\circ\phi\f$ and \f$J = 1\f$ the field equations of an ideal homogeneous fluid of
density 1 say that \f$\frac{D_g\dot\phi}{Dt} = -\mathrm{grad}\,p\circ\phi\f$. *)
Theorem eq_8_11 (slope : 'I_n -> R) : rho = 1 ->
    (forall b k, energy_slope d_v W b k = 0) -> (forall b, d_y b W = 0) ->
    (forall k, D_body k P = \sum_b F b k * slope b) -> J = 1 ->
  (forall a, euler_lagrange d_y d_v D incompressible_density a = 0)
  <-> (forall b, acceleration v d_y D g b = - \sum_a invmx g b a * slope a).
Proof.
move=> one constant_v constant_y chain held.
have unit_metric := metric_is_regular medium; have unit_G := volume_is_unit medium.
pose acc : 'cV[R]_n := \col_b acceleration v d_y D g b; pose p : 'cV[R]_n := \col_a slope a.
have fieldE a : euler_lagrange d_y d_v D incompressible_density a = - (root_G * ((g *m acc) a 0 + p a 0)).
  rewrite eq_8_9 // (slope_in_space root_g root_G a chain) -/J held mul1r [p a 0]mxE.
  by congr (- (_ * (_ + _))); rewrite mxE; apply: eq_bigr => b _; rewrite mxE.
have rightE b : - (\sum_a invmx g b a * slope a) = (- (invmx g *m p)) b 0.
  by rewrite mxE mxE; congr (- _); apply: eq_bigr => a _; rewrite mxE.
split=> [solves b|law a].
  have lowered : g *m acc = - p.
    apply/matrixP => a z; rewrite (ord1 z) [RHS]mxE; have := solves a; rewrite fieldE => /eqP.
    rewrite oppr_eq0 => /eqP /(congr1 ( *%R root_G^-1)); rewrite mulKr // mulr0 => /eqP.
    by rewrite addr_eq0 => /eqP.
  have : acc = - (invmx g *m p) by rewrite -mulmxN -lowered mulmxA mulVmx // mul1mx.
  by rewrite rightE => /matrixP /(_ b 0); rewrite mxE.
have : acc = - (invmx g *m p) by apply/matrixP => b z; rewrite (ord1 z) -rightE mxE law.
rewrite fieldE => ->; rewrite mulmxN mulmxA mulmxV // mul1mx mxE addNr mulr0 oppr0.
by [].
Qed.

(** ** An incompressible solid

Section 8.4: for an energy of the Green tensor with the slope \f$S\f$
\f[ \rho\,g_{ab}\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b = \mathcal P_a{}^i{}_{|i} -
\frac{\partial P}{\partial x^k}\,J\,(F^{-1})^k{}_a \f]
with the covariant divergence of section 6.2, its index corrected. *)
Theorem claim_8_4_elasticity_components (G S : 'M[R]_n) a :
    G^T = G -> root_G ^+ 2 = \det G -> J \is a GRing.unit -> S^T = S ->
    W_g = slope_in_metric S F -> (forall b k, energy_slope d_v W b k = slope_in_gradient S g F b k) ->
  euler_lagrange d_y d_v D incompressible_density a
  = - (root_G * (rho * (\sum_b g a b * acceleration v d_y D g b)
      - two_point_divergence v D G (christoffel g d_y) (first_piola_kirchhoff_stress d_v rho W) a
      + \sum_k D_body k P * areas k a)).
Proof.
move=> symmetric_G root_of_G unit_J symmetric_S W_gE W_FE.
have symmetric_W : W_g^T = W_g by rewrite W_gE /slope_in_metric !trmx_mul trmxK symmetric_S mulmxA.
rewrite pressure_in_field_equations (eq_6_21 medium symmetric_G root_of_G unit_J symmetric_W (S := S)) //.
ring_identity.
Qed.

End Incompressible.

(** ** The field equation of the multiplier is that of a scalar

The right side of (8.6) is printed as the form \f$\Phi\,d^{n+1}x\f$. The left side is a number that is the
same in every chart of the body: where the chart is changed with the determinant \f$b\f$, densities and so the
multiplier are divided by \f$b\f$, and the derivative in the multiplier is multiplied by it. The coefficient
of a form would be divided by \f$b\f$. *)
Theorem eq_8_6_in_another_chart (R : comUnitRingType) (d_lambda : derivation R) (L lambda J b : R) :
    b \is a GRing.unit -> d_lambda lambda = 1 -> d_lambda L = 0 -> d_lambda J = 0 -> d_lambda b = 0 ->
  b * d_lambda ((L + lambda * (J - 1)) / b) = d_lambda (L + lambda * (J - 1)).
Proof.
move=> unit_b own L_free J_free b_free; rewrite [d_lambda (_ / b)]leibniz derivative_of_inverse // b_free.
by rewrite !mul0r oppr0 mulr0 addr0 mulrCA divrr ?mulr1.
Qed.

Theorem eq_8_6_printed_fails :
  ~ (forall (R : comUnitRingType) (d_lambda : derivation R) (L lambda J b : R),
      b \is a GRing.unit -> d_lambda lambda = 1 -> d_lambda L = 0 -> d_lambda J = 0 -> d_lambda b = 0 ->
      d_lambda (L + lambda * (J - 1)) = J - 1 /\ b * d_lambda ((L + lambda * (J - 1)) / b) = (J - 1) / b).
Proof.
move=> claim; have [R [c]] := polynomials 1; have unit2 := unit2_of_coordinates c.
have constant2 : partial c 0 2%:R = 0 by apply: derivative_of_nat.
have own : partial c 0 (coordinate c 0) = 1 by rewrite partial_coordinate.
have [one two] := claim _ (partial c 0) 0 (coordinate c 0) 2%:R 2%:R unit2 own (raddf0 _) constant2 constant2.
move: two; rewrite (eq_8_6_in_another_chart unit2 own (raddf0 _) constant2 constant2) one.
have -> : 2%:R - 1 = 1 :> R by ring_identity.
move/(congr1 (fun r => r * 2%:R)); rewrite divrK // mul1r => double; apply: (one_is_not_zero c).
apply: (addrI (1 : R)); rewrite addr0 -[LHS]double; ring_identity.
Qed.

(** ** A mass density that varies is no matter of the pressure

Section 8.3 says that for inhomogeneous fluids the dependence of the density on the point is implicit in the
pressure, that is, that (8.9) without a density holds with some other pressure \f$P'\f$. Then
\f$\rho\,\partial_kP' = \partial_kP\f$, and the density and the pressure are functions of each other,
\f$\partial_i\rho\,\partial_jP = \partial_j\rho\,\partial_iP\f$. *)
Theorem inhomogeneous_density_condition (R : comUnitRingType) n (D : 'I_n -> derivation R) (rho P P' : R) :
    rho \is a GRing.unit -> (forall i j f, D i (D j f) = D j (D i f)) ->
    (forall k, rho * D k P' = D k P) ->
  forall i j, D i rho * D j P = D j rho * D i P.
Proof.
move=> unit_rho commute same i j; rewrite -!same.
have cross : D i rho * D j P' = D j rho * D i P'.
  have : D i (rho * D j P') = D j (rho * D i P') by rewrite !same commute.
  by rewrite !leibniz (commute i j) => /addIr.
by rewrite mulrCA cross mulrCA.
Qed.

(** So there is no such pressure for the fluid at rest with \f$\rho = 1 + \varepsilon_1\f$ and
\f$P = \varepsilon_2\f$, \f$\varepsilon_i = e^{x_i}\f$ to first order. *)
Theorem claim_8_3_inhomogeneous_density_printed_fails :
  ~ (forall (R : comUnitRingType) n (F : 'M[R]_n) (root_g root_G : R) (D : 'I_n -> derivation R) (rho P : R),
      rho \is a GRing.unit -> root_g \is a GRing.unit -> root_G \is a GRing.unit -> is_gradient D F ->
      (forall i j f, D i (D j f) = D j (D i f)) ->
      exists P', forall a, rho * (\sum_k D k P' * area_transformation F root_g root_G k a)
                           = \sum_k D k P * area_transformation F root_g root_G k a).
Proof.
pose inner := with_small_part_comUnitRingType [comUnitRingType of rat].
pose R := with_small_part_comUnitRingType inner.
pose D (i : 'I_2) : derivation R :=
  if i == 0 then derivation_of_both_parts (derivation_of_small_part [comUnitRingType of rat])
  else derivation_of_small_part inner.
pose rho : R := ((1, 1) : inner, 0 : inner); pose P : R := (0 : inner, 1 : inner).
have unit_rho : rho \is a GRing.unit by [].
have commute i j f : D i (D j f) = D j (D i f).
  move: i j; apply: plane; apply: plane; case: f => [[a b] [e h]] //; rewrite /D /=; congr pair;
    exact: raddf0.
have gradient : is_gradient D (1%:M : 'M[R]_2).
  by move=> k a i; rewrite !mxE !derivative_of_nat.
move=> claim; have [P' same] := claim R 2%N 1%:M 1 1 D rho P unit_rho (unitr1 _) (unitr1 _) gradient commute.
have pick (Q : R) a : \sum_k D k Q * area_transformation 1%:M 1 1 k a = D a Q.
  rewrite /area_transformation adjugate_of_one divrr ?unitr1 // scale1r (bigD1 a) //= mxE eqxx mulr1.
  by rewrite big1 ?addr0 // => k ne; rewrite mxE (negbTE ne) mulr0.
have condition := inhomogeneous_density_condition unit_rho commute
                    (fun k => etrans (congr1 ( *%R rho) (esym (pick P' k))) (etrans (same k) (pick P k))) 0 1.
by have := congr1 (fun f : R => f.2.2) condition; rewrite /D /= !(mul0r, mul1r, addr0, add0r) => /eqP;
  rewrite oner_eq0.
Qed.

(** In the equation with two pressures the thesis sets an index to \f$\dot\phi\f$ inside the covariant
derivative. The components \f$\dot\phi^b\f$ differentiated as functions, without the symbols of the
connection, are not the acceleration, not even for the motion of a shear of the plane with the velocity
\f$(1, 0)\f$. *)
Theorem components_of_velocity_are_not_differentiated_alone :
  ~ (forall (R : comUnitRingType) (g : 'M[R]_2) (d_y : 'I_2 -> derivation R) (rate : derivation R) velocity,
      (2%:R : R) \is a GRing.unit -> g^T = g -> g \in unitmx ->
      (forall a b, rate (g a b) = \sum_c velocity c * d_y c (g a b)) ->
      forall a, \sum_b g a b * rate (velocity b)
                = \sum_b g a b * material_acceleration g d_y rate velocity b).
Proof.
have [R [c]] := polynomials 1; have unit2 := unit2_of_coordinates c => claim.
have same := claim _ _ _ _ _ unit2 (shear_symmetric c) (shear_regular c) (shear_along_motion c).
have lowered a : \sum_b shear_metric c a b * shear_derivative c 0 (shear_velocity [comUnitRingType of R] b)
    = shear_derivative c 0 (\sum_b shear_metric c a b * shear_velocity [comUnitRingType of R] b)
      - 2%:R^-1 * \sum_b \sum_e shear_derivative c a (shear_metric c b e)
          * shear_velocity [comUnitRingType of R] b * shear_velocity [comUnitRingType of R] e.
  rewrite same; apply: claim_6_2_material_acceleration => //;
    [exact: shear_symmetric | exact: shear_regular | exact: shear_along_motion].
have := shear_only_acceleration unit2 lowered 1; rewrite /shear_velocity derivative_of_nat.
exact: (one_is_not_zero c).
Qed.

(** ** From the equation of motion on the body to that of the pressure

Section 8.3: (8.11) is an equation between vectors of space at points of the body. The divergence of its right
side in space, where the vector is \f$h\circ\phi\f$, comes out with the inverse gradient,
\f[ (F^{-1})^k{}_a\,\nabla_k(h\circ\phi)^a = (\mathrm{div}\,h)\circ\phi , \f]
for every vector field \f$h\f$ of space and any symbols of the connection. *)
Theorem claim_8_3_material_divergence (R : comUnitRingType) n (D d_y : 'I_n -> derivation R) (F : 'M[R]_n)
    (gamma : 'I_n -> 'I_n -> 'I_n -> R) (h : 'I_n -> R) : F \in unitmx ->
    (forall k a, D k (h a) = \sum_b F b k * d_y b (h a)) ->
  \sum_k \sum_a invmx F k a * (D k (h a) + \sum_b \sum_c gamma a b c * h b * F c k)
  = \sum_a (d_y a (h a) + \sum_b gamma a b a * h b).
Proof.
move=> unit_F chain; rewrite exchange_big; apply: eq_bigr => a _ /=.
have pick (s : 'I_n -> R) : \sum_k invmx F k a * (\sum_c F c k * s c) = s a.
  under eq_bigr do rewrite mulr_sumr.
  rewrite exchange_big (eq_bigr (fun c => (F *m invmx F) c a * s c)) => [|c _]; last first.
    by rewrite mxE mulr_suml; apply: eq_bigr => k _; ring_identity.
  rewrite mulmxV // (bigD1 a) //= big1 => [|c ne]; last by rewrite mxE (negbTE ne) mul0r.
  by rewrite mxE eqxx mul1r addr0.
rewrite -(pick (fun c => d_y c (h a))) -(pick (fun c => \sum_b gamma a b c * h b)) -big_split.
apply: eq_bigr => k _ /=; rewrite chain mulrDr; congr (_ + _ * _); rewrite exchange_big.
by apply: eq_bigr => c _; rewrite mulr_sumr; apply: eq_bigr => b _; ring_identity.
Qed.
