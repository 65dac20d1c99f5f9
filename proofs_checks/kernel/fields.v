(** * Fields: densities on jets, their field equations and currents

Chapters 6, 7 and 9 for a general density. Functions on jets form a commutative ring, and a vector field is a
derivation of it: the partial derivatives in the coordinates of a jet, and the total derivatives \f$D_\mu\f$
along a section. A form is known by its values on vector fields, and these are determinants. There are \f$n +
1\f$ coordinates \f$x^\mu\f$ of space-time, the first of them time, and \f$N\f$ fields, in any numbers. What
the fields are smooth functions of does not matter: all that is used are the rule of Leibniz and, where it is
named, the chain rule. *)

From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices ring_identities derivations.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

(** A function, or a vector, before others. *)
Definition before (T : Type) k (h : T) (f : 'I_k -> T) (i : 'I_(1 + k)) : T :=
  match split i with inl _ => h | inr j => f j end.

(** The \f$\mu\f$-th of them replaced. *)
Definition replaced (T : Type) k (f : 'I_k -> T) (mu : 'I_k) (h : T) : 'I_k -> T :=
  fun nu => if nu == mu then h else f nu.

(** \f$(df_1\wedge\dots\wedge df_k)(u_1, \dots, u_k) = \det\bigl(u_j(f_i)\bigr)\f$. C++: `actio::wedge`,
`forms/wedge.hpp`. *)
Definition wedge (R : comRingType) k (f : 'I_k -> R) (u : 'I_k -> derivation R) : R :=
  \det (\matrix_(i, j) u j (f i)).

Section Fields.

Variables (R : comRingType) (n N : nat).

(** Coordinates of a jet, \f$x^\mu\f$, \f$y^a\f$ and \f$v^a{}_\mu\f$, and the partial derivatives in them. *)
Variables (x : 'I_n.+1 -> R) (y : 'I_N -> R) (v : 'I_N -> 'I_n.+1 -> R).
Variables (d_x : 'I_n.+1 -> derivation R) (d_y : 'I_N -> derivation R) (d_v : 'I_N -> 'I_n.+1 ->
  derivation R).

(** The total derivatives along a section. *)
Variable D : 'I_n.+1 -> derivation R.

Implicit Types (L f : R) (u V W X : derivation R).

(** The _chain rule_ for a function of first jets along a vector field \f$u\f$:
\f$df(u) = \frac{\partial f}{\partial x^\mu}\,dx^\mu(u) + \frac{\partial f}{\partial y^a}\,dy^a(u) +
\frac{\partial f}{\partial v^a{}_\mu}\,dv^a{}_\mu(u)\f$. *)
Definition chain_rule f u :=
  u f = \sum_mu u (x mu) * d_x mu f + \sum_a u (y a) * d_y a f + \sum_a \sum_mu u (v a mu) * d_v a mu f.

(** The momenta (6.4) of a density. C++: `actio::momenta`, `jets/density.hpp`. *)
Definition momentum L a mu := d_v a mu L.

(** The affine momentum \f$\Pi = L - p_a{}^\mu v^a{}_\mu\f$. The member `Pi` of
what the Legendre transformation gives. C++: `actio::legendre`, `jets/density.hpp`. *)
Definition affine_momentum L := L - \sum_a \sum_mu momentum L a mu * v a mu.

(** The Euler-Lagrange derivative (6.12): \f$E_a = \frac{\partial L}{\partial y^a} -
D_\mu\frac{\partial L}{\partial v^a{}_\mu}\f$. C++: `actio::euler_lagrange`, `jets/field_equations.hpp`. *)
Definition euler_lagrange L a := d_y a L - \sum_mu D mu (momentum L a mu).

