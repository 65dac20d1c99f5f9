(** * Poisson brackets

Chapters 2, 3 and 4 put brackets on dual algebras, on cotangent bundles and on pairs of configurations. That
each is a Poisson bracket is algebra: it follows from the rule of Leibniz and from derivatives that commute,
in any number of dimensions. *)

From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices ring_identities derivations.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory Num.Theory.
Local Open Scope ring_scope.

(** ** Brackets in coordinates *)

Section Brackets.

Variables (R : comRingType) (n : nat) (d : 'I_n -> derivation R).
Implicit Types (f h : R) (P : 'M[R]_n).

(** The column of partial derivatives of a function. *)
Definition gradient f : 'cV[R]_n := \col_i d i f.

(** The bracket \f$\{f, h\} = P^{ij}\,\partial_if\,\partial_jh\f$ with the matrix of functions \f$P\f$. *)
Definition poisson_bracket P f h : R := ((gradient f)^T *m P *m gradient h) 0 0.

(** _Jacobi's identity_. *)
Definition jacobi (bracket : R -> R -> R) :=
  forall f h k, bracket f (bracket h k) + bracket h (bracket k f) + bracket k (bracket f h) = 0.

(** What has to vanish for it: \f$S^{ijk} = P^{il}\,\partial_lP^{jk} + P^{jl}\,\partial_lP^{ki} +
P^{kl}\,\partial_lP^{ij}\f$. *)
Definition half_schouten P i j k := \sum_l P i l * d l (P j k).
Definition schouten P i j k := half_schouten P i j k + half_schouten P j k i + half_schouten P k i j.

Lemma poisson_bracketE P f h :
  poisson_bracket P f h = \sum_i \sum_j P i j * d i f * d j h.
Proof.
rewrite /poisson_bracket mxE exchange_big; apply: eq_bigr => j _ /=.
rewrite !mxE mulr_suml; apply: eq_bigr => i _; rewrite !mxE.
by rewrite [d i f * _]mulrC.
Qed.

(** The matrix of second derivatives. *)
Definition hessian f : 'M[R]_n := \matrix_(i, j) d i (d j f).

Hypothesis commute : forall i j f, d i (d j f) = d j (d i f).

Lemma hessian_symmetric f : (hessian f)^T = hessian f.
Proof. by apply/matrixP => i j; rewrite !mxE commute. Qed.

(** The gradient of a bracket: one term with derivatives of the matrix, and two with second derivatives. *)
Lemma gradient_of_bracket P h k :
  gradient (poisson_bracket P h k) =
  (\col_l ((gradient h)^T *m derivative_of (d l) P *m gradient k) 0 0)
  + hessian h *m P *m gradient k + hessian k *m P^T *m gradient h.
Proof.
have rows l f : (derivative_of (d l) (gradient f))^T = row l (hessian f).
  by apply/matrixP => i j; rewrite !mxE.
have transposed (u v : 'cV[R]_n) : (u^T *m P *m v) 0 0 = (v^T *m P^T *m u) 0 0.
  have -> : v^T *m P^T *m u = (u^T *m P *m v)^T by rewrite !trmx_mul trmxK mulmxA.
  by rewrite [RHS]mxE.
apply/matrixP => l z; rewrite (ord1 z) {z}.
have -> : gradient (poisson_bracket P h k) l 0
          = derivative_of (d l) ((gradient h)^T *m P *m gradient k) 0 0 by rewrite mxE [RHS]mxE.
rewrite !derivative_of_matrix_product mulmxDl.
have -> : derivative_of (d l) (gradient h)^T = row l (hessian h) by rewrite -rows /derivative_of map_trmx.
rewrite [LHS]mxE [X in X + _]mxE.
have -> : ((gradient h)^T *m P *m derivative_of (d l) (gradient k)) 0 0
          = (row l (hessian k) *m P^T *m gradient h) 0 0 by rewrite transposed rows.
rewrite [X in X + _]addrC -!row_mul ![(row _ _) _ _]mxE.
by rewrite [RHS]mxE; congr (_ + _); rewrite [RHS]mxE; congr (_ + _); rewrite [RHS]mxE.
Qed.

(** The terms with second derivatives, \f$T(f, h, k) = (\nabla f)^TP\,\nabla^2h\,P\,\nabla k\f$. *)
Definition second_order P f h k := ((gradient f)^T *m P *m hessian h *m P *m gradient k) 0 0.

Lemma second_order_symmetric P f h k : P^T = - P -> second_order P f h k = second_order P k h f.
Proof.
move=> skewP; rewrite /second_order.
have -> : (gradient f)^T *m P *m hessian h *m P *m gradient k
          = ((gradient k)^T *m P *m hessian h *m P *m gradient f)^T.
  by rewrite !trmx_mul !trmxK hessian_symmetric skewP !(mulNmx, mulmxN) opprK !mulmxA.
by rewrite mxE.
Qed.

(** Those with derivatives of the matrix. *)
Definition first_order P f h k :=
  \sum_i \sum_j \sum_l half_schouten P i j l * (d i f * d j h * d l k).

Lemma nested_bracket P f h k : P^T = - P ->
  poisson_bracket P f (poisson_bracket P h k) =
  first_order P f h k + second_order P f h k - second_order P f k h.
Proof.
move=> skewP; rewrite {1}/poisson_bracket gradient_of_bracket skewP mulmxN mulNmx mulmxBr mulmxDr.
rewrite /second_order !mulmxA [LHS]mxE [X in X + _]mxE [X in _ + _ + X]mxE; congr (_ + _ - _).
rewrite -mulmxA mxE; apply: eq_bigr => i _; rewrite !mxE mulr_sumr.
under [RHS]eq_bigr do under eq_bigr do rewrite mulr_suml.
under [RHS]eq_bigr do rewrite exchange_big.
rewrite [RHS]exchange_big; apply: eq_bigr => m _; rewrite !mxE exchange_big mulr_sumr mulr_sumr.
apply: eq_bigr => l _; rewrite !mxE mulr_suml !mulr_sumr; apply: eq_bigr => j _; rewrite !mxE.
ring_identity.
Qed.

Lemma first_order_cyclic P f h k :
  first_order P f h k + first_order P h k f + first_order P k f h
  = \sum_i \sum_j \sum_l schouten P i j l * (d i f * d j h * d l k).
Proof.
have -> : first_order P h k f = \sum_i \sum_j \sum_l half_schouten P j l i * (d i f * d j h * d l k).
  rewrite /first_order; under eq_bigr do rewrite exchange_big.
  rewrite exchange_big; apply: eq_bigr => i _; apply: eq_bigr => j _; apply: eq_bigr => l _.
  ring_identity.
have -> : first_order P k f h = \sum_i \sum_j \sum_l half_schouten P l i j * (d i f * d j h * d l k).
  rewrite /first_order exchange_big; apply: eq_bigr => i _; rewrite exchange_big.
  apply: eq_bigr => j _; apply: eq_bigr => l _; ring_identity.
rewrite -!big_split; apply: eq_bigr => i _; rewrite -!big_split; apply: eq_bigr => j _.
by rewrite -!big_split; apply: eq_bigr => l _; rewrite /schouten !mulrDl.
Qed.

(** The bracket of a skew matrix of functions satisfies the identity of Jacobi where \f$S^{ijk} = 0\f$: the
terms with second derivatives cancel each other, because mixed derivatives commute. *)
Lemma jacobi_of_matrix P :
  P^T = - P -> (forall i j k, schouten P i j k = 0) -> jacobi (poisson_bracket P).
Proof.
move=> skewP vanishes f h k; rewrite !nested_bracket //.
have cyclic := first_order_cyclic P f h k.
have zero : \sum_i \sum_j \sum_l schouten P i j l * (d i f * d j h * d l k) = 0.
  by apply: big1 => i _; apply: big1 => j _; apply: big1 => l _; rewrite vanishes mul0r.
rewrite (second_order_symmetric f h k skewP) (second_order_symmetric h k f skewP).
rewrite (second_order_symmetric k f h skewP) -[RHS]zero -cyclic; ring_identity.
Qed.

(** The converse, at coordinates: there the double bracket is the sum of derivatives of the matrix. *)
Lemma matrix_of_jacobi P (x : 'I_n -> R) :
    P^T = - P -> (forall i j, d i (x j) = (i == j)%:R) ->
  jacobi (poisson_bracket P) -> forall i j k, schouten P i j k = 0.
Proof.
move=> skewP coordinates holds i j k; rewrite -[RHS](holds (x i) (x j) (x k)).
have flat l : hessian (x l) = 0.
  apply/matrixP => a b; rewrite !mxE coordinates.
  by case: (b == l); rewrite ?derivative_of_one ?raddf0.
have pick (F : 'I_n -> R) l : \sum_a F a * d a (x l) = F l.
  rewrite (bigD1 l) //= coordinates eqxx mulr1 big1 ?addr0 // => a ne.
  by rewrite coordinates (negbTE ne) mulr0.
have first a b c : first_order P (x a) (x b) (x c) = half_schouten P a b c.
  rewrite /first_order -[RHS](pick (half_schouten P ^~ b ^~ c)); apply: eq_bigr => i' _.
  rewrite -(pick (half_schouten P i' ^~ c)) mulr_suml; apply: eq_bigr => j' _.
  rewrite -(pick (half_schouten P i' j')) !mulr_suml; apply: eq_bigr => k' _; ring_identity.
have second a b c : second_order P (x a) (x b) (x c) = 0.
  by rewrite /second_order flat mulmx0 !mul0mx mxE.
by rewrite !nested_bracket // !first !second !subr0 !addr0.
Qed.

(** A _Poisson bracket_: antisymmetric, a derivation in each argument, with the identity of Jacobi. *)
Definition is_poisson_bracket (b : R -> R -> R) :=
  [/\ forall f h, b f h = - b h f, forall f h k, b f (h + k) = b f h + b f k,
      forall f h k, b f (h * k) = b f h * k + h * b f k & jacobi b].

Lemma is_poisson_bracket_of_matrix P :
  P^T = - P -> jacobi (poisson_bracket P) -> is_poisson_bracket (poisson_bracket P).
Proof.
move=> skewP holds; split=> // [f h|f h k|f h k]; rewrite !poisson_bracketE.
- rewrite exchange_big -sumrN; apply: eq_bigr => i _; rewrite -sumrN; apply: eq_bigr => j _.
  have /matrixP /(_ i j) := skewP; rewrite !mxE => ->.
  ring_identity.
- rewrite -big_split; apply: eq_bigr => i _; rewrite -big_split; apply: eq_bigr => j _.
  by rewrite raddfD mulrDr.
- rewrite mulr_suml mulr_sumr -big_split; apply: eq_bigr => i _.
  rewrite mulr_suml mulr_sumr -big_split; apply: eq_bigr => j _; rewrite leibniz /=; ring_identity.
Qed.

End Brackets.

(** ** The Lie-Poisson bracket *)

Section LiePoisson.

Variables (R : comRingType) (n : nat) (d : 'I_n -> derivation R).
Hypothesis commute : forall i j f, d i (d j f) = d j (d i f).

(** Coordinates \f$\mu_i\f$ of the dual algebra, and structure constants of the algebra in the dual basis,
\f$[e_i, e_j] = c_{ij}{}^ke_k\f$. *)
Variables (mu : 'I_n -> R) (c : 'I_n -> 'I_n -> 'I_n -> R).
Hypothesis coordinates : forall i j, d i (mu j) = (i == j)%:R.
Hypothesis constants : forall l i j k, d l (c i j k) = 0.
Hypothesis antisymmetric : forall i j k, c i j k = - c j i k.

(** The matrix \f$\{\mu_i, \mu_j\}_+ = \langle\mu, [e_i, e_j]\rangle\f$ of the plus bracket.
C++: `actio::lie_poisson_tensor_plus`, `variational/lie_poisson.hpp`. *)
Definition lie_poisson_tensor_plus : 'M[R]_n := \matrix_(i, j) \sum_k c i j k * mu k.

(** \f$\{F, H\}_+(\mu) = \langle\mu, [\delta F/\delta\mu, \delta H/\delta\mu]\rangle\f$.
C++: `actio::lie_poisson_bracket_plus`, `variational/lie_poisson.hpp`. *)
Definition lie_poisson_bracket_plus := poisson_bracket d lie_poisson_tensor_plus.

(** The identity of Jacobi for the structure constants. *)
Definition jacobi_of_constants :=
  forall i j k m, \sum_l (c i j l * c l k m + c j k l * c l i m + c k i l * c l j m) = 0.

Lemma lie_poisson_tensor_skew : lie_poisson_tensor_plus^T = - lie_poisson_tensor_plus.
Proof.
by apply/matrixP => i j; rewrite !mxE -sumrN; apply: eq_bigr => k _; rewrite antisymmetric mulNr.
Qed.

Lemma derivative_of_combination m (a : 'I_n -> R) :
  (forall p, d m (a p) = 0) -> d m (\sum_p a p * mu p) = a m.
Proof.
move=> constant_a; rewrite raddf_sum (bigD1 m) //= leibniz coordinates constant_a eqxx mul0r add0r mulr1.
by rewrite big1 ?addr0 // => p ne; rewrite leibniz coordinates constant_a eq_sym (negbTE ne) mul0r mulr0
  addr0.
Qed.

Lemma lie_poisson_half_schouten i j k :
  half_schouten d lie_poisson_tensor_plus i j k = - \sum_m (\sum_l c j k l * c l i m) * mu m.
Proof.
rewrite /half_schouten (eq_bigr (fun l => \sum_m - (c j k l * c l i m * mu m))); last first.
  move=> l _; rewrite !mxE derivative_of_combination // mulr_suml; apply: eq_bigr => m _ /=.
  rewrite [c i l m]antisymmetric; ring_identity.
rewrite exchange_big -sumrN; apply: eq_bigr => m _; rewrite mulr_suml -sumrN.
by apply: eq_bigr => l _.
Qed.

(** ** The dual of a Lie algebra is a Poisson manifold

Theorem 2.2.2 says that the bracket
\f[ \{F, H\}_+(\mu) = \Bigl\langle\mu, \Bigl[\frac{\delta F}{\delta\mu},
\frac{\delta H}{\delta\mu}\Bigr]\Bigr\rangle \f]
is a Poisson structure. It is antisymmetric and a derivation in each argument because the bracket of the
algebra is antisymmetric, and it satisfies the identity of Jacobi if and only if the algebra does: for
structure constants of any finite dimension over any commutative ring, and functions of any kind of the
coordinates \f$\mu_i\f$. The minus bracket is the same with \f$-c_{ij}{}^k\f$. *)
Theorem thm_2_2_2_poisson_structure :
  is_poisson_bracket lie_poisson_bracket_plus <-> jacobi_of_constants.
Proof.
have schoutenE i j k : schouten d lie_poisson_tensor_plus i j k =
    - \sum_m (\sum_l (c i j l * c l k m + c j k l * c l i m + c k i l * c l j m)) * mu m.
  rewrite /schouten !lie_poisson_half_schouten -!opprD -!big_split; congr (- _).
  by apply: eq_bigr => m _; rewrite !big_split /= !mulrDl [RHS]addrAC [RHS]addrC addrA addrAC.
split=> [[_ _ _ holds] i j k m|holds].
  have := matrix_of_jacobi lie_poisson_tensor_skew coordinates holds i j k.
  rewrite schoutenE => /eqP; rewrite oppr_eq0 => /eqP /(congr1 (d m)).
  rewrite raddf0 derivative_of_combination // => p; rewrite raddf_sum big1 // => l _.
  by rewrite !raddfD /= !leibniz !constants !(mul0r, mulr0, addr0).
apply: (is_poisson_bracket_of_matrix lie_poisson_tensor_skew).
apply: (jacobi_of_matrix commute lie_poisson_tensor_skew) => i j k.
by rewrite schoutenE big1 ?oppr0 // => m _; rewrite holds mul0r.
Qed.

End LiePoisson.

(** ** The canonical bracket and brackets of symplectic forms *)

Section Symplectic.

Variables (R : comUnitRingType) (n : nat) (d : 'I_n -> derivation R).
Hypothesis commute : forall i j f, d i (d j f) = d j (d i f).

(** The vector \f$X_F\f$ with \f$X_F\lrcorner\,\omega = dF\f$, for a two-form with the matrix
\f$\omega_{ij}\f$. *)
Definition hamiltonian_vector (omega : 'M[R]_n) F : 'cV[R]_n := - invmx omega *m gradient d F.

(** \f$\{F, H\} = \omega(X_F, X_H)\f$, as in (3.12). *)
Definition symplectic_bracket (omega : 'M[R]_n) F H : R :=
  ((hamiltonian_vector omega F)^T *m omega *m hamiltonian_vector omega H) 0 0.

(** A two-form is closed where \f$\partial_i\omega_{jk} + \partial_j\omega_{ki} + \partial_k\omega_{ij} =
0\f$. *)
Definition closed (omega : 'M[R]_n) :=
  forall i j k, d i (omega j k) + d j (omega k i) + d k (omega i j) = 0.

Variable omega : 'M[R]_n.
Hypothesis skew_form : omega^T = - omega.
Hypothesis nondegenerate : omega \in unitmx.

Lemma skew_inverse : (- invmx omega)^T = - - invmx omega.
Proof.
have : (- invmx omega)^T *m omega = 1%:M.
  by rewrite -[X in _ *m X]trmxK -trmx_mul skew_form mulNmx mulmxN opprK mulmxV // trmx1.
by move/(congr1 (mulmx^~ (invmx omega))); rewrite -mulmxA mulmxV // mulmx1 mul1mx opprK.
Qed.

Lemma hamiltonian_vectorE F :
  (hamiltonian_vector omega F)^T *m omega = (gradient d F)^T.
Proof. by rewrite /hamiltonian_vector trmx_mul skew_inverse opprK -mulmxA mulVmx // mulmx1. Qed.

Lemma symplectic_bracketE F H :
  symplectic_bracket omega F H = poisson_bracket d (- invmx omega) F H.
Proof. by rewrite /symplectic_bracket hamiltonian_vectorE /hamiltonian_vector mulmxA. Qed.

(** ** The bracket on pairs of configurations

With \f$X_F\lrcorner\,\omega = dF\f$ the equation
\f[ \{F, H\} = \omega(X_F, X_H) \f]
defines a Poisson structure, as is said before (3.12) of the discrete two-form: for each two-form on a space
of any dimension that is nondegenerate and closed. *)
Theorem eq_3_12_poisson_structure : closed omega -> is_poisson_bracket (symplectic_bracket omega).
Proof.
move=> closed_form.
pose P := - invmx omega.
have sameE F H : symplectic_bracket omega F H = poisson_bracket d P F H by apply: symplectic_bracketE.
have skewP : P^T = - P by apply: skew_inverse.
have derivative_of_P l : derivative_of (d l) P = P *m derivative_of (d l) omega *m P.
  by rewrite /P derivative_of_matrix_opp derivative_of_inverse_matrix // opprK mulNmx mulmxN mulNmx opprK.
clearbody P.
have halfE i j k : half_schouten d P i j k
    = - \sum_l \sum_m \sum_p P i l * P j m * P k p * d l (omega m p).
  rewrite /half_schouten -sumrN; apply: eq_bigr => l _.
  have -> : d l (P j k) = (P *m derivative_of (d l) omega *m P) j k by rewrite -derivative_of_P [RHS]mxE.
  rewrite mxE mulr_sumr exchange_big -sumrN; apply: eq_bigr => p _.
  rewrite mxE mulr_suml mulr_sumr -sumrN; apply: eq_bigr => m _; rewrite mxE.
  have /matrixP /(_ k p) := skewP; rewrite !mxE => ->.
  ring_identity.
have closed_sum i j k : schouten d P i j k
    = - \sum_l \sum_m \sum_p P i l * P j m * P k p * (d l (omega m p) + d m (omega p l) + d p (omega l m)).
  rewrite /schouten !halfE.
  have -> : \sum_l \sum_m \sum_p P j l * P k m * P i p * d l (omega m p)
            = \sum_l \sum_m \sum_p P i l * P j m * P k p * d m (omega p l).
    under eq_bigr do rewrite exchange_big.
    rewrite exchange_big; apply: eq_bigr => l _; apply: eq_bigr => m _; apply: eq_bigr => p _.
    ring_identity.
  have -> : \sum_l \sum_m \sum_p P k l * P i m * P j p * d l (omega m p)
            = \sum_l \sum_m \sum_p P i l * P j m * P k p * d p (omega l m).
    rewrite exchange_big; apply: eq_bigr => l _; rewrite exchange_big.
    apply: eq_bigr => m _; apply: eq_bigr => p _; ring_identity.
  rewrite -!opprD -!big_split; congr (- _); apply: eq_bigr => l _; rewrite -!big_split.
  by apply: eq_bigr => m _; rewrite -!big_split; apply: eq_bigr => p _; rewrite /= -!mulrDr.
have vanishes i j k : schouten d P i j k = 0.
  rewrite closed_sum big1 ?oppr0 // => l _; rewrite big1 // => m _; rewrite big1 // => p _.
  by rewrite closed_form mulr0.
have [skew_b add_b leibniz_b jacobi_b] :=
  is_poisson_bracket_of_matrix skewP (jacobi_of_matrix commute skewP vanishes).
by split=> [f h|f h k|f h k|f h k]; rewrite !sameE.
Qed.

End Symplectic.

Section Pairs.

Variables (R : comUnitRingType) (n : nat) (d : 'I_(n + n) -> derivation R).
Hypothesis commute : forall i j f, d i (d j f) = d j (d i f).

(** Coordinates of pairs \f$(g_0, g_1)\f$: the first \f$n\f$ are those of \f$g_0\f$, with the mark 0, the
others those of \f$g_1\f$, with the mark 1. *)
Definition side (i : 'I_(n + n)) : R := (n <= i)%:R.

(** The discrete Lagrange two-form (3.5), \f$\frac{\partial^2\mathbb L}{\partial g_0^i\,\partial g_1^j}\,
dg_1^j\wedge dg_0^i\f$, as a matrix on pairs. *)
Definition discrete_lagrange_two_form (L : R) : 'M[R]_(n + n) :=
  \matrix_(i, j) ((side i - side j) * d i (d j L)).

(** The bracket (3.12) on pairs is a Poisson bracket, for each discrete Lagrangian whose two-form is
nondegenerate. *)
Theorem eq_3_12_on_pairs (L : R) :
    discrete_lagrange_two_form L \in unitmx ->
  is_poisson_bracket (symplectic_bracket d (discrete_lagrange_two_form L)).
Proof.
have constant l i : d l (side i) = 0 by rewrite derivative_of_nat.
move=> unit_form; apply: (eq_3_12_poisson_structure commute) => //.
  by apply/matrixP => i j; rewrite !mxE (commute j i); ring_identity.
move=> i j k; rewrite !mxE !leibniz !raddfB /= !constant.
rewrite (commute k i L) (commute k i (d j L)) (commute k j L) (commute j i (d k L)); ring_identity.
Qed.

End Pairs.

Section Canonical.

Variables (R : comRingType) (n : nat) (d_q d_p : 'I_n -> derivation R).
Hypothesis commute_q : forall i j f, d_q i (d_q j f) = d_q j (d_q i f).
Hypothesis commute_p : forall i j f, d_p i (d_p j f) = d_p j (d_p i f).
Hypothesis commute_qp : forall i j f, d_q i (d_p j f) = d_p j (d_q i f).

(** \f$\{F, H\} = \frac{\partial F}{\partial q^i}\frac{\partial H}{\partial p_i} -
\frac{\partial F}{\partial p_i}\frac{\partial H}{\partial q^i}\f$. *)
Definition canonical_bracket F H := \sum_i (d_q i F * d_p i H - d_p i F * d_q i H).

(** The canonical bracket of a cotangent bundle is a Poisson bracket (section 2.2, section 4.1). *)
Theorem claim_4_1_dual_poisson_canonical : is_poisson_bracket canonical_bracket.
Proof.
pose d (i : 'I_(n + n)) := match split i with inl j => d_q j | inr j => d_p j end.
pose P : 'M[R]_(n + n) := block_mx 0 1%:M (- 1%:M) 0.
have commute i j f : d i (d j f) = d j (d i f).
  by rewrite /d; case: (split i) => i'; case: (split j) => j'; rewrite ?commute_qp.
have skewP : P^T = - P by rewrite tr_block_mx opp_block_mx !trmx0 !oppr0 opprK linearN /= trmx1.
have constantP l i j : d l (P i j) = 0.
  rewrite /P /block_mx !mxE; case: (split i) => i'; rewrite !mxE; case: (split j) => j'; rewrite !mxE.
  - exact: raddf0.
  - exact: derivative_of_nat.
  - by rewrite raddfN /= derivative_of_nat oppr0.
  - exact: raddf0.
have sameE F H : canonical_bracket F H = poisson_bracket d P F H.
  have gradientE f : gradient d f = col_mx (gradient d_q f) (gradient d_p f).
    by apply/matrixP => i j; rewrite !mxE /d; case: (split i) => i'; rewrite mxE.
  rewrite /poisson_bracket !gradientE tr_col_mx mul_row_block !mulmx0 !mulmx1 mulmxN add0r addr0.
  rewrite mul_row_col mulNmx [RHS]mxE [X in _ = X + _]mxE addrC mxE mulmx1 mxE.
  by rewrite /canonical_bracket sumrB; congr (_ - _); apply: eq_bigr => i _; rewrite !mxE.
have vanishes i j k : schouten d P i j k = 0.
  by rewrite /schouten /half_schouten !big1 ?addr0 // => l _; rewrite constantP mulr0.
have [skew_b add_b leibniz_b jacobi_b] :=
  is_poisson_bracket_of_matrix skewP (jacobi_of_matrix commute skewP vanishes).
by split=> [f h|f h k|f h k|f h k]; rewrite !sameE.
Qed.

End Canonical.

(** ** Where the plus sign of the bracket comes from *)

Section Reduction.

Variables (R : comUnitRingType) (n : nat).
Implicit Types g p phi psi : 'M[R]_n.

(** On the cotangent bundle of \f$\mathrm{GL}(n)\f$, with the entries of \f$g\f$ as coordinates and those of
\f$p\f$ as momenta, the canonical bracket of two functions is made of their partial derivatives, here
matrices: \f$\{F, H\} = \langle\partial F/\partial g, \partial H/\partial p\rangle -
\langle\partial F/\partial p, \partial H/\partial g\rangle\f$. *)
Definition canonical_pairing (F_g F_p H_g H_p : 'M[R]_n) := pairing F_g H_p - pairing F_p H_g.

(** The partial derivatives of a function \f$f(\mu)\f$ of the momentum \f$\mu = R_g^*p = p\,g^T\f$, whose
derivative at \f$\mu\f$ is \f$\phi = \delta f/\delta\mu\f$: the chain rule. *)
Definition derivatives_right g p phi F_g F_p :=
  forall dg dp, pairing F_g dg + pairing F_p dp = pairing (R_star g dp + R_star dg p) phi.

(** The same for \f$\Pi = L_g^*p = g^Tp\f$. *)
Definition derivatives_left g p phi F_g F_p :=
  forall dg dp, pairing F_g dg + pairing F_p dp = pairing (L_star g dp + L_star dg p) phi.

Lemma pairing_symmetric p v : pairing p v = pairing v p.
Proof. by rewrite /pairing -mxtrace_tr trmx_mul trmxK. Qed.

Lemma pairing_additive p q v : pairing (p + q) v = pairing p v + pairing q v.
Proof. by rewrite /pairing linearD /= mulmxDl mxtraceD. Qed.

Lemma pairing_injective p q : (forall v, pairing p v = pairing q v) -> p = q.
Proof.
move=> same; apply/eqP; rewrite -subr_eq0; apply/eqP/pairing_nondegenerate => v.
by rewrite /pairing linearB /= mulmxBl raddfB /= -!/(pairing _ _) same subrr.
Qed.

Lemma derivatives_rightE g p phi F_g F_p :
  derivatives_right g p phi F_g F_p -> F_g = phi^T *m p /\ F_p = phi *m g.
Proof.
move=> chain; split; apply: pairing_injective => v.
  have := chain v 0; rewrite /pairing /R_star !mulmx0 mxtrace0 addr0 mul0mx add0r => ->.
  by rewrite !trmx_mul !trmxK -mulmxA mxtrace_mulC.
have := chain 0 v; rewrite /pairing /R_star !mulmx0 mxtrace0 add0r trmx0 mulmx0 addr0 => ->.
by rewrite -[RHS]mxtrace_tr !trmx_mul !trmxK -mulmxA mxtrace_mulC -mulmxA.
Qed.

Lemma derivatives_leftE g p phi F_g F_p :
  derivatives_left g p phi F_g F_p -> F_g = p *m phi^T /\ F_p = g *m phi.
Proof.
move=> chain; split; apply: pairing_injective => v.
  have := chain v 0; rewrite /pairing /L_star !mulmx0 mxtrace0 addr0 add0r => ->.
  by rewrite !trmx_mul !trmxK [LHS]mxtrace_mulC mulmxA.
have := chain 0 v; rewrite /pairing /L_star !mulmx0 mxtrace0 add0r trmx0 mul0mx addr0 => ->.
by rewrite -[RHS]mxtrace_tr !trmx_mul !trmxK -mulmxA.
Qed.

(** ** The plus bracket comes from right-invariant functions

Theorem 2.2.2: the canonical bracket of two right-invariant functions on the cotangent bundle, that is of two
functions of \f$\mu = R_g^*p\f$, is the plus bracket
\f$\langle\mu, [\delta F/\delta\mu, \delta H/\delta\mu]\rangle\f$ of the functions on the dual algebra. It is
proved here for the group \f$\mathrm{GL}(n)\f$ of any size, over any commutative ring, with
\f$\{q, p\} = +1\f$ and the commutator of matrices. The chain rule is the one hypothesis: it determines the
partial derivatives. *)
Theorem thm_2_2_2_right g p phi psi F_g F_p H_g H_p :
    derivatives_right g p phi F_g F_p -> derivatives_right g p psi H_g H_p ->
  canonical_pairing F_g F_p H_g H_p = pairing (R_star g p) (bracket phi psi).
Proof.
case/derivatives_rightE => -> ->; case/derivatives_rightE => -> ->.
rewrite /canonical_pairing [X in _ - X]pairing_symmetric /pairing /R_star /bracket.
rewrite !trmx_mul !trmxK mulmxBr raddfB /= !mulmxA; congr (_ - _).
  by rewrite [LHS]mxtrace_mulC !mulmxA.
by rewrite [LHS]mxtrace_mulC !mulmxA.
Qed.

(** The same for left-invariant functions, functions of \f$\Pi = L_g^*p\f$: they have the minus bracket. *)
Theorem thm_2_2_2_left g p phi psi F_g F_p H_g H_p :
    derivatives_left g p phi F_g F_p -> derivatives_left g p psi H_g H_p ->
  canonical_pairing F_g F_p H_g H_p = - pairing (L_star g p) (bracket phi psi).
Proof.
case/derivatives_leftE => -> ->; case/derivatives_leftE => -> ->.
rewrite /canonical_pairing [X in _ - X]pairing_symmetric /pairing /L_star /bracket.
rewrite !trmx_mul !trmxK mulmxBr raddfB /= !mulmxA opprB; congr (_ - _).
  by rewrite -!mulmxA mxtrace_mulC !mulmxA.
by rewrite -!mulmxA mxtrace_mulC !mulmxA.
Qed.

(** ** The Lie-Poisson equations and the plus bracket

Conditions iii and iv of Theorem 2.2.3 say the same at each instant: \f$\dot\mu =
-\mathrm{ad}^*_{\partial h/\partial\mu}\mu\f$ if and only if \f$\dot f = \{f, h\}_+\f$ for all functions
\f$f\f$, that is for all differentials \f$\phi = \delta f/\delta\mu\f$, with
\f$\dot f = \langle\dot\mu, \phi\rangle\f$. *)
Theorem claim_2_2_lie_poisson_equivalence_iii_iv (mu rate dh : 'M[R]_n) :
  rate = - ad_star dh mu <-> forall phi, pairing rate phi = pairing mu (bracket phi dh).
Proof.
have rateE phi : pairing (- ad_star dh mu) phi = pairing mu (bracket phi dh).
  have -> : bracket phi dh = - bracket dh phi by rewrite /bracket opprB.
  rewrite {1}/pairing linearN /= mulNmx raddfN /= -/(pairing _ _) ad_star_dual /ad.
  by rewrite /pairing mulmxN raddfN.
split=> [-> //|same]; apply: pairing_injective => phi; by rewrite same rateE.
Qed.

End Reduction.
