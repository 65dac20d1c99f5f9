(** * Matrices of rational numbers that compute

The matrices of the library of mathematical components are functions, made for proofs; they do not compute.
A counterexample has to be computed. Here a matrix of rational numbers is given by its _rows_, each operation
on matrices is matched with one on rows, and an equation between matrices becomes an equation between lists
of fractions, which is decided by arithmetic. *)

From Coq Require Import ZArith QArith Qcanon.
From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope nat_scope.
Local Open Scope ring_scope.

(** ** The field of rational numbers

The rational numbers are fractions in lowest terms, a canonical form: two of them are equal exactly where
numerators and denominators are. *)

Notation Qc := Qcanon.Qc.

Definition numerator (x : Qc) : Z := Qnum (this x).
Definition denominator (x : Qc) : positive := Qden (this x).

Definition equal_fractions (x y : Qc) : bool :=
  Z.eqb (numerator x) (numerator y) && Pos.eqb (denominator x) (denominator y).

Lemma equal_fractionsP : Equality.axiom equal_fractions.
Proof.
move=> x y; apply: (iffP andP) => [[/Z.eqb_eq num /Pos.eqb_eq den]|->].
  apply: Qc_is_canon; rewrite /Qeq -/(numerator x) -/(numerator y).
  by rewrite -/(denominator x) -/(denominator y) num den.
by split; [apply/Z.eqb_eq | apply/Pos.eqb_eq].
Qed.

Definition Qc_eqMixin := EqMixin equal_fractionsP.
Canonical Qc_eqType := Eval hnf in EqType Qc Qc_eqMixin.

(** A fraction as three natural numbers, of which it can be made again. *)
Definition three_numbers (x : Qc) : nat * nat * nat :=
  (Z.to_nat (numerator x), Z.to_nat (- numerator x), Pos.to_nat (denominator x)).

Definition of_three_numbers (t : nat * nat * nat) : Qc :=
  let: (positive_part, negative_part, d) := t in
  Q2Qc (Qmake (Z.of_nat positive_part - Z.of_nat negative_part) (Pos.of_nat d)).

Lemma in_lowest_terms (x : Qc) : Q2Qc x = x.
Proof. by apply: Qc_is_canon; apply: Qred_correct. Qed.

Lemma three_numbersK : cancel three_numbers of_three_numbers.
Proof.
move=> x; rewrite -[RHS]in_lowest_terms /of_three_numbers /three_numbers Pos2Nat.id.
rewrite /numerator /denominator; case: x => -[num den] _ /=; congr (Q2Qc (Qmake _ _)).
by case: num => [|p|p] //=; rewrite positive_nat_Z // Z.sub_0_r.
Qed.

Definition Qc_choiceMixin := CanChoiceMixin three_numbersK.
Canonical Qc_choiceType := Eval hnf in ChoiceType Qc Qc_choiceMixin.
Definition Qc_countMixin := CanCountMixin three_numbersK.
Canonical Qc_countType := Eval hnf in CountType Qc Qc_countMixin.

Definition Qc_zero : Qc := Q2Qc (Qmake 0 1).
Definition Qc_one : Qc := Q2Qc (Qmake 1 1).

Lemma Qc_opposite : left_inverse Qc_zero Qcopp Qcplus.
Proof. by move=> x; rewrite Qcplus_comm; apply: Qcplus_opp_r. Qed.

Definition Qc_zmodMixin := ZmodMixin Qcplus_assoc Qcplus_comm Qcplus_0_l Qc_opposite.
Canonical Qc_zmodType := Eval hnf in ZmodType Qc Qc_zmodMixin.

Lemma Qc_distributive : left_distributive Qcmult Qcplus.
Proof. by move=> x y z; apply: Qcmult_plus_distr_l. Qed.

Lemma Qc_nonzero : Qc_one != Qc_zero. Proof. by []. Qed.

Definition Qc_ringMixin := ComRingMixin Qcmult_assoc Qcmult_comm Qcmult_1_l Qc_distributive Qc_nonzero.
Canonical Qc_ringType := Eval hnf in RingType Qc Qc_ringMixin.
Canonical Qc_comRingType := Eval hnf in ComRingType Qc Qcmult_comm.

