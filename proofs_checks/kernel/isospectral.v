(** * Isospectral steps: the vorticity of an ideal fluid as a matrix

Chapters 1 and 10 of the thesis name as an ultimate objective schemes for the vorticity of an ideal fluid that
keep all the known first integrals: the Casimirs, which are the moments of the vorticity, with energy and
angular momentum. On the sphere the vorticity can be read as a matrix \f$W\f$, the stream function as a matrix
\f$P\f$ with \f$\Delta P = W\f$, and Euler's equation as \f$\dot W = [P, W]\f$, the Lie-Poisson equation of a
group of matrices. This page is about the discrete Lie-Poisson algorithm of chapter 3 for that equation, with
the Cayley map in place of the exponential map: what a step conserves, and what has to be assumed for it.
Matrices have any size, and their entries lie in any commutative ring. *)

From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices ring_identities derivations rigid_body rotations.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

(* Products are expanded; what is left is an equation between sums of products, which holds entry by entry. *)
Ltac expanded :=
  rewrite ?(mulmxDl, mulmxDr, mulmxBl, mulmxBr, mulNmx, mulmxN, mul1mx, mulmx1, mulmxA, mulr2n).
Ltac named_products :=
  repeat match goal with |- context [?a *m ?b] => let x := fresh in set x := a *m b; clearbody x end.

Ltac by_expansion :=
  expanded; named_products; apply/matrixP => ? ?; rewrite !mxE; ring_identity.

