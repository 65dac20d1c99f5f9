(** * Numbers with an infinitesimal

How the pages on the discrete mechanics of a group take derivatives. A number \f$a + b\varepsilon\f$ with
\f$\varepsilon^2 = 0\f$ is a _dual number_; where a curve \f$x(\varepsilon)\f$ has \f$x(0) = a\f$ and the
derivative \f$b\f$ there, every formula in sums, products and inverses takes \f$a + b\varepsilon\f$ to the
value of the formula and to its derivative. So a variation of a group element is the matrix
\f$g + \varepsilon\,\delta g\f$, a function of group elements is given on such matrices as well, and its
derivative is what multiplies \f$\varepsilon\f$. This is no approximation, and it makes sense over every
commutative ring; the library takes its derivatives in the same way. Dual numbers over dual numbers give
second derivatives. *)

From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

(** ** The ring of dual numbers

\f$a + b\varepsilon\f$: the _value_ \f$a\f$ and the _rate_ \f$b\f$. C++: `actio::Dual`, `numbers/dual.hpp`. *)
Record dual (R : Type) := Dual { value : R; rate : R }.

Section DualNumbers.

Variable R : comUnitRingType.
Implicit Types x y z : dual R.

Lemma dual_equal x y : value x = value y -> rate x = rate y -> x = y.
Proof. by case: x y => [a b] [c d] /= -> ->. Qed.

Definition pair_of_dual x := (value x, rate x).
Definition dual_of_pair (p : R * R) := Dual p.1 p.2.
Lemma pair_of_dualK : cancel pair_of_dual dual_of_pair. Proof. by case. Qed.

Definition dual_eqMixin := CanEqMixin pair_of_dualK.
Canonical dual_eqType := Eval hnf in EqType (dual R) dual_eqMixin.
Definition dual_choiceMixin := CanChoiceMixin pair_of_dualK.
Canonical dual_choiceType := Eval hnf in ChoiceType (dual R) dual_choiceMixin.

(** \f$(a+b\varepsilon) + (c+d\varepsilon) = (a+c) + (b+d)\varepsilon\f$. *)
Definition dual_add x y := Dual (value x + value y) (rate x + rate y).
Definition dual_opp x := Dual (- value x) (- rate x).

Lemma dual_addA : associative dual_add. Proof. by move=> x y z; apply: dual_equal; rewrite /= addrA. Qed.
Lemma dual_addC : commutative dual_add. Proof. by move=> x y; apply: dual_equal; rewrite /= addrC. Qed.
Lemma dual_add0 : left_id (Dual 0 0) dual_add. Proof. by move=> x; apply: dual_equal; rewrite /= add0r. Qed.
Lemma dual_addN : left_inverse (Dual 0 0) dual_opp dual_add.
Proof. by move=> x; apply: dual_equal; rewrite /= addNr. Qed.

Definition dual_zmodMixin := ZmodMixin dual_addA dual_addC dual_add0 dual_addN.
Canonical dual_zmodType := Eval hnf in ZmodType (dual R) dual_zmodMixin.

(** \f$(a+b\varepsilon)(c+d\varepsilon) = ac + (ad+bc)\varepsilon\f$: the rule of Leibniz. *)
Definition dual_mul x y := Dual (value x * value y) (value x * rate y + rate x * value y).

Lemma dual_mulA : associative dual_mul.
Proof. by move=> x y z; apply: dual_equal; rewrite /= ?mulrA // mulrDr mulrDl !mulrA addrA. Qed.
Lemma dual_mulC : commutative dual_mul.
Proof.
move=> x y; apply: dual_equal; rewrite /=; first exact: mulrC.
by rewrite addrC; congr (_ + _); apply: mulrC.
Qed.
Lemma dual_mul1 : left_id (Dual 1 0) dual_mul.
Proof. by move=> x; apply: dual_equal; rewrite /= ?mul0r ?addr0 mul1r. Qed.
Lemma dual_mulD : left_distributive dual_mul dual_add.
Proof. by move=> x y z; apply: dual_equal; rewrite /= !mulrDl // addrACA. Qed.
Lemma dual_nonzero : Dual 1 0 != 0 :> dual R.
Proof. by apply/eqP => /(congr1 (@value R)) /eqP; rewrite /= oner_eq0. Qed.