Lemma Qc_inverse (x : Qc) : x != Qc_zero -> Qcmult (Qcinv x) x = Qc_one.
Proof. by move/eqP=> nonzero; rewrite Qcmult_comm; apply: Qcmult_inv_r. Qed.

Lemma Qc_inverse_zero : Qcinv Qc_zero = Qc_zero. Proof. exact: Qc_is_canon. Qed.

Definition Qc_unitRingMixin := FieldUnitMixin Qc_inverse Qc_inverse_zero.
Canonical Qc_unitRingType := Eval hnf in UnitRingType Qc Qc_unitRingMixin.
Canonical Qc_comUnitRingType := Eval hnf in [comUnitRingType of Qc].

Lemma Qc_field : GRing.Field.mixin_of Qc_unitRingType. Proof. by []. Qed.

Canonical Qc_idomainType := Eval hnf in IdomainType Qc (FieldIdomainMixin Qc_field).
Canonical Qc_fieldType := Eval hnf in FieldType Qc Qc_field.

(** ** Numbers and rows

`rational 3 5` is three fifths; `over 5 [:: [:: 3; -4]; [:: 4; 3]]` are the rows of a rotation, `integers` are
rows over 1. *)

Declare Scope table_scope.
Delimit Scope table_scope with table.
Number Notation Z Z.of_num_int Z.to_num_int : table_scope.
Number Notation positive Pos.of_num_int Pos.to_num_uint : positive_scope.

Definition rational (a : Z) (b : positive) : Qc := Q2Qc (Qmake a b).
Arguments rational a%table b%positive.

Definition rows := seq (seq Qc).

Definition rows_over (d : positive) (a : seq (seq Z)) : rows := [seq [seq rational x d | x <- r] | r <- a].
Notation over d a := (rows_over d%positive a%table).
Notation integers a := (rows_over 1%positive a%table).

(** The number in row \f$i\f$ and column \f$j\f$, both counted from zero; what is not given is zero. *)
Definition entry (a : rows) (i j : nat) : Qc := nth Qc_zero (nth [::] a i) j.

(** The rows of which the entries are given by a formula. *)
Definition tabulate (m n : nat) (f : nat -> nat -> Qc) : rows := mkseq (fun i => mkseq (f i) n) m.

Lemma entry_tabulate m n f i j : (i < m)%N -> (j < n)%N -> entry (tabulate m n f) i j = f i j.
Proof. by move=> i_m j_n; rewrite /entry !nth_mkseq. Qed.

(** ** The matrix with given rows *)

Definition matrix_of_rows (m n : nat) (a : rows) : 'M[Qc]_(m, n) := \matrix_(i < m, j < n) entry a i j.

(** The square matrix of size \f$n\f$. *)
Notation matrix_of n := (matrix_of_rows n%N n%N).

Lemma matrix_of_entry m n a (i : 'I_m) (j : 'I_n) : entry a i j = matrix_of_rows m n a i j.
Proof. by rewrite mxE. Qed.

Lemma matrix_of_tabulate m n f : matrix_of_rows m n (tabulate m n f) = \matrix_(i < m, j < n) f i j.
Proof. by apply/matrixP => i j; rewrite !mxE entry_tabulate. Qed.

(** Every matrix of rational numbers is one of these. *)
Lemma matrix_of_rows_onto m n (A : 'M[Qc]_(m, n)) : exists a, A = matrix_of_rows m n a.
Proof.
pose f i j := odflt Qc_zero (obind (fun i' => omap (A i') (insub j)) (insub i)).
by exists (tabulate m n f); rewrite matrix_of_tabulate; apply/matrixP => i j; rewrite mxE /f !valK.
Qed.

(** ** Equality *)

Definition same_rows (m n : nat) (a b : rows) : bool :=
  all (fun i => all (fun j => equal_fractions (entry a i j) (entry b i j)) (iota 0 n)) (iota 0 m).

Lemma same_rowsP m n a b : reflect (matrix_of_rows m n a = matrix_of_rows m n b) (same_rows m n a b).
Proof.
apply: (iffP allP) => [same|/matrixP same i].
  apply/matrixP => i j; rewrite !mxE; apply/equal_fractionsP.
  have i_m : val i \in iota 0 m by rewrite mem_iota /=.
  by move/allP: (same _ i_m) => /(_ (val j)); apply; rewrite mem_iota /=.
