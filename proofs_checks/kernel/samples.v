(** * Rational samples

Matrices of rational numbers drawn by a rule, the same ones at every run: any, symmetric and skew ones,
rotations, and invertible ones with their inverses. On them the definitions of the other pages can be
evaluated and written out, to be compared with the functions of the library on the same data. *)

From Coq Require Import ZArith QArith Qcanon Ascii String DecimalString.
From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices computed.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

(** ** The value of an expression

The rows of a matrix that is given by an expression in matrices with given rows, together with the proof that
they are its rows. The tactic `by_rows` finds them whatever the size; a definition that is not in `matrices`
is opened before. *)
Definition value (m n : nat) (X : 'M[Qc]_(m, n)) := {r : rows | matrix_of_rows m n r = X}.

(** Likewise a number given by traces, determinants and entries. *)
Definition number (x : Qc) := {y : Qc | y = x}.

Definition rows_of m n X (v : @value m n X) : rows := sval v.
Definition number_of x (v : number x) : Qc := sval v.

Ltac by_rows := eexists; to_rows; reflexivity.

Definition Ad_rows n g x : value (Ad (matrix_of n g) (matrix_of n x)). Proof. by_rows. Defined.
Definition Ad_star_rows n g p : value (Ad_star (matrix_of n g) (matrix_of n p)). Proof. by_rows. Defined.
Definition bracket_rows n x y : value (bracket (matrix_of n x) (matrix_of n y)). Proof. by_rows. Defined.
Definition ad_star_rows n x p : value (ad_star (matrix_of n x) (matrix_of n p)). Proof. by_rows. Defined.
Definition L_star_rows n g p : value (L_star (matrix_of n g) (matrix_of n p)). Proof. by_rows. Defined.
Definition R_star_rows n g p : value (R_star (matrix_of n g) (matrix_of n p)). Proof. by_rows. Defined.
Definition pairing_number n p v : number (pairing (matrix_of n p) (matrix_of n v)). Proof. by_rows. Defined.

(** ** Numbers drawn by a rule

The congruence \f$s\mapsto 1103515245\,s + 12345\f$ modulo \f$2^{31}\f$; a number from \f$-b\f$ to \f$b\f$ is
made of the upper half of each state. *)
Definition next_state (s : Z) : Z := Z.modulo (1103515245 * s + 12345) 2147483648.

Definition drawn (b : Z) (s : Z) : Z := Z.modulo (Z.div s 65536) (2 * b + 1) - b.

(** The numbers that follow a seed. *)
Definition integers_drawn (seed b : Z) (k : nat) : seq Z :=
  map (drawn b) (traject next_state (next_state seed) k).

(** Fractions with numerators from \f$-b\f$ to \f$b\f$ and denominators from 1 to \f$b\f$. *)
Definition fraction_drawn (b : Z) (s : Z) : Qc :=
  rational (drawn b s) (Z.to_pos (1 + Z.modulo (Z.div (next_state s) 65536) b)).

Definition fractions_drawn (seed b : Z) (k : nat) : seq Qc :=
  map (fraction_drawn b) (traject (iter 2 next_state) (next_state seed) k).

Definition row_by_row (m n : nat) (x : seq Qc) : rows :=
  tabulate m n (fun i j => nth Qc_zero x (i * n + j)%N).

(** Any matrix, a symmetric one and a skew one. *)
Definition sample m n (seed : Z) : rows := row_by_row m n (fractions_drawn seed 9 (m * n)).
Definition sample_symmetric n seed := rows_add n n (sample n n seed) (rows_transpose n n (sample n n seed)).
Definition sample_skew n seed :=
  rows_add n n (sample n n seed) (rows_opp n n (rows_transpose n n (sample n n seed))).

Lemma sample_symmetricP n seed : symmetric (matrix_of n (sample_symmetric n seed)).
Proof. by rewrite /symmetric matrix_of_add matrix_of_transpose raddfD /= trmxK addrC. Qed.

Lemma sample_skewP n seed : skew (matrix_of n (sample_skew n seed)).
Proof.
by rewrite /skew matrix_of_add matrix_of_opp matrix_of_transpose raddfB /= trmxK opprD opprK addrC.
Qed.

(** ** Rotations of space

The rotation of the quaternion \f$a + bi + cj + dk\f$ of integers, in closed form. *)
Section Quaternions.

Local Open Scope Z_scope.
Implicit Types a b c d : Z.

Definition norm a b c d := a * a + b * b + c * c + d * d.

Definition rotation_numerators a b c d :=
  [:: [:: a * a + b * b - c * c - d * d; 2 * (b * c - a * d); 2 * (b * d + a * c)];
      [:: 2 * (b * c + a * d); a * a - b * b + c * c - d * d; 2 * (c * d - a * b)];
      [:: 2 * (b * d - a * c); 2 * (c * d + a * b); a * a - b * b - c * c + d * d]].

Definition rotation a b c d : rows := rows_over (Z.to_pos (norm a b c d)) (rotation_numerators a b c d).

Lemma norm_positive a b c d : a <> 0 -> Zpos (Z.to_pos (norm a b c d)) = norm a b c d.
Proof.
move=> nonzero; apply: Z2Pos.id; rewrite /norm.
apply: Z.add_pos_nonneg (Z.square_nonneg _); apply: Z.add_pos_nonneg (Z.square_nonneg _).
apply: Z.add_pos_nonneg (Z.square_nonneg _).
by apply/Z.le_neq; split; [apply: Z.square_nonneg | move/esym/Z.mul_eq_0; case].
Qed.

Lemma Q2Qc_add (x y : Q) : Qcplus (Q2Qc x) (Q2Qc y) = Q2Qc (Qplus x y).
Proof. by apply/Q2Qc_eq_iff; apply: Qplus_comp; apply: Qred_correct. Qed.

Lemma Q2Qc_mul (x y : Q) : Qcmult (Q2Qc x) (Q2Qc y) = Q2Qc (Qmult x y).
Proof. by apply/Q2Qc_eq_iff; apply: Qmult_comp; apply: Qred_correct. Qed.

Lemma Q2Qc_opp (x : Q) : Qcopp (Q2Qc x) = Q2Qc (Qopp x).
Proof. by apply/Q2Qc_eq_iff; apply: Qopp_comp; apply: Qred_correct. Qed.

(** An equation between numbers computed from fractions, as one between integers. *)
Ltac to_integers :=
  lazy -[rational Qcplus Qcmult Qcopp Q2Qc Z.mul Z.add Z.sub Z.opp Pos.mul];
  rewrite /rational ?(Q2Qc_add, Q2Qc_mul, Q2Qc_opp); apply/Q2Qc_eq_iff;
  cbv [Qeq Qplus Qmult Qopp Qnum Qden]; rewrite ?Pos2Z.inj_mul.

Lemma rational_mul (x y : Z) (p r : positive) :
  (rational x p * rational y r)%R = rational (x * y) (p * r).
Proof. by to_integers; ring. Qed.

Lemma rational_times (x y : Z) : rational (x * y) 1 = (rational x 1 * rational y 1)%R.
Proof. by rewrite rational_mul. Qed.

Lemma over_integers m n p (t : seq (seq Z)) :
  matrix_of_rows m n (rows_over p t) = (rational 1 p *: matrix_of_rows m n (rows_over 1 t))%R.
Proof.
apply/matrixP => i j; rewrite !mxE /entry /rows_over.
have [i_t|i_t] := ltnP i (size t); last first.
  by rewrite !(nth_default [::]) ?size_map // !nth_nil mulr0.
rewrite !(nth_map [::]) //; have [j_t|j_t] := ltnP j (size (nth [::] t i)); last first.
  by rewrite !(nth_default Qc_zero) ?size_map // mulr0.
by rewrite !(nth_map 0) // rational_mul Z.mul_1_l Pos.mul_1_r.
Qed.

(** The matrix of numerators is a multiple of a rotation. *)
Lemma rotation_square a b c d (A := matrix_of 3 (rows_over 1 (rotation_numerators a b c d))) :
  A *m A^T = (rational (norm a b c d * norm a b c d) 1)%:M.
Proof.
rewrite /A -?computedE; apply/matrixP => -[[|[|[|//]]] ?] [[|[|[|//]]] ?]; rewrite -!matrix_of_entry.
all: by to_integers; rewrite /norm; ring.
Qed.

Lemma rotation_cube a b c d :
  \det (matrix_of 3 (rows_over 1 (rotation_numerators a b c d))) =
    rational (norm a b c d * norm a b c d * norm a b c d) 1.
Proof. by rewrite -?computedE; to_integers; rewrite /norm; ring. Qed.

Lemma rational_self (z : Z) p : Zpos p = z -> (rational 1 p * rational z 1 = 1)%R.
Proof. by move=> <-; rewrite rational_mul; to_integers; ring. Qed.

Lemma rotation_orthogonal a b c d : a <> 0 -> orthogonal (matrix_of 3 (rotation a b c d)).
Proof.
move/(norm_positive b c d)/rational_self; rewrite /orthogonal /rotation over_integers.
set u := rational 1 _ => u_norm.
rewrite linearZ /= -scalemxAl -scalemxAr scalerA rotation_square scale_scalar_mx.
by rewrite rational_times mulrACA u_norm mulr1.
Qed.

Lemma rotation_det a b c d : a <> 0 -> \det (matrix_of 3 (rotation a b c d)) = 1%R.
Proof.
move/(norm_positive b c d)/rational_self; rewrite /rotation over_integers.
set u := rational 1 _ => u_norm.
by rewrite detZ rotation_cube rational_times rational_times -expr2 -exprSr -exprMn u_norm expr1n.
Qed.

(** An odd number is not zero, so that the quaternion drawn has a rotation. *)
Definition sample_rotation seed : rows :=
  let x := nth 0 (integers_drawn seed 4 4) in rotation (2 * x 0%N + 1) (x 1%N) (x 2%N) (x 3%N).

Lemma sample_rotationP seed :
  orthogonal (matrix_of 3 (sample_rotation seed)) /\ \det (matrix_of 3 (sample_rotation seed)) = 1%R.
Proof.
have odd (x : Z) : 2 * x + 1 <> 0 by case: x.
by split; [exact: rotation_orthogonal | exact: rotation_det].
Qed.

End Quaternions.

(** ** Rotations of any dimension

Cayley's transform \f$(1 - A)^{-1}(1 + A)\f$ of a skew matrix \f$A\f$. *)
Definition cayley n (a : rows) : rows :=
  let e := rows_scalar n Qc_one in
  rows_mul n n n (rows_inverse n (rows_add n n e (rows_opp n n a))) (rows_add n n e a).

Lemma cayley_orthogonal n a :
  skew (matrix_of n a) -> 1%:M - matrix_of n a \in unitmx -> orthogonal (matrix_of n (cayley n a)).
Proof.
rewrite /skew /orthogonal; set A := matrix_of n a => skew_A unit.
have -> : matrix_of n (cayley n a) = invmx (1%:M - A) *m (1%:M + A).
  by rewrite matrix_of_mul matrix_of_inverse !matrix_of_add matrix_of_opp !matrix_of_scalar.
have plus_tr : (1%:M + A)^T = 1%:M - A by rewrite raddfD /= trmx1 skew_A.
have minus_tr : (1%:M - A)^T = 1%:M + A by rewrite -plus_tr trmxK.
have unit_plus : 1%:M + A \in unitmx by rewrite -unitmx_tr plus_tr.
have commute : (1%:M - A) *m (1%:M + A) = (1%:M + A) *m (1%:M - A).
  by rewrite mulmxBl mulmxBr !mulmxDl !mulmxDr !mul1mx !mulmx1.
rewrite trmx_mul trmx_inv plus_tr minus_tr -mulmxA (mulmxA _ _ (invmx _)) -commute.
by rewrite -(mulmxA _ _ (invmx _)) mulmxV // mulmx1 mulVmx.
Qed.

(** A rational matrix with \f$aa^T = 0\f$ is zero: sums of squares vanish only where all squares do. *)
Lemma Qc_opp_zero : Qcopp Qc_zero = Qc_zero. Proof. exact: oppr0. Qed.

Lemma square_nonneg (x : Qc) : Qcle Qc_zero (x * x)%R.
Proof.
have product (y : Qc) : Qcle Qc_zero y -> Qcle Qc_zero (y * y)%R.
  by move=> y_nonneg; have := Qcmult_le_compat_r _ _ _ y_nonneg y_nonneg; rewrite Qcmult_0_l.
have [x_neg|/product//] := Qclt_le_dec x Qc_zero.
rewrite -mulrNN; apply: product; rewrite -Qc_opp_zero.
exact/Qcopp_le_compat/Qclt_le_weak.
Qed.

Lemma sum_nonneg (I : finType) (P : pred I) (f : I -> Qc) :
  (forall i, Qcle Qc_zero (f i)) -> Qcle Qc_zero (\sum_(i | P i) f i)%R.
Proof.
move=> f_nonneg; apply: (big_ind (Qcle Qc_zero)) => // x y x_nonneg y_nonneg.
by rewrite -[Qc_zero](addr0 (0 : Qc)); apply: Qcplus_le_compat.
Qed.

Lemma gram_zero m n (a : 'M[Qc]_(m, n)) : a *m a^T = 0 -> a = 0.
Proof.
move/matrixP=> zero; apply/matrixP => i j; have := zero i i.
rewrite !mxE (bigD1 j) //= mxE => /eqP; rewrite addr_eq0 => /eqP square.
have : Qcle (a i j * a i j)%R Qc_zero.
  rewrite square -Qc_opp_zero; apply: Qcopp_le_compat; apply: sum_nonneg => k.
  by rewrite mxE; apply: square_nonneg.
move=> nonpos; have := Qcle_antisym _ _ nonpos (@square_nonneg (a i j)).
by move/eqP; rewrite mulf_eq0 orbb => /eqP.
Qed.

(** For a skew \f$A\f$ the matrix \f$1 - A\f$ is always invertible. *)
Lemma cayley_defined n (A : 'M[Qc]_n) : skew A -> 1%:M - A \in unitmx.
Proof.
move=> skew_A; rewrite -row_free_unit -kermx_eq0; apply/eqP/gram_zero.
set K := kermx _; have fixed : K = K *m A.
  by apply/eqP; rewrite -subr_eq0 -[X in X - _]mulmx1 -mulmxBr mulmx_ker.
have minus : K *m K^T = - (K *m K^T).
  by rewrite {1}[in K^T]fixed trmx_mul skew_A mulNmx mulmxN mulmxA -fixed.
have two : (2%:R : Qc) != 0 by [].
apply: (scalerI two); rewrite scaler0 scaler_nat mulr2n {1}minus; exact: addNr.
Qed.

Definition sample_rotation_of n seed : rows := cayley n (sample_skew n seed).

Lemma sample_rotation_ofP n seed : orthogonal (matrix_of n (sample_rotation_of n seed)).
Proof. by apply: cayley_orthogonal; [|apply: cayley_defined]; apply: sample_skewP. Qed.

(** ** Invertible matrices with their inverses

A _shear_ adds to the row \f$i\f$ the multiple by \f$c\f$ of the row \f$j\f$; with \f$-c\f$ it is undone. The
inverse of a product of shears are the shears undone in the opposite order. *)
Definition shear n (t : nat * nat * Qc) : rows :=
  let: (i, j, c) := t in
  tabulate n n (fun k l => if k == l then Qc_one else if (k == i) && (l == j) then c else Qc_zero).

Definition undone (t : nat * nat * Qc) := let: (i, j, c) := t in (i, j, Qcopp c).

Definition proper (t : nat * nat * Qc) := let: (i, j, _) := t in i != j.

Definition shears n (l : seq (nat * nat * Qc)) : rows :=
  foldr (fun t a => rows_mul n n n (shear n t) a) (rows_scalar n Qc_one) l.

Definition shears_undone n l : rows := shears n (rev (map undone l)).

Lemma shear_undone n t : proper t -> matrix_of n (shear n t) *m matrix_of n (shear n (undone t)) = 1%:M.
Proof.
case: t => [[i j] c] /= i_j; rewrite !matrix_of_tabulate.
pose N d : 'M[Qc]_n := \matrix_(k, l) if (val k == i) && (val l == j) then d else 0.
have shearE d : \matrix_(k < n, l < n)
    (if k == l :> nat then Qc_one else if (k == i :> nat) && (l == j :> nat) then d else Qc_zero) =
    1%:M + N d.
  apply/matrixP => k l; rewrite !mxE -val_eqE /=.
  have [->|_] := altP (val k =P val l); last by rewrite add0r.
  by have [->|_] := altP (val l =P i); rewrite ?(negbTE i_j) addr0.
have N_N d e : N d *m N e = 0.
  apply/matrixP => k l; rewrite !mxE big1 // => m _; rewrite !mxE.
  have [->|_] := altP (val m =P i); first by rewrite (negbTE i_j) andbF mul0r.
  by rewrite mulr0.
have N_opp : N (- c) = - N c by apply/matrixP => k l; rewrite !mxE; case: ifP; rewrite ?oppr0.
by rewrite !shearE N_opp mulmxDl mul1mx mulmxDr mulmx1 mulmxN N_N oppr0 addr0 addrNK.
Qed.

Lemma shears_cat n l m :
  matrix_of n (shears n (l ++ m)) = matrix_of n (shears n l) *m matrix_of n (shears n m).
Proof.
elim: l => [|t l IH]; first by rewrite /= matrix_of_scalar mul1mx.
by rewrite /= !matrix_of_mul IH mulmxA.
Qed.

Lemma shears_inverse n l :
  all proper l -> matrix_of n (shears n l) *m matrix_of n (shears_undone n l) = 1%:M.
Proof.
rewrite /shears_undone; elim: l => [|t l IH] /=; first by rewrite !matrix_of_scalar mul1mx.
case/andP=> t_proper /IH inverse; rewrite rev_cons -cats1 shears_cat matrix_of_mul -mulmxA.
rewrite (mulmxA _ _ (matrix_of n (shears n [:: _]))) inverse mul1mx /= matrix_of_mul matrix_of_scalar mulmx1.
exact: shear_undone.
Qed.

(** All pairs of different indices, with a fraction drawn for each. *)
Definition sample_shears n seed : seq (nat * nat * Qc) :=
  let pairs := [seq t <- allpairs pair (iota 0 n) (iota 0 n) | t.1 != t.2] in
  zip pairs [seq fraction_drawn 3 s | s <- traject (iter 2 next_state) (next_state seed) (size pairs)].

Definition sample_invertible n seed : rows := shears n (sample_shears n seed).
Definition sample_inverse n seed : rows := shears_undone n (sample_shears n seed).

Lemma sample_shears_proper n seed : all proper (sample_shears n seed).
Proof.
rewrite /sample_shears; set pairs := filter _ _; set fractions := map _ _.
have := filter_all (fun t : nat * nat => t.1 != t.2) (allpairs pair (iota 0 n) (iota 0 n)).
rewrite -/pairs; elim: pairs fractions => [|[i j] l IH] [|c m] //=.
by case/andP=> -> l_proper; exact: IH.
Qed.

Lemma sample_inverseP n seed :
  invmx (matrix_of n (sample_invertible n seed)) = matrix_of n (sample_inverse n seed).
Proof.
have product := shears_inverse n (sample_shears_proper n seed).
have [unit _] := mulmx1_unit product.
by rewrite -[LHS]mulmx1 -[1%:M]product mulmxA mulVmx // mul1mx.
Qed.

(** ** Writing

Numerators and denominators, in rows, and a line of text for each matrix: its name, its numbers of rows and
columns and its entries, row by row, as `-4/5` or `3`, with spaces between. *)
Definition fractions m n (a : rows) : seq (seq (Z * Z)) :=
  [seq [seq (numerator (entry a i j), Zpos (denominator (entry a i j))) | j <- iota 0 n] | i <- iota 0 m].

Definition text_of_integer (z : Z) : string := NilZero.string_of_int (Z.to_int z).

Definition text_of_number (x : Qc) : string :=
  let num := text_of_integer (numerator x) in
  if denominator x is xH then num
  else String.append num (String.append "/" (text_of_integer (Zpos (denominator x)))).

Definition words (l : seq string) : string := String.concat " " l.
Definition lines (l : seq string) : string := String.concat (String (Ascii.ascii_of_nat 10) EmptyString) l.

Definition matrix_line (name : string) m n (a : rows) : string :=
  words [:: name, text_of_integer (Z.of_nat m), text_of_integer (Z.of_nat n)
          & [seq text_of_number (entry a i j) | i <- iota 0 m, j <- iota 0 n]].

Definition number_line (name : string) (x : Qc) : string :=
  words [:: name; "1"; "1"; text_of_number x]%string.