(* det(t - XY) = det(t - YX), both from the determinant of a matrix of four blocks. *)
Lemma det_exchange (S : comRingType) n (t : S) (X Y : 'M[S]_n) :
  GRing.lreg t -> \det (t%:M - X *m Y) = \det (t%:M - Y *m X).
Proof.
move=> regular; apply: (@lregX _ t n regular).
have left : \det (block_mx t%:M X Y 1%:M) = \det (t%:M - X *m Y).
  rewrite -[LHS]mulr1 -[X in _ * X = _](_ : \det (block_mx 1%:M 0 (- Y) (1%:M : 'M_n)) = 1); last first.
    by rewrite det_lblock !det1 mulr1.
  rewrite -det_mulmx mulmx_block !mulmx1 !mulmx0 !mul1mx !add0r addrN mulmxN.
  by rewrite det_ublock det1 mulr1.
have := det_mulmx (block_mx 1%:M 0 (- Y) t%:M) (block_mx t%:M X Y 1%:M).
rewrite det_lblock det1 mul1r det_scalar left mulmx_block !mul1mx !mul0mx !addr0 mulmx1 mulNmx.
rewrite (scalar_mxC t Y) addNr mulNmx [in LHS]addrC.
by rewrite det_ublock det_scalar => <-.
Qed.

Lemma char_poly_exchange (S : comRingType) n (X Y : 'M[S]_n) : char_poly (X *m Y) = char_poly (Y *m X).
Proof.
rewrite /char_poly /char_poly_mx !map_mxM; apply: det_exchange.
by apply: monic_lreg; apply: monicX.
Qed.

Section Step.

Variables (R : comUnitRingType) (n : nat).
Implicit Types A P Q U W X Y Wt : 'M[R]_n.

(** ** A step *)

(** A step is made of two matrices: \f$A\f$, which moves, and \f$\tilde W\f$, the vorticity half-way. The
vorticity before the step is \f$W_0 = (1 - A)\tilde W(1 + A)\f$. *)
Definition vorticity_before A Wt := (1%:M - A) *m Wt *m (1%:M + A).

(** The vorticity after the step is \f$W_1 = (1 + A)\tilde W(1 - A)\f$. *)
Definition vorticity_after A Wt := (1%:M + A) *m Wt *m (1%:M - A).

(** The Cayley map, \f$\mathrm{cay}(A) = (1 - A)^{-1}(1 + A)\f$; the library's takes \f$2A\f$.
C++: `actio::cayley`, `groups/matrix_group.hpp`. *)
Definition cayley A := invmx (1%:M - A) *m (1%:M + A).

(** The power \f$W^k\f$. *)
Definition power W k := iter k (mulmx W) 1%:M.

(** The Casimir functions, or moments of the vorticity: \f$C_k = \mathrm{Tr}(W^k)\f$. For \f$k = 2\f$ it is
the enstrophy. *)
Definition casimir k W := \tr (power W k).

Lemma one_pm_commute A : (1%:M - A) *m (1%:M + A) = (1%:M + A) *m (1%:M - A).
Proof. by by_expansion. Qed.

(** ** The increment of a step

\f[ W_1 - W_0 = 2\,[A, \tilde W] . \f]
So a step is the midpoint rule for \f$\dot W = [P, W]\f$ with \f$A = \frac{\Delta t}2P\f$. Nothing is assumed
of \f$A\f$ and \f$\tilde W\f$. *)
Theorem step_increment A Wt : vorticity_after A Wt - vorticity_before A Wt = bracket A Wt *+ 2.
Proof. by rewrite /vorticity_after /vorticity_before /bracket; by_expansion. Qed.

(** ** The mean of a step

\f[ W_0 + W_1 = 2(\tilde W - A\tilde WA), \qquad W_0 + [A, \tilde W] = \tilde W - A\tilde WA . \f]
The second equation names one half of the first without dividing by 2: the mean of the two vorticities is not
\f$\tilde W\f$, but differs from it by \f$A\tilde WA\f$. *)
Theorem step_mean A Wt :
  vorticity_before A Wt + vorticity_after A Wt = (Wt - A *m Wt *m A) *+ 2 /\
  vorticity_before A Wt + bracket A Wt = Wt - A *m Wt *m A.
Proof. by rewrite /vorticity_after /vorticity_before /bracket; split; by_expansion. Qed.

(** ** The equation for the vorticity half-way

A step from a given \f$W_0\f$ solves \f$W_0 = (1 - A)\tilde W(1 + A)\f$. The equation is the fixed-point
equation \f$\tilde W = W_0 + [A, \tilde W] + A\tilde WA\f$, which needs products of matrices alone. *)
Theorem step_fixed_point A W Wt :
  W = vorticity_before A Wt <-> Wt = W + bracket A Wt + A *m Wt *m A.
Proof.
have [_ mean] := step_mean A Wt; split=> [-> | fixed].
  by rewrite mean subrK.
by apply: (addIr (bracket A Wt)); rewrite mean; apply/eqP; rewrite eq_sym subr_eq; apply/eqP.
Qed.

(** ** The step in reverse

Minus \f$A\f$ exchanges the vorticities before and after: the scheme is symmetric in time. *)
Theorem step_reversed A Wt :
  vorticity_before (- A) Wt = vorticity_after A Wt /\ vorticity_after (- A) Wt = vorticity_before A Wt.
Proof. by rewrite /vorticity_after /vorticity_before opprK. Qed.

(** ** A step is a conjugation, without an inverse

\f[ (1 - A)\,W_1\,(1 + A) = (1 + A)\,W_0\,(1 - A) . \f]
Both sides are \f$(1 - A)(1 + A)\,\tilde W\,(1 - A)(1 + A)\f$. Neither \f$1 - A\f$ nor \f$1 + A\f$ needs an
inverse. *)
Theorem step_without_inverse A Wt :
  (1%:M - A) *m vorticity_after A Wt *m (1%:M + A) = (1%:M + A) *m vorticity_before A Wt *m (1%:M - A).
Proof.
rewrite /vorticity_after /vorticity_before !mulmxA one_pm_commute -!mulmxA.
by rewrite one_pm_commute !mulmxA.
Qed.

Lemma cayley_commute A : 1%:M - A \in unitmx -> cayley A = (1%:M + A) *m invmx (1%:M - A).
Proof.
move=> unit; rewrite -[LHS](mulmxK unit) /cayley -[X in X *m _ = _]mulmxA.
by rewrite -one_pm_commute mulKmx.
Qed.

Lemma cayley_left A : 1%:M - A \in unitmx -> (1%:M - A) *m cayley A = 1%:M + A.
Proof. by move=> unit; rewrite /cayley mulKVmx. Qed.

Lemma cayley_right A : 1%:M - A \in unitmx -> cayley A *m (1%:M - A) = 1%:M + A.
Proof. by move=> unit; rewrite cayley_commute // mulmxKV. Qed.

Lemma cayley_inverse A :
  1%:M - A \in unitmx -> 1%:M + A \in unitmx -> cayley A *m cayley (- A) = 1%:M.
Proof.
move=> minus plus; have unit : 1%:M - - A \in unitmx by rewrite opprK.
by rewrite /cayley opprK mulmxA -[X in X *m _ = _]mulmxA mulmxV // mulmx1 mulVmx.
Qed.

Lemma cayley_unit A : 1%:M - A \in unitmx -> 1%:M + A \in unitmx -> cayley A \in unitmx.
Proof. by move=> minus plus; case: (mulmx1_unit (cayley_inverse minus plus)). Qed.

Lemma cayley_inv A :
  1%:M - A \in unitmx -> 1%:M + A \in unitmx -> invmx (cayley A) = cayley (- A).
Proof.
move=> minus plus; have unit := cayley_unit minus plus.
by rewrite -[RHS](mulKmx unit) cayley_inverse // mulmx1.
Qed.

(** ** A step is a conjugation by the Cayley map

With \f$U = \mathrm{cay}(A)\f$ and an inverse of \f$1 - A\f$ alone, \f$W_1U = UW_0\f$. Where \f$1 + A\f$ has
an inverse as well, \f$W_1 = UW_0U^{-1} = \mathrm{Ad}_UW_0\f$. Neither matrix has to be skew. *)
Theorem step_conjugates A Wt : 1%:M - A \in unitmx ->
  vorticity_after A Wt *m cayley A = cayley A *m vorticity_before A Wt /\
  (1%:M + A \in unitmx -> vorticity_after A Wt = Ad (cayley A) (vorticity_before A Wt)).
Proof.
move=> minus; have turned : vorticity_after A Wt *m cayley A = cayley A *m vorticity_before A Wt.
  rewrite {1}/cayley (cayley_commute minus) /vorticity_after /vorticity_before.
  (* Both sides are (1 + A) Wt (1 + A). *)
  by rewrite !mulmxA -[X in X *m _ = _]mulmxA mulmxV // mulmx1 -[X in _ = X *m _ *m _]mulmxA mulVmx // mulmx1.
by split=> // plus; rewrite /Ad -turned mulmxK // cayley_unit.
Qed.

Lemma powerS W k : power W k.+1 = W *m power W k.
Proof. by []. Qed.

Lemma powerSr W k : power W k.+1 = power W k *m W.
Proof.
elim: k => [|k hyp]; first by rewrite /power /= mulmx1 mul1mx.
by rewrite powerS {1}hyp mulmxA -powerS.
Qed.

Lemma power_exchange X Y k : power (X *m Y) k.+1 = X *m power (Y *m X) k *m Y.
Proof.
elim: k => [|k hyp]; first by rewrite /power /= !mulmx1.
by rewrite [LHS]powerS hyp [power (Y *m X) k.+1]powerS !mulmxA.
Qed.

Lemma casimir_exchange X Y k : casimir k (X *m Y) = casimir k (Y *m X).
Proof.
case: k => [//|k]; rewrite /casimir power_exchange mxtrace_mulC mulmxA.
by rewrite mxtrace_mulC -powerSr.
Qed.

(** ** All Casimirs are conserved

\f[ \mathrm{Tr}(W_1^k) = \mathrm{Tr}(W_0^k) \quad\text{for every } k . \f]
Nothing is assumed: no inverse, no symmetry of \f$A\f$ or \f$\tilde W\f$, no relation between the two. So the
Casimirs hold for every choice of \f$A\f$, and for every error in it. *)
Theorem casimirs_conserved A Wt k : casimir k (vorticity_after A Wt) = casimir k (vorticity_before A Wt).
Proof.
(* Tr((XY)^k) = Tr((YX)^k), and 1 - A commutes with 1 + A. *)
rewrite /vorticity_after /vorticity_before [LHS]casimir_exchange [RHS]casimir_exchange.
by rewrite !mulmxA one_pm_commute.
Qed.

(** ** The spectrum is conserved

\f[ \det(z - W_1) = \det(z - W_0) \f]
as polynomials in \f$z\f$, again without any hypothesis. Where 2, 3, ..., n have no inverse this says more
than the moments do; it holds for matrices that cannot be brought to diagonal form as well. *)
Theorem spectrum_conserved A Wt : char_poly (vorticity_after A Wt) = char_poly (vorticity_before A Wt).
Proof.
rewrite /vorticity_after /vorticity_before [LHS]char_poly_exchange [RHS]char_poly_exchange.
by rewrite !mulmxA one_pm_commute.
Qed.

(** ** A step from any position

A turn \f$g\f$ of \f$A\f$ and \f$\tilde W\f$ turns the vorticities before and after. For \f$g\f$ any matrix
with an inverse. *)
Theorem step_equivariant (g : 'M[R]_n) A Wt : g \in unitmx ->
  vorticity_before (Ad g A) (Ad g Wt) = Ad g (vorticity_before A Wt) /\
  vorticity_after (Ad g A) (Ad g Wt) = Ad g (vorticity_after A Wt).
Proof.
move=> unit.
have AdM X Y : Ad g X *m Ad g Y = Ad g (X *m Y) by rewrite /Ad !mulmxA mulmxKV.
have AdD X Y : Ad g (X + Y) = Ad g X + Ad g Y by rewrite /Ad mulmxDr mulmxDl.
have AdN X : Ad g (- X) = - Ad g X by rewrite /Ad mulmxN mulNmx.
have Ad1 : Ad g 1%:M = 1%:M by rewrite /Ad mulmx1 mulmxV.
by rewrite /vorticity_before /vorticity_after -!AdM !AdD !AdN !Ad1.
Qed.

(** ** The finish: Casimirs do not need convergence

Let \f$W_s\f$ be any matrix in place of the solution, \f$r = W_0 + [A, W_s] + AW_sA - W_s\f$ its residual in
the fixed-point equation, and \f$U = \mathrm{cay}(A)\f$. Then
\f[ U W_0 U^{-1} = W_0 - r + 2\,[A, W_s] + U r U^{-1} . \f]
The left side has the Casimirs of \f$W_0\f$ whatever \f$A\f$ is; on the right \f$U\f$ stands beside the small
\f$r\f$ alone. *)
Theorem finish_without_convergence A W Ws r : 1%:M - A \in unitmx -> 1%:M + A \in unitmx ->
  r = W + bracket A Ws + A *m Ws *m A - Ws ->
  Ad (cayley A) W = W - r + bracket A Ws *+ 2 + Ad (cayley A) r.
Proof.
move=> minus plus residual.
(* W - r is the vorticity before a step with Ws; the step carries it along. *)
have before : W - r = vorticity_before A Ws.
  by rewrite residual /vorticity_before /bracket; by_expansion.
have -> : W - r + bracket A Ws *+ 2 = Ad (cayley A) (W - r).
  by rewrite before -step_increment addrC subrK (proj2 (step_conjugates _ minus) plus).
by rewrite /Ad mulmxBr mulmxBl subrK.
Qed.

Lemma casimir_Ad (g : 'M[R]_n) W k : g \in unitmx -> casimir k (Ad g W) = casimir k W.
Proof. by move=> unit; rewrite /Ad casimir_exchange mulmxA mulVmx // mul1mx. Qed.

Lemma char_poly_Ad (g : 'M[R]_n) W : g \in unitmx -> char_poly (Ad g W) = char_poly W.
Proof. by move=> unit; rewrite /Ad char_poly_exchange mulmxA mulVmx // mul1mx. Qed.

(** With \f$r\f$ taken from the fixed-point equation, the right side of that formula has the Casimirs and the
spectrum of \f$W_0\f$, however far \f$W_s\f$ is from a solution. *)
Theorem casimirs_without_convergence A W Ws : 1%:M - A \in unitmx -> 1%:M + A \in unitmx ->
  let r := W + bracket A Ws + A *m Ws *m A - Ws in
  let next := W - r + bracket A Ws *+ 2 + Ad (cayley A) r in
  (forall k, casimir k next = casimir k W) /\ char_poly next = char_poly W.
Proof.
move=> minus plus r next; have unit := cayley_unit minus plus.
rewrite -(_ : Ad (cayley A) W = next); last by apply: finish_without_convergence.
by split=> [k|]; [apply: casimir_Ad | apply: char_poly_Ad].
Qed.

(** ** The Cayley map from one inverse

With \f$S = (1 - A^2)^{-1}\f$,
\f[ \mathrm{cay}(A) = 2S - 1 + 2AS . \f]
For a skew \f$A\f$ the matrix \f$S\f$ is symmetric and \f$AS\f$ is skew: half of each is enough. *)
Theorem cayley_by_one_inverse A : 1%:M - A *m A \in unitmx ->
  let S := invmx (1%:M - A *m A) in cayley A = S *+ 2 - 1%:M + (A *m S) *+ 2.
Proof.
move=> unit S.
have factors : 1%:M - A *m A = (1%:M + A) *m (1%:M - A) by by_expansion.
have minus : 1%:M - A \in unitmx by move: unit; rewrite factors unitmx_mul => /andP[].
have inverse : (1%:M - A *m A) *m S = 1%:M by rewrite mulmxV.
have commutes : (1%:M - A *m A) *m (A *m S) = A.
  by rewrite mulmxA (_ : _ *m A = A *m (1%:M - A *m A)) -?mulmxA ?inverse ?mulmx1 //; by_expansion.
apply: (can_inj (mulKmx unit)).
rewrite !mulr2n !mulmxDr mulmxN mulmx1 inverse commutes.
rewrite {1}factors -mulmxA /cayley mulKVmx //; by_expansion.
Qed.

(** ** Energy *)

(** The trace form is invariant: \f$\mathrm{Tr}([X, Y]Z) = \mathrm{Tr}(X[Y, Z])\f$. *)
Lemma trace_bracket X Y Z : \tr (bracket X Y *m Z) = \tr (X *m bracket Y Z).
Proof.
rewrite /bracket mulmxBl mulmxBr !raddfB /= !mulmxA; congr (_ - _).
by rewrite -mulmxA mxtrace_mulC.
Qed.

Lemma trace_turn X Wt Y Z : \tr (X *m Wt *m Y *m Z) = \tr (Wt *m (Y *m Z *m X)).
Proof. by rewrite -!mulmxA mxtrace_mulC !mulmxA. Qed.

Lemma bracketN X Y : bracket Y X = - bracket X Y.
Proof. by rewrite /bracket opprB. Qed.

Lemma bracket_scale (e : R) X Y : bracket (e *: X) Y = e *: bracket X Y.
Proof. by rewrite /bracket -scalemxAl -scalemxAr scalerBr. Qed.

(** Of two matrices that commute, one is orthogonal to every bracket of the other. *)
Lemma trace_commuting A Q W : A *m Q = Q *m A -> \tr (Q *m bracket A W) = 0.
Proof. by move=> commute; rewrite -trace_bracket /bracket commute subrr mul0mx raddf0. Qed.

(** A map \f$\Delta\f$ of matrices, in the place of the Laplacian, is _self-adjoint_ where
\f$\mathrm{Tr}(\Delta X\,Y) = \mathrm{Tr}(X\,\Delta Y)\f$. *)
Definition self_adjoint (Laplacian : 'M[R]_n -> 'M[R]_n) :=
  forall X Y, \tr (Laplacian X *m Y) = \tr (X *m Laplacian Y).

(** It is _invariant_ under \f$X\f$ where it commutes with the bracket: \f$\Delta[X, Y] = [X, \Delta Y]\f$. *)
Definition invariant (Laplacian : 'M[R]_n -> 'M[R]_n) X :=
  forall Y, Laplacian (bracket X Y) = bracket X (Laplacian Y).

(** Twice the energy of a vorticity \f$W = \Delta P\f$, up to a factor that does not depend on \f$W\f$:
\f$\mathrm{Tr}(PW)\f$. *)
Definition energy P W := \tr (P *m W).

Section Energy.

Variable Laplacian : 'M[R]_n -> 'M[R]_n.
Hypothesis adjoint : self_adjoint Laplacian.

Lemma trace_nondegenerate X : (forall Y, \tr (X *m Y) = 0) -> X = 0.
Proof.
move=> vanishes; apply: trmx_inj; rewrite trmx0; apply: pairing_nondegenerate => Y.
by rewrite /pairing trmxK.
Qed.

(** A self-adjoint map is additive; this need not be assumed. *)
Lemma self_adjoint_additive X Y : Laplacian (X - Y) = Laplacian X - Laplacian Y.
Proof.
apply/eqP; rewrite -subr_eq0; apply/eqP; apply: trace_nondegenerate => Z.
by rewrite 2!mulmxBl !raddfB /= !adjoint mulmxBl !raddfB /= -opprD subrr.
Qed.

(** It is homogeneous as well. *)
Lemma self_adjoint_scale (e : R) X : Laplacian (e *: X) = e *: Laplacian X.
Proof.
apply/eqP; rewrite -subr_eq0; apply/eqP; apply: trace_nondegenerate => Z.
by rewrite mulmxBl raddfB /= adjoint -!scalemxAl !mxtraceZ adjoint subrr.
Qed.

Lemma self_adjoint_sum X Y : Laplacian (X + Y) = Laplacian X + Laplacian Y.
Proof. by rewrite -{1}[Y]opprK self_adjoint_additive -[- Y]scaleN1r self_adjoint_scale scaleN1r opprK. Qed.

(** ** The energy does not depend on the stream function

Two stream functions of one vorticity give one energy. So \f$\Delta\f$ need not have an inverse, and where it
has a kernel no choice matters. *)
Theorem energy_well_defined P P' W : Laplacian P = W -> Laplacian P' = W -> energy P W = energy P' W.
Proof. by move=> one other; rewrite /energy -[in LHS]other -adjoint one mxtrace_mulC. Qed.

(** ** The change of energy

With \f$\Delta P_0 = W_0\f$, \f$\Delta P_1 = W_1\f$ and \f$\Delta Q = W_0 + W_1\f$,
\f[ \mathrm{Tr}(P_1W_1) - \mathrm{Tr}(P_0W_0) = \mathrm{Tr}\bigl(Q\,(W_1 - W_0)\bigr) . \f]
So \f$\frac12Q\f$ is a discrete gradient of the energy, for any two vorticities. *)
Theorem energy_difference P0 P1 Q W0 W1 :
  Laplacian P0 = W0 -> Laplacian P1 = W1 -> Laplacian Q = W0 + W1 ->
  energy P1 W1 - energy P0 W0 = \tr (Q *m (W1 - W0)).
Proof.
move=> one two sum.
rewrite -one -two -self_adjoint_additive -adjoint sum one two mulmxDl !mulmxBr !raddfD /= !raddfN /=.
rewrite /energy (mxtrace_mulC P1) (mxtrace_mulC P0).
have -> : \tr (W0 *m P1) = \tr (W1 *m P0) by rewrite -one -two adjoint mxtrace_mulC.
by rewrite [RHS]addrC addrA subrK.
Qed.

(** ** Energy is conserved by the averaged stream function

Where \f$A\f$ commutes with a solution \f$Q\f$ of \f$\Delta Q = W_0 + W_1\f$, in particular where it is a
multiple of one, the step conserves the energy. The step with
\f$A = \frac{\Delta t}2\Delta^{-1}\frac{W_0 + W_1}2\f$ is of this kind. Neither 2 nor \f$\Delta\f$ needs an
inverse, and \f$A\f$ need not be skew. *)
Theorem energy_conserved A Wt P0 P1 Q :
  Laplacian P0 = vorticity_before A Wt -> Laplacian P1 = vorticity_after A Wt ->
  Laplacian Q = vorticity_before A Wt + vorticity_after A Wt -> A *m Q = Q *m A ->
  energy P1 (vorticity_after A Wt) = energy P0 (vorticity_before A Wt).
Proof.
move=> one two sum commute; apply/eqP; rewrite -subr_eq0 (energy_difference one two sum).
by rewrite step_increment mulr2n mulmxDr raddfD /= (trace_commuting Wt commute) addr0.
Qed.

(** ** The change of energy by the Lie-Poisson step

Where \f$A\f$ commutes with a solution \f$P\f$ of \f$\Delta P = \tilde W - c\f$ instead, as in the discrete
Lie-Poisson algorithm, the energy changes by
\f[ \mathrm{Tr}(P_1W_1) - \mathrm{Tr}(P_0W_0) = -4\,\mathrm{Tr}\bigl(Z\,[A, \tilde W]\bigr), \qquad
\Delta Z = A\tilde WA - c , \f]
a quantity of third order in \f$A\f$. Here \f$c\f$ is a multiple of the identity: the trace of \f$\tilde W\f$
need not be zero where that of \f$W_0\f$ is. *)
Theorem energy_error A Wt P0 P1 P Z (c : R) :
  Laplacian P0 = vorticity_before A Wt -> Laplacian P1 = vorticity_after A Wt ->
  Laplacian P = Wt - c%:M -> Laplacian Z = A *m Wt *m A - c%:M -> A *m P = P *m A ->
  energy P1 (vorticity_after A Wt) - energy P0 (vorticity_before A Wt) = - (\tr (Z *m bracket A Wt) *+ 4).
Proof.
move=> one two middle rest commute.
have sum : Laplacian ((P - Z) + (P - Z)) = vorticity_before A Wt + vorticity_after A Wt.
  rewrite self_adjoint_sum self_adjoint_additive middle rest (proj1 (step_mean A Wt)).
  by rewrite mulr2n [Wt - c%:M - _](_ : _ = Wt - A *m Wt *m A) // opprB addrA subrK.
rewrite (energy_difference one two sum) step_increment -mulr2n -!scaler_nat -scalemxAl -scalemxAr.
rewrite !mxtraceZ mulmxBl raddfB /= (trace_commuting Wt commute) sub0r !mulrN mulrA -natrM.
by rewrite -[RHS]mulNrn -[RHS]mulr_natl mulrN.
Qed.

Lemma noether_identity X P : invariant Laplacian X -> \tr (X *m bracket P (Laplacian P)) *+ 2 = 0.
Proof.
move=> invariance.
have half : \tr (X *m bracket P (Laplacian P)) = - \tr (X *m bracket P (Laplacian P)).
  (* Delta goes from one factor to the other, and through the bracket with X. *)
  rewrite -{1}trace_bracket -adjoint invariance trace_bracket.
  by rewrite [bracket (Laplacian P) P]bracketN mulmxN raddfN.
by rewrite mulr2n {1}half addNr.
Qed.

(** ** Noether's theorem for the Lie-Poisson step

Where \f$\Delta\f$ is invariant under \f$X\f$ and \f$A = \epsilon P\f$ with \f$\Delta P = \tilde W - c\f$, the
step conserves \f$\mathrm{Tr}(XW)\f$. With \f$X\f$ a generator of the rotations of the sphere this is a
component of the angular momentum. The factor 2 of the increment is used: no division by 2 is. *)
Theorem angular_momentum_conserved A Wt P X (e c : R) :
  invariant Laplacian X -> Laplacian P = Wt - c%:M -> A = e *: P ->
  \tr (X *m vorticity_after A Wt) = \tr (X *m vorticity_before A Wt).
Proof.
move=> invariance middle parallel; apply/eqP; rewrite -subr_eq0 -raddfB /= -mulmxBr step_increment.
have -> : bracket A Wt = e *: bracket P (Laplacian P).
  rewrite parallel bracket_scale middle; congr (e *: _); rewrite /bracket mulmxBr mulmxBl.
  by rewrite scalar_mxC opprB addrA subrK.
rewrite -scaler_nat -scalemxAr -scalemxAr !mxtraceZ mulrCA mulr_natl.
by rewrite (noether_identity _ invariance) mulr0.
Qed.

(** ** Casimirs and energy

For a step whose \f$A\f$ is a multiple of \f$Q\f$, \f$\Delta Q = W_0 + W_1\f$: all Casimirs, the spectrum and
the energy are those of before. The Laplacian is any self-adjoint map of matrices. *)
Theorem claim_10_0_reduced_hydrodynamics_energy A Wt P0 P1 Q (e : R) :
  Laplacian P0 = vorticity_before A Wt -> Laplacian P1 = vorticity_after A Wt ->
  Laplacian Q = vorticity_before A Wt + vorticity_after A Wt -> A = e *: Q ->
  [/\ forall k, casimir k (vorticity_after A Wt) = casimir k (vorticity_before A Wt),
      char_poly (vorticity_after A Wt) = char_poly (vorticity_before A Wt)
    & energy P1 (vorticity_after A Wt) = energy P0 (vorticity_before A Wt)].
Proof.
move=> one two sum parallel; split; first exact: casimirs_conserved; first exact: spectrum_conserved.
by apply: (energy_conserved one two sum); rewrite parallel -scalemxAl -scalemxAr.
Qed.

(** ** Casimirs and angular momentum

For a step of the discrete Lie-Poisson algorithm, \f$A = \epsilon P\f$ with \f$\Delta P = \tilde W - c\f$: all
Casimirs, the spectrum, and \f$\mathrm{Tr}(XW)\f$ for every \f$X\f$ under which the Laplacian is invariant.
The energy changes in third order. *)
Theorem claim_10_0_reduced_hydrodynamics_angular_momentum A Wt P (e c : R) :
  Laplacian P = Wt - c%:M -> A = e *: P ->
  [/\ forall k, casimir k (vorticity_after A Wt) = casimir k (vorticity_before A Wt),
      char_poly (vorticity_after A Wt) = char_poly (vorticity_before A Wt)
    & forall X, invariant Laplacian X ->
      \tr (X *m vorticity_after A Wt) = \tr (X *m vorticity_before A Wt)].
Proof.
move=> middle parallel; split; [exact: casimirs_conserved | exact: spectrum_conserved | move=> X invariance].
exact: angular_momentum_conserved invariance middle parallel.
Qed.

(** ** All known first integrals at once

Chapter 10 expects schemes for the vorticity of an ideal fluid that preserve all the known first integrals. On
matrices: a step conserves the energy where \f$[A, \tilde W]\f$ is orthogonal to \f$Q\f$,
\f$\Delta Q = W_0 + W_1\f$, and the components of the angular momentum where it is orthogonal to the
generators \f$X_i\f$ of the rotations; one equation each, to be met by the choice of \f$A\f$. The Casimirs and
the spectrum are conserved for every \f$A\f$. The generators may be any matrices, and \f$\Delta\f$ need not be
invariant under them. That there is such an \f$A\f$ is not part of the statement. *)
Theorem claim_10_0_reduced_hydrodynamics (I : Type) (X : I -> 'M[R]_n) A Wt P0 P1 Q :
  Laplacian P0 = vorticity_before A Wt -> Laplacian P1 = vorticity_after A Wt ->
  Laplacian Q = vorticity_before A Wt + vorticity_after A Wt ->
  \tr (Q *m bracket A Wt) = 0 -> (forall i, \tr (X i *m bracket A Wt) = 0) ->
  [/\ forall k, casimir k (vorticity_after A Wt) = casimir k (vorticity_before A Wt),
      char_poly (vorticity_after A Wt) = char_poly (vorticity_before A Wt),
      energy P1 (vorticity_after A Wt) = energy P0 (vorticity_before A Wt)
    & forall i, \tr (X i *m vorticity_after A Wt) = \tr (X i *m vorticity_before A Wt)].
Proof.
move=> one two sum level turns.
split; [exact: casimirs_conserved | exact: spectrum_conserved | | move=> i]; apply/eqP; rewrite -subr_eq0.
  by rewrite (energy_difference one two sum) step_increment mulr2n mulmxDr raddfD /= level addr0.
by rewrite -raddfB -mulmxBr step_increment mulr2n mulmxDr raddfD /= turns addr0.
Qed.

(** ** Equilibria stand still

Let \f$\Delta P = W\f$ with \f$[P, W] = 0\f$, and \f$A = 2\epsilon P\f$ with \f$1 - A\f$ and \f$1 + A\f$
invertible. Then \f$\tilde W = (1 - A)^{-1}W(1 + A)^{-1}\f$ gives \f$W_0 = W_1 = W\f$ and solves the equations
of the energy-conserving step with \f$Q = 2P\f$, for every length of the step. *)
Theorem equilibria_stand_still A P W (e : R) : Laplacian P = W -> bracket P W = 0 -> A = e *: (P + P) ->
  1%:M - A \in unitmx -> 1%:M + A \in unitmx ->
  let Wt := invmx (1%:M - A) *m W *m invmx (1%:M + A) in
  [/\ vorticity_before A Wt = W, vorticity_after A Wt = W
    & Laplacian (P + P) = vorticity_before A Wt + vorticity_after A Wt].
Proof.
move=> stream rest parallel minus plus Wt.
have before : vorticity_before A Wt = W by rewrite /vorticity_before /Wt !mulmxA mulmxV // mul1mx mulmxKV.
have commute : A *m W = W *m A.
  move/eqP: rest; rewrite /bracket subr_eq0 => /eqP rest.
  by rewrite parallel -scalemxAl -scalemxAr mulmxDl mulmxDr rest.
have after : vorticity_after A Wt = W.
  apply: (can_inj (mulKmx minus)); apply: (can_inj (mulmxK plus)).
  by rewrite step_without_inverse before; expanded; rewrite !commute; by_expansion.
by split=> //; rewrite self_adjoint_sum stream before after.
Qed.

(** ** Rossby and Haurwitz's wave

Let \f$\Delta X = \kappa X\f$ and \f$\Delta V = \lambda V\f$. The vorticity \f$W = \kappa aX + \lambda bV\f$
has the stream function \f$P = aX + bV\f$, and
\f[ [P, W] = (\lambda - \kappa)\,ab\,[X, V] : \f]
with \f$X\f$ a generator of rotations, the equation turns \f$V\f$ about the axis of \f$X\f$ and leaves \f$X\f$
where it is. *)
Theorem rossby_haurwitz X V (a b k l : R) :
  Laplacian X = k *: X -> Laplacian V = l *: V ->
  Laplacian (a *: X + b *: V) = (k * a) *: X + (l * b) *: V /\
  bracket (a *: X + b *: V) ((k * a) *: X + (l * b) *: V) = ((l - k) * (a * b)) *: bracket X V.
Proof.
move=> eigen other; split.
  by rewrite self_adjoint_sum !self_adjoint_scale eigen other !scalerA (mulrC a) (mulrC b).
rewrite /bracket !mulmxDl !mulmxDr -!scalemxAl -!scalemxAr !scalerA; named_products.
by apply/matrixP => i j; rewrite !mxE; ring_identity.
Qed.

End Energy.

(** ** The Laplacian of the sphere *)

(** Hoppe's and Yau's Laplacian, of three matrices \f$S_1, S_2, S_3\f$ that represent the rotations:
\f$\Delta W = \sum_k[S_k, [S_k, W]]\f$. *)
Definition laplacian S1 S2 S3 W :=
  bracket S1 (bracket S1 W) + bracket S2 (bracket S2 W) + bracket S3 (bracket S3 W).

Lemma trace_double_bracket X Y Z : \tr (bracket X (bracket X Y) *m Z) = - \tr (bracket X Y *m bracket X Z).
Proof. by rewrite -trace_bracket [bracket X (bracket _ _)]bracketN mulNmx raddfN. Qed.

(** It is self-adjoint, whatever the three matrices are. *)
Theorem laplacian_self_adjoint S1 S2 S3 : self_adjoint (laplacian S1 S2 S3).
Proof.
have one S X Y : \tr (bracket S (bracket S X) *m Y) = \tr (X *m bracket S (bracket S Y)).
  by rewrite (mxtrace_mulC X) (trace_double_bracket S X) (trace_double_bracket S Y) mxtrace_mulC.
move=> X Y; have left a b c d : \tr ((a + b + c) *m d) = \tr (a *m d) + \tr (b *m d) + \tr (c *m d).
  by rewrite !mulmxDl !raddfD.
by rewrite left !one [RHS]mxtrace_mulC left !(mxtrace_mulC X).
Qed.

Lemma jacobi X Y Z : bracket X (bracket Y Z) = bracket (bracket X Y) Z + bracket Y (bracket X Z).
Proof. by rewrite /bracket; by_expansion. Qed.

Lemma bracketD X Y Z : bracket X (Y + Z) = bracket X Y + bracket X Z.
Proof. by rewrite /bracket mulmxDr mulmxDl opprD addrACA. Qed.

Lemma bracketNl X Y : bracket (- X) Y = - bracket X Y.
Proof. by rewrite /bracket mulNmx mulmxN opprB addrC opprK. Qed.

Lemma bracketNr X Y : bracket X (- Y) = - bracket X Y.
Proof. by rewrite /bracket mulNmx mulmxN opprB addrC opprK. Qed.

(* The first of three derivations goes past the squares of the other two; what it leaves in the one it leaves,
   with the opposite sign, in the other. *)
Lemma past_squares (d1 d2 d3 : 'M[R]_n -> 'M[R]_n) Y :
  (forall X Z, d2 (X + Z) = d2 X + d2 Z) -> (forall X Z, d3 (X + Z) = d3 X + d3 Z) ->
  (forall X, d3 (- X) = - d3 X) ->
  (forall X, d1 (d2 X) = d3 X + d2 (d1 X)) -> (forall X, d1 (d3 X) = - d2 X + d3 (d1 X)) ->
  d1 (d2 (d2 Y)) + d1 (d3 (d3 Y)) = d2 (d2 (d1 Y)) + d3 (d3 (d1 Y)).
Proof.
move=> add2 add3 opp3 past2 past3; rewrite past2 past3 past2 past3 add2 add3 opp3.
by rewrite [- _ + (_ + _)]addrA [d3 (d2 Y) + _]addrA addrACA -opprD [d2 (d3 Y) + _]addrC subrr add0r.
Qed.

Lemma invariant_first S1 S2 S3 : bracket S1 S2 = S3 -> bracket S3 S1 = S2 ->
  invariant (laplacian S1 S2 S3) S1.
Proof.
move=> third second Y.
have sum a b c : bracket S1 (a + b + c) = bracket S1 a + (bracket S1 b + bracket S1 c).
  by rewrite 2!bracketD addrA.
rewrite /laplacian sum -[LHS]addrA; congr (_ + _); symmetry.
apply: (past_squares (d1 := bracket S1) (d2 := bracket S2) (d3 := bracket S3)) => *.
- exact: bracketD.
- exact: bracketD.
- exact: bracketNr.
- by rewrite jacobi third.
- by rewrite jacobi [bracket S1 S3]bracketN second bracketNl.
Qed.

Lemma laplacian_cyclic S1 S2 S3 W : laplacian S2 S3 S1 W = laplacian S1 S2 S3 W.
Proof. by rewrite /laplacian [LHS]addrC [LHS]addrA. Qed.

(** ** The Laplacian commutes with the rotations

Where \f$[S_1, S_2] = S_3\f$, \f$[S_2, S_3] = S_1\f$ and \f$[S_3, S_1] = S_2\f$, Hoppe's and Yau's Laplacian
is invariant under \f$S_1\f$, \f$S_2\f$ and \f$S_3\f$. So the angular momentum \f$\mathrm{Tr}(S_kW)\f$ is
conserved by the discrete Lie-Poisson algorithm. Nothing else is asked of the three matrices; the
representation may be reducible. *)
Theorem laplacian_invariant S1 S2 S3 :
  bracket S1 S2 = S3 -> bracket S2 S3 = S1 -> bracket S3 S1 = S2 ->
  [/\ invariant (laplacian S1 S2 S3) S1, invariant (laplacian S1 S2 S3) S2
    & invariant (laplacian S1 S2 S3) S3].
Proof.
move=> third first second; split; first exact: invariant_first.
  by move=> Y; have := invariant_first first third Y; rewrite !(laplacian_cyclic S1).
by move=> Y; have := invariant_first second first Y; rewrite !(laplacian_cyclic S2) !(laplacian_cyclic S1).
Qed.

(** ** Where to look for the correction

For matrices \f$Q_i\f$, the gradients of the integrals that are to be conserved, the numbers
\f$\mathrm{Tr}(Q_i[Q_j, W])\f$ are skew in \f$i\f$ and \f$j\f$, and the numbers
\f$\mathrm{Tr}(Q_i[[Q_j, W], W]) = -\mathrm{Tr}([Q_i, W][Q_j, W])\f$ are symmetric. So a correction of \f$A\f$
by multiples of the \f$Q_j\f$ meets a skew system of equations, whose regular case has no solution but zero;
one by multiples of the tangent vectors \f$[Q_j, W]\f$ of the orbit meets their Gram matrix. *)
Theorem correction_systems (I : Type) (Q : I -> 'M[R]_n) W i j :
  \tr (Q i *m bracket (Q j) W) = - \tr (Q j *m bracket (Q i) W) /\
  \tr (Q i *m bracket (bracket (Q j) W) W) = - \tr (bracket (Q i) W *m bracket (Q j) W).
Proof.
split; first by rewrite -!trace_bracket [bracket (Q j) _]bracketN mulNmx raddfN opprK.
by rewrite [bracket _ W in LHS]bracketN mulmxN raddfN /= -trace_bracket.
Qed.

(** ** The step in the terms of chapter 3 *)

Section Derivative.

Variable d : derivation R.

Lemma derivative_of_identity : derivative_of d (1%:M : 'M[R]_n) = 0.
Proof. by apply/matrixP => i j; rewrite !mxE; case: (i == j); rewrite ?derivative_of_one ?raddf0. Qed.

Lemma derivative_of_trace X : d (\tr X) = \tr (derivative_of d X).
Proof. by rewrite /mxtrace raddf_sum; apply: eq_bigr => i _; rewrite mxE. Qed.

(** ** The derivative of the Cayley map

With \f$U = \mathrm{cay}(A)\f$ and any derivation \f$d\f$ of the ring, which acts on matrices entry by entry,
\f[ (1 - A)\,dU\,(1 - A) = 2\,dA, \qquad (1 - A)\,(dU\,U^{-1})\,(1 + A) = 2\,dA, \qquad
(1 + A)\,(U^{-1}dU)\,(1 - A) = 2\,dA : \f]
the derivative as it is, translated to the identity on the right, and on the left. *)
Theorem derivative_of_cayley A : 1%:M - A \in unitmx ->
  (1%:M - A) *m derivative_of d (cayley A) *m (1%:M - A) = derivative_of d A *+ 2 /\
  (1%:M + A \in unitmx ->
    (1%:M - A) *m (derivative_of d (cayley A) *m invmx (cayley A)) *m (1%:M + A) = derivative_of d A *+ 2 /\
    (1%:M + A) *m (invmx (cayley A) *m derivative_of d (cayley A)) *m (1%:M - A) = derivative_of d A *+ 2).
Proof.
move=> minus; set U := cayley A.
have product := cayley_left minus.
have plain : (1%:M - A) *m derivative_of d U *m (1%:M - A) = derivative_of d A *+ 2.
  (* Leibniz's rule for (1 - A) U = 1 + A. *)
  have := derivative_of_matrix_product d (1%:M - A) U.
  rewrite product !derivative_of_matrix_sum derivative_of_matrix_opp derivative_of_identity !add0r.
  rewrite mulNmx addrC => /eqP; rewrite eq_sym subr_eq => /eqP ->.
  rewrite mulmxDl -[derivative_of d A *m U *m _]mulmxA cayley_right //.
  by by_expansion.
split=> // plus; have unit : U \in unitmx by apply: cayley_unit.
have right : invmx U *m (1%:M + A) = 1%:M - A.
  by apply: (can_inj (mulKmx unit)); rewrite mulKVmx // cayley_right.
have left : (1%:M + A) *m invmx U = 1%:M - A.
  by apply: (can_inj (mulmxK unit)); rewrite mulmxKV.
by rewrite !mulmxA left -!mulmxA right !mulmxA.
Qed.

(** ** The two Legendre images of a step

Let the derivative of a function of \f$A\f$ be \f$2\,\mathrm{Tr}(\tilde W\,dA)\f$. As a function of
\f$U = \mathrm{cay}(A)\f$ it has the derivative
\f[ 2\,\mathrm{Tr}(\tilde W\,dA) = \mathrm{Tr}(W_1\,dU\,U^{-1}) = \mathrm{Tr}(W_0\,U^{-1}dU) : \f]
its differential at \f$U\f$, translated to the identity on the two sides, is \f$W_1\f$ and \f$W_0\f$. *)
Theorem legendre_images A Wt : 1%:M - A \in unitmx -> 1%:M + A \in unitmx ->
  let U := cayley A in let dU := derivative_of d U in
  \tr (vorticity_after A Wt *m (dU *m invmx U)) = \tr (Wt *m derivative_of d A) *+ 2 /\
  \tr (vorticity_before A Wt *m (invmx U *m dU)) = \tr (Wt *m derivative_of d A) *+ 2.
Proof.
move=> minus plus U dU; have [_ /(_ plus) [right left]] := derivative_of_cayley minus.
(* The trace moves the factors 1 - A and 1 + A from one matrix to the other. *)
by rewrite /vorticity_after /vorticity_before !trace_turn right left mulr2n mulmxDr raddfD -mulr2n.
Qed.

End Derivative.

(** ** The difference of two values of the Cayley map

\f[ (1 - B)\,(\mathrm{cay}(B) - \mathrm{cay}(A))\,(1 - A) = 2(B - A) , \f]
without a limit: so the map is injective where 2 is no divisor of zero. *)
Theorem cayley_difference A B : 1%:M - A \in unitmx -> 1%:M - B \in unitmx ->
  (1%:M - B) *m (cayley B - cayley A) *m (1%:M - A) = (B - A) *+ 2.
Proof.
move=> minus other; rewrite [_ *m (cayley B - _)]mulmxBr mulmxBl cayley_left // -[X in _ - X]mulmxA.
rewrite cayley_right //.
by by_expansion.
Qed.

(** The relative motion of a step, which looks back as in chapter 3: \f$f = g_kg_{k+1}^{-1}\f$ for
\f$g_{k+1} = \mathrm{cay}(A)g_k\f$, so \f$f = \mathrm{cay}(-A)\f$. *)
Definition relative_motion A := cayley (- A).

(** The differential of the reduced discrete Lagrangian at \f$f\f$, as a covector there. *)
Definition differential_at_motion A Wt := - ((1%:M + A) *m Wt *m (1%:M + A))^T.

(** It is the differential: its pairing with \f$df\f$ is \f$2\,\mathrm{Tr}(\tilde W\,dA)\f$, whatever the
derivation. *)
Lemma differential_is_derivative (d : derivation R) A Wt : 1%:M + A \in unitmx ->
  pairing (differential_at_motion A Wt) (derivative_of d (relative_motion A)) =
  \tr (Wt *m derivative_of d A) *+ 2.
Proof.
move=> plus; have minus : 1%:M - - A \in unitmx by rewrite opprK.
have [plain _] := derivative_of_cayley d minus.
move: plain; rewrite opprK derivative_of_matrix_opp => plain.
rewrite /pairing /differential_at_motion raddfN /= trmxK mulNmx raddfN /= trace_turn plain.
by rewrite mulNrn mulmxN raddfN opprK mulr2n mulmxDr raddfD -mulr2n.
Qed.

Lemma motion_right A : 1%:M + A \in unitmx -> relative_motion A *m (1%:M + A) = 1%:M - A.
Proof. by move=> plus; have := @cayley_right (- A); rewrite opprK => ->. Qed.

Lemma motion_left A : 1%:M + A \in unitmx -> (1%:M + A) *m relative_motion A = 1%:M - A.
Proof. by move=> plus; have := @cayley_left (- A); rewrite opprK => ->. Qed.

Lemma step_momenta A Wt : 1%:M + A \in unitmx ->
  R_star (relative_motion A) (differential_at_motion A Wt) = - (vorticity_before A Wt)^T /\
  L_star (relative_motion A) (differential_at_motion A Wt) = - (vorticity_after A Wt)^T.
Proof.
move=> plus; rewrite /R_star /L_star /differential_at_motion mulNmx mulmxN -!trmx_mul; split.
  by rewrite !mulmxA (motion_right plus).
by rewrite -!mulmxA (motion_left plus) mulmxA.
Qed.

(** ** A step is a step of the discrete Lie-Poisson algorithm

A vorticity \f$W\f$ is the momentum \f$\mu = W^T\f$, whose pairing with \f$\xi\f$ is \f$\mathrm{Tr}(W\xi)\f$.
With the relative motion \f$f\f$ and the differential \f$\ell'\f$ of the reduced discrete Lagrangian there,
\f[ \mu_0 = -R_f^*\,\ell'(f), \qquad \mu_1 = -L_f^*\,\ell'(f), \qquad \mu_1 = \mathrm{Ad}_f^*\,\mu_0 , \f]
which are the momenta before and after a right-invariant step and the update (3.17). *)
Theorem step_is_discrete_lie_poisson A Wt : 1%:M - A \in unitmx -> 1%:M + A \in unitmx ->
  let f := relative_motion A in
  let differential := differential_at_motion A Wt in
  [/\ (vorticity_before A Wt)^T = - R_star f differential,
      (vorticity_after A Wt)^T = - L_star f differential
    & (vorticity_after A Wt)^T = Ad_star f (vorticity_before A Wt)^T].
Proof.
move=> minus plus f differential; have [right left] := step_momenta Wt plus.
have unit : f \in unitmx by rewrite /f /relative_motion cayley_unit // opprK.
have before : (vorticity_before A Wt)^T = - R_star f differential by rewrite right opprK.
have after : (vorticity_after A Wt)^T = - L_star f differential by rewrite left opprK.
split=> //; rewrite before after /Ad_star /R_star /L_star mulmxN mulNmx -!mulmxA.
by rewrite -trmx_mul mulVmx // trmx1 mulmx1.
Qed.

(** ** The vorticity half-way solves the discrete Euler-Poincaré equations

The equation (3.10), \f$R_{f'}^*\ell'(f') = L_f^*\ell'(f)\f$ for a motion \f$f\f$ and the next one \f$f'\f$,
says that the vorticity before the next step is the vorticity after this one. *)
Theorem step_solves_discrete_euler_poincare A Wt A' Wt' : 1%:M + A \in unitmx -> 1%:M + A' \in unitmx ->
  R_star (relative_motion A') (differential_at_motion A' Wt') =
    L_star (relative_motion A) (differential_at_motion A Wt) <->
  vorticity_before A' Wt' = vorticity_after A Wt.
Proof.
move=> plus next.
rewrite (step_momenta Wt' next).1 (step_momenta Wt plus).2.
by split=> [/oppr_inj/trmx_inj | ->].
Qed.

(** ** The differential of the Lagrangian

For a self-adjoint \f$\Delta\f$ that commutes with a derivation \f$d\f$,
\f[ d\,\mathrm{Tr}(A\,\Delta A) = 2\,\mathrm{Tr}(\Delta A\,dA) . \f]
So for \f$A = \epsilon P\f$, \f$\Delta P = \tilde W\f$, the Lagrangian of the steps above is
\f$\frac1\epsilon\mathrm{Tr}(A\,\Delta A)\f$, a multiple of the kinetic energy. On matrices of trace zero
\f$\Delta P = \tilde W - c\f$ gives the same differential. *)
Theorem lagrangian_differential (Laplacian : 'M[R]_n -> 'M[R]_n) (d : derivation R) A :
  self_adjoint Laplacian -> (forall X, derivative_of d (Laplacian X) = Laplacian (derivative_of d X)) ->
  d (\tr (A *m Laplacian A)) = \tr (Laplacian A *m derivative_of d A) *+ 2.
Proof.
move=> adjoint commute; rewrite derivative_of_trace derivative_of_matrix_product raddfD /= commute.
by rewrite -(adjoint A) mxtrace_mulC mulr2n.
Qed.

(** ** Equations of the vorticity as a Lie-Poisson equation

With \f$\mu = W^T\f$ the Lie-Poisson equation of a right-invariant Hamiltonian,
\f$\dot\mu = -\mathrm{ad}_P^*\mu\f$ (theorem 2.2.3), is \f$\dot W = [P, W]\f$. *)
Theorem euler_zeitlin_is_lie_poisson P W : (- ad_star P W^T)^T = bracket P W.
Proof. by rewrite /ad_star /bracket raddfN raddfB /= !trmx_mul !trmxK opprB. Qed.

(** ** The vorticity is carried along

Let the vorticity after each step be that before the next, and \f$g_{k+1} = \mathrm{cay}(A_k)\,g_k\f$ from
\f$g_0 = 1\f$. Then \f$W_k = g_kW_0g_k^{-1}\f$, and the body momentum \f$\mathrm{Ad}_{g_k}^*\mu_k\f$, the
momentum map of the relabelling of the fluid, is the same after every step. This is the discrete vorticity
preservation that chapter 10 expects of a discrete Noether theorem, for the group of matrices. *)
Theorem claim_10_0_vorticity_preservation_matrices (A Wt g : nat -> 'M[R]_n) :
  (forall k, 1%:M - A k \in unitmx) -> (forall k, 1%:M + A k \in unitmx) ->
  (forall k, vorticity_before (A k.+1) (Wt k.+1) = vorticity_after (A k) (Wt k)) ->
  g 0%N = 1%:M -> (forall k, g k.+1 = cayley (A k) *m g k) ->
  let W k := vorticity_before (A k) (Wt k) in
  forall k, W k = Ad (g k) (W 0%N) /\ Ad_star (g k) (W k)^T = (W 0%N)^T.
Proof.
move=> minus plus chain start moves W.
have unit k : g k \in unitmx.
  by elim: k => [|k hyp]; rewrite ?start ?unitmx1 // moves unitmx_mul hyp cayley_unit.
have carried k : W k *m g k = g k *m W 0%N.
  elim: k => [|k hyp]; first by rewrite start mulmx1 mul1mx.
  rewrite {1}/W chain moves (mulmxA (vorticity_after _ _)) (step_conjugates _ (minus k)).1.
  by rewrite -!(mulmxA (cayley _)) -hyp.
move=> k; split; first by rewrite /Ad -carried mulmxK.
by rewrite /Ad_star -!trmx_mul carried mulKmx.
Qed.

(** ** Skew matrices and unitary ones *)

(** A map \f$X\mapsto X^*\f$ in the place of the transpose, or of the transpose with complex conjugate
entries: additive, an exchange of factors, and its own inverse. *)
Definition involution (star : 'M[R]_n -> 'M[R]_n) :=
  [/\ forall X Y, star (X + Y) = star X + star Y, forall X Y, star (X *m Y) = star Y *m star X
    & forall X, star (star X) = X].

(** The transpose is one. *)
Lemma transpose_involution : involution trmx.
Proof. by split; [exact: raddfD | exact: trmx_mul | exact: trmxK]. Qed.

(** So is the transpose with conjugate entries, for any automorphism of the ring that is its own inverse. *)
Lemma hermitian_involution (conj : {rmorphism R -> R}) :
  (forall a, conj (conj a) = a) -> involution (fun X => (map_mx conj X)^T).
Proof.
move=> twice; split=> [X Y | X Y | X]; first by rewrite map_mxD raddfD.
  by rewrite map_mxM trmx_mul.
by apply/matrixP => i j; rewrite !mxE twice.
Qed.

Section Star.

Variable star : 'M[R]_n -> 'M[R]_n.
Hypothesis starred : involution star.

Let starD : forall X Y, star (X + Y) = star X + star Y. Proof. by case: starred. Qed.
Let starM : forall X Y, star (X *m Y) = star Y *m star X. Proof. by case: starred. Qed.
Let starK : forall X, star (star X) = X. Proof. by case: starred. Qed.

Let star0 : star 0 = 0. Proof. by apply: (addIr (star 0)); rewrite -starD addr0 add0r. Qed.
Let starN X : star (- X) = - star X.
Proof. by apply/eqP; rewrite -addr_eq0 -starD addNr star0. Qed.
Let star1 : star 1%:M = 1%:M.
Proof. by rewrite -[LHS]mul1mx -{1}[1%:M]starK -starM mul1mx starK. Qed.

(** ** A step keeps the vorticity skew

Where \f$A^* = -A\f$, a step with \f$\tilde W^*\f$ in place of \f$\tilde W\f$ has the vorticities \f$W_0^*\f$
and \f$W_1^*\f$. So \f$W_0\f$ and \f$W_1\f$ are skew where \f$\tilde W\f$ is, and symmetric where it is. *)
Theorem step_starred A Wt : star A = - A ->
  star (vorticity_before A Wt) = vorticity_before A (star Wt) /\
  star (vorticity_after A Wt) = vorticity_after A (star Wt) /\
  (star Wt = - Wt -> star (vorticity_before A Wt) = - vorticity_before A Wt /\
                     star (vorticity_after A Wt) = - vorticity_after A Wt).
Proof.
move=> skew.
have before : star (vorticity_before A Wt) = vorticity_before A (star Wt).
  by rewrite /vorticity_before !starM !starD starN star1 skew opprK mulmxA.
have after : star (vorticity_after A Wt) = vorticity_after A (star Wt).
  by rewrite /vorticity_after !starM !starD starN star1 skew opprK mulmxA.
split=> //; split=> // skew_too; rewrite before after skew_too.
by rewrite /vorticity_before /vorticity_after !mulmxN !mulNmx.
Qed.

Lemma star_unit X Y : X *m Y = 1%:M -> star Y *m star X = 1%:M.
Proof. by move=> inverse; rewrite -starM inverse star1. Qed.

(** ** The Cayley map of a skew matrix is unitary

Where \f$A^* = -A\f$ and \f$1 - A\f$ has an inverse, so has \f$1 + A\f$, and \f$U = \mathrm{cay}(A)\f$ has
\f$U^*U = UU^* = 1\f$. Then \f$\mathrm{Ad}_UX = UXU^*\f$ for every \f$X\f$: the step is \f$W_1 = UW_0U^*\f$,
and the finish without convergence adds \f$UrU^*\f$. *)
Theorem cayley_unitary A : star A = - A -> 1%:M - A \in unitmx ->
  [/\ 1%:M + A \in unitmx, star (cayley A) *m cayley A = 1%:M, cayley A *m star (cayley A) = 1%:M
    & forall X, Ad (cayley A) X = cayley A *m X *m star (cayley A)].
Proof.
move=> skew minus; have inverse := star_unit (mulVmx minus).
have factor : star (1%:M - A) = 1%:M + A by rewrite starD starN star1 skew opprK.
have plus : 1%:M + A \in unitmx by rewrite -factor; case: (mulmx1_unit inverse).
have star_inverse : star (invmx (1%:M - A)) = invmx (1%:M + A).
  by rewrite -[LHS](mulKmx plus) -{2}factor inverse mulmx1.
have adjoint : star (cayley A) = cayley (- A).
  by rewrite [in RHS]cayley_commute ?opprK // /cayley starM star_inverse starD star1 skew.
have one := cayley_inverse minus plus; rewrite adjoint.
by split=> // [|X]; [exact: mulmx1C | rewrite /Ad cayley_inv].
Qed.

(** ** One product is enough

For skew \f$A\f$ and \f$\tilde W\f$ and the one product \f$B = A\tilde W\f$: \f$[A, \tilde W] = B - B^*\f$,
and \f$A\tilde WA = BA\f$ is skew. *)
Theorem one_product A Wt : star A = - A -> star Wt = - Wt ->
  let B := A *m Wt in [/\ bracket A Wt = B - star B, A *m Wt *m A = B *m A & star (B *m A) = - (B *m A)].
Proof.
move=> skew skew_too B; rewrite /B /bracket !starM skew skew_too.
by split=> //; rewrite !mulNmx !mulmxN ?opprK ?mulmxA // mulNmx.
Qed.

End Star.

(* An entry by the numbers of its row and its column. *)
Lemma entry_at (m : nat) (M : 'M[R]_m.+1) : exists a : nat -> nat -> R, forall i j, M i j = a i j.
Proof. by exists (fun i j => M (inord i) (inord j)) => i j; rewrite !inord_val. Qed.

(* The signs of the cofactors, and the entries of the identity. *)
Ltac signs :=
  repeat match goal with |- context [GRing.exp (GRing.opp (GRing.one _)) ?k] =>
    progress (let k' := eval compute in k in change k with k') end;
  rewrite ?expr0 ?expr1 ?sqrrN ?expr1n ?mul1r ?mulN1r ?mulr0n ?mulr1n ?addr0.

Lemma det_of_two (M : 'M[R]_2) (a : nat -> nat -> R) : (forall i j, M i j = a i j) ->
  \det M = a 0%N 0%N * a 1%N 1%N - a 0%N 1%N * a 1%N 0%N.
Proof.
move=> entry; rewrite (expand_det_row _ ord0) !big_ord_recl big_ord0 /cofactor !det_mx11 !mxE !entry /=.
by signs; rewrite mulrN.
Qed.

Lemma det_of_three (M : 'M[R]_3) (a : nat -> nat -> R) : (forall i j, M i j = a i j) ->
  \det M = a 0%N 0%N * (a 1%N 1%N * a 2%N 2%N - a 1%N 2%N * a 2%N 1%N)
    - a 0%N 1%N * (a 1%N 0%N * a 2%N 2%N - a 1%N 2%N * a 2%N 0%N)
    + a 0%N 2%N * (a 1%N 0%N * a 2%N 1%N - a 1%N 1%N * a 2%N 0%N).
Proof.
move=> entry; rewrite (expand_det_row _ ord0) !big_ord_recl big_ord0 /cofactor !entry.
have minor (k : 'I_3) : \det (row' ord0 (col' k M)) =
    a 1%N (bump k 0) * a 2%N (bump k 1) - a 1%N (bump k 1) * a 2%N (bump k 0).
  by rewrite (det_of_two (a := fun i j => a i.+1 (bump k j))) // => i j; rewrite !mxE entry.
by rewrite !minor /=; signs; rewrite mulrN addrA.
Qed.

(** ** Which group the Cayley map reaches

For matrices of two and of three rows,
\f[ \det(1 + A) - \det(1 - A) = 2\,\mathrm{Tr}A, \qquad
\det(1 + A) - \det(1 - A) = 2\,(\mathrm{Tr}A + \det A) . \f]
So for \f$\mathrm{Tr}A = 0\f$ the determinant of \f$\mathrm{cay}(A)\f$ is 1 in \f$\mathrm{SU}(2)\f$; in
\f$\mathrm{SU}(3)\f$ it is 1 only where \f$2\det A = 0\f$, and \f$A = \mathrm{diag}(i, i, -2i)\f$ leaves the
group. A multiple of \f$U\f$ makes the same step: what moves the vorticity is an element of the unitary group
up to a factor. *)
Theorem cayley_determinant (A : 'M[R]_2) (B : 'M[R]_3) :
  \det (1%:M + A) - \det (1%:M - A) = \tr A *+ 2 /\
  \det (1%:M + B) - \det (1%:M - B) = (\tr B + \det B) *+ 2.
Proof.
have [a entry_a] := entry_at A; have [b entry_b] := entry_at B.
have plus m (X : 'M[R]_m) x : (forall i j, X i j = x (i : nat) (j : nat)) ->
    forall i j, (1%:M + X) i j = ((i : nat) == j)%:R + x i j.
  by move=> entry i j; rewrite !mxE entry.
have minus m (X : 'M[R]_m) x : (forall i j, X i j = x (i : nat) (j : nat)) ->
    forall i j, (1%:M - X) i j = ((i : nat) == j)%:R - x i j.
  by move=> entry i j; rewrite !mxE entry.
rewrite /mxtrace !big_ord_recl !big_ord0 !entry_a !entry_b; split.
  rewrite [\det (1%:M + A)](det_of_two (a := fun i j => (i == j)%:R + a i j) (plus _ _ _ entry_a)).
  rewrite [\det (1%:M - A)](det_of_two (a := fun i j => (i == j)%:R - a i j) (minus _ _ _ entry_a)) /=.
  by signs; rewrite /bump mulr2n /= ?add1n; ring_identity.
rewrite [\det (1%:M + B)](det_of_three (a := fun i j => (i == j)%:R + b i j) (plus _ _ _ entry_b)).
rewrite [\det (1%:M - B)](det_of_three (a := fun i j => (i == j)%:R - b i j) (minus _ _ _ entry_b)).
rewrite (det_of_three entry_b) /=.
by signs; rewrite /bump mulr2n /= ?add1n; ring_identity.
Qed.

End Step.

(** ** Euler's equation in continuous time

The derivative by time is any derivation of the ring of numbers; on matrices it acts entry by entry. *)

Section Euler.

Variables (R : comUnitRingType) (n : nat) (d : derivation R).
Implicit Types P W : 'M[R]_n.

Lemma derivative_of_power P W k : derivative_of d W = bracket P W ->
  derivative_of d (power W k) = bracket P (power W k).
Proof.
move=> equation; elim: k => [|k hyp].
  by rewrite derivative_of_identity /bracket mulmx1 mul1mx subrr.
rewrite powerS derivative_of_matrix_product hyp equation /bracket mulmxBl mulmxBr !mulmxA.
by rewrite addrA subrK.
Qed.

(* Where a matrix changes by a bracket, its determinant does not change. *)
Lemma determinant_of_bracket (S : comRingType) (c : derivation S) (P M : 'M[S]_n) :
  derivative_of c M = P *m M - M *m P -> c (\det M) = 0.
Proof.
move=> change; rewrite derivative_of_determinant change mulmxBr raddfB /= !mulmxA mul_adj_mx.
by rewrite mxtrace_mulC mulmxA mul_mx_adj subrr.
Qed.

(** ** The moments of the vorticity

\f[ \mathrm{Tr}(W^k[P, W]) = 0 \quad\text{for every } k, \f]
for any two matrices: the gradient of each Casimir is orthogonal to every tangent vector of the orbit. *)
Theorem moments_orthogonal P W k : \tr (power W k *m bracket P W) = 0.
Proof. by rewrite bracketN mulmxN raddfN /= trace_commuting ?oppr0 // -powerS powerSr. Qed.

(** ** Euler's equation conserves all Casimirs and the spectrum

Let \f$\dot W = [P, W]\f$, with a derivation of the numbers in the place of the derivative by time and \f$P\f$
any matrix. Then \f$\frac{d}{dt}W^k = [P, W^k]\f$, so \f$\frac{d}{dt}\mathrm{Tr}(W^k) = 0\f$ for every
\f$k\f$, and every coefficient of the characteristic polynomial is constant. *)
Theorem euler_equation_casimirs P W : derivative_of d W = bracket P W ->
  (forall k, d (casimir k W) = 0) /\ (forall i, d (char_poly W)`_i = 0).
Proof.
move=> equation; split=> [k | i].
  by rewrite derivative_of_trace (derivative_of_power _ equation) /bracket raddfB /= mxtrace_mulC subrr.
(* z - W changes by the bracket of P with it, as W does. *)
have -> : d (char_poly W)`_i = (coefficient_derivative d (char_poly W))`_i by rewrite coef_map.
rewrite /char_poly (determinant_of_bracket (P := map_mx polyC P)) ?coef0 //.
have -> : map_mx polyC P *m char_poly_mx W - char_poly_mx W *m map_mx polyC P = - map_mx polyC (bracket P W).
  rewrite /char_poly_mx mulmxBl mulmxBr scalar_mxC opprB addrC addrA subrK -!map_mxM.
  by rewrite /bracket map_mxB opprB.
apply/matrixP => j k; rewrite -equation /char_poly_mx !mxE raddfB raddfMn /=.
by rewrite coefficient_derivative_X coefficient_derivative_C mul0rn sub0r.
Qed.

(** ** Euler's equation conserves energy and angular momentum

Let \f$\Delta\f$ be self-adjoint and commute with the derivation, \f$\Delta P = W\f$ and
\f$\dot W = [P, W]\f$. Then the energy \f$\mathrm{Tr}(PW)\f$ is constant; and twice the derivative of
\f$\mathrm{Tr}(XW)\f$ is zero, for every constant \f$X\f$ under which \f$\Delta\f$ is invariant. *)
Theorem euler_equation_energy (Laplacian : 'M[R]_n -> 'M[R]_n) P W :
  self_adjoint Laplacian -> (forall Y, derivative_of d (Laplacian Y) = Laplacian (derivative_of d Y)) ->
  Laplacian P = W -> derivative_of d W = bracket P W ->
  d (energy P W) = 0 /\
  (forall X, invariant Laplacian X -> derivative_of d X = 0 -> d (\tr (X *m W)) *+ 2 = 0).
Proof.
move=> adjoint commute stream equation.
have level : \tr (P *m bracket P W) = 0 by apply: trace_commuting.
split=> [| X invariance constant].
  have first : \tr (derivative_of d P *m W) = \tr (P *m derivative_of d W).
    by rewrite -[in LHS]stream -adjoint -commute stream mxtrace_mulC.
  by rewrite /energy derivative_of_trace derivative_of_matrix_product raddfD /= first equation level addr0.
rewrite derivative_of_trace derivative_of_matrix_product constant mul0mx add0r equation -stream.
exact: noether_identity.
Qed.

End Euler.

(** ** The rigid body of any dimension

The operator of inertia \f$J(\Omega) = \Lambda\Omega + \Omega\Lambda\f$ (section 5.0) is self-adjoint for
every matrix \f$\Lambda\f$, and invariant under every \f$X\f$ that commutes with it. So all that is said above
of \f$\Delta\f$ holds for the free rigid body of any dimension: the Casimirs of the momentum are conserved by
every step, the energy by one with \f$A\f$ parallel to the sum of the velocities before and after. *)
Theorem inertia_operator_self_adjoint (R : comUnitRingType) n (Lambda : 'M[R]_n) :
  self_adjoint (inertia_operator Lambda) /\
  (forall X, bracket X Lambda = 0 -> invariant (inertia_operator Lambda) X).
Proof.
split=> [X Y | X].
  rewrite /inertia_operator mulmxDl mulmxDr !raddfD /= addrC; congr (_ + _); first by rewrite mulmxA.
  by rewrite -mulmxA mxtrace_mulC mulmxA.
move=> /eqP; rewrite subr_eq0 => /eqP commutes Y; rewrite /inertia_operator /bracket; expanded.
by rewrite -commutes -!mulmxA -commutes; by_expansion.
Qed.

(** ** A step of the rigid body in space

On \f$\mathfrak{so}(3)\f$, with \f$A = \hat a\f$ and \f$\tilde W = \hat w\f$, the momenta before and after a
step are
\f[ w - a\times w + (a\cdot w)\,a, \qquad w + a\times w + (a\cdot w)\,a . \f]
Their lengths are equal for every \f$a\f$. *)
Theorem rigid_body_step (R : comUnitRingType) (a w : 'I_3 -> R) :
  let along i := w i + dot a w * a i in
  [/\ vorticity_before (hat a) (hat w) = hat (fun i => along i - cross a w i),
      vorticity_after (hat a) (hat w) = hat (fun i => along i + cross a w i)
    & dot (fun i => along i - cross a w i) (fun i => along i - cross a w i) =
      dot (fun i => along i + cross a w i) (fun i => along i + cross a w i)].
Proof.
move=> along; have [_ mean] := step_mean (hat a) (hat w).
have square : hat w - hat a *m hat w *m hat a = hat along.
  apply/matrixP; apply: axes; apply: axes;
    rewrite !(mxE, sum_over_axes) /= /along /dot ?sum_over_axes ?next3; ring_identity.
have before : vorticity_before (hat a) (hat w) = hat along - hat (cross a w).
  by rewrite -square -mean -hat_bracket addrK.
have after : vorticity_after (hat a) (hat w) = hat along + hat (cross a w).
  rewrite -square -mean -hat_bracket -[LHS](subrK (vorticity_before (hat a) (hat w))) step_increment.
  by rewrite mulr2n addrC addrA.
have opposite : dot along (cross a w) = 0.
  rewrite /along /dot /cross !sum_over_axes !next3; ring_identity.
split; first by rewrite before; apply/matrixP; apply: axes; apply: axes; rewrite !mxE /=; ring_identity.
  by rewrite after; apply/matrixP; apply: axes; apply: axes; rewrite !mxE /=; ring_identity.
set v := cross a w in opposite *.
have -> : dot (fun i => along i - v i) (fun i => along i - v i) =
    dot (fun i => along i + v i) (fun i => along i + v i) - dot along v *+ 4.
  by rewrite /dot !sum_over_axes; ring_identity.
by rewrite opposite mul0rn subr0.
Qed.