Definition dual_ringMixin := ComRingMixin dual_mulA dual_mulC dual_mul1 dual_mulD dual_nonzero.
Canonical dual_ringType := Eval hnf in RingType (dual R) dual_ringMixin.
Canonical dual_comRingType := Eval hnf in ComRingType (dual R) dual_mulC.

(** A dual number has an inverse where its value has one:
\f$(a+b\varepsilon)^{-1} = a^{-1} - a^{-1}b\,a^{-1}\varepsilon\f$. *)
Definition dual_unit : {pred dual R} := fun x => value x \is a GRing.unit.
Definition dual_inv x :=
  if x \in dual_unit then Dual (value x)^-1 (- ((value x)^-1 * rate x * (value x)^-1)) else x.

Lemma dual_mulV : {in dual_unit, left_inverse 1 dual_inv *%R}.
Proof.
move=> x unit_x; rewrite /dual_inv unit_x; have u : value x \is a GRing.unit := unit_x.
apply: dual_equal; first by rewrite /= mulVr.
by rewrite /= mulNr divrK // subrr.
Qed.
Lemma dual_unit_of_inverse x y : y * x = 1 -> dual_unit x.
Proof. by move/(congr1 (@value R)) => /= yx1; apply/unitrPr; exists (value y); rewrite mulrC. Qed.
Lemma dual_inv_out : {in [predC dual_unit], dual_inv =1 id}.
Proof. by move=> x; rewrite inE /= /dual_inv => /negbTE ->. Qed.

Definition dual_unitRingMixin := ComUnitRingMixin dual_mulV dual_unit_of_inverse dual_inv_out.
Canonical dual_unitRingType := Eval hnf in UnitRingType (dual R) dual_unitRingMixin.
Canonical dual_comUnitRingType := Eval hnf in [comUnitRingType of dual R].

Lemma value_additive : additive (@value R). Proof. by []. Qed.
Canonical value_Additive := Additive value_additive.
Lemma rate_additive : additive (@rate R). Proof. by []. Qed.
Canonical rate_Additive := Additive rate_additive.

End DualNumbers.

(** ** Matrices that vary *)

Section VariedMatrices.

Variable R : comUnitRingType.