rewrite mem_iota /= add0n => i_m; apply/allP => j; rewrite mem_iota /= add0n => j_n.
by have := same (Ordinal i_m) (Ordinal j_n); rewrite !mxE /= => ->; apply/equal_fractionsP.
Qed.

Lemma matrix_of_eq m n a b : same_rows m n a b = (matrix_of_rows m n a == matrix_of_rows m n b).
Proof. exact/same_rowsP/eqP. Qed.

(** ** Operations on rows *)

Definition rows_add m n a b := tabulate m n (fun i j => Qcplus (entry a i j) (entry b i j)).
Definition rows_opp m n a := tabulate m n (fun i j => Qcopp (entry a i j)).
Definition rows_scale m n c a := tabulate m n (fun i j => Qcmult c (entry a i j)).
Definition rows_transpose m n a := tabulate n m (fun i j => entry a j i).

(** The sum of the numbers \f$f(0), \dots, f(n-1)\f$. *)
Definition sum_to n (f : nat -> Qc) : Qc := foldr (fun k s => Qcplus (f k) s) Qc_zero (iota 0 n).

Definition rows_mul m n p a b :=
  tabulate m p (fun i k => sum_to n (fun j => Qcmult (entry a i j) (entry b j k))).

(** The number \f$c\f$ on the diagonal, and given numbers on it. *)
Definition rows_scalar n c := tabulate n n (fun i j => if i == j then c else Qc_zero).
Definition diagonal (d : seq Qc) :=
  tabulate (size d) (size d) (fun i j => if i == j then nth Qc_zero d i else Qc_zero).
Definition rows_trace n a := sum_to n (fun i => entry a i i).

(** The rows without the row \f$i\f$ and the column \f$j\f$. *)
Definition rows_minor n i j a := tabulate n n (fun k l => entry a (bump i k) (bump j l)).

Definition signed (k : nat) (x : Qc) : Qc := if odd k then Qcopp x else x.

