(** * Derivations

Fields on space-time, brackets of functions and variations of a density have one algebra in common: that of
the _derivations_ of a commutative ring. The ring is thought of as a ring of smooth functions, and a
derivation as a vector field that differentiates them; nothing is used of either but the rule of Leibniz. So
what is proved here holds for smooth functions, for polynomials, and for power series alike. *)

From mathcomp Require Import all_ssreflect fingroup perm all_algebra.
From actio Require Import matrices ring_identities.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

(** ** Derivations of a commutative ring *)

(** A _derivation_ is an additive map with \f$d(fh) = (df)\,h + f\,dh\f$. *)
Record derivation (R : comRingType) := Derivation {
  derive :> {additive R -> R};
  leibniz : forall f h, derive (f * h) = derive f * h + f * derive h
}.

(** It acts on a matrix entry by entry. *)
Definition derivative_of (R : comRingType) (d : derivation R) m n (A : 'M[R]_(m, n)) := map_mx d A.

Section Derivations.

Variables (R : comRingType) (d : derivation R).
Implicit Types f h : R.

Lemma derivative_of_one : d 1 = 0.
Proof.
have := leibniz d 1 1; rewrite !mulr1 mul1r => /eqP; rewrite -subr_eq subrr => /eqP <-; by [].
Qed.

Lemma derivative_of_nat k : d k%:R = 0.
Proof. by rewrite raddfMn /= derivative_of_one mul0rn. Qed.

(** The derivative of a product of several factors. *)
Lemma derivative_of_product (I : finType) (P : pred I) (f : I -> R) :
  d (\prod_(i | P i) f i) = \sum_(i | P i) d (f i) * \prod_(j | P j && (j != i)) f j.
Proof.
rewrite [X in d X]big_mkcond /=.
pose g i := if P i then f i else 1.
have split_at (r : seq I) : uniq r ->
    d (\prod_(i <- r) g i) = \sum_(i <- r | P i) d (f i) * \prod_(j <- r | j != i) g j.
  elim: r => [|a r IH] /=; first by rewrite !big_nil derivative_of_one.
  case/andP => a_notin uniq_r; rewrite !big_cons leibniz (IH uniq_r).
  rewrite mulr_sumr.
  have -> : \sum_(i <- r | P i) g a * (d (f i) * \prod_(j <- r | j != i) g j)
            = \sum_(i <- r | P i) d (f i) * \prod_(j <- a :: r | j != i) g j.
    rewrite big_seq_cond [RHS]big_seq_cond; apply: eq_bigr => i /andP [i_in _].
    rewrite big_cons; have -> : a != i by apply: contraNneq a_notin => ->.
    by rewrite mulrCA.
  rewrite {1 2}/g; case: (P a); last by rewrite derivative_of_one mul0r add0r.
  rewrite eqxx /=; congr (_ * _ + _).
  rewrite big_seq [RHS]big_seq_cond; apply: eq_bigl => j /=.
  case j_in: (j \in r) => //=; apply/esym; apply: contraNneq a_notin => <-; exact: j_in.
rewrite split_at ?index_enum_uniq //; apply: eq_bigr => i Pi; congr (_ * _).
by rewrite -big_mkcondl; apply: eq_bigl => j.
Qed.

Lemma derivative_of_matrix_product m n p (A : 'M[R]_(m, n)) (B : 'M[R]_(n, p)) :
  derivative_of d (A *m B) = derivative_of d A *m B + A *m derivative_of d B.
Proof.
apply/matrixP => i j; rewrite !mxE raddf_sum -big_split /=; apply: eq_bigr => k _.
by rewrite leibniz !mxE.
Qed.

Lemma derivative_of_matrix_sum m n (A B : 'M[R]_(m, n)) :
  derivative_of d (A + B) = derivative_of d A + derivative_of d B.
Proof. exact: map_mxD. Qed.

Lemma derivative_of_matrix_opp m n (A : 'M[R]_(m, n)) : derivative_of d (- A) = - derivative_of d A.
Proof. exact: map_mxN. Qed.

Lemma derivative_of_transpose m n (A : 'M[R]_(m, n)) : derivative_of d A^T = (derivative_of d A)^T.
Proof. exact/esym/map_trmx. Qed.

(** *** Jacobi's formula *)

(** The derivative of a determinant: \f$d\det A = \mathrm{Tr}(\mathrm{adj}(A)\,dA)\f$. No inverse is
needed. *)
Lemma derivative_of_determinant n (A : 'M[R]_n) : d (\det A) = \tr (\adj A *m derivative_of d A).
Proof.
rewrite /determinant raddf_sum /=.
transitivity (\sum_(s : 'S_n) \sum_i (-1) ^+ s * (d (A i (s i)) * \prod_(j | j != i) A j (s j))).
  apply: eq_bigr => s _; rewrite leibniz.
  have -> : d ((-1) ^+ s) = 0 by case: (odd_perm s);
    rewrite ?expr0 ?expr1 ?raddfN /= derivative_of_one ?oppr0.
  by rewrite mul0r add0r derivative_of_product mulr_sumr.
rewrite exchange_big /= /mxtrace [RHS](eq_bigr (fun j => \sum_i cofactor A i j * d (A i j))); last first.
  by move=> j _; rewrite mxE; apply: eq_bigr => i _; rewrite !mxE.
rewrite [RHS]exchange_big; apply: eq_bigr => i _ /=.
rewrite (partition_big (fun s : 'S_n => s i) xpredT) //=; apply: eq_bigr => j _.
rewrite expand_cofactor mulr_suml; apply: eq_bigr => s /eqP <-.
rewrite [d _ * _]mulrC mulrA; congr (_ * _ * _); apply: eq_bigl => k; by rewrite eq_sym.
Qed.

End Derivations.

(** *** Piola's identity *)

Section Piola.

Variables (R : comRingType) (n : nat).
Implicit Types (F : 'M[R]_n) (D : 'I_n -> derivation R).

(** The matrix \f$F\f$ is a _gradient_ where \f$\partial_kF^a{}_i = \partial_iF^a{}_k\f$: with
\f$F^a{}_i = \partial_i\phi^a\f$ this says that mixed derivatives commute. *)
Definition is_gradient m (D : 'I_n -> derivation R) (F : 'M[R]_(m, n)) :=
  forall k a i, D k (F a i) = D i (F a k).

(** The derivative of one cofactor, as a sum over permutations. *)
Lemma derivative_of_cofactor (d : derivation R) F a k :
  d (cofactor F a k) = \sum_(m | m != a) \sum_(s : 'S_n | s a == k)
    (-1) ^+ s * (d (F m (s m)) * \prod_(j | (a != j) && (j != m)) F j (s j)).
Proof.
rewrite expand_cofactor raddf_sum exchange_big /=; apply: eq_bigr => s _.
rewrite leibniz.
have -> : d ((-1) ^+ s) = 0 by case: (odd_perm s); rewrite ?expr0 ?expr1 ?raddfN /= derivative_of_one ?oppr0.
rewrite mul0r add0r derivative_of_product mulr_sumr; apply: eq_bigl => m; by rewrite eq_sym.
Qed.

(** A sum over permutations vanishes where exchanging two places turns the sign of each term: of the two
halves, with \f$s(a) < s(m)\f$ and with \f$s(a) > s(m)\f$, each is minus the other. *)
Lemma sum_over_permutations_vanishes (a m : 'I_n) (f : 'S_n -> R) :
  m != a -> (forall s, f (tperm a m * s)%g = - f s) -> \sum_s f s = 0.
Proof.
move=> ma turns; rewrite (bigID (fun s : 'S_n => (s a < s m)%N)) /=.
rewrite [X in _ + X](reindex_inj (mulgI (tperm a m))) /=.
rewrite [X in _ + X](eq_big (fun s : 'S_n => (s a < s m)%N) (fun s => - f s)) ?sumrN ?subrr // => s.
have ne : (s a == s m :> nat) = false by apply/negbTE; rewrite val_eqE (inj_eq perm_inj) eq_sym.
by rewrite !permM tpermL tpermR -leqNgt leq_eqVlt ne.
Qed.

(** The matrix of cofactors of a gradient has no divergence: \f$\sum_k\partial_k\,\mathrm{adj}(F)^k{}_a =
0\f$, over any commutative ring and in any dimension. In a term with \f$\partial_kF^m{}_l\f$ the exchange of
the places \f$k\f$ and \f$l\f$ turns the sign of the permutation and nothing else. *)
Lemma divergence_of_cofactors D F a : is_gradient D F -> \sum_k D k ((\adj F) k a) = 0.
Proof.
move=> grad.
transitivity (\sum_(m | m != a) \sum_(s : 'S_n)
    (-1) ^+ s * (D (s a) (F m (s m)) * \prod_(j | (a != j) && (j != m)) F j (s j))).
  transitivity (\sum_k D k (cofactor F a k)); first by apply: eq_bigr => k _; rewrite mxE.
  rewrite (eq_bigr _ (fun k _ => derivative_of_cofactor (D k) F a k)).
  rewrite exchange_big /=; apply: eq_bigr => m _.
  rewrite [RHS](partition_big (fun s : 'S_n => s a) xpredT) //=.
  by apply: eq_bigr => k _; apply: eq_bigr => s /eqP ->.
rewrite big1 // => m ma; apply: (sum_over_permutations_vanishes ma) => s.
rewrite odd_permM odd_tperm eq_sym ma addTb signrN mulNr; congr (- (_ * (_ * _))).
  by rewrite !permM tpermL tpermR grad.
apply: eq_bigr => j /andP [aj jm]; by rewrite permM tpermD // eq_sym.
Qed.

End Piola.

(** *** Inverses and roots *)

Section Units.

Variables (R : comUnitRingType) (d : derivation R).

(** \f$d(A^{-1}) = -A^{-1}\,dA\,A^{-1}\f$. *)
Lemma derivative_of_inverse_matrix n (A : 'M[R]_n) :
  A \in unitmx -> derivative_of d (invmx A) = - (invmx A *m derivative_of d A *m invmx A).
Proof.
move=> unitA; have : derivative_of d (invmx A *m A) = 0.
  rewrite mulVmx //; apply/matrixP => i j; rewrite !mxE.
  by case: (i == j); rewrite ?derivative_of_one ?raddf0.
rewrite derivative_of_matrix_product => /(congr1 (mulmx^~ (invmx A))).
by rewrite mulmxDl -[X in X + _]mulmxA mulmxV // mulmx1 mul0mx => /eqP; rewrite addr_eq0 => /eqP.
Qed.

Lemma derivative_of_inverse (f : R) : f \is a GRing.unit -> d f^-1 = - (d f / f / f).
Proof.
move=> unit_f; have : d (f^-1 * f) = 0 by rewrite mulVr // derivative_of_one.
rewrite leibniz => /(congr1 (fun h => h / f)); rewrite mulrDl mul0r mulrK // => /eqP.
by rewrite addr_eq0 => /eqP ->; rewrite [_^-1 * _]mulrC.
Qed.

(** A root \f$r\f$ of \f$\det g\f$: \f$2\,dr = r\,g^{ab}\,dg_{ab}\f$. *)
Lemma derivative_of_root n (g : 'M[R]_n) (r : R) :
    r ^+ 2 = \det g -> r \is a GRing.unit ->
  2%:R * d r = r * \tr (invmx g *m derivative_of d g).
Proof.
move=> root unit_r.
have unit_g : g \in unitmx by rewrite unitmxE -root unitrX.
have := derivative_of_determinant d g.
have -> : \adj g = \det g *: invmx g by rewrite /invmx unit_g scalerA divrr ?scale1r // -unitmxE.
rewrite -root expr2 leibniz -scalemxAl mxtraceZ -mulrA [d r * r]mulrC -mulrDr.
move/(mulrI unit_r) <-; by rewrite mulr_natl mulr2n.
Qed.

End Units.

Lemma adjugate_of_one (R : comRingType) n : \adj (1%:M : 'M[R]_n) = 1%:M.
Proof. by have := mul_mx_adj (1%:M : 'M[R]_n); rewrite mul1mx det1. Qed.

(** ** Sylvester's determinant *)

(** \f$\det(1 + PQ) = \det(1 + QP)\f$ for matrices of any two sizes, over any commutative ring. *)
Lemma determinant_of_sum (R : comRingType) m k (P : 'M[R]_(m, k)) (Q : 'M[R]_(k, m)) :
  \det (1%:M + P *m Q) = \det (1%:M + Q *m P).
Proof.
have two_ways : block_mx 1%:M 0 (- Q) 1%:M *m block_mx 1%:M P 0 (1%:M + Q *m P)
              = block_mx (1%:M + P *m Q) P 0 1%:M *m block_mx 1%:M 0 (- Q) 1%:M.
  rewrite !mulmx_block !(mul0mx, mulmx0, mul1mx, mulmx1, addr0, add0r) mulmxN mulNmx addrK.
  by rewrite addrC addrK.
have := congr1 determinant two_ways.
by rewrite !det_mulmx !(det_lblock, det_ublock) !det1 !(mul1r, mulr1).
Qed.

Lemma determinant_of_two (R : comRingType) (M : 'M[R]_2) : \det M = M 0 0 * M 1 1 - M 1 0 * M 0 1.
Proof.
rewrite (expand_det_col _ 0) !big_ord_recl big_ord0 addr0 /cofactor !det_mx11 !mxE /=.
have -> : lift 0 0 = 1 :> 'I_2 by apply: val_inj.
have -> : lift 1 0 = 0 :> 'I_2 by apply: val_inj.
rewrite /bump /= expr0 expr1; ring_identity.
Qed.

Lemma determinant_of_blocks (R : comRingType) (a b c e : 'M[R]_1) :
  \det (block_mx a b c e : 'M_(1 + 1)) = a 0 0 * e 0 0 - c 0 0 * b 0 0.
Proof.
rewrite (determinant_of_two (block_mx a b c e)).
have -> : 0 = lshift 1 (0 : 'I_1) :> 'I_(1 + 1) by apply: val_inj.
have -> : 1 = rshift 1 (0 : 'I_1) :> 'I_(1 + 1) by apply: val_inj.
by congr (_ * _ - _ * _);
   [exact: block_mxEul | exact: block_mxEdr | exact: block_mxEdl | exact: block_mxEur].
Qed.

(** ** Polynomials *)

(** The derivative of polynomials in one variable over \f$R\f$, a derivation. *)
Definition polynomial_derivative (R : comRingType) : derivation [comRingType of {poly R}] :=
  @Derivation [comRingType of {poly R}] [additive of @deriv R] (@derivM R).

Lemma polynomial_derivative_X (R : comRingType) : polynomial_derivative R 'X = 1.
Proof. exact: derivX. Qed.

Lemma polynomial_derivative_C (R : comRingType) (f : R) : polynomial_derivative R f%:P = 0.
Proof. exact: derivC. Qed.

Section Coefficients.

Variables (R : comRingType) (d : derivation R).

Lemma leibniz_of_coefficients (p q : {poly R}) :
  map_poly d (p * q) = map_poly d p * q + p * map_poly d q.
Proof.
apply/polyP => k; rewrite coefD !coefM coef_map !coefM raddf_sum -big_split /=.
by apply: eq_bigr => i _; rewrite leibniz !coef_map.
Qed.

(** A derivation of \f$R\f$ acts on polynomials over \f$R\f$ by their coefficients. *)
Definition coefficient_derivative : derivation [comRingType of {poly R}] :=
  @Derivation [comRingType of {poly R}] [additive of map_poly d] leibniz_of_coefficients.

Lemma coefficient_derivative_X : coefficient_derivative 'X = 0.
Proof. by apply/polyP => k; rewrite coef_map coefX coef0 /= derivative_of_nat. Qed.

Lemma coefficient_derivative_C (f : R) : coefficient_derivative f%:P = (d f)%:P.
Proof. exact: map_polyC. Qed.

Lemma coefficient_derivative_commutes (p : {poly R}) :
  polynomial_derivative R (coefficient_derivative p) = coefficient_derivative (polynomial_derivative R p).
Proof. by apply/polyP => k; rewrite coef_deriv !coef_map coef_deriv /= raddfMn. Qed.

End Coefficients.

(** *** Rings of polynomials *)

(** What the counterexamples are made of: a ring with \f$n\f$ coordinates \f$x_i\f$, derivations
\f$\partial_i\f$ that commute, \f$\partial_ix_j = \delta_{ij}\f$, the rational numbers among its elements, and
the value of an element at the origin. *)
Record coordinate_ring n (R : comUnitRingType) := CoordinateRing {
  coordinate : 'I_n -> R;
  partial : 'I_n -> derivation R;
  constant : {rmorphism rat -> R};
  at_origin : {rmorphism R -> rat};
  partial_coordinate : forall i j, partial i (coordinate j) = (i == j)%:R;
  partial_constant : forall i q, partial i (constant q) = 0;
  partials_commute : forall i j f, partial i (partial j f) = partial j (partial i f);
  coordinate_at_origin : forall i, at_origin (coordinate i) = 0;
  constant_at_origin : forall q, at_origin (constant q) = q
}.

(** One variable more. *)
Lemma one_coordinate_more n (R : idomainType) :
  coordinate_ring n [comUnitRingType of R] -> coordinate_ring n.+1 [comUnitRingType of {poly R}].
Proof.
move=> c.
pose x (i : 'I_n.+1) : {poly R} := if unlift ord0 i is Some j then (coordinate c j)%:P else 'X.
pose d (i : 'I_n.+1) : derivation [comRingType of {poly R}] :=
  if unlift ord0 i is Some j then coefficient_derivative (partial c j) else polynomial_derivative _.
apply: (@CoordinateRing _ [comUnitRingType of {poly R}] x d [rmorphism of polyC \o constant c]
         [rmorphism of at_origin c \o horner_eval 0]).
- move=> i j; rewrite /d /x; case: (unliftP ord0 i) => [k|] ->; case: (unliftP ord0 j) => [l|] ->.
  + by rewrite coefficient_derivative_C partial_coordinate (inj_eq lift_inj) rmorph_nat.
  + by rewrite coefficient_derivative_X eq_sym (negbTE (neq_lift _ _)).
  + by rewrite polynomial_derivative_C (negbTE (neq_lift _ _)).
  + by rewrite polynomial_derivative_X eqxx.
- move=> i q; rewrite /d; case: (unliftP ord0 i) => [k|] _ /=; last exact: polynomial_derivative_C.
  by rewrite map_polyC /= partial_constant.
- move=> i j f; rewrite /d.
  case: (unliftP ord0 i) => [k|] _; case: (unliftP ord0 j) => [l|] _ //.
  + by apply/polyP => m; rewrite !coef_map /= partials_commute.
  + exact/esym/coefficient_derivative_commutes.
  + exact: coefficient_derivative_commutes.
- move=> i; rewrite /x /= /horner_eval; case: (unliftP ord0 i) => [k|] _.
  + by rewrite hornerC coordinate_at_origin.
  + by rewrite hornerX rmorph0.
- by move=> q; rewrite /= /horner_eval hornerC constant_at_origin.
Qed.

Lemma polynomials n : exists R : idomainType, inhabited (coordinate_ring n [comUnitRingType of R]).
Proof.
elim: n => [|n [R [c]]]; last by exists [idomainType of {poly R}]; split; exact: one_coordinate_more.
exists [idomainType of rat]; split.
pose none (i : 'I_0) : derivation [comRingType of rat] := match i with Ordinal _ lt =>
  match notF lt with end end.
by apply: (@CoordinateRing 0 [comUnitRingType of rat] (fun _ => 0) none [rmorphism of idfun]
            [rmorphism of idfun]) => //; case.
Qed.

(** The derivation that is zero everywhere. *)
Lemma leibniz_of_zero (R : comRingType) (f h : R) :
  (\0%R : R -> R) (f * h) = (\0%R : R -> R) f * h + f * (\0%R : R -> R) h.
Proof. by rewrite mul0r mulr0 addr0. Qed.

Definition zero_derivation (R : comRingType) : derivation R :=
  @Derivation R [additive of \0%R : R -> R] (@leibniz_of_zero R).

(** *** Numbers with a small part *)

(** Elements \f$a + b\varepsilon\f$ with \f$\varepsilon^2 = 0\f$ over \f$R\f$, and the derivation
\f$\varepsilon\,\partial/\partial\varepsilon\f$: a ring in which units need not be constant, as
\f$1 + \varepsilon\f$. It is what the polynomials of first order in \f$\varepsilon = e^x\f$ make with
\f$d/dx\f$. *)
Section SmallParts.

Variable R : comUnitRingType.

Definition with_small_part := (R * R)%type.
Canonical with_small_part_eqType := [eqType of with_small_part].
Canonical with_small_part_choiceType := [choiceType of with_small_part].
Canonical with_small_part_zmodType := [zmodType of with_small_part].
Implicit Types f h : with_small_part.

Definition small_product f h : with_small_part := (f.1 * h.1, f.1 * h.2 + f.2 * h.1).

Lemma small_product_associative : associative small_product.
Proof. move=> [a b] [c e] [k l]; congr pair; rewrite /=; ring_identity. Qed.
Lemma small_product_commutative : commutative small_product.
Proof. move=> [a b] [c e]; congr pair; rewrite /=; ring_identity. Qed.
Lemma small_product_one : left_id ((1, 0) : with_small_part) small_product.
Proof. move=> [a b]; congr pair; rewrite /=; ring_identity. Qed.
Lemma small_product_additive : left_distributive small_product +%R.
Proof. move=> [a b] [c e] [k l]; congr pair; rewrite /=; ring_identity. Qed.
Lemma small_one_nonzero : (1, 0) != 0 :> with_small_part.
Proof. by apply/eqP => -[/eqP]; rewrite oner_eq0. Qed.

Definition small_ringMixin :=
  ComRingMixin small_product_associative small_product_commutative small_product_one small_product_additive
    small_one_nonzero.
Canonical with_small_part_ringType := Eval hnf in RingType with_small_part small_ringMixin.
Canonical with_small_part_comRingType := Eval hnf in ComRingType with_small_part small_product_commutative.

Definition small_unit : pred with_small_part := fun f => f.1 \is a GRing.unit.
Definition small_inverse f : with_small_part := if small_unit f then (f.1^-1, - (f.2 / f.1 / f.1)) else f.

Lemma small_mulVr : {in small_unit, left_inverse 1 small_inverse *%R}.
Proof.
move=> [a b] unit_a; rewrite /small_inverse; have -> : small_unit (a, b) by [].
congr pair; rewrite /=; first by rewrite mulVr.
have -> : a^-1 * b + - (b / a / a) * a = a^-1 * b - b / a * (a / a) by ring_identity.
by rewrite divrr // mulr1 [b / a]mulrC subrr.
Qed.

Lemma small_unitPl f h : h * f = 1 -> small_unit f.
Proof. by case=> one _; apply/unitrPr; exists h.1; rewrite mulrC. Qed.

Lemma small_inverse_out : {in [predC small_unit], small_inverse =1 id}.
Proof.
move=> f; rewrite /small_inverse; case: ifP => // unit_f; rewrite inE /= => /negP not_unit.
by case: not_unit; exact: unit_f.
Qed.

Definition small_unitRingMixin := ComUnitRingMixin small_mulVr small_unitPl small_inverse_out.
Canonical with_small_part_unitRingType := Eval hnf in UnitRingType with_small_part small_unitRingMixin.
Canonical with_small_part_comUnitRingType := Eval hnf in [comUnitRingType of with_small_part].

(** The derivation \f$\varepsilon\,\partial/\partial\varepsilon\f$, and a derivation of the coefficients. *)
Definition small_derivative f : with_small_part := (0, f.2).

Lemma small_derivative_additive : additive small_derivative.
Proof. by move=> [a b] [c e]; congr pair; rewrite /= ?subrr. Qed.

Lemma small_derivative_leibniz f h :
  small_derivative (f * h) = small_derivative f * h + f * small_derivative h.
Proof. case: f h => [a b] [c e]; congr pair; rewrite /=; ring_identity. Qed.

Definition derivation_of_small_part : derivation [comRingType of with_small_part] :=
  @Derivation [comRingType of with_small_part] (Additive small_derivative_additive) small_derivative_leibniz.

Variable d : derivation R.

Definition both_parts f : with_small_part := (d f.1, d f.2).

Lemma both_parts_additive : additive both_parts.
Proof. by move=> [a b] [c e]; congr pair; rewrite /= raddfB. Qed.

Lemma both_parts_leibniz f h : both_parts (f * h) = both_parts f * h + f * both_parts h.
Proof.
case: f h => [a b] [c e]; congr pair; rewrite /= ?raddfD /= !leibniz //; ring_identity.
Qed.

Definition derivation_of_both_parts : derivation [comRingType of with_small_part] :=
  @Derivation [comRingType of with_small_part] (Additive both_parts_additive) both_parts_leibniz.

End SmallParts.
