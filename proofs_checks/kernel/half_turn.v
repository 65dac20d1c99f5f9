(** * The step as a half turn

The scheme of Moser and Veselov for \f$n=3\f$, in quaternions: one step is a half turn about a null vector,
and what determines the null vector is the same in all steps. This page proves the algebra of \ref ch05a;
the letters are those of that page. It goes beyond the thesis. A quaternion is a number \f$q_0\f$ and a
vector \f$q\f$; vectors have three components in any commutative ring, and the theorems say which numbers
need an inverse. *)

From Coq Require Import Ring.
From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices slopes rigid_body body_multipliers moser_veselov body_integrals
  body_casimirs.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

Section HalfTurn.

Variable R : comUnitRingType.

Add Ring laws_for_half_turns : (laws_of_a_ring R).

(** ** Vectors and matrices of size three *)

Record vector := Vector { x1 : R; x2 : R; x3 : R }.

Implicit Types c D delta p q u v y l : vector.
Implicit Types a K kappa s : R.

Definition dot u v := x1 u * x1 v + x2 u * x2 v + x3 u * x3 v.
Definition cross u v :=
  Vector (x2 u * x3 v - x3 u * x2 v) (x3 u * x1 v - x1 u * x3 v) (x1 u * x2 v - x2 u * x1 v).
Definition plus u v := Vector (x1 u + x1 v) (x2 u + x2 v) (x3 u + x3 v).
Definition minus u v := Vector (x1 u - x1 v) (x2 u - x2 v) (x3 u - x3 v).
Definition multiple a u := Vector (a * x1 u) (a * x2 u) (a * x3 u).

(** The diagonal matrix with the entries of \f$c\f$, applied to \f$u\f$; the vector \f$(a, a, a)\f$. *)
Definition entrywise c u := Vector (x1 c * x1 u) (x2 c * x2 u) (x3 c * x3 u).
Definition constant a := Vector a a a.

Lemma same_components u v : x1 u = x1 v -> x2 u = x2 v -> x3 u = x3 v -> u = v.
Proof. by case: u => ? ? ?; case: v => ? ? ? /= -> -> ->. Qed.

Ltac open_vectors := rewrite /dot /cross /plus /minus /multiple /entrywise /constant /=.
Ltac calculate := open_vectors; calculate_in R.
Ltac by_components := apply: same_components; open_vectors; calculate_in R.

(** A matrix of size three, given by its rows. *)
Definition table (f : nat -> nat -> R) : 'M[R]_3 := \matrix_(i < 3, j < 3) f i j.
Definition of_rows (rows : seq (seq R)) := table (fun i j => nth 0 (nth [::] rows i) j).

(** The skew matrix of a vector, \f$\hatmap p\,u = p\times u\f$, and the diagonal matrix of one. *)
Definition hat p := of_rows [:: [:: 0; - x3 p; x2 p]; [:: x3 p; 0; - x1 p]; [:: - x2 p; x1 p; 0]].
Definition diagonal l := of_rows [:: [:: x1 l; 0; 0]; [:: 0; x2 l; 0]; [:: 0; 0; x3 l]].

Section Tables.

Variables f g : nat -> nat -> R.

Lemma table_product :
  table f *m table g = table (fun i j => f i 0%N * g 0%N j + (f i 1%N * g 1%N j + f i 2%N * g 2%N j)).
Proof. by apply/matrixP => i j; rewrite !mxE !big_ord_recl big_ord0 !mxE addr0. Qed.
Lemma table_sum : table f + table g = table (fun i j => f i j + g i j).
Proof. by apply/matrixP => i j; rewrite !mxE. Qed.
Lemma table_opposite : - table f = table (fun i j => - f i j).
Proof. by apply/matrixP => i j; rewrite !mxE. Qed.
Lemma table_multiple a : a *: table f = table (fun i j => a * f i j).
Proof. by apply/matrixP => i j; rewrite !mxE. Qed.
Lemma table_transpose : (table f)^T = table (fun i j => f j i).
Proof. by apply/matrixP => i j; rewrite !mxE. Qed.
Lemma table_trace : \tr (table f) = f 0%N 0%N + (f 1%N 1%N + f 2%N 2%N).
Proof. by rewrite /mxtrace !big_ord_recl big_ord0 !mxE addr0. Qed.
Lemma table_equal : (forall i j, (i < 3)%N -> (j < 3)%N -> f i j = g i j) -> table f = table g.
Proof. by move=> same; apply/matrixP => i j; rewrite !mxE same. Qed.

