(** * Stresses

The two stresses of section 6.2, first Piola and Kirchhoff's \f$\mathcal P_a{}^i = \rho\,\partial W/\partial
v^a{}_i\f$ (6.19) and Cauchy's \f$\sigma^{ab} = \frac{2\rho}J\,\partial W/\partial g_{ab}\f$ (6.14), and the
equation of motion written with them: for any stored energy (6.20), and for one that depends on the Green
tensor (6.21). Body and space may have different dimensions. *)

From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices ring_identities derivations fields continuum.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

Section Stresses.

Variables (R : comUnitRingType) (n N : nat).

(** The Green tensor \f$C_{ij} = g_{ab}F^a{}_iF^b{}_j\f$ (6.2). C++: `actio::green_tensor`,
`continuum/continuum.hpp`. *)
Definition green_tensor (g : 'M[R]_N) (F : 'M[R]_(N, n)) : 'M[R]_n := F^T *m g *m F.

(** \f$\sigma^{ab} = \frac{2\rho}{J}\,\frac{\partial W}{\partial g_{ab}}\f$ (6.14). C++:
`actio::cauchy_stress`, `continuum/stresses.hpp`. *)
Definition cauchy_stress (rho J : R) (W_g : 'M[R]_N) : 'M[R]_N := (2%:R * rho / J) *: W_g.

(** A stored energy that depends on the metric and the gradient through the Green tensor, with the symmetric
slope \f$S^{ij} = \partial W/\partial C_{ij}\f$, has the rate \f$dW = S^{ij}\,dC_{ij}\f$. *)
Definition rate_through_green_tensor (d : derivation R) (W : R) (S : 'M[R]_n) (g : 'M[R]_N) (F : 'M[R]_(N,
  n)) :=
  d W = \tr (S^T *m derivative_of d (green_tensor g F)).