(** The Cartan form (6.10) on \f$n + 1\f$ vectors: \f$\Theta = p_a{}^\mu\,dy^a\wedge d^nx_\mu +
\Pi\,d^{n+1}x\f$. With \f$d^nx_\mu = \partial_\mu\lrcorner\,d^{n+1}x\f$ the form \f$dh\wedge d^nx_\mu\f$ is
\f$dx^0\wedge\dots\wedge dx^n\f$ with \f$dh\f$ at the \f$\mu\f$-th place. C++: `actio::cartan_form`,
`jets/cartan.hpp`. *)
Definition cartan_form L (u : 'I_n.+1 -> derivation R) : R :=
  \sum_a \sum_mu momentum L a mu * wedge (replaced x mu (y a)) u + affine_momentum L * wedge x u.

(** The form \f$\Omega = -d\Theta = dy^a\wedge dp_a{}^\mu\wedge d^nx_\mu - d\Pi\wedge d^{n+1}x\f$ on
\f$n + 2\f$ vectors, as section 6.1 writes it. C++: `actio::multisymplectic_form`, `jets/cartan.hpp`. *)
Definition multisymplectic_form L (u : 'I_(1 + n.+1) -> derivation R) : R :=
  \sum_a \sum_mu wedge (before (y a) (replaced x mu (momentum L a mu))) u
  - wedge (before (affine_momentum L) x) u.

Hypothesis along_x : forall mu nu, D nu (x mu) = (mu == nu)%:R.
Hypothesis along_y : forall a mu, D mu (y a) = v a mu.

(** *** Determinants with one row or one column replaced *)

Lemma wedge_on_section mu h : wedge (replaced x mu h) D = D mu h.
Proof.
rewrite /wedge.
have -> : \matrix_(i, j) D j (replaced x mu h i)
          = 1%:M + delta_mx mu (0 : 'I_1) *m (\row_j (D j h - (mu == j)%:R)).
  apply/matrixP => i j; rewrite !mxE big_ord1 !mxE /replaced eqxx andbT.
  case: eqP => [->|_]; rewrite ?along_x ?mul0r ?addr0 // mul1r addrC subrK //.
rewrite determinant_of_sum det_mx11 mxE [X in _ + X]mxE (bigD1 mu) //= !mxE !eqxx mulr1 big1 => [|j ne].
  by rewrite addr0 addrC subrK.
by rewrite !mxE (negbTE ne) mulr0.
Qed.

Lemma volume_on_section : wedge x D = 1.
Proof.
rewrite /wedge -[RHS](det1 R n.+1); congr (\det _); apply/matrixP => i j; by rewrite !mxE along_x.
Qed.

(** ** The density from the Cartan form

Corollary 6.2.1: along a section the Cartan form gives back the density, \f$(j^1\phi)^*\Theta =
L\,d^{n+1}x\f$. Pulled back along a section a form is known by its value on the total derivatives \f$D_0,
\dots, D_n\f$, on which \f$d^{n+1}x\f$ is 1. *)
Theorem cor_6_2_1 L : cartan_form L D = L.
Proof.
rewrite /cartan_form volume_on_section mulr1.
have -> : \sum_a \sum_mu momentum L a mu * wedge (replaced x mu (y a)) D
          = \sum_a \sum_mu momentum L a mu * v a mu.
  by apply: eq_bigr => a _; apply: eq_bigr => mu _; rewrite wedge_on_section along_y.
by rewrite addrC /affine_momentum subrK.
Qed.

(** A vector before the total derivatives: its part along the section drops out. *)
Definition vertical_part W f : R := W f - \sum_nu W (x nu) * D nu f.

Lemma wedge_before h (f : 'I_n.+1 -> R) W :
  wedge (before h f) (before W D) =
  \det (block_mx (vertical_part W h)%:M (\row_j D j h)
                 (\col_i vertical_part W (f i)) (\matrix_(i, j) D j (f i))).
Proof.
pose xi : 'cV[R]_n.+1 := \col_nu W (x nu).
have -> : block_mx (vertical_part W h)%:M (\row_j D j h)
                   (\col_i vertical_part W (f i)) (\matrix_(i, j) D j (f i))
  = block_mx (W h)%:M (\row_j D j h) (\col_i W (f i)) (\matrix_(i, j) D j (f i))
    *m block_mx 1%:M 0 (- xi) 1%:M.
  rewrite mulmx_block !mulmx0 !mulmx1 !add0r; congr (block_mx _ _ _ _).
    apply/matrixP => i j; rewrite (ord1 i) (ord1 j) !mxE /= /vertical_part mulr1n; congr (_ + _).
    by rewrite -sumrN; apply: eq_bigr => nu _; rewrite !mxE mulrN mulrC.
  apply/matrixP => i j; rewrite (ord1 j) !mxE /vertical_part; congr (_ + _).
  by rewrite -sumrN; apply: eq_bigr => nu _; rewrite !mxE mulrN mulrC.
rewrite det_mulmx det_lblock !det1 !mulr1 /wedge; congr (\det _).
apply/matrixP => i j; rewrite /block_mx !mxE /before.
by case: (splitP i) => i' _; rewrite !mxE; case: (splitP j) => j' _;
  rewrite !mxE ?(ord1 i') ?(ord1 j') ?mulr1n.
Qed.

Lemma vertical_part_of_base mu W : vertical_part W (x mu) = 0.
Proof.
rewrite /vertical_part (bigD1 mu) //= along_x eqxx mulr1 big1 => [|k ne]; first by rewrite addr0 subrr.
by rewrite along_x eq_sym (negbTE ne) mulr0.
Qed.

Lemma volume_before h W : wedge (before h x) (before W D) = vertical_part W h.
Proof.
rewrite wedge_before.
have -> : \matrix_(i, j) D j (x i) = 1%:M by apply/matrixP => i j; rewrite !mxE along_x.
have -> : \col_i vertical_part W (x i) = 0 by apply/matrixP => i j; rewrite !mxE vertical_part_of_base.
by rewrite det_ublock det1 mulr1 det_scalar1.
Qed.

Lemma wedge_replaced_before h mu q W :
  wedge (before h (replaced x mu q)) (before W D)
  = vertical_part W h * D mu q - vertical_part W q * D mu h.
Proof.
pose e : 'cV[R]_n.+1 := delta_mx mu 0.
pose b : 'rV[R]_n.+1 := \row_j D j h; pose r : 'rV[R]_n.+1 := \row_j (D j q - (mu == j)%:R).
pose P : 'M_(1 + n.+1, 1 + 1) := block_mx 1%:M 0 0 e.
pose Q : 'M_(1 + 1, 1 + n.+1) := block_mx (vertical_part W h - 1)%:M b (vertical_part W q)%:M r.
have -> : wedge (before h (replaced x mu q)) (before W D) = \det (1%:M + P *m Q).
  rewrite wedge_before /P /Q mulmx_block !mul1mx !mul0mx !addr0 !add0r.
  rewrite [in RHS](@scalar_mx_block R 1 n.+1) add_block_mx !add0r.
  congr (\det (block_mx _ _ _ _)); apply/matrixP => i j.
  - by rewrite !mxE -mulrnDl addrC subrK.
  - rewrite (ord1 j) !mxE big_ord1 !mxE eqxx andbT mulr1n /replaced; case: eqP => _.
      by rewrite mul1r.
    by rewrite vertical_part_of_base mul0r.
  - rewrite !mxE big_ord1 !mxE eqxx andbT /replaced; case: eqP => [->|_].
      by rewrite mul1r addrC subrK.
    by rewrite along_x mul0r addr0.
rewrite determinant_of_sum /P /Q mulmx_block !mulmx1 !mulmx0 !addr0 !add0r.
rewrite [1%:M](@scalar_mx_block R 1 1) add_block_mx !add0r determinant_of_blocks.
have pick (s : 'rV[R]_n.+1) : (s *m e) 0 0 = s 0 mu.
  rewrite mxE (bigD1 mu) //= !mxE !eqxx mulr1 big1 ?addr0 // => k ne.
  by rewrite !mxE (negbTE ne) mulr0.
rewrite [in X in X * _ - _]mxE [in X in _ * X - _]mxE !pick !mxE !eqxx /= !mulr1n; ring_identity.
Qed.

Lemma vertical_part_of_product W f g :
  vertical_part W (f * g) = vertical_part W f * g + f * vertical_part W g.
Proof.
rewrite /vertical_part leibniz.
have -> : \sum_nu W (x nu) * D nu (f * g)
          = (\sum_nu W (x nu) * D nu f) * g + f * \sum_nu W (x nu) * D nu g.
  rewrite mulr_suml mulr_sumr -big_split; apply: eq_bigr => nu _; rewrite leibniz /=; ring_identity.
ring_identity.
Qed.

Lemma vertical_part_of_difference W f g :
  vertical_part W (f - g) = vertical_part W f - vertical_part W g.
Proof.
rewrite /vertical_part raddfB /=.
have -> : \sum_nu W (x nu) * D nu (f - g)
          = \sum_nu W (x nu) * D nu f - \sum_nu W (x nu) * D nu g.
  by rewrite -sumrB; apply: eq_bigr => nu _; rewrite raddfB mulrBr.
ring_identity.
Qed.

Lemma vertical_part_of_sum W (I : finType) (f : I -> R) :
  vertical_part W (\sum_i f i) = \sum_i vertical_part W (f i).
Proof.
rewrite /vertical_part sumrB raddf_sum; congr (_ - _).
by rewrite exchange_big; apply: eq_bigr => nu _; rewrite raddf_sum mulr_sumr.
Qed.

Lemma vertical_part_of_field W a : vertical_part W (y a) = W (y a) - \sum_mu v a mu * W (x mu).
Proof.
by rewrite /vertical_part; congr (_ - _); apply: eq_bigr => nu _; rewrite along_y mulrC.
Qed.

(** The chain rule for the vertical part. *)
Lemma vertical_chain_rule L W : chain_rule L W -> (forall mu, chain_rule L (D mu)) ->
  vertical_part W L = \sum_a vertical_part W (y a) * d_y a L
                      + \sum_a \sum_mu vertical_part W (v a mu) * d_v a mu L.
Proof.
move=> along_W along_D.
have part (I : finType) (c g : I -> R) :
    \sum_i vertical_part W (c i) * g i
    = \sum_i W (c i) * g i - \sum_nu W (x nu) * \sum_i D nu (c i) * g i.
  under [X in _ = _ - X]eq_bigr do rewrite mulr_sumr.
  rewrite [X in _ = _ - X]exchange_big -sumrB; apply: eq_bigr => i _.
  rewrite /vertical_part mulrBl mulr_suml; congr (_ - _); apply: eq_bigr => nu _.
  by rewrite mulrA.
have base : \sum_mu vertical_part W (x mu) * d_x mu L = 0.
  by rewrite big1 // => mu _; rewrite vertical_part_of_base mul0r.
rewrite -[RHS]add0r -[X in X + _]base !pair_bigA !part.
rewrite {1}/vertical_part along_W !pair_bigA.
have -> : \sum_nu W (x nu) * D nu L
  = \sum_nu W (x nu) * (\sum_i D nu (x i) * d_x i L)
    + \sum_nu W (x nu) * (\sum_i D nu (y i) * d_y i L)
    + \sum_nu W (x nu) * (\sum_i D nu (v i.1 i.2) * d_v i.1 i.2 L).
  rewrite -!big_split; apply: eq_bigr => nu _; rewrite along_D pair_bigA /=; ring_identity.
ring_identity.
Qed.

(** ** The Euler-Lagrange derivative and the multisymplectic form

With \f$\Omega = -d\Theta\f$, as it is set after (6.6), for every vector field \f$W\f$ on the jet bundle
\f[ (j^1\phi)^*(W\lrcorner\Omega) = -E_a\,(W^a - v^a{}_\mu W^\mu)\,d^{n+1}x , \f]
where \f$E_a\f$ is the Euler-Lagrange derivative (6.12). So (6.8) has the sign that is printed in it reversed,
\f$D_{EL}\mathcal L\cdot\mathcal V = -(j^1\phi)^*[j^1\mathcal V\lrcorner\Omega]\f$, for arbitrary variations.
That \f$W\f$ is the prolongation of a variation is not used, nor that the section has commuting second
derivatives: only the chain rule for the density along \f$W\f$ and along the section. *)
Theorem eq_6_8 L W : chain_rule L W -> (forall mu, chain_rule L (D mu)) ->
  multisymplectic_form L (before W D)
  = - \sum_a euler_lagrange L a * (W (y a) - \sum_mu v a mu * W (x mu)).
Proof.
move=> along_W along_D; rewrite /multisymplectic_form volume_before.
have -> : \sum_a \sum_mu wedge (before (y a) (replaced x mu (momentum L a mu))) (before W D)
  = \sum_a vertical_part W (y a) * (\sum_mu D mu (momentum L a mu))
    - \sum_a \sum_mu vertical_part W (momentum L a mu) * v a mu.
  rewrite -sumrB; apply: eq_bigr => a _; rewrite mulr_sumr -sumrB; apply: eq_bigr => mu _.
  by rewrite wedge_replaced_before along_y.
rewrite /affine_momentum vertical_part_of_difference (vertical_chain_rule along_W along_D).
have -> : vertical_part W (\sum_a \sum_mu momentum L a mu * v a mu)
  = \sum_a \sum_mu vertical_part W (momentum L a mu) * v a mu
    + \sum_a \sum_mu vertical_part W (v a mu) * d_v a mu L.
  rewrite vertical_part_of_sum -big_split; apply: eq_bigr => a _.
  rewrite vertical_part_of_sum -big_split; apply: eq_bigr => mu _.
  by rewrite vertical_part_of_product [momentum L a mu * _]mulrC.
have -> : \sum_a euler_lagrange L a * (W (y a) - \sum_mu v a mu * W (x mu))
  = \sum_a vertical_part W (y a) * d_y a L
    - \sum_a vertical_part W (y a) * (\sum_mu D mu (momentum L a mu)).
  rewrite -sumrB; apply: eq_bigr => a _; rewrite -vertical_part_of_field /euler_lagrange; ring_identity.
ring_identity.
Qed.

(** ** The field equations by contraction

A section solves the field equations \f$E_a = 0\f$ if and only if \f$(j^1\phi)^*(W\lrcorner\Omega) = 0\f$ for
every vector field \f$W\f$ on the jet bundle along which the density has its chain rule (section 6.2). One way
uses that the \f$\partial/\partial y^a\f$ are among them. *)
Theorem claim_6_2_el_by_contraction L :
    (forall a mu, d_y a (x mu) = 0) -> (forall a b, d_y a (y b) = (b == a)%:R) ->
    (forall a b mu, d_y a (v b mu) = 0) -> (forall mu, chain_rule L (D mu)) ->
  (forall W, chain_rule L W -> multisymplectic_form L (before W D) = 0)
  <-> (forall a, euler_lagrange L a = 0).
Proof.
move=> base fields velocities along_D; split=> [zero a|solves W along_W]; last first.
  by rewrite eq_6_8 // big1 ?oppr0 // => a _; rewrite solves mul0r.
have pick (g : 'I_N -> R) : \sum_b d_y a (y b) * g b = g a.
  by rewrite (bigD1 a) //= fields eqxx mul1r big1 ?addr0 // => b ne; rewrite fields (negbTE ne) mul0r.
have along_a : chain_rule L (d_y a).
  rewrite /chain_rule pick big1 => [|mu _]; last by rewrite base mul0r.
  rewrite add0r [X in _ + X]big1 ?addr0 // => b _; rewrite big1 // => mu _.
  by rewrite velocities mul0r.
have sumE : \sum_b euler_lagrange L b * (d_y a (y b) - \sum_mu v b mu * d_y a (x mu)) = euler_lagrange L a.
  rewrite -[RHS](pick (euler_lagrange L)); apply: eq_bigr => b _; rewrite [X in _ - X]big1 => [|mu _];
    last by rewrite base mulr0.
  by rewrite subr0 mulrC.
by have := zero (d_y a) along_a; rewrite eq_6_8 // sumE => /eqP; rewrite oppr_eq0 => /eqP.
Qed.

(** ** The Euler-Lagrange derivative written out

(6.12) with total derivatives is (6.9): by the chain rule for the momenta along the section
\f[ E_a = \frac{\partial L}{\partial y^a} - \frac{\partial^2L}{\partial x^\mu\,\partial v^a{}_\mu} -
\frac{\partial^2L}{\partial y^b\,\partial v^a{}_\mu}\,\phi^b{}_{,\mu} -
\frac{\partial^2L}{\partial v^b{}_\nu\,\partial v^a{}_\mu}\,\phi^b{}_{,\mu\nu} . \f] *)
Theorem claim_6_2_el_forms_equivalent L a : (forall mu, chain_rule (momentum L a mu) (D mu)) ->
  euler_lagrange L a
  = d_y a L - \sum_mu d_x mu (d_v a mu L) - \sum_mu \sum_b d_y b (d_v a mu L) * v b mu
    - \sum_mu \sum_b \sum_nu d_v b nu (d_v a mu L) * D mu (v b nu).
Proof.
move=> along_D; rewrite /euler_lagrange -!addrA -!opprD; congr (_ - _); rewrite -!big_split.
apply: eq_bigr => mu _ /=; rewrite along_D /momentum -addrA; congr (_ + (_ + _)).
- rewrite (bigD1 mu) //= along_x eqxx mul1r big1 ?addr0 // => nu ne.
  by rewrite along_x (negbTE ne) mul0r.
- by apply: eq_bigr => b _; rewrite along_y mulrC.
- by apply: eq_bigr => b _; apply: eq_bigr => nu _; rewrite mulrC.
Qed.

(** ** Noether's currents

A vector field \f$X\f$ on the jet bundle contracted into the Cartan form and pulled back along a section is
\f$(j^1\phi)^*(X\lrcorner\Theta) = j^\kappa\,d^nx_\kappa\f$ with
\f[ j^\kappa = p_a{}^\kappa\,(X^a - v^a{}_\nu X^\nu) + L\,X^\kappa . \f]
The coefficient \f$j^\kappa\f$ is the value of \f$\Theta\f$ on \f$D_0, \dots, D_n\f$ with \f$D_\kappa\f$
replaced by \f$X\f$. This is the momentum map (9.7) in coordinates, for every density and every \f$X\f$. C++:
`actio::noether_current`, `noether/covariant_momentum_map.hpp`. *)
Definition noether_current L X kappa : R :=
  \sum_a momentum L a kappa * (X (y a) - \sum_nu v a nu * X (x nu)) + L * X (x kappa).

(** Cramer's rule: a determinant with one column replaced. *)
Lemma determinant_of_replaced_column (A : 'M[R]_n.+1) kappa (c : 'cV[R]_n.+1) :
  \det (\matrix_(i, j) if j == kappa then c i 0 else A i j) = (\adj A *m c) kappa 0.
Proof.
rewrite (expand_det_col _ kappa) mxE; apply: eq_bigr => i _; rewrite !mxE eqxx mulrC; congr (_ * _).
rewrite /cofactor; congr (_ * \det _); apply/matrixP => k l; rewrite !mxE.
by rewrite eq_sym (negbTE (neq_lift _ _)).
Qed.

Lemma wedge_replaced_vector mu h kappa X :
  wedge (replaced x mu h) (replaced D kappa X)
  = (mu == kappa)%:R * vertical_part X h + D mu h * X (x kappa).
Proof.
pose A : 'M[R]_n.+1 := \matrix_(i, j) D j (replaced x mu h i).
pose xi : 'cV[R]_n.+1 := \col_nu X (x nu).
have -> : wedge (replaced x mu h) (replaced D kappa X)
          = (\adj A *m (vertical_part X h *: delta_mx mu 0 + A *m xi)) kappa 0.
  rewrite -determinant_of_replaced_column; congr (\det _); apply/matrixP => i j; rewrite !mxE /replaced.
  case: (j == kappa) => //; rewrite eqxx andbT; case: (eqVneq i mu) => [->|ne].
    rewrite mulr1 /vertical_part.
    have -> : \sum_j0 A mu j0 * xi j0 0 = \sum_nu X (x nu) * D nu h.
      by apply: eq_bigr => nu _; rewrite !mxE /replaced eqxx mulrC.
    by rewrite subrK.
  rewrite mulr0 add0r (bigD1 i) //= !mxE /replaced (negbTE ne) along_x eqxx mul1r big1 ?addr0 // => k ki.
  by rewrite !mxE /replaced (negbTE ne) along_x eq_sym (negbTE ki) mul0r.
rewrite mulmxDr mulmxA mul_adj_mx mxE; congr (_ + _); last first.
  rewrite mul_scalar_mx !mxE; congr (_ * _); exact: (wedge_on_section mu h).
rewrite -scalemxAr mxE mulrC; congr (_ * _).
have -> : (\adj A *m (delta_mx mu 0 : 'cV[R]_n.+1)) kappa 0 = cofactor A mu kappa.
  rewrite mxE (bigD1 mu) //= !mxE !eqxx mulr1 big1 ?addr0 // => k ne.
  by rewrite !mxE (negbTE ne) mulr0.
have -> : cofactor A mu kappa = cofactor (1%:M : 'M[R]_n.+1) mu kappa.
  rewrite /cofactor; congr (_ * \det _); apply/matrixP => k l; rewrite !mxE.
  by rewrite /replaced eq_sym (negbTE (neq_lift _ _)) along_x.
have := mul_mx_adj (1%:M : 'M[R]_n.+1); rewrite mul1mx det1 => /matrixP /(_ kappa mu).
by rewrite !mxE eq_sym.
Qed.

Theorem noether_current_from_cartan_form L X kappa :
  cartan_form L (replaced D kappa X) = noether_current L X kappa.
Proof.
rewrite /cartan_form /noether_current.
have -> : wedge x (replaced D kappa X) = X (x kappa).
  have -> : wedge x (replaced D kappa X) = wedge (replaced x kappa (x kappa)) (replaced D kappa X).
    by congr (\det _); apply/matrixP => i j; rewrite !mxE /replaced; case: (eqVneq i kappa) => [->|].
  by rewrite wedge_replaced_vector vertical_part_of_base mulr0 add0r along_x eqxx mul1r.
have -> : \sum_a \sum_mu momentum L a mu * wedge (replaced x mu (y a)) (replaced D kappa X)
  = \sum_a momentum L a kappa * (X (y a) - \sum_nu v a nu * X (x nu))
    + (\sum_a \sum_mu momentum L a mu * v a mu) * X (x kappa).
  rewrite mulr_suml -big_split; apply: eq_bigr => a _ /=.
  have -> : momentum L a kappa * (X (y a) - \sum_nu v a nu * X (x nu))
            = \sum_mu momentum L a mu * ((mu == kappa)%:R * vertical_part X (y a)).
    rewrite [RHS](bigD1 kappa) //= eqxx mul1r vertical_part_of_field [X in _ = _ + X]big1 ?addr0 // => mu ne.
    by rewrite (negbTE ne) mul0r mulr0.
  rewrite mulr_suml -big_split; apply: eq_bigr => mu _.
  rewrite wedge_replaced_vector along_y /=; ring_identity.
rewrite /affine_momentum; ring_identity.
Qed.

(** The density rate of equivariance of a vector field whose part on space-time is \f$\xi^\mu\f$:
\f$r = X(L) + L\,D_\mu\xi^\mu\f$. It vanishes for all jets where the density is equivariant. *)
Definition equivariance_rate L X : R := X L + L * \sum_mu D mu (X (x mu)).

(** The prolongation of a vector field on \f$Y\f$: \f$X(v^a{}_\mu) = D_\mu X^a - v^a{}_\nu\,D_\mu X^\nu\f$.
C++: `actio::prolongation`, `jets/prolongation.hpp`. *)
Definition prolonged X :=
  forall a mu, X (v a mu) = D mu (X (y a)) - \sum_nu v a nu * D mu (X (x nu)).

(** ** Noether's theorem, off shell

Theorem 9.1.1 says that the current of a symmetry is closed along solutions. For every density, every
prolonged vector field \f$X\f$ and every section, whether a solution or not,
\f[ D_\kappa\,j^\kappa = r - E_a\,(X^a - v^a{}_\mu X^\mu) \f]
with the rate of equivariance \f$r\f$ and the Euler-Lagrange derivative \f$E_a\f$. Here the mixed second
derivatives of the section commute. *)
Theorem thm_9_1_1 L X :
    (forall a mu nu, D mu (v a nu) = D nu (v a mu)) -> prolonged X ->
    chain_rule L X -> (forall mu, chain_rule L (D mu)) ->
  \sum_kappa D kappa (noether_current L X kappa)
  = equivariance_rate L X - \sum_a euler_lagrange L a * (X (y a) - \sum_mu v a mu * X (x mu)).
Proof.
move=> mixed prolonged_X along_X along_D.
pose Q a := X (y a) - \sum_nu v a nu * X (x nu).
have vertical_v a mu : vertical_part X (v a mu) = D mu (Q a).
  rewrite /vertical_part prolonged_X /Q raddfB /= [in RHS]raddf_sum.
  have -> : \sum_nu D mu (v a nu * X (x nu))
            = \sum_nu v a nu * D mu (X (x nu)) + \sum_nu X (x nu) * D nu (v a mu).
    by rewrite -big_split; apply: eq_bigr => nu _; rewrite leibniz mixed /=; ring_identity.
  ring_identity.
have divergence : \sum_kappa D kappa (noether_current L X kappa)
  = \sum_a \sum_kappa D kappa (momentum L a kappa) * Q a
    + \sum_a \sum_kappa momentum L a kappa * D kappa (Q a)
    + \sum_kappa X (x kappa) * D kappa L + L * \sum_kappa D kappa (X (x kappa)).
  have -> : \sum_kappa D kappa (noether_current L X kappa)
    = \sum_kappa (\sum_a D kappa (momentum L a kappa) * Q a + \sum_a momentum L a kappa * D kappa (Q a)
        + X (x kappa) * D kappa L + L * D kappa (X (x kappa))).
    apply: eq_bigr => kappa _; rewrite /noether_current raddfD /= leibniz raddf_sum -/Q.
    have -> : \sum_a D kappa (momentum L a kappa * (X (y a) - \sum_nu v a nu * X (x nu)))
      = \sum_a D kappa (momentum L a kappa) * Q a + \sum_a momentum L a kappa * D kappa (Q a).
      by rewrite -big_split; apply: eq_bigr => a _; rewrite leibniz.
    ring_identity.
  by rewrite !big_split mulr_sumr /=; congr (_ + _ + _ + _); apply: exchange_big.
have chain := vertical_chain_rule along_X along_D.
have XL : X L = vertical_part X L + \sum_kappa X (x kappa) * D kappa L by rewrite /vertical_part subrK.
rewrite divergence /equivariance_rate XL chain /euler_lagrange.
have -> : \sum_a \sum_mu vertical_part X (v a mu) * d_v a mu L
          = \sum_a \sum_kappa momentum L a kappa * D kappa (Q a).
  by apply: eq_bigr => a _; apply: eq_bigr => mu _; rewrite vertical_v mulrC.
have -> : \sum_a (d_y a L - \sum_mu D mu (momentum L a mu)) * (X (y a) - \sum_mu v a mu * X (x mu))
          = \sum_a vertical_part X (y a) * d_y a L - \sum_a \sum_kappa D kappa (momentum L a kappa) * Q a.
  rewrite -sumrB; apply: eq_bigr => a _; rewrite vertical_part_of_field -/(Q a) -mulr_suml; ring_identity.
ring_identity.
Qed.

(** (9.5): along a solution the current of a symmetry is closed. *)
Theorem eq_9_5 L X :
    (forall a mu nu, D mu (v a nu) = D nu (v a mu)) -> prolonged X ->
    chain_rule L X -> (forall mu, chain_rule L (D mu)) ->
    equivariance_rate L X = 0 -> (forall a, euler_lagrange L a = 0) ->
  \sum_kappa D kappa (noether_current L X kappa) = 0.
Proof.
move=> mixed prolonged_X along_X along_D symmetric_L solves; rewrite thm_9_1_1 // symmetric_L sub0r.
by rewrite big1 ?oppr0 // => a _; rewrite solves mul0r.
Qed.

(** ** The momentum map and the current

(9.4) asks of the covariant momentum map that \f$X\lrcorner\Omega = dJ\f$, and (9.7) says that it is
\f$J = X\lrcorner\Theta\f$. Pulled back along a section, whether a solution or not, the two differ by the rate
of equivariance,
\f[ (j^1\phi)^*(X\lrcorner\Omega) = d\bigl((j^1\phi)^*(X\lrcorner\Theta)\bigr) - r\,d^{n+1}x , \f]
so that (9.7) satisfies (9.4) along every section if and only if \f$r = 0\f$. On vectors that are tangent to
no section (9.4) says more, which is not proved here. *)
Theorem eq_9_4_along_sections L X :
    (forall a mu nu, D mu (v a nu) = D nu (v a mu)) -> prolonged X ->
    chain_rule L X -> (forall mu, chain_rule L (D mu)) ->
  multisymplectic_form L (before X D)
  = \sum_kappa D kappa (cartan_form L (replaced D kappa X)) - equivariance_rate L X.
Proof.
move=> mixed prolonged_X along_X along_D; rewrite eq_6_8 //.
under [X in _ = X - _]eq_bigr do rewrite noether_current_from_cartan_form.
by rewrite thm_9_1_1 // addrAC subrr add0r.
Qed.

(** ** The multisymplectic form formula at a point

Theorem 6.2.2 says that the form \f$j^1\mathcal V\lrcorner j^1\mathcal W\lrcorner\Omega\f$ has no flux through
the boundary of a region where \f$V\f$ and \f$W\f$ are first variations of a solution. By Stokes' theorem that
is a statement about a divergence: for all vertical variations, of a solution or not,
\f[ D_\mu\bigl(W^a\,V(p_a{}^\mu) - V^a\,W(p_a{}^\mu)\bigr) = V^a\,W(E_a) - W^a\,V(E_a) , \f]
and it vanishes where both solve the linearised equations \f$V(E_a) = W(E_a) = 0\f$. Variations are vector
fields that commute with the total derivatives; the chain rule is used along them and along their
commutator. *)
Theorem thm_6_2_2_divergence L V W :
    (forall mu, V (x mu) = 0) -> (forall mu, W (x mu) = 0) ->
    (forall mu f, V (D mu f) = D mu (V f)) -> (forall mu f, W (D mu f) = D mu (W f)) ->
    chain_rule L V -> chain_rule L W ->
    V (W L) - W (V L) = \sum_a (V (W (y a)) - W (V (y a))) * d_y a L
      + \sum_a \sum_mu (V (W (v a mu)) - W (V (v a mu))) * d_v a mu L ->
  \sum_mu D mu (\sum_a (W (y a) * V (momentum L a mu) - V (y a) * W (momentum L a mu)))
  = \sum_a (V (y a) * W (euler_lagrange L a) - W (y a) * V (euler_lagrange L a)).
Proof.
move=> vertical_V vertical_W commute_V commute_W along_V along_W commutator.
have expand X X' : (forall mu, X' (x mu) = 0) -> chain_rule L X' ->
    X (X' L) = \sum_a X (X' (y a)) * d_y a L + \sum_a X' (y a) * X (d_y a L)
      + \sum_a \sum_mu X (X' (v a mu)) * d_v a mu L + \sum_a \sum_mu X' (v a mu) * X (d_v a mu L).
  move=> vertical_X' ->; rewrite big1 => [|mu _]; last by rewrite vertical_X' mul0r.
  rewrite add0r raddfD /= !raddf_sum -[RHS]addrA -[X in _ = X + _]big_split -[X in _ = _ + X]big_split.
  congr (_ + _); apply: eq_bigr => a _; first exact: leibniz.
  by rewrite raddf_sum -[RHS]big_split; apply: eq_bigr => mu _; exact: leibniz.
have second_order : \sum_a W (y a) * V (d_y a L) + \sum_a \sum_mu W (v a mu) * V (d_v a mu L)
    = \sum_a V (y a) * W (d_y a L) + \sum_a \sum_mu V (v a mu) * W (d_v a mu L).
  move: commutator; rewrite (expand V W) // (expand W V) //.
  have -> : \sum_a (V (W (y a)) - W (V (y a))) * d_y a L
            = \sum_a V (W (y a)) * d_y a L - \sum_a W (V (y a)) * d_y a L.
    by rewrite -sumrB; apply: eq_bigr => a _; rewrite mulrBl.
  have -> : \sum_a \sum_mu (V (W (v a mu)) - W (V (v a mu))) * d_v a mu L
    = \sum_a \sum_mu V (W (v a mu)) * d_v a mu L - \sum_a \sum_mu W (V (v a mu)) * d_v a mu L.
    by rewrite -sumrB; apply: eq_bigr => a _; rewrite -sumrB; apply: eq_bigr => mu _; rewrite mulrBl.
  move/eqP; rewrite -subr_eq0 => /eqP zero; apply/eqP; rewrite -subr_eq0; apply/eqP.
  rewrite -[RHS]zero; ring_identity.
have divergence : \sum_mu D mu (\sum_a (W (y a) * V (momentum L a mu) - V (y a) * W (momentum L a mu)))
  = \sum_a \sum_mu W (v a mu) * V (d_v a mu L) - \sum_a \sum_mu V (v a mu) * W (d_v a mu L)
    + \sum_a W (y a) * (\sum_mu V (D mu (momentum L a mu)))
    - \sum_a V (y a) * (\sum_mu W (D mu (momentum L a mu))).
  under eq_bigr do rewrite raddf_sum.
  rewrite exchange_big -!sumrB -big_split -sumrB; apply: eq_bigr => a _ /=.
  rewrite !mulr_sumr -!sumrB -big_split -sumrB; apply: eq_bigr => mu _.
  by rewrite raddfB /= !leibniz -!along_y !commute_V !commute_W /momentum; ring_identity.
rewrite divergence.
have equation : \sum_a (V (y a) * W (euler_lagrange L a) - W (y a) * V (euler_lagrange L a))
  = \sum_a V (y a) * W (d_y a L) - \sum_a W (y a) * V (d_y a L)
    + \sum_a W (y a) * (\sum_mu V (D mu (momentum L a mu)))
    - \sum_a V (y a) * (\sum_mu W (D mu (momentum L a mu))).
  rewrite -!sumrB -big_split -sumrB; apply: eq_bigr => a _ /=.
  rewrite /euler_lagrange !raddfB /= [V (\sum__ _)]raddf_sum [W (\sum__ _)]raddf_sum; ring_identity.
rewrite equation; move/eqP: second_order; rewrite -subr_eq0 => /eqP zero.
apply/eqP; rewrite -subr_eq0; apply/eqP; rewrite -[RHS]zero; ring_identity.
Qed.

End Fields.

(** ** Equivariance of a family of automorphisms, to first order

A family \f$\eta_\varepsilon\f$ that begins at the identity with the rate \f$X\f$ takes a function \f$f\f$ to
\f$\eta_\varepsilon^*f = f + \varepsilon X(f)\f$, to first order in \f$\varepsilon\f$. *)
Section Families.

Variables (R : comUnitRingType) (n N : nat).
Variables (x : 'I_n.+1 -> R) (y : 'I_N -> R) (v : 'I_N -> 'I_n.+1 -> R).
Variables (d_x : 'I_n.+1 -> derivation R) (d_y : 'I_N -> derivation R) (d_v : 'I_N -> 'I_n.+1 -> derivation R)
          (D : 'I_n.+1 -> derivation R).
Hypothesis along_x : forall mu nu, D nu (x mu) = (mu == nu)%:R.
Hypothesis along_y : forall a mu, D mu (y a) = v a mu.

Definition carried (X : derivation R) (f : R) : with_small_part R := (f, X f).

(** Products are carried to products: that is the rule of Leibniz. *)
Lemma carried_product X f h : carried X (f * h) = carried X f * carried X h.
Proof. by rewrite /carried leibniz; congr pair; rewrite addrC. Qed.

(** \f$\eta_\varepsilon^*x^\mu\f$ differentiated along a section, and the determinant of
\f$\partial\eta_\varepsilon/\partial x\f$. *)
Definition carried_jacobian (X : derivation R) : with_small_part R :=
  \det (\matrix_(mu, nu) derivation_of_both_parts (D nu) (carried X (x mu))).

(** The part without \f$\varepsilon\f$. *)
Definition large_part (f : with_small_part R) : R := f.1.
Lemma large_part_additive : additive large_part. Proof. by []. Qed.
Lemma large_part_multiplicative : multiplicative large_part. Proof. by []. Qed.
Canonical large_part_is_additive := Additive large_part_additive.
Canonical large_part_is_rmorphism := AddRMorphism large_part_multiplicative.

Lemma carried_jacobian_to_first_order X : carried_jacobian X = (1, \sum_mu D mu (X (x mu))).
Proof.
pose M := \matrix_(mu, nu) derivation_of_both_parts (D nu) (carried X (x mu)).
have large : map_mx large_part M = 1%:M by apply/matrixP => mu nu; rewrite !mxE /large_part /= along_x.
have := derivative_of_determinant (derivation_of_small_part R) M.
move/(congr1 (fun f : with_small_part R => f.2)) => second.
have one : (\det M).1 = 1 by rewrite -[LHS]/(large_part _) -det_map_mx large det1.
rewrite /carried_jacobian -/M [LHS]surjective_pairing one; congr pair.
have cofactors mu k : (\adj M mu k).1 = (mu == k)%:R.
  have := map_mx_adj [rmorphism of large_part] M; rewrite large adjugate_of_one => /matrixP /(_ mu k).
  by rewrite !mxE.
rewrite -[LHS]/((derivation_of_small_part R (\det M)).2) second /mxtrace.
have small_sum (I : finType) (f : I -> with_small_part R) : (\sum_i f i).2 = \sum_i (f i).2.
  exact: (big_morph (fun f : with_small_part R => f.2) (fun _ _ => erefl) erefl).
rewrite small_sum; apply: eq_bigr => mu _; rewrite mxE small_sum (bigD1 mu) //= big1 => [|k ne].
  by rewrite cofactors eqxx mul1r !mxE /= mulr0 addr0 addr0.
by rewrite cofactors eq_sym (negbTE ne) mul0r !mxE /= mulr0 addr0.
Qed.

(** The defect of equivariance of a family,
\f$\eta_\varepsilon^*L\,\det(\partial\eta_\varepsilon/\partial x) - L\f$, is to first order \f$\varepsilon\f$
times the rate \f$r = X(L) + L\,D_\mu\xi^\mu\f$: a density that is equivariant along the family has
\f$r = 0\f$. That \f$r = 0\f$ makes a density equivariant under finite automorphisms needs flows, and is not
proved here. *)
Theorem claim_9_1_equivariance_to_first_order L X :
  carried X L * carried_jacobian X = (L, equivariance_rate x D L X).
Proof.
rewrite carried_jacobian_to_first_order; congr pair; rewrite /= mulr1 //.
by rewrite addrC.
Qed.

(** ** Noether's theorem for a family of symmetries

Theorem 9.1.1 from the equivariance of the density, for a family to first order: along a solution the current
\f$(j^1\phi)^*(X\lrcorner\Theta)\f$ is closed. *)
Theorem thm_9_1_1_of_families L X :
    (forall a mu nu, D mu (v a nu) = D nu (v a mu)) -> prolonged x y v D X ->
    chain_rule x y v d_x d_y d_v L X -> (forall mu, chain_rule x y v d_x d_y d_v L (D mu)) ->
    carried X L * carried_jacobian X = (L, 0) ->
    (forall a, euler_lagrange d_y d_v D L a = 0) ->
  \sum_kappa D kappa (cartan_form x y v d_v L (replaced D kappa X)) = 0.
Proof.
move=> mixed prolonged_X along_X along_D.
rewrite claim_9_1_equivariance_to_first_order => -[symmetric_L] solves.
under eq_bigr do rewrite noether_current_from_cartan_form //.
exact: (eq_9_5 along_x along_y mixed prolonged_X along_X along_D symmetric_L solves).
Qed.

End Families.

(** (6.8) with the printed sign fails for one field on a space-time with one dimension of the body, already
for the density \f$L = y\f$ and the variation \f$\partial/\partial y\f$ of the section \f$y = 0\f$: the left
side is 1, the right side \f$-1\f$. *)
Theorem eq_6_8_printed_fails :
  ~ (forall (R : comRingType) (n N : nat) (x : 'I_n.+1 -> R) (y : 'I_N -> R) (v : 'I_N -> 'I_n.+1 -> R)
       (d_x : 'I_n.+1 -> derivation R) (d_y : 'I_N -> derivation R) (d_v : 'I_N -> 'I_n.+1 -> derivation R)
       (D : 'I_n.+1 -> derivation R) (L : R) (V : derivation R),
      (forall mu nu, D nu (x mu) = (mu == nu)%:R) -> (forall a mu, D mu (y a) = v a mu) ->
      (forall a mu nu, D mu (v a nu) = D nu (v a mu)) ->
      (forall mu, V (x mu) = 0) -> prolonged x y v D V ->
      chain_rule x y v d_x d_y d_v L V -> (forall mu, chain_rule x y v d_x d_y d_v L (D mu)) ->
      multisymplectic_form x y v d_v L (before V D) = \sum_a euler_lagrange d_y d_v D L a * V (y a)).
Proof.
move=> claim; have [R [c]] := polynomials 3.
pose base (mu : 'I_2) : 'I_3 := widen_ord (leqnSn 2) mu.
have base_ne mu : (base mu == ord_max) = false by rewrite -val_eqE /= ltn_eqF.
pose x mu := coordinate c (base mu); pose y (_ : 'I_1) := coordinate c ord_max.
pose v (_ : 'I_1) (_ : 'I_2) := 0 : R; pose D mu := partial c (base mu); pose V := partial c ord_max.
pose d_y (_ : 'I_1) := V; pose d_v (_ : 'I_1) (_ : 'I_2) := zero_derivation [comRingType of R].
have along_x mu nu : D nu (x mu) = (mu == nu)%:R by rewrite partial_coordinate eq_sym.
have along_y a mu : D mu (y a) = v a mu by rewrite partial_coordinate base_ne.
have mixed a mu nu : D mu (v a nu) = D nu (v a mu) by rewrite !raddf0.
have vertical mu : V (x mu) = 0 by rewrite partial_coordinate eq_sym base_ne.
have Vy a : V (y a) = 1 by rewrite partial_coordinate eqxx.
have prolonged_V : prolonged x y v D V.
  move=> a mu; rewrite Vy derivative_of_one raddf0 big1 ?subr0 // => nu _; exact: mul0r.
have Dy a mu : D mu (y a) = 0 by rewrite along_y.
have chain u : chain_rule x y v D d_y d_v (y 0) u.
  rewrite /chain_rule big1 => [|mu _]; last by rewrite Dy mulr0.
  rewrite big_ord1 Vy mulr1 add0r [X in _ + X]big1 ?addr0 // => a _; rewrite big1 // => mu _.
  exact: mulr0.
have := claim _ _ _ x y v D d_y d_v D (y 0) V along_x along_y mixed vertical prolonged_V (chain V)
              (fun mu => chain (D mu)).
rewrite (eq_6_8 along_x along_y (chain V) (fun mu => chain (D mu))) !big_ord1 Vy /euler_lagrange big1 =>
  [|mu _]; last exact: raddf0.
rewrite big1 => [|mu _]; last exact: mul0r.
rewrite !subr0 !mulr1 -/V [V (y 0)]Vy => /(congr1 (at_origin c)); rewrite rmorphN rmorph1 => /eqP.
by rewrite eq_sym -addr_eq0 -(natrD _ 1 1) pnatr_eq0.
Qed.

(** ** The current of time translation

Section 9.2: with \f$\zeta_Y = (0, \zeta, 0)\f$ the current is
\f$-\zeta\,(e\,d^nx_0 + p_a{}^j\dot\phi^a\,d^nx_j)\f$, with the energy density \f$e = p_a{}^0v^a{}_0 - L\f$ of
(6.5). Time is the coordinate \f$x^0\f$. C++: `actio::energy_density`, `jets/density.hpp`. *)
Definition energy_density (R : comRingType) n N (v : 'I_N -> 'I_n.+1 -> R)
    (d_v : 'I_N -> 'I_n.+1 -> derivation R) (L : R) := \sum_a momentum d_v L a ord0 * v a ord0 - L.

Theorem claim_9_2_time_current (R : comRingType) n N (x : 'I_n.+1 -> R) (y : 'I_N -> R) (v : 'I_N ->
  'I_n.+1 -> R)
    (d_v : 'I_N -> 'I_n.+1 -> derivation R) (L zeta : R) (X : derivation R) :
    (forall mu, X (x mu) = zeta *+ (mu == ord0)) -> (forall a, X (y a) = 0) ->
  noether_current x y v d_v L X ord0 = - (zeta * energy_density v d_v L)
  /\ forall j, noether_current x y v d_v L X (lift ord0 j)
      = - (zeta * \sum_a momentum d_v L a (lift ord0 j) * v a ord0).
Proof.
move=> base fields.
have along a : X (y a) - \sum_nu v a nu * X (x nu) = - (zeta * v a ord0).
  rewrite fields sub0r big_ord_recl base eqxx mulr1n big1 ?addr0 => [|j _]; first by rewrite mulrC.
  by rewrite base mulr0n mulr0.
rewrite /noether_current /energy_density; split=> [|j].
  rewrite base eqxx mulr1n mulrBr mulr_sumr opprB addrC [L * _]mulrC -sumrN; congr (_ + _).
  by apply: eq_bigr => a _; rewrite along; ring_identity.
rewrite base mulr0n mulr0 addr0 mulr_sumr -sumrN; apply: eq_bigr => a _; rewrite along; ring_identity.
Qed.

(** The balance of energy along a section:
\f$\dot e + D_j\bigl(p_a{}^j\,\dot\phi^a\bigr) = -\dot\phi^a\,E_a\f$. *)
Definition energy_balance (R : comRingType) n N (v : 'I_N -> 'I_n.+1 -> R) (d_y : 'I_N -> derivation R)
    (d_v : 'I_N -> 'I_n.+1 -> derivation R) (D : 'I_n.+1 -> derivation R) (L : R) : Prop :=
  D ord0 (energy_density v d_v L) + \sum_j D (lift ord0 j) (\sum_a momentum d_v L a (lift ord0 j) * v a ord0)
  = - (\sum_a v a ord0 * euler_lagrange d_y d_v D L a).

(** ** The continuity of energy

Section 9.2: where the density does not depend on time, \f$\partial L/\partial t = 0\f$, along every section
\f[ \dot e + D_j\bigl(p_a{}^j\,\dot\phi^a\bigr) = -\dot\phi^a\,E_a \f]
for every density: along solutions energy is continuous, and a closed current of time says no more than
\f$\dot\phi^aE_a = 0\f$. The vector field is \f$\partial/\partial t\f$. *)
Theorem claim_9_2_energy_converse (R : comRingType) n N
    (x : 'I_n.+1 -> R) (y : 'I_N -> R) (v : 'I_N -> 'I_n.+1 -> R)
    (d_x : 'I_n.+1 -> derivation R) (d_y : 'I_N -> derivation R) (d_v : 'I_N -> 'I_n.+1 -> derivation R)
    (D : 'I_n.+1 -> derivation R) (L : R) (X : derivation R) :
    (forall mu nu, D nu (x mu) = (mu == nu)%:R) -> (forall a mu, D mu (y a) = v a mu) ->
    (forall a mu nu, D mu (v a nu) = D nu (v a mu)) -> (forall mu, chain_rule x y v d_x d_y d_v L (D mu)) ->
    (forall mu, X (x mu) = (mu == ord0)%:R) -> (forall a, X (y a) = 0) -> (forall a mu, X (v a mu) = 0) ->
    chain_rule x y v d_x d_y d_v L X -> X L = 0 ->
  energy_balance v d_y d_v D L.
Proof.
move=> along_x along_y mixed along_D base fields velocities along_X no_time; rewrite /energy_balance.
have constant mu nu : D mu (X (x nu)) = 0 by rewrite base derivative_of_nat.
have prolonged_X : prolonged x y v D X.
  by move=> a mu; rewrite velocities fields raddf0 big1 ?subr0 // => nu _; rewrite constant mulr0.
have := thm_9_1_1 along_x along_y mixed prolonged_X along_X along_D.
rewrite /equivariance_rate no_time [X in L * X]big1 => [|mu _]; last exact: constant.
rewrite mulr0 addr0 sub0r.
have [time_part space_part] : noether_current x y v d_v L X ord0 = - (1 * energy_density v d_v L)
    /\ forall j, noether_current x y v d_v L X (lift ord0 j)
                 = - (1 * \sum_a momentum d_v L a (lift ord0 j) * v a ord0).
  apply: claim_9_2_time_current => // mu; exact: base.
rewrite big_ord_recl time_part mul1r raddfN /=.
have -> : \sum_(j < n) D (lift ord0 j) (noether_current x y v d_v L X (lift ord0 j))
          = - (\sum_j D (lift ord0 j) (\sum_a momentum d_v L a (lift ord0 j) * v a ord0)).
  by rewrite -sumrN; apply: eq_bigr => j _; rewrite space_part mul1r raddfN.
have -> : \sum_a euler_lagrange d_y d_v D L a * (X (y a) - \sum_mu v a mu * X (x mu))
          = - (\sum_a v a ord0 * euler_lagrange d_y d_v D L a).
  rewrite -sumrN; apply: eq_bigr => a _; rewrite fields big_ord_recl base eqxx big1 => [|j _].
    by rewrite /=; ring_identity.
  by rewrite base mulr0.
by rewrite -opprD => /oppr_inj.
Qed.

(** ** Constraints and multipliers *)

Section Constraints.

Variables (R : comRingType) (n N k : nat).
Variables (d_y : 'I_N -> derivation R) (d_v : 'I_N -> 'I_n.+1 -> derivation R) (D : 'I_n.+1 -> derivation R).

(** A density, constraints \f$\Phi^i\f$ on first jets and multipliers \f$\lambda_i\f$, which are other fields:
they do not depend on \f$y\f$ and \f$v\f$. *)
Variables (L : R) (Phi lambda : 'I_k -> R).
Hypothesis multiplier_y : forall a i, d_y a (lambda i) = 0.
Hypothesis multiplier_v : forall a mu i, d_v a mu (lambda i) = 0.

(** The left side of the constrained Euler-Lagrange equations (7.2). C++:
`actio::constrained_field_equations`, `constraints/constrained_equations.hpp`. *)
Definition constrained_equation (l : 'I_k -> R) a :=
  \sum_mu D mu (d_v a mu L) - d_y a L
  + \sum_i l i * d_y a (Phi i) - \sum_mu D mu (\sum_i l i * d_v a mu (Phi i)).

Lemma euler_lagrange_of_augmented (l : 'I_k -> R) a :
    (forall b i, d_y b (l i) = 0) -> (forall b mu i, d_v b mu (l i) = 0) ->
  euler_lagrange d_y d_v D (L - \sum_i l i * Phi i) a = - constrained_equation l a.
Proof.
move=> l_y l_v; rewrite /euler_lagrange /momentum /constrained_equation.
have -> : d_y a (L - \sum_i l i * Phi i) = d_y a L - \sum_i l i * d_y a (Phi i).
  rewrite raddfB /= raddf_sum; congr (_ - _); apply: eq_bigr => i _.
  by rewrite leibniz l_y mul0r add0r.
have -> : \sum_mu D mu (d_v a mu (L - \sum_i l i * Phi i))
          = \sum_mu D mu (d_v a mu L) - \sum_mu D mu (\sum_i l i * d_v a mu (Phi i)).
  rewrite -sumrB; apply: eq_bigr => mu _; rewrite -raddfB /=; congr (D mu _).
  rewrite raddfB /= raddf_sum; congr (_ - _); apply: eq_bigr => i _.
  by rewrite leibniz l_v mul0r add0r.
ring_identity.
Qed.

(** ** The density with the multiplier among its fields

The field equations of \f$L_\Phi = L - \langle\lambda, \Phi\rangle\f$ are the constrained equations (7.2), and
for the multiplier the constraint; those of the printed \f$L + \langle\lambda, \Phi\rangle\f$ are (7.2) with
\f$-\lambda\f$ in place of \f$\lambda\f$. Numbers of fields and of constraints are arbitrary. *)
Theorem claim_7_2_augmented_lagrangian a :
  euler_lagrange d_y d_v D (L - \sum_i lambda i * Phi i) a = - constrained_equation lambda a.
Proof. exact: euler_lagrange_of_augmented. Qed.

Theorem claim_7_2_augmented_lagrangian_other_sign a :
  euler_lagrange d_y d_v D (L + \sum_i lambda i * Phi i) a = - constrained_equation (fun i => - lambda i) a.
Proof.
rewrite -euler_lagrange_of_augmented => [|b i|b mu i]; last 2 first.
- by rewrite raddfN /= multiplier_y oppr0.
- by rewrite raddfN /= multiplier_v oppr0.
by congr (euler_lagrange _ _ _ (_ + _) a); rewrite -sumrN; apply: eq_bigr => i _; rewrite mulNr opprK.
Qed.

Theorem claim_7_2_augmented_lagrangian_multiplier (d_lambda : 'I_k -> derivation R) j :
    (forall i, d_lambda j (lambda i) = (i == j)%:R) -> d_lambda j L = 0 -> (forall i,
      d_lambda j (Phi i) = 0) ->
  d_lambda j (L - \sum_i lambda i * Phi i) = - Phi j.
Proof.
move=> own L_free Phi_free; rewrite raddfB /= L_free sub0r raddf_sum (bigD1 j) //= big1 => [|i ne].
  by rewrite leibniz own eqxx Phi_free mul1r mulr0 !addr0.
by rewrite leibniz own (negbTE ne) Phi_free mul0r mulr0 addr0.
Qed.

End Constraints.

(** The equations of the printed density \f$L + \langle\lambda, \Phi\rangle\f$ are not (7.2): for \f$L = y\f$,
\f$\Phi = y\f$ and \f$\lambda = 1\f$ the section \f$y = 0\f$ solves (7.2) and not the other. *)
Theorem claim_7_2_augmented_lagrangian_printed_fails :
  ~ (forall (R : comRingType) (n N k : nat) (d_y : 'I_N -> derivation R) (d_v : 'I_N -> 'I_n.+1 ->
    derivation R)
       (D : 'I_n.+1 -> derivation R) (L : R) (Phi lambda : 'I_k -> R),
      (forall a i, d_y a (lambda i) = 0) -> (forall a mu i, d_v a mu (lambda i) = 0) ->
      (forall a, euler_lagrange d_y d_v D (L + \sum_i lambda i * Phi i) a = 0)
      <-> (forall a, constrained_equation d_y d_v D L Phi lambda a = 0)).
Proof.
move=> claim; have [R [c]] := polynomials 1.
pose y := coordinate c 0; pose d_y (_ : 'I_1) := partial c 0.
pose zero := zero_derivation [comRingType of R].
have Dy a : d_y a y = 1 by rewrite partial_coordinate.
have lambda_y a (i : 'I_1) : d_y a (1 : R) = 0 by exact: derivative_of_one.
have lambda_v (a : 'I_1) (mu : 'I_2) (i : 'I_1) : zero (1 : R) = 0 by [].
pose d_v (_ : 'I_1) (_ : 'I_2) := zero; pose D (_ : 'I_2) := zero.
have solves a : constrained_equation d_y d_v D y (fun _ : 'I_1 => y) (fun _ => 1) a = 0.
  rewrite /constrained_equation big_ord1 mul1r Dy [X in X - _ + _]big1 // [X in _ - X]big1 //; ring_identity.
have [_ H] := claim _ _ _ _ d_y d_v D y (fun _ => y) (fun _ => 1) lambda_y lambda_v.
have := H solves ord0; rewrite /euler_lagrange big_ord1 mul1r big1 // subr0 raddfD /= Dy.
move/(congr1 (at_origin c)) => /eqP.
by rewrite -(natrD _ 1 1) rmorph_nat raddf0 pnatr_eq0.
Qed.

(** ** Lagrange's multiplier theorem, the linear part

At a point \f$\varphi\f$ with \f$\Psi(\varphi) = 0\f$ the differential of \f$h\f$ is a row, and that of
\f$\Psi\f$ a matrix. The differential of \f$h\f$ vanishes on all vectors that \f$d\Psi\f$ takes to zero if and
only if there is a multiplier, \f$dh = \lambda\,d\Psi\f$, and that is what it means that \f$h -
\langle\lambda, \Psi\rangle\f$ is critical at \f$(\varphi, \lambda)\f$. This holds over any field and for any
\f$\Psi\f$. That \f$d\Psi\f$ is onto, a hypothesis that Theorem 7.1.1 does not name, is needed for the vectors
in question to be the tangent vectors of \f$\mathcal N = \Psi^{-1}(0)\f$, and it makes the multiplier
unique. *)
Theorem claim_7_1_first_to_second_on_kernel (F : fieldType) m k (dh : 'rV[F]_m) (dPsi : 'M[F]_(k, m)) :
  (forall u : 'cV[F]_m, dPsi *m u = 0 -> dh *m u = 0) <-> exists lambda : 'rV[F]_k, dh = lambda *m dPsi.
Proof.
split=> [vanishes|[lambda ->] u on_kernel]; last by rewrite -mulmxA on_kernel mulmx0.
apply/submxP; rewrite submxE; apply/eqP/matrixP => i j; rewrite [RHS]mxE.
have := vanishes (cokermx dPsi *m delta_mx j 0); rewrite mulmxA mulmx_coker mul0mx [dh *m _]mulmxA =>
  /(_ erefl).
by rewrite -colE => /matrixP /(_ i 0); rewrite [LHS]mxE [RHS]mxE.
Qed.

Theorem claim_7_1_first_to_second_unique (F : fieldType) m k (dPsi : 'M[F]_(k,
  m)) (lambda lambda' : 'rV[F]_k) :
  row_free dPsi -> lambda *m dPsi = lambda' *m dPsi -> lambda = lambda'.
Proof. by move=> onto; apply: (row_free_inj onto). Qed.

(** As printed, without a hypothesis on \f$\Psi\f$, the first statement of Theorem 7.1.1 does not imply the
second: \f$h(x) = x\f$ on the zeros of \f$\Psi(x) = x^2\f$, which are one point, has its minimum and its
maximum there, and no \f$\lambda\f$ makes \f$h - \lambda\Psi\f$ critical. *)
Theorem claim_7_1_first_to_second_printed_fails :
  ~ (forall (h Psi : {poly rat}) (phi : rat), Psi.[phi] = 0 ->
      (forall psi, Psi.[psi] = 0 -> h.[phi] <= h.[psi]) ->
      exists lambda, ((h - lambda *: Psi)^`()).[phi] = 0).
Proof.
move=> claim; have [||lambda] := claim 'X ('X ^+ 2) 0.
- by rewrite hornerXn expr0n.
- by move=> psi; rewrite hornerXn => /eqP; rewrite sqrf_eq0 => /eqP ->.
rewrite derivB derivX derivZ derivXn hornerD hornerN hornerZ hornerMn hornerXn expr1 mul0rn mulr0 subr0
  hornerC.
by move/eqP; rewrite oner_eq0.
Qed.

(** If an extremum in the second statement were to be a minimum or a maximum, it would fail for a constraint
as regular as \f$\Psi(x) = x\f$: near every zero of \f$\Psi\f$ the function \f$\bar h(x, \lambda) = x^2 -
\lambda x\f$ rises and falls, though \f$h\f$ has its minimum there. An extremum is a point where the
derivative vanishes. *)
Theorem thm_7_1_1_printed_fails_as_minimum_or_maximum :
  ~ (forall (h Psi : {poly rat}) (phi : rat), Psi.[phi] = 0 ->
      (forall psi, Psi.[psi] = 0 -> h.[phi] <= h.[psi]) ->
      let h_bar x l := h.[x] - l * Psi.[x] in
      exists lambda eps, 0 < eps /\
        ((forall x l, `|x - phi| < eps -> `|l - lambda| < eps -> h_bar phi lambda <= h_bar x l)
         \/ (forall x l, `|x - phi| < eps -> `|l - lambda| < eps -> h_bar x l <= h_bar phi lambda))).
Proof.
move=> claim; have [||lambda [eps [eps_pos]]] := claim ('X ^+ 2) 'X 0; first by rewrite hornerX.
  by move=> psi; rewrite hornerX => ->.
rewrite !hornerXn !hornerX expr0n /= mulr0 subrr.
pose t := eps / 2%:R; have t_pos : 0 < t by rewrite divr_gt0.
have t_eps : t < eps by rewrite ltr_pdivr_mulr // ltr_pmulr // ltr1n.
pose s := t / 2%:R; have s_pos : 0 < s by rewrite divr_gt0.
have s_t : s < t by rewrite ltr_pdivr_mulr // ltr_pmulr // ltr1n.
have s_eps := lt_trans s_t t_eps.
have near_s : `|s - 0| < eps by rewrite subr0 gtr0_norm.
have near_minus_s : `|- s - 0| < eps by rewrite subr0 normrN gtr0_norm.
have near_lambda : `|lambda - lambda| < eps by rewrite subrr normr0.
have near_more : `|(lambda + t) - lambda| < eps by rewrite addrAC subrr add0r gtr0_norm.
have near_less : `|(lambda - t) - lambda| < eps by rewrite addrAC subrr add0r normrN gtr0_norm.
case: (leP 0 lambda) => sign [least|greatest].
- have := least s (lambda + t) near_s near_more;
  rewrite hornerXn hornerX expr2 -mulrBl pmulr_lge0 // subr_ge0.
  by rewrite leNgt (lt_le_trans s_t) // ler_addr.
- have := greatest (- s) lambda near_minus_s near_lambda; rewrite hornerXn hornerX sqrrN mulrN opprK leNgt.
  by rewrite ltr_paddr ?exprn_gt0 // mulr_ge0 // ltW.
- have := least (- s) (lambda - t) near_minus_s near_less.
  rewrite hornerXn hornerX sqrrN mulrN opprK expr2 -mulrDl pmulr_lge0 // leNgt; case/negP.
  by rewrite addrCA -[X in _ < X](addr0 0) ltr_add // subr_lt0.
- have := greatest s lambda near_s near_lambda; rewrite hornerXn hornerX leNgt -mulNr.
  by rewrite ltr_paddr ?exprn_gt0 // mulr_ge0 ?oppr_ge0 // ltW.
Qed.