End Tables.

Ltac by_entries :=
  rewrite /hat /diagonal /of_rows;
  rewrite ?(table_product, table_sum, table_opposite, table_multiple, table_transpose);
  apply: table_equal => -[|[|[|//]]] [|[|[|//]]] _ _ /=; calculate_in R.

(** The rotation of a quaternion, \f$1 + 2q_0\hatmap q + 2\hatmap q^2\f$. *)
Definition rotation_of (q0 : R) q : 'M[R]_3 := 1%:M + 2%:R * q0 *: hat q + 2%:R *: (hat q *m hat q).

(** The principal moments of the body with \f$\Lambda = \mathrm{diag}(l)\f$: \f$I_1 = l_2+l_3\f$ and so on. *)
Definition moments l := Vector (x2 l + x3 l) (x3 l + x1 l) (x1 l + x2 l).

Lemma hat_squared q : hat q *m hat q = of_rows
  [:: [:: x1 q * x1 q - dot q q; x1 q * x2 q; x1 q * x3 q];
      [:: x1 q * x2 q; x2 q * x2 q - dot q q; x2 q * x3 q];
      [:: x1 q * x3 q; x2 q * x3 q; x3 q * x3 q - dot q q]].
Proof. by rewrite /dot; by_entries. Qed.

Lemma hat_cubed q : hat q *m hat q *m hat q = - dot q q *: hat q.
Proof. by rewrite hat_squared; move: (dot q q) => ?; by_entries. Qed.

Lemma hat_skew q : (hat q)^T = - hat q.
Proof. by by_entries. Qed.

Lemma hat_plus u v : hat (plus u v) = hat u + hat v.
Proof. by by_entries. Qed.

Lemma hat_multiple a u : hat (multiple a u) = a *: hat u.
Proof. by by_entries. Qed.

Lemma hat_inertia q l : hat q *m diagonal l + diagonal l *m hat q = hat (entrywise (moments l) q).
Proof. by by_entries. Qed.

Lemma hat_squared_bracket q l :
  hat q *m hat q *m diagonal l - diagonal l *m hat q *m hat q = hat (cross q (entrywise (moments l) q)).
Proof. by rewrite -[diagonal l *m _ *m _]mulmxA hat_squared; move: (dot q q) => ?; by_entries. Qed.

(** The matrix of a quaternion of length 1 is orthogonal. *)
Theorem rotation_of_a_quaternion (q0 : R) q : q0 ^+ 2 + dot q q = 1 -> orthogonal (rotation_of q0 q).
Proof.
move=> unit; rewrite /orthogonal /rotation_of; have := hat_cubed q; have := hat_skew q.
have -> : dot q q = 1 - q0 ^+ 2 by rewrite -unit; calculate_in R.
move: (hat q) => Q Q_skew cube.
rewrite !transpose_add !transpose_scale trmx1 trmx_mul Q_skew mulNmx mulmxN opprK.
rewrite !(mulmxDl, mulmxDr) !(mul1mx, mulmx1) -?scalemxAr -?scalemxAl -?scalemxAr !mulmxN !mulmxA cube.
by rewrite -!scalemxAl ?mulmxN; compare_entries_in R.
Qed.

(** ** The momenta of a step

Let \f$f^{-1}\f$ be the rotation of the quaternion \f$(q_0, q)\f$, and \f$y = Iq\f$. Then the momenta before
and after the step are \f$2p\f$ and \f$2p'\f$ with \f$p = q_0y + q\times y\f$ and
\f$p' = q_0y - q\times y\f$. The length of the quaternion is not used. *)
Theorem half_turn_momenta (q0 : R) q l (y := entrywise (moments l) q) (f := (rotation_of q0 q)^T) :
  momentum_before f (diagonal l) = hat (multiple 2%:R (plus (multiple q0 y) (cross q y))) /\
  momentum_after f (diagonal l) = hat (multiple 2%:R (minus (multiple q0 y) (cross q y))).
Proof.
have -> : minus (multiple q0 y) (cross q y) = plus (multiple q0 y) (multiple (-1) (cross q y)).
  by by_components.
rewrite !(hat_multiple, hat_plus) /y -hat_inertia -hat_squared_bracket.
rewrite /momentum_before /momentum_after /f !trmxK /rotation_of !transpose_add !transpose_scale trmx1.
rewrite trmx_mul hat_skew mulNmx mulmxN opprK; move: (hat q) (diagonal l) => Q L.
rewrite !(mulmxDl, mulmxDr) !(mul1mx, mulmx1) -?scalemxAr -?scalemxAl !(mulmxN, mulNmx) !mulmxA.
by split; compare_entries_in R.
Qed.

(** The number \f$K = \langle q, y\rangle\f$ is half of \f$\mathrm{Tr}\Lambda - \mathrm{Tr}(f\Lambda)\f$: a
value of the discrete Lagrangian. *)
Theorem half_turn_lagrangian (q0 : R) q l :
  reduced_lagrangian (diagonal l) (rotation_of q0 q)^T =
  \tr (diagonal l) - 2%:R * dot q (entrywise (moments l) q).
Proof.
rewrite /reduced_lagrangian /rotation_of hat_squared !transpose_add !transpose_scale trmx1.
rewrite !mulmxDl mul1mx -!scalemxAl !mxtraceD !mxtraceZ /hat /diagonal /of_rows.
by rewrite !(table_transpose, table_product) !table_trace /=; calculate.
Qed.

Lemma length_identity a q y :
  (a ^+ 2 + dot q q) * dot y y =
  dot (plus (multiple a y) (cross q y)) (plus (multiple a y) (cross q y)) + dot q y ^+ 2.
Proof. by calculate. Qed.

(** ** The half turn

From here on the moments enter by their reciprocals: \f$q = cy\f$, that is \f$q_i = c_iy_i\f$. The vector
\f$p'\f$ is the image of \f$p\f$ under the half turn about \f$y\f$,
\f$p' = 2\frac{\langle p,y\rangle}{\langle y,y\rangle}y - p\f$. The length of the momentum and its energy
\f$\sum c_ip_i^2\f$ are conserved, whatever the length of the quaternion. *)

Section OneStep.

Variables (q0 : R) (c y : vector).
Let q := entrywise c y.
Let p := plus (multiple q0 y) (cross q y).
Let p' := minus (multiple q0 y) (cross q y).
Let K := dot q y.

Theorem half_turn_image : dot y y \is a GRing.unit -> p' = minus (multiple (2%:R * dot p y / dot y y) y) p.
Proof.
move=> unit; have -> : 2%:R * dot p y / dot y y = 2%:R * q0.
  by apply: (mulIr unit); rewrite divrK // /p /q; calculate.
by rewrite /p /p'; by_components.
Qed.

Theorem half_turn_conserved : dot p' p' = dot p p /\ dot p' (entrywise c p') = dot p (entrywise c p).
Proof. by rewrite /p /p' /q; split; calculate. Qed.

(** ** The null vector

Let the quaternion have length 1, and put \f$D_i = (|p|^2+K^2)\,c_i - K\f$. Then \f$|y|^2 = |p|^2+K^2\f$,
and \f$y\f$ is a null vector of both \f$D+\hatmap p\f$ and \f$D-\hatmap{p'}\f$. The quaternion is given back
by \f$|y|^2q_0 = \langle p,y\rangle\f$ and \f$|y|^2q_i = (D_i+K)\,y_i\f$. *)
Hypothesis length_1 : q0 ^+ 2 + dot q q = 1.

Theorem half_turn_length : dot y y = dot p p + K ^+ 2.
Proof. by rewrite -[LHS]mul1r -length_1 length_identity. Qed.

Let D := minus (multiple (dot p p + K ^+ 2) c) (constant K).

Theorem half_turn_null_vector :
  plus (entrywise D y) (cross p y) = constant 0 /\ minus (entrywise D y) (cross p' y) = constant 0.
Proof. by rewrite /D -half_turn_length /p /p' /K /q; split; by_components. Qed.

Theorem half_turn_quaternion :
  dot y y * q0 = dot p y /\ multiple (dot y y) q = entrywise (plus D (constant K)) y.
Proof.
rewrite /D -half_turn_length /p /q; split; first by calculate.
by by_components.
Qed.

End OneStep.

(** ** Every null vector makes a step

Conversely, let \f$y\f$ with \f$|y|^2 = N = |p|^2+K^2\f$ be a null vector of \f$D+\hatmap p\f$, where
\f$D_i = N c_i - K\f$ and \f$N\f$ has an inverse. Then \f$q = cy\f$ and \f$q_0 = \langle p,y\rangle/N\f$ is
a quaternion of length 1, its step begins with \f$p\f$, and \f$K = \langle q,y\rangle\f$. *)
Theorem half_turn_solution c p y K (N := dot p p + K ^+ 2) (D := minus (multiple N c) (constant K))
    (q := entrywise c y) (q0 := dot p y / N) :
  N \is a GRing.unit -> dot y y = N -> plus (entrywise D y) (cross p y) = constant 0 ->
  [/\ dot q y = K, plus (multiple q0 y) (cross q y) = p & q0 ^+ 2 + dot q q = 1].
Proof.
move=> unit y_N null.
have is_K : dot q y = K.
  apply: (mulrI unit); apply/eqP; rewrite -subr_eq0 -{2}y_N; apply/eqP.
  transitivity (dot y (plus (entrywise D y) (cross p y))); first by rewrite /D /q; calculate.
  by rewrite null; calculate.
have cross_product : cross p y = minus (multiple K y) (multiple N q).
  have -> : cross p y = minus (plus (entrywise D y) (cross p y)) (entrywise D y) by by_components.
  by rewrite null /D /q; by_components.
have is_p : multiple N p = multiple N (plus (multiple q0 y) (cross q y)).
  rewrite /q0; transitivity (plus (multiple (dot p y) y) (cross y (cross p y))).
    by rewrite -y_N; by_components.
  by rewrite cross_product -[dot p y in LHS](divrK unit); by_components.
have p_is : plus (multiple q0 y) (cross q y) = p.
  by case: is_p => /(mulrI unit) ? /(mulrI unit) ? /(mulrI unit) ?; apply: same_components.
by split=> //; apply: (mulIr unit); rewrite mul1r -{1}y_N length_identity p_is is_K.
Qed.

(** ** Half turns of other bodies

Three numbers \f$\delta_i\f$, a unit vector \f$u\f$ and a null vector \f$y\f$ of
\f$\mathrm{diag}(\delta)+\hatmap u\f$ make a step of the scheme for every \f$\kappa\f$, that of a body with
the reciprocal moments \f$\tilde j_i = (\delta_i+\kappa)/(1+\kappa^2)\f$. So a half turn with suitable
\f$\delta\f$ and \f$\kappa\f$, the exact motion among them, is a step of Moser and Veselov with modified
moments. *)
Theorem half_turn_of_another_body delta u y kappa (N := 1 + kappa ^+ 2)
    (j := multiple N^-1 (plus delta (constant kappa))) (q := entrywise j y) (q0 := dot u y / N) :
  N \is a GRing.unit -> dot u u = 1 -> dot y y = N -> plus (entrywise delta y) (cross u y) = constant 0 ->
  [/\ dot q y = kappa, plus (multiple q0 y) (cross q y) = u & q0 ^+ 2 + dot q q = 1].
Proof.
move=> unit u_1 y_N null; have := @half_turn_solution j u y kappa; rewrite u_1 -/N; apply=> //.
rewrite -null; congr (plus (entrywise _ y) _); rewrite /j.
by apply: same_components; open_vectors; rewrite mulVKr // addrK.
Qed.

(** The determinant of \f$D+\hatmap p\f$, \f$D_1D_2D_3 + D_1p_1^2 + D_2p_2^2 + D_3p_3^2\f$. *)
Definition determinant D p := x1 D * x2 D * x3 D + dot p (entrywise D p).

Lemma determinant_of_rows a11 a12 a13 a21 a22 a23 a31 a32 a33 :
  \det (of_rows [:: [:: a11; a12; a13]; [:: a21; a22; a23]; [:: a31; a32; a33]]) =
  a11 * (a22 * a33 - a23 * a32) - a12 * (a21 * a33 - a23 * a31) + a13 * (a21 * a32 - a22 * a31).
Proof.
rewrite (expand_det_row _ ord0) !big_ord_recl big_ord0 /cofactor !(expand_det_row _ ord0).
by rewrite !big_ord_recl !big_ord0 /cofactor !det_mx11 !mxE /=; calculate_in R.
Qed.

Theorem half_turn_determinant D p : \det (diagonal D + hat p) = determinant D p.
Proof.
have -> : diagonal D + hat p =
  of_rows [:: [:: x1 D; - x3 p; x2 p]; [:: x3 p; x2 D; - x1 p]; [:: - x2 p; x1 p; x3 D]] by by_entries.
by rewrite determinant_of_rows /determinant; calculate.
Qed.

(** ** What every half turn about a null vector conserves

Let \f$D\f$ be any three numbers and \f$y\f$ a null vector of \f$D+\hatmap p\f$. The vector
\f$p' = ay - p\f$ has \f$\sum D_ip_i'^2 = \sum D_ip_i^2\f$, for every \f$a\f$: so the condition for a null
vector, \f$\det(D+\hatmap p) = 0\f$, holds for \f$p'\f$ again. If the \f$D_i = \alpha c_i+\beta\f$ come from
the moments and \f$p'\f$ is as long as \f$p\f$, the energy is conserved. *)
Theorem half_turn_quadratic_form D p y a (p' := minus (multiple a y) p) :
  plus (entrywise D y) (cross p y) = constant 0 ->
  dot p' (entrywise D p') = dot p (entrywise D p) /\ determinant D p' = determinant D p.
Proof.
move=> null; suff kept : dot p' (entrywise D p') = dot p (entrywise D p) by rewrite /determinant kept.
have orthogonal_to u : dot u (plus (entrywise D y) (cross p y)) = 0 by rewrite null; calculate.
have along_y : dot y (entrywise D y) = 0 by rewrite -(orthogonal_to y); calculate.
have along_p : dot p (entrywise D y) = 0 by rewrite -(orthogonal_to p); calculate.
transitivity (a ^+ 2 * dot y (entrywise D y) - 2%:R * a * dot p (entrywise D y) + dot p (entrywise D p)).
  by rewrite /p'; calculate.
by rewrite along_y along_p !mulr0 subrr add0r.
Qed.

Theorem half_turn_energy c p y a alpha beta (D := plus (multiple alpha c) (constant beta))
    (p' := minus (multiple a y) p) :
  alpha \is a GRing.unit -> plus (entrywise D y) (cross p y) = constant 0 -> dot p' p' = dot p p ->
  dot p' (entrywise c p') = dot p (entrywise c p).
Proof.
move=> unit null length; have [kept _] := half_turn_quadratic_form a null.
have in_two u : dot u (entrywise D u) = alpha * dot u (entrywise c u) + beta * dot u u.
  by rewrite /D; calculate.
by move: kept; rewrite -/p' !in_two length => /addIr /(mulrI unit).
Qed.

(** ** The axis in closed form

For a unit vector \f$u\f$ the vector \f$v_i = (1+\delta_j\delta_k)\,u_i + (\delta_k-\delta_j)\,u_ju_k\f$,
\f$(i,j,k)\f$ cyclic, has
\f$(\mathrm{diag}(\delta)+\hatmap u)\,v = \det(\mathrm{diag}(\delta)+\hatmap u)\,u\f$: where the determinant
vanishes, it is a null vector.
C++: `actio::HalfTurn::axis`, `fast_body/space/half_turn.hpp`. *)
Definition axis delta u :=
  Vector ((1 + x2 delta * x3 delta) * x1 u + (x3 delta - x2 delta) * (x2 u * x3 u))
         ((1 + x3 delta * x1 delta) * x2 u + (x1 delta - x3 delta) * (x3 u * x1 u))
         ((1 + x1 delta * x2 delta) * x3 u + (x2 delta - x1 delta) * (x1 u * x2 u)).

Theorem half_turn_axis delta u :
  dot u u = 1 ->
  plus (entrywise delta (axis delta u)) (cross u (axis delta u)) = multiple (determinant delta u) u.
Proof. by move=> length_1; rewrite /axis -length_1 /determinant; by_components. Qed.

(** The residual of the equation for the twist,
\f$e_3(1+\kappa^2)^2 - e_2\kappa(1+\kappa^2) + e_1\kappa^2 - \kappa + r\f$, with the elementary symmetric
functions of \f$j_1, j_2, j_3\f$.
C++: `actio::TwistEquation::residual`, `fast_body/space/explicit_moser_veselov.hpp`. *)
Definition twist_residual j kappa (r : R) :=
  let sum := 1 + kappa ^+ 2 in
  x1 j * x2 j * x3 j * sum ^+ 2 - (x1 j * x2 j + x2 j * x3 j + x3 j * x1 j) * kappa * sum
  + (x1 j + x2 j + x3 j) * kappa ^+ 2 - kappa + r.

(** ** The constant of the motion

Let \f$p = su\f$ with \f$|u| = 1\f$ and a number \f$s\f$ that has an inverse, \f$j_i = sc_i\f$, and
\f$K = s\kappa\f$. Then \f$\kappa\f$ satisfies an equation of the fourth degree, of which the coefficients
are made of \f$s\f$, of the moments and of the energy \f$r = \sum j_iu_i^2\f$. All of these are constants of
the motion; so \f$\kappa\f$ is among the same four numbers in all steps. *)
Theorem half_turn_twist (q0 : R) c y s u kappa (q := entrywise c y) (j := multiple s c) :
  q0 ^+ 2 + dot q q = 1 -> s \is a GRing.unit ->
  plus (multiple q0 y) (cross q y) = multiple s u -> dot u u = 1 -> dot q y = s * kappa ->
  twist_residual j kappa (dot u (entrywise j u)) = 0.
Proof.
move=> length_1 unit is_p u_1 is_K.
have squares : dot y y = s ^+ 2 * (1 + kappa ^+ 2).
  rewrite (half_turn_length length_1) -/q is_p is_K mulrDr mulr1 exprMn; congr (_ + _).
  by rewrite -[RHS]mulr1 -u_1; calculate.
have energies : s * dot u (entrywise j u) = q0 ^+ 2 * dot q y + dot (cross q y) (entrywise c (cross q y)).
  transitivity (dot (multiple s u) (entrywise c (multiple s u))); first by rewrite /j; calculate.
  by rewrite -is_p /q; calculate.
have scalar : q0 ^+ 2 = 1 - dot q q by rewrite -length_1; calculate_in R.
apply: (mulrI unit); rewrite mulr0 /twist_residual; cbv zeta; rewrite [LHS]mulrDr energies scalar.
transitivity (x1 c * x2 c * x3 c * dot y y ^+ 2
  - (x1 c * x2 c + x2 c * x3 c + x3 c * x1 c) * dot q y * dot y y
  + (x1 c + x2 c + x3 c) * dot q y ^+ 2 - dot q y
  + ((1 - dot q q) * dot q y + dot (cross q y) (entrywise c (cross q y)))).
  by rewrite squares is_K /j; calculate.
by rewrite /q; calculate.
Qed.

End HalfTurn.
