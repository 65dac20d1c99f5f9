(** * What the steps of the body conserve, and how long they may be

Chapters 1 and 5 of the thesis: the integrals of the scheme of Moser and Veselov, and the half of its longest
step that is algebra, with the conventions of the file on the body. *)

From Coq Require Import Ring Qcanon.
From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices computed slopes rigid_body body_multipliers moser_veselov.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.
(** ** What the scheme conserves

Chapter 1 calls the scheme of Moser and Veselov completely integrable. The integrals are proved here, for
bodies of any size: the matrices \f$1 - sM - s^2\Lambda^2\f$ before and after a step have two factors in
common, in one order and in the other. That the integrals are in involution, how many of them are
independent, and that the step is a Poisson map is not proved here. *)

Section Spectra.

Variables (R : comRingType) (n : nat).

Add Ring laws_for_spectra : (laws_of_a_ring R).

Implicit Types (A B f L M : 'M[R]_n) (z s : R).

(* Over a field this is a well-known exercise; over a ring, two factorizations of one matrix of blocks. *)
Lemma characteristic_polynomial_exchanged A B : char_poly (A *m B) = char_poly (B *m A).
Proof.
pose a := map_mx polyC A; pose b := map_mx polyC B; pose x : 'M[{poly R}]_n := 'X%:M.
pose whole := block_mx x a b 1%:M.
have from_the_right : \det whole = char_poly (A *m B).
  pose factor := block_mx 1%:M 0 (- b) 1%:M.
  have -> : \det whole = \det (whole *m factor) by rewrite det_mulmx det_lblock !det1 !mulr1.
  rewrite mulmx_block !(mulmx0, mulmx1, mul1mx, add0r) mulmxN subrr det_ublock det1 mulr1.
  by rewrite /char_poly /char_poly_mx map_mxM.
have from_the_left : 'X ^+ n * \det whole = 'X ^+ n * char_poly (B *m A).
  pose factor := block_mx 1%:M 0 (- b) x.
  have -> : 'X ^+ n * \det whole = \det (factor *m whole).
    by rewrite det_mulmx det_lblock det1 mul1r det_scalar.
  rewrite mulmx_block !(mul0mx, mul1mx, mulmx1, addr0) mulNmx {1}/x scalar_mxC addNr det_ublock det_scalar.
  by rewrite mulNmx addrC /char_poly /char_poly_mx map_mxM.
have /monic_lreg cancel_power : 'X ^+ n \is @monic R by apply: monicXn.
by rewrite -from_the_right; apply: cancel_power.
Qed.

Lemma characteristic_polynomial_at A z : (char_poly A).[z] = \det (z%:M - A).
Proof.
rewrite -horner_evalE -det_map_mx; congr (\det _); apply/matrixP => i j.
by rewrite !mxE /= horner_evalE hornerD hornerN hornerMn hornerX hornerC.
Qed.

Lemma determinant_exchanged A B z : \det (z%:M - A *m B) = \det (z%:M - B *m A).
Proof. by rewrite -!characteristic_polynomial_at characteristic_polynomial_exchanged. Qed.

(** The matrix \f$1 - sM - s^2\Lambda^2\f$.
C++: `actio::lax_matrix`, `rigid_body/isospectral.hpp`. *)
Definition lax_matrix s L M := 1%:M - s *: M - s ^+ 2 *: (L *m L).

(** All integrals together: the polynomial \f$\det(z - M - s\Lambda^2)\f$ in \f$z\f$ and \f$s\f$, of which
the coefficients are the integrals.
C++: `actio::isospectral_integrals`, `rigid_body/isospectral.hpp`. *)
Definition isospectral_integrals L M : {poly {poly R}} :=
  char_poly (map_mx polyC M + 'X *: map_mx polyC (L *m L)).

Lemma lax_factors f L s (M0 := f^T *m L - L *m f) (M1 := L *m f^T - f *m L) :
  f *m f^T = 1%:M ->
  lax_matrix s L M0 = (f^T + s *: L) *m (f - s *: L) /\ lax_matrix s L M1 = (f - s *: L) *m (f^T + s *: L).
Proof.
move=> o; have o' : f^T *m f = 1%:M by apply: mulmx1C.
rewrite /lax_matrix !(mulmxDl, mulmxDr, mulNmx, mulmxN) -?scalemxAl -?scalemxAr o o' scalerA -expr2 /M0 /M1.
by split; compare_entries_in R.
Qed.

Lemma similar_determinants f L z s (M0 := f^T *m L - L *m f) (M1 := L *m f^T - f *m L) :
  GRing.lreg s -> f *m f^T = 1%:M ->
  \det (z%:M - (M0 + s *: (L *m L))) = \det (z%:M - (M1 + s *: (L *m L))).
Proof.
move=> s_regular o; have [first second] := lax_factors L s o.
have s_power : GRing.lreg (s ^+ n) by apply: lregX.
apply: s_power; rewrite -!detZ.
have expand M : s *: (z%:M - (M + s *: (L *m L))) = (s * z - 1)%:M + lax_matrix s L M.
  rewrite scalerBr scale_scalar_mx scalerDr scalerA -expr2 /lax_matrix raddfB /=.
  by compare_entries_in R.
rewrite !expand first second; set A := f^T + _; set B := f - _.
by rewrite -[A *m B]opprK -mulNmx determinant_exchanged mulmxN opprK.
Qed.

End Spectra.

Lemma integrals_kept (R : comRingType) n (f L : 'M[R]_n) :
  f *m f^T = 1%:M ->
  isospectral_integrals L (f^T *m L - L *m f) = isospectral_integrals L (L *m f^T - f *m L).
Proof.
move=> o; rewrite /isospectral_integrals /char_poly /char_poly_mx.
pose raised (a : 'M[R]_n) := map_mx polyC (map_mx polyC a).
have s_regular : GRing.lreg ('X%:P : {poly {poly R}}).
  move=> p q same; apply/polyP => i; apply: (monic_lreg (monicX R)).
  by have := congr1 (fun r : {poly {poly R}} => r`_i) same; rewrite !coefCM.
have raise M : map_mx polyC (map_mx polyC M + 'X *: map_mx polyC (L *m L)) =
    raised M + 'X%:P *: (raised L *m raised L).
  by rewrite /raised map_mxD map_mxZ !map_mxM.
rewrite !raise /raised !(map_mxB, map_mxM) -!map_trmx.
apply: similar_determinants => //.
by rewrite !map_trmx -!map_mxM o !map_mx1.
Qed.

Section Integrals.

Variables (R : comUnitRingType) (n : nat).
Implicit Types (f L M : 'M[R]_n) (d e : 'rV[R]_n) (s : R).

Add Ring laws_for_integrals : (laws_of_a_ring R).

(** ** The two factors

For every orthogonal \f$f\f$, every \f$\Lambda\f$ and every number \f$s\f$,
\f$1 - sM_0 - s^2\Lambda^2 = (f^T + s\Lambda)(f - s\Lambda)\f$ with the momentum before the step, and the
same two factors, exchanged, with the momentum after it. No symmetry of \f$\Lambda\f$ is needed. *)
Theorem claim_1_0_moser_veselov_integrable_factors f L s :
  orthogonal f ->
  lax_matrix s L (momentum_before f L) = (f^T + s *: L) *m (f - s *: L) /\
  lax_matrix s L (momentum_after f L) = (f - s *: L) *m (f^T + s *: L).
Proof. exact: lax_factors. Qed.

(** ** The integrals

Along a motion \f$\det(1 - sM - s^2\Lambda^2)\f$ is conserved for every \f$s\f$, and so is the whole
polynomial \f$\det(z - M - s\Lambda^2)\f$ in the two variables: each of its coefficients is an integral. The
matrix \f$\Lambda\f$ may be any. *)
Theorem claim_1_0_moser_veselov_integrable_determinant f10 f21 L s :
  orthogonal f10 -> discrete_euler_poincare L f10 f21 ->
  \det (lax_matrix s L (momentum_before f21 L)) = \det (lax_matrix s L (momentum_before f10 L)).
Proof.
move=> o motion; rewrite [momentum_before f21 L]motion.
have [before after] := claim_1_0_moser_veselov_integrable_factors L s o.
by rewrite -/(momentum_after f10 L) before after !det_mulmx mulrC.
Qed.

Theorem claim_1_0_moser_veselov_integrable_integrals f10 f21 L :
  orthogonal f10 -> discrete_euler_poincare L f10 f21 ->
  isospectral_integrals L (momentum_before f21 L) = isospectral_integrals L (momentum_before f10 L).
Proof. by move=> o motion; rewrite [momentum_before f21 L]motion [RHS]integrals_kept. Qed.

(** The integrals without \f$\Lambda\f$, the coefficients of \f$\det(z - M)\f$, are kept by every update
\f$f\Pi f^T\f$, whatever the orthogonal \f$f\f$ and the matrix \f$\Pi\f$ are. *)
Theorem claim_5_2_manifest_preservation_casimirs f M :
  orthogonal f -> char_poly (f *m M *m f^T) = char_poly M.
Proof. by move=> o; rewrite characteristic_polynomial_exchanged mulmxA (orthogonal_left o) mul1mx. Qed.

(** The body velocity of a momentum, \f$(J^{-1}M)_{ij} = M_{ij}/(\Lambda_i+\Lambda_j)\f$ for
\f$\Lambda = \mathrm{diag}(d)\f$, and its energy, \f$\tfrac14\mathrm{Tr}(M^TJ^{-1}M)\f$.
C++: `actio::body_velocity`, `actio::kinetic_energy`, `rigid_body/inertia.hpp`. *)
Definition body_velocity d M := \matrix_(i, j) (M i j / (d 0 i + d 0 j)).
Definition energy_of_momentum d M := 4%:R^-1 * pairing M (body_velocity d M).

Lemma body_velocity_inverts d M :
  (forall i j, i != j -> d 0 i + d 0 j \is a GRing.unit) -> (forall i, M i i = 0) ->
  inertia_operator (diag_mx d) (body_velocity d M) = M.
Proof.
move=> sums zero; apply/matrixP => i j; rewrite /inertia_operator mul_diag_mx mul_mx_diag !mxE.
case: (eqVneq i j) => [<-|ne]; first by rewrite zero !mul0r mulr0 addr0.
by rewrite [_ * d 0 j]mulrC -mulrDl mulrC divrK // sums.
Qed.

Lemma sum_of_squares_in_a_row f i : orthogonal f -> \sum_j f i j ^+ 2 = 1.
Proof.
by move/matrixP/(_ i i); rewrite !mxE eqxx mulr1n => <-; apply: eq_bigr => j _; rewrite mxE expr2.
Qed.

Lemma squares_weighted f d : orthogonal f -> \sum_i \sum_j d 0 i * f i j ^+ 2 = \sum_i d 0 i.
Proof. by move=> o; apply: eq_bigr => i _; rewrite -mulr_sumr sum_of_squares_in_a_row // mulr1. Qed.

Lemma squares_weighted_by_column f d : orthogonal f -> \sum_i \sum_j d 0 j * f i j ^+ 2 = \sum_i d 0 i.
Proof.
move=> o; rewrite exchange_big -(squares_weighted d (orthogonal_transpose o)).
by apply: eq_bigr => j _; apply: eq_bigr => i _; rewrite mxE.
Qed.

(** ** The energy

The kinetic energy of the body momentum, the true one and not a discrete one, is the same before and after a
step, in any dimension and for every orthogonal \f$f\f$; so a motion conserves it. The sums
\f$\Lambda_i+\Lambda_j\f$ must have inverses. In the proof,
\f$M_{ij}^2 - M_{ij}'^2 = (\Lambda_j^2-\Lambda_i^2)(f_{ji}^2-f_{ij}^2)\f$ is divided by
\f$\Lambda_i+\Lambda_j\f$, and the rows and columns of \f$f\f$ have length 1. *)
Theorem claim_1_0_moser_veselov_integrable_energy f d (L := diag_mx d) :
  (forall i j, i != j -> d 0 i + d 0 j \is a GRing.unit) -> orthogonal f ->
  energy_of_momentum d (momentum_after f L) = energy_of_momentum d (momentum_before f L).
Proof.
move=> sums o; congr (_ * _).
have entries M V : pairing M V = \sum_i \sum_j M j i * V j i.
  by apply: eq_bigr => i _; rewrite mxE; apply: eq_bigr => j _; rewrite mxE.
have term i j : momentum_after f L j i * body_velocity d (momentum_after f L) j i -
    momentum_before f L j i * body_velocity d (momentum_before f L) j i =
    d 0 j * f i j ^+ 2 - d 0 i * f i j ^+ 2 - (d 0 j * f j i ^+ 2 - d 0 i * f j i ^+ 2).
  rewrite /body_velocity /momentum_after /momentum_before /L !mul_diag_mx !mul_mx_diag !mxE.
  case: (eqVneq i j) => [<-|ne]; first by rewrite [f i i * _]mulrC !subrr.
  have unit : d 0 j + d 0 i \is a GRing.unit by rewrite sums // eq_sym.
  have divide (x y : R) : x * (y / (d 0 j + d 0 i)) * (d 0 j + d 0 i) = x * y by rewrite -mulrA divrK.
  by apply: (mulIr unit); rewrite [LHS]mulrBl !divide; calculate_in R.
apply/eqP; rewrite -subr_eq0 !entries -sumrB; apply/eqP.
under eq_bigr => i _ do (rewrite -sumrB; under eq_bigr => j _ do rewrite term; rewrite !sumrB).
rewrite !sumrB squares_weighted_by_column // squares_weighted //.
rewrite [X in _ - (X - _)]exchange_big [X in _ - (_ - X)]exchange_big /=.
by rewrite squares_weighted // squares_weighted_by_column // !subrr.
Qed.

(** ** One momentum of many relative motions

A momentum does not determine the relative motion: every diagonal matrix of signs is orthogonal and has the
momentum zero, as \f$f=1\f$ has. In the scheme \f$M_k\mapsto\omega_k\f$ of section 5.2 a branch must be
chosen. *)
Theorem claim_5_2_dep_on_group_signs d e :
  (forall i, e 0 i ^+ 2 = 1) ->
  orthogonal (diag_mx e) /\ momentum_before (diag_mx e) (diag_mx d) = 0.
Proof.
move=> signs; split.
  rewrite /orthogonal tr_diag_mx mulmx_diag; apply/matrixP => i j; rewrite !mxE.
  by case: eqP => [->|]; rewrite ?mulr0n // -expr2 signs.
by rewrite /momentum_before tr_diag_mx !mulmx_diag; apply/matrixP => i j; rewrite !mxE mulrC subrr.
Qed.

(** ** The equation of a step as an equation for a square root

For an invertible symmetric \f$\Lambda\f$, to find an orthogonal \f$f\f$ with
\f$f^T\Lambda - \Lambda f = P\f$ is to find a matrix \f$X\f$ with the skew part \f$X - X^T = P\f$ and
\f$X^TX = \Lambda^2\f$: they are related by \f$X = f^T\Lambda\f$. *)
Theorem claim_5_2_solvability_square_root L P :
  L \in unitmx -> symmetric L ->
  (exists2 f, orthogonal f & momentum_before f L = P) <->
  (exists2 X : 'M[R]_n, X - X^T = P & X^T *m X = L *m L).
Proof.
move=> unit L_sym; split=> [[f o <-]|[X <- square]].
  exists (f^T *m L); first by rewrite trmx_mul trmxK L_sym.
  by rewrite trmx_mul trmxK L_sym mulmxA (turn_back _ o).
have inverse_sym : (invmx L)^T = invmx L by rewrite trmx_inv L_sym.
exists (invmx L *m X^T); last by rewrite /momentum_before trmx_mul trmxK inverse_sym mulmxKV // mulKVmx.
by rewrite /orthogonal trmx_mul trmxK inverse_sym -!mulmxA [X^T *m _]mulmxA square -mulmxA mulKmx // mulmxV.
Qed.

(** The inner product of columns, \f$u^Tw\f$. *)
Definition inner_product (u w : 'cV[R]_n) : R := \tr (u^T *m w).

(** ** A square that limits the step

With \f$X = f^T\Lambda\f$ and \f$P = f^T\Lambda - \Lambda f\f$, for all columns \f$u, w\f$ and numbers
\f$s\f$,
\f[ |su + Xw|^2 + |sw - Xu|^2 = s^2(|u|^2+|w|^2) + |\Lambda u|^2 + |\Lambda w|^2 + 2s\,u^TPw . \f]
In complex numbers the right side is the Hermitian form of \f$s^2 + \Lambda^2 - isP\f$ at \f$u + iw\f$, and
the left side is \f$|(s - iX)(u + iw)|^2\f$. *)
Theorem claim_5_2_solvability_square f L (u w : 'cV[R]_n) s (X := f^T *m L) :
  symmetric L -> orthogonal f ->
  inner_product (s *: u + X *m w) (s *: u + X *m w) + inner_product (s *: w - X *m u) (s *: w - X *m u) =
  s ^+ 2 * (inner_product u u + inner_product w w)
  + (inner_product (L *m u) (L *m u) + inner_product (L *m w) (L *m w))
  + 2%:R * s * inner_product u (momentum_before f L *m w).
Proof.
move=> L_sym o.
have square v w' : inner_product (X *m v) (X *m w') = inner_product (L *m v) (L *m w').
  by rewrite /inner_product /X !trmx_mul trmxK L_sym !mulmxA (turn_back _ o).
have expand v w' t : inner_product (s *: v + t *: (X *m w')) (s *: v + t *: (X *m w')) =
    s ^+ 2 * inner_product v v + t ^+ 2 * inner_product (L *m w') (L *m w') +
    2%:R * s * t * inner_product v (X *m w').
  have sym : inner_product (X *m w') v = inner_product v (X *m w').
    by rewrite /inner_product -[LHS]mxtrace_tr [in LHS]trmx_mul trmxK.
  rewrite -square {1}/inner_product [(_ + _)^T]linearD /= [(s *: _)^T]linearZ [(t *: _)^T]linearZ /=.
  rewrite mulmxDl !mulmxDr -?scalemxAl -?scalemxAr -?scalemxAl !mxtraceD !mxtraceZ.
  by rewrite -!/(inner_product _ _) sym; calculate_in R.
rewrite -[X *m w]scale1r expand -[- (X *m u)]scaleN1r expand.
have -> : inner_product w (X *m u) = inner_product u (X^T *m w).
  by rewrite /inner_product -[LHS]mxtrace_tr trmx_mul [(X *m u)^T]trmx_mul trmxK mulmxA.
have -> : inner_product u (momentum_before f L *m w) = inner_product u (X *m w) - inner_product u (X^T *m w).
  by rewrite /momentum_before /inner_product mulmxBl mulmxBr [LHS]linearB /= /X trmx_mul trmxK L_sym.
by calculate_in R.
Qed.

End Integrals.

(** ** Steps that are too long

Over ordered numbers a square is not negative. So where (5.7) has a solution with \f$h\f$ times the momentum
\f$M\f$, \f$f^T\Lambda - \Lambda f = hM\f$, the form
\f$s^2(|u|^2+|w|^2) + |\Lambda u|^2 + |\Lambda w|^2 + 2sh\,u^TMw\f$ is nowhere negative: for longer steps,
where it is, there is _no_ solution. This is one half of the formula for the largest step,
\f$1/h_{\max} = \max_{s>0}s\,\rho\big((s^2+\Lambda^2)^{-1/2}\,iM\,(s^2+\Lambda^2)^{-1/2}\big)\f$, and it
needs no sign of \f$\Lambda\f$.
C++: `actio::largest_step`, `rigid_body/largest_step.hpp`. *)

Section LongestStep.

Import Order.TTheory Num.Theory.

Variables (F : realFieldType) (n : nat).

Theorem claim_5_2_solvability_bound h (f L M : 'M[F]_n) :
  symmetric L -> orthogonal f -> momentum_before f L = h *: M ->
  forall (u w : 'cV[F]_n) (s : F),
  0 <= s ^+ 2 * (inner_product u u + inner_product w w)
       + (inner_product (L *m u) (L *m u) + inner_product (L *m w) (L *m w))
       + 2%:R * s * h * inner_product u (M *m w).
Proof.
move=> L_sym o is_hM u w s.
have positive (v : 'cV[F]_n) : 0 <= inner_product v v.
  by apply: sumr_ge0 => i _; rewrite mxE; apply: sumr_ge0 => j _; rewrite mxE -expr2 sqr_ge0.
have -> : 2%:R * s * h * inner_product u (M *m w) = 2%:R * s * inner_product u (momentum_before f L *m w).
  by rewrite is_hM /inner_product -scalemxAl -scalemxAr mxtraceZ mulrA.
by rewrite -(claim_5_2_solvability_square u w s L_sym o) addr_ge0.
Qed.

End LongestStep.