(** Its derivatives in the gradient and in the metric: \f$2\,g_{ab}F^b{}_jS^{ij}\f$ and
\f$F^a{}_iS^{ij}F^b{}_j\f$. *)
Definition slope_in_gradient (S : 'M[R]_n) (g : 'M[R]_N) (F : 'M[R]_(N, n)) := 2%:R *: (g *m F *m S).
Definition slope_in_metric (S : 'M[R]_n) (F : 'M[R]_(N, n)) : 'M[R]_N := F *m S *m F^T.

Lemma trace_of_product m k (A B : 'M[R]_(m, k)) : \tr (A^T *m B) = \sum_a \sum_i A a i * B a i.
Proof.
rewrite /mxtrace exchange_big; apply: eq_bigr => i _; rewrite mxE; apply: eq_bigr => a _.
by rewrite mxE.
Qed.

Lemma rate_in_gradient d W S g F : g^T = g -> S^T = S -> derivative_of d g = 0 ->
    rate_through_green_tensor d W S g F ->
  d W = \sum_a \sum_i slope_in_gradient S g F a i * d (F a i).
Proof.
move=> sym_g sym_S constant_g ->.
have -> : \sum_a \sum_i slope_in_gradient S g F a i * d (F a i)
          = \tr ((slope_in_gradient S g F)^T *m derivative_of d F).
  by rewrite trace_of_product; apply: eq_bigr => a _; apply: eq_bigr => i _; congr (_ * _); rewrite [RHS]mxE.
rewrite /green_tensor !derivative_of_matrix_product constant_g mulmx0 addr0 derivative_of_transpose.
rewrite /slope_in_gradient linearZ /= -scalemxAl mxtraceZ mulr_natl mulr2n mulmxDr mxtraceD sym_S.
set F' := derivative_of d F; congr (_ + _).
  rewrite -mxtrace_tr !trmx_mul !trmxK sym_S sym_g mxtrace_mulC.
  by rewrite !mulmxA.
by rewrite !trmx_mul sym_S sym_g !mulmxA.
Qed.

Lemma rate_in_metric d W S g F : S^T = S -> derivative_of d F = 0 ->
    rate_through_green_tensor d W S g F ->
  d W = \sum_a \sum_b slope_in_metric S F a b * d (g a b).
Proof.
move=> sym_S constant_F ->.
have -> : \sum_a \sum_b slope_in_metric S F a b * d (g a b)
          = \tr ((slope_in_metric S F)^T *m derivative_of d g).
  by rewrite trace_of_product; apply: eq_bigr => a _; apply: eq_bigr => b _; congr (_ * _); rewrite [RHS]mxE.
rewrite /green_tensor !derivative_of_matrix_product derivative_of_transpose constant_F trmx0 mul0mx add0r.
rewrite mulmx0 addr0 /slope_in_metric !trmx_mul trmxK sym_S.
by rewrite [S *m _]mulmxA [LHS]mxtrace_mulC !mulmxA.
Qed.

(** ** Piola's transformation

For an energy of the Green tensor \f$\mathcal P_a{}^iF^b{}_i = J\,g_{ac}\,\sigma^{cb}\f$, for bodies of fewer
dimensions than their space as well; and where \f$F\f$ has an inverse
\f[ \mathcal P_a{}^i = J\,g_{ab}\,\sigma^{bc}\,(F^{-1})^i{}_c . \f]
The solid may have any symmetry or none. *)
Theorem claim_6_2_piola_transform_with_gradient (rho J : R) S g F : J \is a GRing.unit ->
  rho *: slope_in_gradient S g F *m F^T = J *: (g *m cauchy_stress rho J (slope_in_metric S F)).
Proof.
move=> unit_J; rewrite /cauchy_stress /slope_in_gradient /slope_in_metric -scalemxAr !scalerA -!scalemxAl.
rewrite !mulmxA; congr (_ *: _).
by rewrite mulrCA mulrV // mulr1 mulrC.
Qed.

(** ** The balance of moment of momentum

The Cauchy stress is symmetric by its definition, with the symmetric derivative in the metric. That
\f$g^{ac}\,\mathcal P_c{}^iF^b{}_i\f$ is symmetric holds for an energy of the Green tensor. *)
Theorem claim_6_2_stress_symmetry (rho J : R) (W_g : 'M[R]_N) :
  W_g^T = W_g -> (cauchy_stress rho J W_g)^T = cauchy_stress rho J W_g.
Proof. by move=> sym; rewrite linearZ /= sym. Qed.

Theorem claim_6_2_stress_symmetry_of_solids (rho : R) S g F : S^T = S -> g \in unitmx ->
  let tau := invmx g *m (rho *: slope_in_gradient S g F) *m F^T in tau^T = tau.
Proof.
move=> sym_S unit_g /=; rewrite /slope_in_gradient scalerA -scalemxAr !mulmxA mulVmx // mul1mx -scalemxAl
  linearZ /=.
by rewrite !trmx_mul trmxK sym_S mulmxA.
Qed.

End Stresses.

Theorem claim_6_2_piola_transform (R : comUnitRingType) n (rho J : R) (S g F : 'M[R]_n) :
    J \is a GRing.unit -> F \in unitmx ->
  rho *: slope_in_gradient S g F = J *: (g *m cauchy_stress rho J (slope_in_metric S F) *m (invmx F)^T).
Proof.
move=> unit_J unit_F; rewrite scalemxAl -claim_6_2_piola_transform_with_gradient // -mulmxA -trmx_mul mulVmx
  //.
by rewrite trmx1 mulmx1.
Qed.

Section Equations.

Variables (R : comUnitRingType) (n N : nat).
Variables (v : 'I_N -> 'I_n.+1 -> R) (d_y : 'I_N -> derivation R) (d_v : 'I_N -> 'I_n.+1 -> derivation R)
          (D : 'I_n.+1 -> derivation R).
Variables (rho vol J : R) (G : 'M[R]_n) (g : 'M[R]_N) (W : R) (W_g : 'M[R]_N).
Hypothesis medium : is_medium v d_y d_v D rho vol g W W_g.
Hypothesis symmetric_G : G^T = G.
Hypothesis root_of_G : vol ^+ 2 = \det G.
Hypothesis unit_J : J \is a GRing.unit.
Hypothesis symmetric_slope : W_g^T = W_g.

Let gamma := christoffel g d_y.
Let P := first_piola_kirchhoff_stress d_v rho W.
Let sigma := cauchy_stress rho J W_g.

Lemma force_of_metric a :
  rho * (\sum_b \sum_c W_g b c * d_y a (g b c))
  = \sum_b \sum_c gamma b a c * (J * \sum_e g b e * sigma e c).
Proof.
have sym_g := metric_entry (metric_is_symmetric medium).
have sym_W b c : W_g b c = W_g c b by have /matrixP /(_ c b) := symmetric_slope; rewrite mxE.
have [_ /(_ (fun _ _ _ => erefl)) [sym_gamma parallel]] :=
  claim_6_2_christoffel d_y (two_is_unit medium) (metric_is_symmetric medium) (metric_is_regular medium)
    gamma.
have half : \sum_b \sum_c W_g b c * d_y a (g b c)
    = 2%:R * (\sum_b \sum_c \sum_e gamma b a c * g b e * W_g e c).
  have first : \sum_e \sum_c W_g e c * (\sum_b g b c * gamma b e a) = \sum_b \sum_c \sum_e gamma b a c * g b
    e * W_g e c.
    rewrite exchange_big; under eq_bigr do under eq_bigr do rewrite mulr_sumr.
    under eq_bigr do rewrite exchange_big.
    rewrite exchange_big; apply: eq_bigr => b _; rewrite exchange_big; apply: eq_bigr => c _.
    apply: eq_bigr => e _; rewrite (sym_W c e) (sym_gamma b c a); ring_identity.
  have second : \sum_e \sum_c W_g e c * (\sum_b g e b * gamma b c a) = \sum_b \sum_c \sum_e gamma b a c * g
    b e * W_g e c.
    under eq_bigr do under eq_bigr do rewrite mulr_sumr.
    under eq_bigr do rewrite exchange_big.
    rewrite exchange_big; apply: eq_bigr => b _; rewrite exchange_big; apply: eq_bigr => c _.
    apply: eq_bigr => e _; rewrite (sym_gamma b c a) (sym_g e b); ring_identity.
  rewrite mulr_natl mulr2n -{1}first -second -big_split; apply: eq_bigr => b _ /=.
  by rewrite -big_split; apply: eq_bigr => c _; rewrite parallel mulrDr.
rewrite half mulrA [rho * _]mulrC mulr_sumr; apply: eq_bigr => b _.
rewrite mulr_sumr; apply: eq_bigr => c _; rewrite mulr_sumr mulr_sumr mulr_sumr; apply: eq_bigr => e _.
rewrite /sigma /cauchy_stress mxE.
have -> : gamma b a c * (J * (g b e * (2%:R * rho / J * W_g e c)))
          = (2%:R * rho / J * J) * (gamma b a c * g b e * W_g e c) by ring_identity.
by rewrite divrK // [rho * _]mulrC.
Qed.

(** ** The equation of motion with stresses

(6.20): for every stored energy \f$W(x, G, g, v)\f$
\f[ \rho\,g_{ab}\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b = \mathcal P_a{}^i{}_{|i} +
\gamma^b_{ac}\bigl(\mathcal P_b{}^jF_j{}^c - J\,g_{bd}\,\sigma^{dc}\bigr) \f]
with the covariant divergence that obeys the rule of Leibniz, with the Christoffel symbols of both metrics:
the Euler-Lagrange derivative of (6.3) is
\f$-\sqrt{\det G}\f$ times the difference of the two sides. *)
Theorem eq_6_20 a :
  euler_lagrange d_y d_v D (medium_density v rho vol g W) a
  = - (vol * (rho * (\sum_b g a b * acceleration v d_y D g b)
      - (two_point_divergence v D G gamma P a
         + \sum_b \sum_c gamma b a c * (\sum_j P b j * gradient_of v c j - J * \sum_e g b e * sigma e c)))).
Proof.
rewrite (eq_6_13 medium); congr (- (_ * _)).
have -> : vol^-1 * (\sum_k D (along_body k) (rho * energy_slope d_v W a k * vol))
          = \sum_i D (along_body i) (P a i) + \sum_j P a j * body_symbol D G j.
  rewrite mulr_sumr -big_split; apply: eq_bigr => k _ /=; rewrite leibniz mulrDr.
  rewrite mulrCA mulVr ?(volume_is_unit medium) // mulr1 /P /first_piola_kirchhoff_stress.
  rewrite (body_symbol_of_root D (two_is_unit medium) symmetric_G root_of_G (volume_is_unit medium)).
  by congr (_ + _); ring_identity.
have -> : \sum_b \sum_c gamma b a c * (\sum_j P b j * gradient_of v c j - J * \sum_e g b e * sigma e c)
  = \sum_b \sum_c \sum_j P b j * gamma b a c * gradient_of v c j
    - rho * (\sum_b \sum_c W_g b c * d_y a (g b c)).
  rewrite force_of_metric -sumrB; apply: eq_bigr => b _; rewrite -sumrB; apply: eq_bigr => c _.
  by rewrite mulrBr; congr (_ - _); rewrite mulr_sumr; apply: eq_bigr => j _; ring_identity.
rewrite /two_point_divergence; ring_identity.
Qed.

(** ** The equation of motion of elasticity

(6.21), \f$\rho\,\frac{D_gV}{Dt} = \mathrm{DIV}\,\mathcal P\f$ with one index lowered: for an energy of the
Green tensor, where \f$\mathcal P_b{}^jF^c{}_j = J\,g_{bd}\,\sigma^{dc}\f$ and the last term of (6.20)
vanishes. *)
Theorem eq_6_21 (S : 'M[R]_n) a :
    let F := \matrix_(b, k) gradient_of v b k in
    W_g = slope_in_metric S F -> (forall b k, energy_slope d_v W b k = slope_in_gradient S g F b k) ->
  euler_lagrange d_y d_v D (medium_density v rho vol g W) a
  = - (vol * (rho * (\sum_b g a b * acceleration v d_y D g b) - two_point_divergence v D G gamma P a)).
Proof.
move=> F W_gE W_FE; rewrite eq_6_20.
have vanishes b c : \sum_j P b j * gradient_of v c j - J * (\sum_e g b e * sigma e c) = 0.
  have := claim_6_2_piola_transform_with_gradient rho S g F unit_J; rewrite -W_gE => /matrixP /(_ b c).
  rewrite [LHS]mxE [RHS]mxE [X in _ = _ * X]mxE => <-; apply/eqP; rewrite subr_eq0; apply/eqP.
  apply: eq_bigr => j _; rewrite (mxE trmx_key) (mxE matrix_key) /P /first_piola_kirchhoff_stress W_FE.
  by congr (_ * _); rewrite [RHS]mxE.
rewrite (big1 _ _ (fun b => \sum_c _)) ?addr0 // => b _; apply: big1 => c _.
by rewrite vanishes mulr0.
Qed.

(** The first Piola-Kirchhoff stress is minus the spatial momenta over \f$\sqrt{\det G}\f$ (section 6.2). *)
Theorem claim_6_2_piola_momenta a j :
  P a j = - (momentum d_v (medium_density v rho vol g W) a (along_body j) / vol).
Proof.
rewrite (eq_6_4 medium a).2 /space_momentum /P /first_piola_kirchhoff_stress mulNr opprK mulrK //.
exact: volume_is_unit medium.
Qed.

End Equations.