(** \f$f + \varepsilon v\f$. C++: `actio::checks::varied`, `sequences.hpp` of the checks. *)
Definition varied m n (f v : 'M[R]_(m, n)) : 'M[dual R]_(m, n) := \matrix_(i, j) Dual (f i j) (v i j).

(** A matrix that does not vary. *)
Definition still m n (f : 'M[R]_(m, n)) := varied f 0.

Definition value_of m n (f : 'M[dual R]_(m, n)) : 'M[R]_(m, n) := \matrix_(i, j) value (f i j).

(** What \f$\varepsilon\f$ multiplies. *)
Definition rate_of m n (f : 'M[dual R]_(m, n)) : 'M[R]_(m, n) := \matrix_(i, j) rate (f i j).

Section Arithmetic.

Variables m n p : nat.
Implicit Types f v g w : 'M[R]_(m, n).

Lemma value_varied f v : value_of (varied f v) = f. Proof. by apply/matrixP => i j; rewrite !mxE. Qed.
Lemma rate_varied f v : rate_of (varied f v) = v. Proof. by apply/matrixP => i j; rewrite !mxE. Qed.

(** Every matrix of dual numbers is of this kind. *)
Lemma variedE (x : 'M[dual R]_(m, n)) : x = varied (value_of x) (rate_of x).
Proof. by apply/matrixP => i j; rewrite !mxE; case: (x i j). Qed.

Lemma varied_add f v g w : varied f v + varied g w = varied (f + g) (v + w).
Proof. by apply/matrixP => i j; rewrite !mxE. Qed.
Lemma varied_opp f v : - varied f v = varied (- f) (- v).
Proof. by apply/matrixP => i j; rewrite !mxE. Qed.
Lemma varied_transpose f v : (varied f v)^T = varied f^T v^T.
Proof. by apply/matrixP => i j; rewrite !mxE. Qed.

(** The rule of Leibniz: \f$(f+\varepsilon v)(g+\varepsilon w) = fg + \varepsilon(fw + vg)\f$. *)
Lemma varied_mul f v (g w : 'M[R]_(n, p)) :
  varied f v *m varied g w = varied (f *m g) (f *m w + v *m g).
Proof.
apply/matrixP => i j; rewrite !mxE; apply: dual_equal; rewrite /= raddf_sum /=.
  by apply: eq_bigr => k _; rewrite !mxE.
by rewrite -big_split; apply: eq_bigr => k _; rewrite !mxE.
Qed.

End Arithmetic.

Variable n : nat.
Implicit Types f v g w p : 'M[R]_n.

Lemma varied_one : varied 1%:M 0 = 1%:M :> 'M[dual R]_n.
Proof. by apply/matrixP => i j; rewrite !mxE; case: (i == j). Qed.

Lemma trace_varied f v : \tr (varied f v) = Dual (\tr f) (\tr v).
Proof. by apply: dual_equal; rewrite /= raddf_sum; apply: eq_bigr => i _; rewrite mxE. Qed.

Lemma pairing_varied p q f v :
  pairing (varied p q) (varied f v) = Dual (pairing p f) (pairing p v + pairing q f).
Proof. by rewrite /pairing varied_transpose varied_mul trace_varied raddfD. Qed.

(** A matrix that varies has an inverse where it starts from a matrix that has one:
\f$(g+\varepsilon w)^{-1} = g^{-1} - \varepsilon\,g^{-1}w\,g^{-1}\f$. *)
Lemma varied_right_inverse g w : g \in unitmx ->
  varied g w *m varied (invmx g) (- (invmx g *m w *m invmx g)) = 1%:M.
Proof.
by move=> u; rewrite varied_mul mulmxV // mulmxN !mulmxA mulmxV // mul1mx addNr varied_one.
Qed.
Lemma varied_unit g w : (varied g w \in unitmx) = (g \in unitmx).
Proof.
apply/idP/idP => [u|/(varied_right_inverse w) /mulmx1_unit []//].
move: (mulmxV u); rewrite [invmx _]variedE varied_mul -varied_one => /(congr1 (@value_of n n)).
by rewrite !value_varied => /mulmx1_unit [].
Qed.
Lemma varied_inverse g w : g \in unitmx ->
  invmx (varied g w) = varied (invmx g) (- (invmx g *m w *m invmx g)).
Proof.
move=> u; rewrite -[LHS]mulmx1 -(varied_right_inverse w u) mulmxA mulVmx ?mul1mx //.
by rewrite varied_unit.
Qed.

(** ** The differential of a function of matrices

A function \f$\ell\f$ of matrices is given on matrices of dual numbers. Its differential \f$\ell'(f)\f$ is the
covector of which the entries are the derivatives of \f$\ell\f$ along the unit matrices. *)
Definition differential (l : 'M[dual R]_n -> dual R) f : 'M[R]_n :=
  \matrix_(i, j) rate (l (varied f (delta_mx i j))).

(** \f$\ell\f$ is _differentiable_ at \f$f\f$ where its derivatives along all directions are those of a
covector: \f$\frac{d}{d\varepsilon}\ell(f+\varepsilon v) = \langle\ell'(f), v\rangle\f$. *)
Definition differentiable (l : 'M[dual R]_n -> dual R) f :=
  forall v, rate (l (varied f v)) = pairing (differential l f) v.

Lemma pairing_unit_matrix p i j : pairing p (delta_mx i j) = p i j.
Proof.
rewrite /pairing /mxtrace (bigD1 j) //= mxE (bigD1 i) //= !mxE !eqxx mulr1.
rewrite big1 ?addr0; last by move=> k ne; rewrite !mxE (negbTE ne) mulr0.
rewrite big1 ?addr0 // => k ne; rewrite mxE big1 // => l _.
by rewrite !mxE (negbTE ne) andbF mulr0.
Qed.

(** The differential is the only covector with this property. *)
Lemma differential_is l f p : (forall v, rate (l (varied f v)) = pairing p v) -> differential l f = p.
Proof. by move=> is_p; apply/matrixP => i j; rewrite mxE is_p pairing_unit_matrix. Qed.
Lemma differentiable_is l f p : (forall v, rate (l (varied f v)) = pairing p v) -> differentiable l f.
Proof. by move=> is_p v; rewrite (differential_is is_p). Qed.

(** Polynomials in the entries are differentiable: constants and entries are, sums and products of two
functions are where both are. *)
Lemma differentiable_constant c f : differentiable (fun=> Dual c 0) f.
Proof. by apply: (@differentiable_is _ _ 0) => v; rewrite /pairing trmx0 mul0mx mxtrace0. Qed.
Lemma differentiable_entry i j f : differentiable (fun x => x i j) f.
Proof.
apply: (@differentiable_is _ _ (delta_mx i j)) => v.
by rewrite mxE -[RHS]mxtrace_tr trmx_mul trmxK -[LHS](pairing_unit_matrix v).
Qed.

Lemma pairing_addl p q v : pairing (p + q) v = pairing p v + pairing q v.
Proof. by rewrite /pairing raddfD mulmxDl raddfD. Qed.
Lemma pairing_oppl p v : pairing (- p) v = - pairing p v.
Proof. by rewrite /pairing raddfN mulNmx raddfN. Qed.
Lemma pairing_scalel c p v : pairing (c *: p) v = c * pairing p v.
Proof. by rewrite /pairing linearZ -scalemxAl mxtraceZ. Qed.
Lemma pairing_addr p v w : pairing p (v + w) = pairing p v + pairing p w.
Proof. by rewrite /pairing mulmxDr raddfD. Qed.
Lemma pairing_oppr p v : pairing p (- v) = - pairing p v.
Proof. by rewrite /pairing mulmxN raddfN. Qed.
Lemma pairing_0l v : pairing 0 v = 0 :> R. Proof. by rewrite /pairing trmx0 mul0mx mxtrace0. Qed.
Lemma pairing_0r p : pairing p 0 = 0 :> R. Proof. by rewrite /pairing mulmx0 mxtrace0. Qed.

(** \f$\langle p, v\rangle = \mathrm{Tr}(p^Tv)\f$ is symmetric in the two matrices. *)
Lemma pairing_sym p q : pairing p q = pairing q p.
Proof. by rewrite /pairing -mxtrace_tr trmx_mul trmxK. Qed.

Lemma differentiable_sum l k f : differentiable l f -> differentiable k f ->
  differentiable (fun x => l x + k x) f.
Proof.
move=> dl dk; apply: (@differentiable_is _ _ (differential l f + differential k f)) => v.
by rewrite pairing_addl -dl -dk.
Qed.
Lemma differentiable_product l k f a b : (forall v, value (l (varied f v)) = a) ->
  (forall v, value (k (varied f v)) = b) -> differentiable l f -> differentiable k f ->
  differentiable (fun x => l x * k x) f.
Proof.
move=> at_l at_k dl dk; apply: (@differentiable_is _ _ (a *: differential k f + b *: differential l f)) => v.
by rewrite /= at_l at_k dk dl pairing_addl !pairing_scalel [b * _]mulrC.
Qed.

(** The function \f$\ell(f) = \mathrm{Tr}(W^Tf)\f$: its differential is \f$W\f$ everywhere. *)
Definition linear_function W (x : 'M[dual R]_n) : dual R := pairing (still W) x.

Lemma linear_differential W f : differential (linear_function W) f = W.
Proof. by apply: differential_is => v; rewrite /linear_function pairing_varied /= pairing_0l addr0. Qed.
Lemma linear_differentiable W f : differentiable (linear_function W) f.
Proof.
by apply: (@differentiable_is _ _ W) => v; rewrite /linear_function pairing_varied /= pairing_0l addr0.
Qed.

End VariedMatrices.