(** The determinant, expanded along the first row. *)
Fixpoint rows_det n a : Qc :=
  if n is n'.+1 then sum_to n (fun j => Qcmult (entry a 0 j) (signed j (rows_det n' (rows_minor n' 0 j a))))
  else Qc_one.

(** The matrix of cofactors, transposed, and the inverse: a matrix that has none is left as it is. *)
Definition rows_adjugate n a :=
  tabulate n n (fun i j => signed (j + i) (rows_det n.-1 (rows_minor n.-1 j i a))).
Definition rows_inverse n a :=
  let d := rows_det n a in
  if equal_fractions d Qc_zero then a else rows_scale n n (Qcinv d) (rows_adjugate n a).

(** ** The operations on rows are those on matrices *)

Lemma sum_toE n (f : nat -> Qc) : sum_to n f = \sum_(i < n) f i.
Proof. by rewrite -(big_mkord xpredT f) /index_iota subn0 unlock. Qed.

Lemma signedE k x : signed k x = (-1) ^+ k * x.
Proof.
rewrite -signr_odd /signed; case: (odd k).
  by rewrite expr1 mulN1r.
by rewrite expr0 mul1r.
Qed.

Lemma matrix_of_add m n a b :
  matrix_of_rows m n (rows_add m n a b) = matrix_of_rows m n a + matrix_of_rows m n b.
Proof. by rewrite matrix_of_tabulate; apply/matrixP => i j; rewrite !mxE. Qed.

Lemma matrix_of_opp m n a : matrix_of_rows m n (rows_opp m n a) = - matrix_of_rows m n a.
Proof. by rewrite matrix_of_tabulate; apply/matrixP => i j; rewrite !mxE. Qed.

Lemma matrix_of_zero m n : matrix_of_rows m n [::] = 0.
Proof. by apply/matrixP => i j; rewrite !mxE /entry !nth_nil. Qed.

Lemma matrix_of_scale m n c a : matrix_of_rows m n (rows_scale m n c a) = c *: matrix_of_rows m n a.
Proof. by rewrite matrix_of_tabulate; apply/matrixP => i j; rewrite !mxE. Qed.

Lemma rational_add a b : rational (Z.add a b) 1 = rational a 1 + rational b 1.
Proof.
apply/Q2Qc_eq_iff; apply: (Qeq_trans _ (Qplus (Qmake a 1) (Qmake b 1))).
  by rewrite /Qeq /= !Z.mul_1_r.
by apply: Qplus_comp; apply: Qeq_sym; apply: Qred_correct.
Qed.

Lemma rational_nat k : rational (Z.of_nat k) 1 = k%:R.
Proof.
elim: k => [|k IH]; first by apply: Qc_is_canon.
by rewrite Nat2Z.inj_succ -Z.add_1_r rational_add IH -addn1 natrD.
Qed.

Lemma matrix_of_muln m n a k :
  matrix_of_rows m n (rows_scale m n (rational (Z.of_nat k) 1) a) = matrix_of_rows m n a *+ k.
Proof.
by rewrite matrix_of_scale rational_nat scaler_nat.
Qed.

Lemma matrix_of_transpose m n a : matrix_of_rows n m (rows_transpose m n a) = (matrix_of_rows m n a)^T.
Proof. by rewrite matrix_of_tabulate; apply/matrixP => i j; rewrite !mxE. Qed.

Lemma matrix_of_mul m n p a b :
  matrix_of_rows m p (rows_mul m n p a b) = matrix_of_rows m n a *m matrix_of_rows n p b.
Proof.
rewrite matrix_of_tabulate; apply/matrixP => i k; rewrite !mxE sum_toE.
by apply: eq_bigr => j _; rewrite !mxE.
Qed.

Lemma matrix_of_scalar n c : matrix_of n (rows_scalar n c) = c%:M.
Proof. by rewrite matrix_of_tabulate; apply/matrixP => i j; rewrite !mxE -val_eqE; case: eqP. Qed.

(** Where the size is not zero, the matrices are a ring with its own signs for one, product and power. *)
Lemma matrix_of_one n : matrix_of n.+1 (rows_scalar n.+1 Qc_one) = 1.
Proof. by rewrite matrix_of_scalar. Qed.

Lemma matrix_of_ring_mul n a b :
  matrix_of n.+1 (rows_mul n.+1 n.+1 n.+1 a b) = matrix_of n.+1 a * matrix_of n.+1 b.
Proof. by rewrite matrix_of_mul. Qed.

Lemma matrix_of_exp n a k :
  matrix_of n.+1 (iter k (rows_mul n.+1 n.+1 n.+1 a) (rows_scalar n.+1 Qc_one)) = matrix_of n.+1 a ^+ k.
Proof. by elim: k => [|k IH]; rewrite ?matrix_of_one // iterS matrix_of_ring_mul IH exprS. Qed.

Lemma matrix_of_diagonal d :
  matrix_of (size d) (diagonal d) = diag_mx (\row_(i < size d) nth Qc_zero d i).
Proof.
by rewrite matrix_of_tabulate; apply/matrixP => i j; rewrite !mxE -val_eqE; case: eqP => [->|].
Qed.

Lemma matrix_of_trace n a : rows_trace n a = \tr (matrix_of n a).
Proof. by rewrite /rows_trace sum_toE; apply: eq_bigr => i _; rewrite mxE. Qed.

Lemma matrix_of_minor n (i j : 'I_n.+1) a :
  matrix_of n (rows_minor n i j a) = row' i (col' j (matrix_of n.+1 a)).
Proof. by rewrite matrix_of_tabulate; apply/matrixP => k l; rewrite !mxE. Qed.

Lemma matrix_of_det n a : rows_det n a = \det (matrix_of n a).
Proof.
elim: n a => [|n IH] a; first by rewrite det_mx00.
rewrite (expand_det_row _ ord0) [LHS]sum_toE; apply: eq_bigr => j _.
by rewrite mxE /cofactor -matrix_of_minor -IH signedE.
Qed.

Lemma matrix_of_adjugate n a : matrix_of n (rows_adjugate n a) = \adj (matrix_of n a).
Proof.
case: n => [|n]; first by rewrite [LHS]flatmx0 [RHS]flatmx0.
rewrite matrix_of_tabulate; apply/matrixP => i j.
by rewrite !mxE /cofactor -matrix_of_minor -matrix_of_det signedE.
Qed.

Lemma matrix_of_unit n a : ~~ equal_fractions (rows_det n a) Qc_zero = (matrix_of n a \in unitmx).
Proof. by rewrite unitmxE -matrix_of_det. Qed.

Lemma matrix_of_inverse n a : matrix_of n (rows_inverse n a) = invmx (matrix_of n a).
Proof.
rewrite /invmx -matrix_of_unit /rows_inverse; case: ifP => // _.
by rewrite matrix_of_scale matrix_of_det matrix_of_adjugate.
Qed.

(** A matrix that is inverse to another one by computation is so. *)
Lemma matrix_of_inverse_given n a b :
  same_rows n n (rows_mul n n n a b) (rows_scalar n Qc_one) -> invmx (matrix_of n a) = matrix_of n b.
Proof.
move/same_rowsP; rewrite matrix_of_mul matrix_of_scalar => product_is_1.
have [unit _] := mulmx1_unit product_is_1.
by rewrite -[LHS]mulmx1 -[1%:M]product_is_1 mulmxA mulVmx // mul1mx.
Qed.

(** All of them together: `rewrite -!computedE` turns an expression in matrices with given rows into one
matrix with computed rows, and a trace or a determinant into a number. *)
Definition computedE :=
  (matrix_of_add, matrix_of_opp, matrix_of_scale, matrix_of_muln, matrix_of_transpose, matrix_of_mul,
   matrix_of_inverse, matrix_of_adjugate, matrix_of_scalar, matrix_of_zero, matrix_of_diagonal, matrix_of_one,
   matrix_of_ring_mul, matrix_of_exp, matrix_of_trace, matrix_of_det, matrix_of_unit, matrix_of_entry,
   matrix_of_eq).

(** ** To decide

`to_rows` writes both sides of an equation between matrices with given rows, opened to the operations of
linear algebra, as matrices with computed rows. `decide_by_computation` proves what is then true by
arithmetic: an equation \f$A = B\f$ or \f$x = y\f$, its negation, a membership \f$A\in GL(n)\f$. *)

(** The words of the page on matrices, opened. *)
Ltac open_matrices :=
  rewrite /orthogonal /symmetric /skew /skew_part /Ad_star /Ad /ad_star /ad /bracket /pairing /L_star /R_star
    /left_translation /right_translation.

Ltac to_rows := open_matrices; rewrite -?computedE.

(** What is left when a matrix that does not compute stands in the goal. *)
Ltac only_numbers :=
  lazymatch goal with
  | |- context [matrix _ _ _] => fail "a matrix without rows is left: open its definition first"
  | _ => idtac
  end.

Ltac decide_by_computation :=
  to_rows;
  first [ by apply/same_rowsP; vm_compute; reflexivity
        | by move/same_rowsP; vm_compute
        | only_numbers;
          first [ by apply/eqP; vm_compute; reflexivity
                | by move/eqP; vm_compute
                | by vm_compute ] ].

(** ** An example

The momentum of a body is moved on by \f$\mathrm{Ad}^*_{f^{-1}}\Pi = f\Pi f^T\f$; without the star it is
moved back. One rotation by the angle of which cosine and sine are three and four fifths tells them apart. *)
Example adjoint_without_star :
  ~ (forall (R : comUnitRingType) (n : nat) (f P : 'M[R]_n),
       orthogonal f -> skew P -> Ad (invmx f) P = f *m P *m f^T).
Proof.
pose f := over 5 [:: [:: 3; -4; 0]; [:: 4; 3; 0]; [:: 0; 0; 5]].
pose P := integers [:: [:: 0; 0; 1]; [:: 0; 0; 0]; [:: -1; 0; 0]].
move/(_ Qc_comUnitRingType 3%N (matrix_of 3 f) (matrix_of 3 P)) => claim.
have rotation : orthogonal (matrix_of 3 f) by decide_by_computation.
have momentum : skew (matrix_of 3 P) by decide_by_computation.
by move: (claim rotation momentum); decide_by_computation.
Qed.
