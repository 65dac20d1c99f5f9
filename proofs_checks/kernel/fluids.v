(** * Fluids: the Jacobian and the pressure

Sections 6.1, 6.2, 8.2 and 8.3 for media whose body and space have one dimension \f$n\f$, any: the Jacobian
(6.1) and its derivatives, Piola's identity, the three lines of (6.17), the equation of a barotropic fluid
(6.18), and incompressible media with their pressure. Where the thesis writes \f$J\,(F^{-1})^k{}_a\f$ the
matrix of cofactors stands here, times \f$\sqrt{\det g/\det G}\f$: it is the same where \f$F\f$ has an
inverse, and nothing below needs one. *)

From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices ring_identities derivations fields continuum stresses.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Jacobian.

Variables (R : comUnitRingType) (n : nat).
Implicit Types (F g G : 'M[R]_n).

(** The Jacobian \f$J = \det F\,\sqrt{\det g}/\sqrt{\det G}\f$ (6.1). The roots are elements of the ring.
C++: `actio::jacobian`, `continuum/continuum.hpp`. *)
Definition jacobian F (root_g root_G : R) : R := \det F * root_g / root_G.

(** \f$J\,(F^{-1})^k{}_a\f$, a row for each \f$k\f$. C++: `actio::area_transformation`,
`continuum/stresses.hpp`, which has rows and columns exchanged. *)
Definition area_transformation F (root_g root_G : R) : 'M[R]_n := (root_g / root_G) *: \adj F.

Lemma area_transformationE F root_g root_G : F \in unitmx ->
  area_transformation F root_g root_G = jacobian F root_g root_G *: invmx F.
Proof.
move=> unit_F; rewrite /area_transformation /jacobian /invmx unit_F scalerA; congr (_ *: _).
have unit_det : \det F \is a GRing.unit by rewrite -unitmxE.
have -> : \det F * root_g / root_G / \det F = \det F / \det F * (root_g / root_G) by ring_identity.
by rewrite divrr // mul1r.
Qed.

(** ** The Jacobian under changes of coordinates

\f$J\f$ is a scalar (section 6.1). With \f$A\f$ and \f$B\f$ the derivatives of the changes of charts of space
and body, \f$F\f$ becomes \f$AFB^{-1}\f$ and the metrics \f$A^{-T}gA^{-1}\f$ and \f$B^{-T}GB^{-1}\f$. Their
roots, with the sign of charts that keep the orientation, are divided by \f$\det A\f$ and \f$\det B\f$, and
\f$J\f$ stays. *)
Theorem claim_6_1_jacobian_scalar F g G A B root_g root_G :
    A \in unitmx -> B \in unitmx -> root_G \is a GRing.unit ->
    root_g ^+ 2 = \det g -> root_G ^+ 2 = \det G ->
  [/\ (root_g / \det A) ^+ 2 = \det ((invmx A)^T *m g *m invmx A),
      (root_G / \det B) ^+ 2 = \det ((invmx B)^T *m G *m invmx B)
    & jacobian (A *m F *m invmx B) (root_g / \det A) (root_G / \det B) = jacobian F root_g root_G].
Proof.
move=> unit_A unit_B unit_G root_gE root_GE.
have dA : \det A \is a GRing.unit by rewrite -unitmxE.
have dB : \det B \is a GRing.unit by rewrite -unitmxE.
have squared (r a d : R) : r ^+ 2 = d -> (r / a) ^+ 2 = a^-1 * d * a^-1 by move=> <-; ring_identity.
split; rewrite ?det_mulmx ?det_tr ?det_inv; [exact: squared | exact: squared | ].
rewrite /jacobian !det_mulmx det_inv [(_ / _)^-1 in LHS]invrM ?unitrV // invrK.
have -> : \det A * \det F / \det B * (root_g / \det A) * (\det B / root_G)
          = \det A / \det A * (\det B / \det B) * (\det F * root_g / root_G) by ring_identity.
by rewrite !divrr // !mul1r.
Qed.

(** Its square is \f$\det C/\det G\f$ with the Green tensor \f$C = F^TgF\f$. *)
Theorem claim_6_1_green_tensor_volume F g G root_g root_G :
    root_G \is a GRing.unit -> root_g ^+ 2 = \det g -> root_G ^+ 2 = \det G ->
  jacobian F root_g root_G ^+ 2 * \det G = \det (green_tensor g F).
Proof.
move=> unit_G root_gE root_GE; rewrite /jacobian /green_tensor !det_mulmx det_tr -root_gE -root_GE.
have -> : (\det F * root_g / root_G) ^+ 2 * root_G ^+ 2
          = (root_G / root_G) ^+ 2 * (\det F * root_g ^+ 2 * \det F) by ring_identity.
by rewrite divrr // expr1n mul1r.
Qed.

(** ** The Finger tensor

\f$c = b^{-1}\f$ (section 6.1), with \f$b^{ab} = F^a{}_iF^b{}_jG^{ij}\f$ and the pushed-forward metric
\f$c_{ab} = G_{ij}(F^{-1})^i{}_a(F^{-1})^j{}_b\f$ (6.2). *)
Theorem claim_6_1_finger_tensor F G : F \in unitmx -> G \in unitmx ->
  ((invmx F)^T *m G *m invmx F) *m (F *m invmx G *m F^T) = 1%:M.
Proof.
move=> unit_F unit_G; rewrite !mulmxA mulmxKV // mulmxK // -trmx_mul mulmxV // trmx1.
by [].
Qed.

(** ** The Jacobian of the initial configuration

At \f$\phi(x, 0) = x\f$, \f$F = 1\f$ it is \f$J = \sqrt{\det g(x)/\det G(x)}\f$. *)
Theorem claim_6_1_initial_jacobian root_g root_G : jacobian 1%:M root_g root_G = root_g / root_G.
Proof. by rewrite /jacobian det1 mul1r. Qed.

End Jacobian.

(** The printed \f$J(x, 0) = 1\f$ needs the metrics of body and space to have one volume: on a line with \f$g
= 4\f$ and \f$G = 1\f$ it is 2. *)
Theorem claim_6_1_initial_jacobian_printed_fails :
  ~ (forall n (g G : 'M[rat]_n) (root_g root_G : rat), 0 < root_g -> 0 < root_G ->
      root_g ^+ 2 = \det g -> root_G ^+ 2 = \det G -> jacobian (1%:M : 'M[rat]_n) root_g root_G = 1).
Proof.
move=> claim; have := claim 1%N 4%:R%:M 1%:M 2%:R 1 isT isT;
  rewrite det_scalar1 det1 claim_6_1_initial_jacobian.
by move/(_ _ _) => /(_ erefl erefl) /eqP; vm_compute.
Qed.

(** ** Barotropic fluids *)

Section Barotropic.

Variables (R : comUnitRingType) (n : nat).

(** Deformation gradient, metric of space, and the roots \f$\sqrt{\det g}\f$ and \f$\sqrt{\det G}\f$. *)
Variables (F g : 'M[R]_n) (root_g root_G : R).
Hypothesis root_of_g : root_g ^+ 2 = \det g.
Hypothesis unit_g : root_g \is a GRing.unit.
Hypothesis unit_G : root_G \is a GRing.unit.
Hypothesis unit2 : (2%:R : R) \is a GRing.unit.

Let J := jacobian F root_g root_G.
Let areas := area_transformation F root_g root_G.

(** The derivatives of \f$J\f$: \f$\partial J/\partial v^a{}_i = J\,(v^{-1})^i{}_a\f$ and
\f$\partial J/\partial g_{ab} = \frac12J\,g^{ab}\f$. *)
Lemma derivative_in_gradient (d : derivation R) : d root_g = 0 -> d root_G = 0 ->
  d J = \tr (areas *m derivative_of d F).
Proof.
move=> d_g d_G; rewrite /J /jacobian !leibniz d_g derivative_of_inverse // d_G !mul0r oppr0 !mulr0 !addr0.
rewrite derivative_of_determinant /areas /area_transformation -scalemxAl mxtraceZ; ring_identity.
Qed.

Lemma derivative_in_metric (d : derivation R) : derivative_of d F = 0 -> d root_G = 0 ->
  2%:R * d J = J * \tr (invmx g *m derivative_of d g).
Proof.
move=> d_F d_G; rewrite /J /jacobian !leibniz derivative_of_determinant d_F mulmx0 mxtrace0 mul0r add0r.
rewrite derivative_of_inverse // d_G !mul0r oppr0 mulr0 addr0.
have := derivative_of_root d root_of_g unit_g => root.
have -> : 2%:R * (\det F * d root_g / root_G) = \det F * (2%:R * d root_g) / root_G by ring_identity.
rewrite root; ring_identity.
Qed.

(** A stored energy \f$W(J, x)\f$ with \f$W' = \partial W/\partial J\f$, and its material pressure
\f$P = -\rho\,\partial W/\partial J\f$ (6.16). C++: `actio::material_pressure`, `continuum/stresses.hpp`. *)
Variables (rho W W_J : R).
Definition material_pressure : R := - (rho * W_J).

(** ** The spatial momenta of a barotropic fluid

\f$p_a{}^i = -\rho\,\frac{\partial W}{\partial v^a{}_i}\sqrt{\det G} = P\,J\,(v^{-1})^i{}_a\sqrt{\det G}\f$,
with \f$i\f$ an index of \f$v\f$. The derivation is \f$\partial/\partial v^a{}_i\f$. *)
Theorem claim_6_2_barotropic_momenta (d : derivation R) a i :
    derivative_of d F = delta_mx a i -> d root_g = 0 -> d root_G = 0 -> d W = W_J * d J ->
  - (rho * d W * root_G) = material_pressure * areas i a * root_G.
Proof.
move=> d_F d_g d_G ->; rewrite derivative_in_gradient // d_F.
have -> : \tr (areas *m delta_mx a i) = areas i a.
  have entry k : (areas *m delta_mx a i) k k = (k == i)%:R * areas k a.
    rewrite mxE (bigD1 a) //= (mxE delta_mx_key) eqxx big1 ?addr0 => [|l ne]; last first.
      by rewrite (mxE delta_mx_key) (negbTE ne) mulr0.
    by rewrite mulrC.
  by rewrite /mxtrace (bigD1 i) //= entry eqxx mul1r big1 ?addr0 // => k ne; rewrite entry (negbTE ne) mul0r.
rewrite /material_pressure; ring_identity.
Qed.

(** ** The Cauchy stress of a barotropic fluid

\f$\sigma^{ab} = -P\,g^{ab}\f$: the symmetric slope of \f$W\f$ in the metric is \f$\frac12W'J\,g^{ab}\f$, and
the definition (6.14) makes of it minus the pressure times the metric. *)
Definition fluid_slope : 'M[R]_n := (2%:R^-1 * W_J * J) *: invmx g.

Lemma rate_of_fluid (d : derivation R) : g^T = g ->
    derivative_of d F = 0 -> d root_G = 0 -> d W = W_J * d J ->
  d W = \sum_a \sum_b fluid_slope a b * d (g a b).
Proof.
move=> sym_g d_F d_G ->.
have sym_inverse : (invmx g)^T = invmx g by rewrite trmx_inv sym_g.
have -> : \sum_a \sum_b fluid_slope a b * d (g a b) = \tr (fluid_slope^T *m derivative_of d g).
  by rewrite trace_of_product; apply: eq_bigr => a _; apply: eq_bigr => b _; congr (_ * _); rewrite [RHS]mxE.
rewrite /fluid_slope linearZ /= sym_inverse -scalemxAl mxtraceZ.
have -> : d J = 2%:R^-1 * (J * \tr (invmx g *m derivative_of d g)).
  by rewrite -derivative_in_metric // mulrA mulVr // mul1r.
ring_identity.
Qed.

Theorem claim_6_2_barotropic_stress : J \is a GRing.unit ->
  cauchy_stress rho J fluid_slope = - material_pressure *: invmx g.
Proof.
move=> unit_J; rewrite /cauchy_stress /fluid_slope scalerA /material_pressure opprK; congr (_ *: _).
have -> : 2%:R * rho / J * (2%:R^-1 * W_J * J) = (2%:R / 2%:R) * (J / J) * (rho * W_J) by ring_identity.
by rewrite !divrr // !mul1r.
Qed.

(** ** The force of the metric

The right side of (6.13) is \f$-\rho\,\frac{\partial W}{\partial g_{bc}}\frac{\partial g_{bc}}{\partial y^a} =
\frac P2\,J\,g^{bc}\,\frac{\partial g_{bc}}{\partial y^a}\f$ for a barotropic fluid; the derivation is
\f$\partial/\partial y^a\f$. *)
Theorem claim_6_2_metric_force (d : derivation R) :
    derivative_of d F = 0 -> d root_G = 0 -> d W = W_J * d J ->
  - (rho * d W) = 2%:R^-1 * material_pressure * J * \tr (invmx g *m derivative_of d g).
Proof.
move=> d_F d_G ->.
have -> : d J = 2%:R^-1 * (J * \tr (invmx g *m derivative_of d g)).
  by rewrite -derivative_in_metric // mulrA mulVr // mul1r.
rewrite /material_pressure; ring_identity.
Qed.

(** *** The expansion (6.17) *)

(** The derivatives in the directions of the body and in those of space; the metric is a function of the point
of space. *)
Variables (D d_y : 'I_n -> derivation R).
Hypothesis section : is_gradient D F.
Hypothesis along_section : forall k b c, D k (g b c) = \sum_a F a k * d_y a (g b c).

(** ** Piola's identity

The terms (I) and (II) of (6.17), from differentiating \f$\det v\f$ and \f$(v^{-1})^k{}_a\f$, cancel:
\f[ \frac{\partial\det F}{\partial x^k}(F^{-1})^k{}_a +
\det F\,\frac{\partial(F^{-1})^k{}_a}{\partial x^k} = 0 \f]
where \f$F\f$ is the gradient of a map, in every dimension. *)
Theorem claim_6_2_cancelling_terms a : F \in unitmx ->
  \sum_k D k (\det F) * invmx F k a + \sum_k \det F * D k (invmx F k a) = 0.
Proof.
move=> unit_F; rewrite -big_split -[RHS](divergence_of_cofactors a section); apply: eq_bigr => k _ /=.
rewrite -leibniz; congr (D k _); rewrite /invmx unit_F [X in _ * X]mxE mulrA divrr ?mul1r //.
Qed.

(** The three lines, without the inertia that all of them begin with: the first, the middle with
\f$\partial\sqrt{\det g}/\partial x^k\f$ and with what is printed there, and the last. *)
Definition first_line P a : R := - (root_G^-1 * \sum_k D k (- (P * areas k a * root_G))).
Definition middle_line P a : R :=
  \sum_k D k P * areas k a + P / root_G * \sum_k (\adj F) k a * D k root_g.
Definition printed_middle_line P a : R :=
  \sum_k D k P * areas k a + P / root_G * \sum_k (\adj F) k a * D k (\det g).
Definition last_line P a : R :=
  \sum_k D k P * areas k a + 2%:R^-1 * P * J * \tr (invmx g *m derivative_of (d_y a) g).

(** The first two lines agree by Piola's identity. *)
Lemma first_and_middle_line P a : first_line P a = middle_line P a.
Proof.
have cofactor_form k : areas k a * root_G = root_g * (\adj F) k a.
  rewrite /areas /area_transformation mxE.
  have -> : root_g / root_G * (\adj F) k a * root_G = root_G / root_G * (root_g * (\adj F) k a) by
    ring_identity.
  by rewrite divrr // mul1r.
have areaE k : areas k a = root_G^-1 * (root_g * (\adj F) k a).
  by rewrite -cofactor_form mulrC mulrK.
rewrite /first_line /middle_line -mulrN -sumrN.
have -> : \sum_k - D k (- (P * areas k a * root_G))
  = \sum_k D k P * (root_g * (\adj F) k a) + P * (\sum_k (\adj F) k a * D k root_g)
    + P * root_g * (\sum_k D k ((\adj F) k a)).
  rewrite !mulr_sumr -!big_split; apply: eq_bigr => k _ /=.
  rewrite raddfN /= opprK -mulrA cofactor_form !leibniz; ring_identity.
rewrite (divergence_of_cofactors a section) mulr0 addr0 mulrDr; congr (_ + _); last by ring_identity.
by rewrite mulr_sumr; apply: eq_bigr => k _; rewrite areaE; ring_identity.
Qed.

Lemma slopes_of_root a :
  2%:R * (\sum_k (\adj F) k a * D k root_g)
  = \det F * root_g * \tr (invmx g *m derivative_of (d_y a) g).
Proof.
have root k : 2%:R * D k root_g = root_g * (\sum_b F b k * \tr (invmx g *m derivative_of (d_y b) g)).
  rewrite (derivative_of_root (D k) root_of_g unit_g); congr (_ * _).
  have -> : derivative_of (D k) g = \sum_b F b k *: derivative_of (d_y b) g.
    by apply/matrixP => b c; rewrite summxE mxE along_section; apply: eq_bigr => e _; rewrite !mxE.
  rewrite mulmx_sumr raddf_sum; apply: eq_bigr => b _ /=; rewrite -scalemxAr mxtraceZ.
  by [].
have -> : 2%:R * (\sum_k (\adj F) k a * D k root_g)
  = root_g * (\sum_b (F *m \adj F) b a * \tr (invmx g *m derivative_of (d_y b) g)).
  rewrite mulr_sumr; under eq_bigr do rewrite mulrCA root mulrCA mulr_sumr.
  rewrite -mulr_sumr exchange_big; congr (_ * _); apply: eq_bigr => b _; rewrite mxE mulr_suml.
  by apply: eq_bigr => k _; ring_identity.
rewrite mul_mx_adj (bigD1 a) //= big1 => [|b ne]; last by rewrite mxE (negbTE ne) mul0r.
rewrite mxE eqxx addr0 /= mulr1n; ring_identity.
Qed.

Lemma middle_and_last_line P a : middle_line P a = last_line P a.
Proof.
rewrite /middle_line /last_line; congr (_ + _).
have -> : \sum_k (\adj F) k a * D k root_g
          = 2%:R^-1 * (\det F * root_g * \tr (invmx g *m derivative_of (d_y a) g)).
  by rewrite -slopes_of_root mulrA mulVr // mul1r.
rewrite /J /jacobian; ring_identity.
Qed.

(** ** The left side for a barotropic fluid, in three lines

(6.17), without the inertial term: with \f$\det F\,(F^{-1})^k{}_a\f$ for the cofactors and the root of
\f$\det g\f$ in the middle line, the three lines are one, for every function \f$P\f$. *)
Theorem eq_6_17 P a : first_line P a = middle_line P a /\ middle_line P a = last_line P a.
Proof. by rewrite first_and_middle_line middle_and_last_line. Qed.

(** The first expression equals the last. *)
Theorem claim_6_2_barotropic_expansion_end P a : first_line P a = last_line P a.
Proof. by rewrite first_and_middle_line middle_and_last_line. Qed.

(** The slopes of a function \f$P = p\circ\phi\f$ of the point of space: \f$\frac{\partial P}{\partial
x^k}\,J\,(F^{-1})^k{}_a = J\,\frac{\partial p}{\partial y^a}\f$. *)
Lemma slope_in_space P (slope : 'I_n -> R) a :
    (forall k, D k P = \sum_b F b k * slope b) ->
  \sum_k D k P * areas k a = J * slope a.
Proof.
move=> chain; have -> : \sum_k D k P * areas k a = root_g / root_G * (\sum_b slope b * (F *m \adj F) b a).
  rewrite mulr_sumr; under [RHS]eq_bigr do rewrite mxE mulr_sumr mulr_sumr.
  rewrite [RHS]exchange_big; apply: eq_bigr => k _; rewrite chain mulr_suml; apply: eq_bigr => b _.
  rewrite /areas /area_transformation [X in _ * X = _]mxE; ring_identity.
rewrite mul_mx_adj (bigD1 a) //= big1 => [|b ne]; last by rewrite mxE (negbTE ne) mulr0.
rewrite mxE eqxx addr0 /= mulr1n /J /jacobian; ring_identity.
Qed.

End Barotropic.

(** In the printed middle line of (6.17) the root is missing over \f$\det g\f$. It fails on a line, for the
identical motion and \f$P = 1\f$, where the volume of space is \f$1 + \varepsilon\f$: the two lines are
\f$\varepsilon\f$ and \f$2\varepsilon\f$. *)
Theorem eq_6_17_printed_fails :
  ~ (forall (R : comUnitRingType) n (F g : 'M[R]_n) (root_g root_G : R) (D d_y : 'I_n ->
    derivation R) (P : R),
      root_g ^+ 2 = \det g -> root_g \is a GRing.unit -> root_G \is a GRing.unit ->
      is_gradient D F -> (forall k b c, D k (g b c) = \sum_a F a k * d_y a (g b c)) ->
      forall a, first_line F root_g root_G D P a = printed_middle_line F g root_g root_G D P a).
Proof.
move=> claim; pose R := with_small_part_comUnitRingType [comUnitRingType of rat].
pose r : R := (1, 1); pose D (_ : 'I_1) := derivation_of_small_part [comUnitRingType of rat].
have unit_r : r \is a GRing.unit by [].
have gradient : is_gradient D (1%:M : 'M[R]_1) by move=> k a i; rewrite (ord1 k) (ord1 i).
have along k (b c : 'I_1) : D k ((r ^+ 2)%:M b c) = \sum_a (1%:M : 'M[R]_1) a k * D a ((r ^+ 2)%:M b c).
  by rewrite big_ord1 (ord1 k) [X in _ = X * _]mxE mul1r.
have root : r ^+ 2 = \det ((r ^+ 2)%:M : 'M[R]_1) by rewrite det_scalar1.
have := claim R 1%N 1%:M ((r ^+ 2)%:M) r 1 D D 1 root unit_r (unitr1 _) gradient along 0.
rewrite first_and_middle_line ?unitr1 // /middle_line /printed_middle_line.
rewrite !big_ord1 adjugate_of_one [1%:M 0 0]mxE det_scalar1 eqxx divr1 !mul1r => /addrI equal.
have : (1 : rat) = 1 * 1 + 1 * 1 := congr1 (fun f : R => f.2) equal.
by rewrite !mul1r => /eqP; vm_compute.
Qed.

(** ** Fluids in motion *)

Section Fluids.

Variables (R : comUnitRingType) (n : nat).
Variables (v : 'I_n -> 'I_n.+1 -> R) (d_y : 'I_n -> derivation R) (d_v : 'I_n -> 'I_n.+1 -> derivation R)
          (D : 'I_n.+1 -> derivation R).
Variables (rho : R) (g : 'M[R]_n) (root_g root_G W : R).

(** The deformation gradient as a matrix, the Jacobian and \f$J\,(F^{-1})^k{}_a\f$ at a jet. *)
Definition gradient_matrix : 'M[R]_n := \matrix_(a, k) gradient_of v a k.
Let F := gradient_matrix.
Let J := jacobian F root_g root_G.
Let areas := area_transformation F root_g root_G.
Let D_body (k : 'I_n) := D (along_body k).

(** A medium whose body has the dimension of its space, and whose section has commuting second derivatives;
its metric is a function of the point of space. *)
Variable W_g : 'M[R]_n.
Hypothesis medium : is_medium v d_y d_v D rho root_G g W W_g.
Hypothesis root_of_g : root_g ^+ 2 = \det g.
Hypothesis unit_g : root_g \is a GRing.unit.
Hypothesis root_g_v : forall a mu, d_v a mu root_g = 0.
Hypothesis mixed : forall k a i, D_body k (gradient_of v a i) = D_body i (gradient_of v a k).

Let unit2 := two_is_unit medium.
Let unit_G := volume_is_unit medium.

Lemma gradient_of_section : is_gradient D_body F.
Proof. by move=> k a i; rewrite !mxE; apply: mixed. Qed.

Lemma metric_along_section k b c : D_body k (g b c) = \sum_a F a k * d_y a (g b c).
Proof. by rewrite /D_body (space_D medium); apply: eq_bigr => a _; rewrite mxE. Qed.

Lemma gradient_in_gradient a k : derivative_of (d_v a (along_body k)) F = delta_mx a k.
Proof.
apply/matrixP => b i; rewrite [LHS]mxE (mxE matrix_key) (velocity_coordinates medium) [RHS]mxE.
by rewrite /along_body (inj_eq lift_inj).
Qed.

Lemma gradient_in_velocity a : derivative_of (d_v a ord0) F = 0.
Proof.
apply/matrixP => b i; rewrite [LHS]mxE (mxE matrix_key) (velocity_coordinates medium) [RHS]mxE.
by rewrite [along_body _ == _]eq_sym (negbTE (neq_lift _ _)) andbF.
Qed.

Lemma gradient_in_place a : derivative_of (d_y a) F = 0.
Proof. by apply/matrixP => b i; rewrite [LHS]mxE (mxE matrix_key) (place_coordinates medium) [RHS]mxE. Qed.

(** The derivatives of \f$J\f$ at a jet. *)
Lemma jacobian_in_gradient a k : d_v a (along_body k) J = areas k a.
Proof.
rewrite (derivative_in_gradient F unit_G) ?gradient_in_gradient ?root_g_v ?(body_v medium _ _).2 //.
have entry i : (areas *m delta_mx a k) i i = (i == k)%:R * areas i a.
  rewrite mxE (bigD1 a) //= (mxE delta_mx_key) eqxx big1 ?addr0 => [|l ne]; last first.
    by rewrite (mxE delta_mx_key) (negbTE ne) mulr0.
  by rewrite mulrC.
by rewrite /mxtrace (bigD1 k) //= entry eqxx mul1r big1 ?addr0 // => i ne; rewrite entry (negbTE ne) mul0r.
Qed.

Lemma jacobian_in_velocity a : d_v a ord0 J = 0.
Proof.
rewrite (derivative_in_gradient F unit_G) ?gradient_in_velocity ?root_g_v ?(body_v medium _ _).2 //.
by rewrite mulmx0 mxtrace0.
Qed.

Lemma jacobian_in_place a : d_y a J = 2%:R^-1 * J * \tr (invmx g *m derivative_of (d_y a) g).
Proof.
have := derivative_in_metric root_of_g unit_g unit_G (gradient_in_place a) (body_y medium a).2.
by rewrite -/J -mulrA => <-; rewrite mulrA mulVr // mul1r.
Qed.

(** What the pressure adds to the field equations: the derivative of \f$P\sqrt{\det G}\,J\f$ with
\f$P\sqrt{\det G}\f$ held, minus the divergence of \f$P\sqrt{\det G}\,\partial J/\partial v\f$. The terms with
derivatives of the metric cancel. *)
Lemma field_equation_of_pressure P a :
  P * root_G * d_y a J - \sum_k D_body k (P * areas k a * root_G) = - (root_G * \sum_k D_body k P * areas k
    a).
Proof.
have := claim_6_2_barotropic_expansion_end root_of_g unit_g unit_G unit2 gradient_of_section
  metric_along_section P a.
rewrite /first_line /last_line -/areas => expansion.
have first : root_G * (\sum_k D_body k P * areas k a + 2%:R^-1 * P * J * \tr (invmx g *m derivative_of (d_y
  a) g))
             = \sum_k D_body k (P * areas k a * root_G).
  rewrite -expansion mulrN mulrA mulrV // mul1r -sumrN; apply: eq_bigr => k _.
  by rewrite raddfN opprK.
rewrite -first jacobian_in_place; ring_identity.
Qed.

(** ** The equation of a barotropic fluid

(6.18): for \f$W = W(J, x)\f$ with the pressure \f$P = -\rho\,\partial W/\partial J\f$
\f[ \rho\,g_{ab}\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b =
-\frac{\partial P}{\partial x^k}\,J\,(F^{-1})^k{}_a , \f]
with a mass density that may vary: the Euler-Lagrange derivative is \f$-\sqrt{\det G}\f$ times the difference
of the two sides. *)
Theorem eq_6_18 W_J a :
    (forall b k, d_v b (along_body k) W = W_J * d_v b (along_body k) J) ->
    (forall b, d_y b W = W_J * d_y b J) ->
  euler_lagrange d_y d_v D (medium_density v rho root_G g W) a
  = - (root_G * (rho * (\sum_b g a b * acceleration v d_y D g b)
                 + \sum_k D_body k (material_pressure rho W_J) * areas k a)).
Proof.
move=> chain_v chain_y; rewrite (eq_6_13 medium) -(energy_y medium) chain_y.
pose P := material_pressure rho W_J; have := field_equation_of_pressure P a.
have -> : \sum_k D_body k (P * areas k a * root_G)
          = - (\sum_k D (along_body k) (rho * energy_slope d_v W a k * root_G)).
  rewrite -sumrN; apply: eq_bigr => k _; rewrite /energy_slope chain_v jacobian_in_gradient -raddfN.
  congr (D_body k _); rewrite /P /material_pressure; ring_identity.
rewrite opprK => pressure.
set Z := \sum_k D _ _; set A := \sum_b _.
rewrite mulrDr mulrBr [root_G * (root_G^-1 * Z)]mulrA mulrV // mul1r -/P.
have -> : root_G * (rho * (W_J * d_y a J)) = - (P * root_G * d_y a J).
  rewrite /P /material_pressure; ring_identity.
rewrite mulrDr -[root_G * \sum_k _]opprK -pressure -/Z; ring_identity.
Qed.

(** ** The equation with spatial density and spatial pressure

Where \f$P = p\circ\phi\f$ is a function of the point of space the field equations of a barotropic fluid say
that
\f[ \frac{D_gV}{Dt} = -\frac1{\rho_{\mathrm{sp}}}\,\mathrm{grad}\,p\circ\phi , \qquad
\rho_{\mathrm{sp}} = \rho/J , \f]
with the gradient of the metric \f$g\f$. *)
Theorem claim_6_2_barotropic_spatial_form W_J (slope : 'I_n -> R) : rho \is a GRing.unit ->
    (forall b k, d_v b (along_body k) W = W_J * d_v b (along_body k) J) ->
    (forall b, d_y b W = W_J * d_y b J) ->
    (forall k, D_body k (material_pressure rho W_J) = \sum_b F b k * slope b) ->
  (forall a, euler_lagrange d_y d_v D (medium_density v rho root_G g W) a = 0)
  <-> (forall b, acceleration v d_y D g b = - (J / rho * \sum_a invmx g b a * slope a)).
Proof.
move=> unit_rho chain_v chain_y chain_p; have unit_metric := metric_is_regular medium.
pose acc : 'cV[R]_n := \col_b acceleration v d_y D g b; pose p : 'cV[R]_n := \col_a slope a.
have fieldE a : euler_lagrange d_y d_v D (medium_density v rho root_G g W) a
                = - (root_G * (rho * (g *m acc) a 0 + J * slope a)).
  rewrite (eq_6_18 a chain_v chain_y) -/areas.
  rewrite (slope_in_space root_g root_G a chain_p) mxE; congr (- (_ * (_ * _ + _))).
  by apply: eq_bigr => b _; rewrite mxE.
have rightE b : - (J / rho * \sum_a invmx g b a * slope a) = (- (J / rho) *: (invmx g *m p)) b 0.
  by rewrite mxE mulNr mxE; congr (- (_ * _)); apply: eq_bigr => a _; rewrite mxE.
split=> [solves b|law a].
  have lowered : g *m acc = - (J / rho) *: p.
    apply/matrixP => a z; rewrite (ord1 z) [RHS]mxE [p a 0]mxE; have := solves a; rewrite fieldE => /eqP.
    rewrite oppr_eq0 => /eqP /(congr1 ( *%R root_G^-1)); rewrite mulKr // mulr0 => /eqP.
    rewrite addr_eq0 => /eqP /(congr1 ( *%R rho^-1)); rewrite mulKr // => ->; ring_identity.
  have : acc = - (J / rho) *: (invmx g *m p) by rewrite scalemxAr -lowered mulmxA mulVmx // mul1mx.
  by rewrite rightE => /matrixP /(_ b 0); rewrite mxE.
have : acc = - (J / rho) *: (invmx g *m p) by apply/matrixP => b z; rewrite (ord1 z) -rightE mxE law.
rewrite fieldE => ->; rewrite -scalemxAr mulmxA mulmxV // mul1mx !mxE.
have -> : rho * (- (J / rho) * slope a) = - (rho / rho * (J * slope a)) by ring_identity.
by rewrite divrr // mul1r addNr mulr0 oppr0.
Qed.

End Fluids.
