(** * Values of the definitions

What definitions of these pages give on rational matrices, written out: on two samples of each of the groups
\f$GL(2)\f$, \f$GL(3)\f$, \f$GL(4)\f$ and \f$SO(3)\f$ where a definition is about a group, and of the sizes 2,
3 and 4 where it is about a body. The library evaluates its functions on the same matrices and compares
fractions. A definition enters as it stands on its page: the rows that are computed come with a proof that
they are its rows. *)

From Coq Require Import ZArith QArith Qcanon String.
From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices groups groupoids rotations isospectral rigid_body body_multipliers
  moser_veselov body_integrals body_casimirs dual_numbers.
From actio Require Import computed samples.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope nat_scope.
Local Open Scope ring_scope.

(** ** A function to differentiate

The differential of a linear function is the same everywhere; a quadratic one tells the points apart. It is
\f$\ell(f) = \mathrm{Tr}(a^T\!f\,b\,f)\f$, with \f$\ell'(f) = a\,(bf)^T + (fb)^T a\f$; and on pairs
\f$\mathbb L(x, y) = \mathrm{Tr}(a^Tx\,b\,y)\f$. *)
Section Functions.

Variables (R : comUnitRingType) (n : nat).
Implicit Types a b f v g : 'M[R]_n.

Definition quadratic_function a b (x : 'M[dual R]_n) : dual R := pairing (still a) (x *m still b *m x).

Definition product_function a b (x y : 'M[dual R]_n) : dual R := pairing (still a) (x *m still b *m y).

Lemma pairing_left a v g : pairing a (v *m g) = pairing (a *m g^T) v.
Proof. by rewrite -/(right_translation g v) -R_star_dual. Qed.

Lemma pairing_right a v g : pairing a (g *m v) = pairing (g^T *m a) v.
Proof. by rewrite -/(left_translation g v) -L_star_dual. Qed.

Lemma quadratic_rate a b f v :
  rate (quadratic_function a b (varied f v)) = pairing (a *m (b *m f)^T + (f *m b)^T *m a) v.
Proof.
rewrite /quadratic_function !varied_mul pairing_varied /= pairing_0l addr0 mulmx0 add0r.
by rewrite pairing_addr pairing_addl pairing_right -mulmxA pairing_left addrC.
Qed.

Lemma quadratic_differential a b f :
  differential (quadratic_function a b) f = a *m (b *m f)^T + (f *m b)^T *m a.
Proof. by apply: differential_is => v; apply: quadratic_rate. Qed.

Lemma quadratic_differentiable a b f : differentiable (quadratic_function a b) f.
Proof. by apply: differentiable_is => v; apply: quadratic_rate. Qed.

Lemma product_first a b f g :
  differential (fun x => product_function a b x (still g)) f = a *m (b *m g)^T.
Proof.
apply: differential_is => v; rewrite /product_function !varied_mul pairing_varied /= pairing_0l addr0.
by rewrite !mulmx0 !add0r -mulmxA pairing_left.
Qed.

Lemma product_second a b f g :
  differential (fun x => product_function a b (still g) x) f = (g *m b)^T *m a.
Proof.
apply: differential_is => v; rewrite /product_function !varied_mul pairing_varied /= pairing_0l addr0.
by rewrite mulmx0 mul0mx addr0 mul0mx addr0 pairing_right.
Qed.

Lemma product_D1 a b f g : D1 (product_function a b) f g = R_star f (a *m (b *m g)^T).
Proof. by rewrite /D1 /first_differential product_first. Qed.

Lemma product_D2 a b f g : D2 (product_function a b) f g = R_star g ((f *m b)^T *m a).
Proof. by rewrite /D2 /second_differential product_second. Qed.

Lemma kirillov_kostant_value mu v w :
  kirillov_kostant_plus (@all_matrices R n) mu (ad_star v mu) (ad_star w mu) (pairing mu (bracket v w)).
Proof. by exists v, w. Qed.

End Functions.

(** ** The rows of each definition *)

(* The rows are left open first and the equation is rewritten: a rewriting of the claim as a whole would be
   part of what computes. *)
Ltac by_differential :=
  eexists; rewrite /right_differential /left_differential !quadratic_differential; to_rows; reflexivity.

(** The negative of what has rows, and a difference. *)
Lemma value_oppP m n (X : 'M[Qc]_(m, n)) (v : value X) : matrix_of_rows m n (rows_opp m n (rows_of v)) = - X.
Proof. by rewrite matrix_of_opp (svalP v). Qed.

Lemma value_subP m n (X Y : 'M[Qc]_(m, n)) (v : value X) (w : value Y) :
  matrix_of_rows m n (rows_add m n (rows_of v) (rows_opp m n (rows_of w))) = X - Y.
Proof. by rewrite matrix_of_add matrix_of_opp (svalP v) (svalP w). Qed.

Definition value_opp m n (X : 'M[Qc]_(m, n)) (v : value X) : value (- X) := exist _ _ (value_oppP v).
Definition value_sub m n (X Y : 'M[Qc]_(m, n)) (v : value X) (w : value Y) : value (X - Y) :=
  exist _ _ (value_subP v w).

Section Rows.

Variable n : nat.
Local Notation M := (matrix_of n).
Local Notation function a b := (quadratic_function (M a) (M b)).
Local Notation pair_function a b := (product_function (M a) (M b)).
Implicit Types a b c d f g mu v w x y : rows.

Definition skew_part_rows a : value (skew_part (M a)). Proof. by_rows. Defined.
Definition left_translation_rows g v : value (left_translation (M g) (M v)). Proof. by_rows. Defined.
Definition right_translation_rows g v : value (right_translation (M g) (M v)). Proof. by_rows. Defined.

Definition relative_motion_right_rows f g : value (relative_motion_right (M f) (M g)).
Proof. rewrite /relative_motion_right; by_rows. Defined.
Definition relative_motion_left_rows f g : value (relative_motion_left (M f) (M g)).
Proof. rewrite /relative_motion_left; by_rows. Defined.
Definition reconstruct_right_rows g f : value (reconstruct_right (M g) (M f)).
Proof. rewrite /reconstruct_right; by_rows. Defined.
Definition reconstruct_left_rows g f : value (reconstruct_left (M g) (M f)).
Proof. rewrite /reconstruct_left; by_rows. Defined.
Definition lie_poisson_update_right_rows f mu : value (lie_poisson_update_right (M f) (M mu)).
Proof. rewrite /lie_poisson_update_right; by_rows. Defined.
Definition lie_poisson_update_left_rows f mu : value (lie_poisson_update_left (M f) (M mu)).
Proof. rewrite /lie_poisson_update_left; by_rows. Defined.

Definition right_differential_rows a b f : value (right_differential (function a b) (M f)).
Proof. by_differential. Defined.
Definition left_differential_rows a b f : value (left_differential (function a b) (M f)).
Proof. by_differential. Defined.
Definition euler_poincare_right_rows a b f g : value (euler_poincare_right (function a b) (M f) (M g)) :=
  value_sub (right_differential_rows a b g) (left_differential_rows a b f).
Definition euler_poincare_left_rows a b f g : value (euler_poincare_left (function a b) (M f) (M g)) :=
  value_sub (left_differential_rows a b g) (right_differential_rows a b f).
Definition momentum_before_right_rows a b f : value (momentum_before_right (function a b) (M f)) :=
  value_opp (right_differential_rows a b f).
Definition momentum_before_left_rows a b f : value (momentum_before_left (function a b) (M f)) :=
  value_opp (left_differential_rows a b f).

Definition initial_momentum_left_rows a b g : value (initial_momentum_left (function a b) (M g)) :=
  value_opp (left_differential_rows a b g).
Definition final_momentum_left_rows g mu : value (final_momentum_left (M g) (M mu)).
Proof. rewrite /final_momentum_left; by_rows. Defined.

Definition D1_rows a b f g : value (D1 (pair_function a b) (M f) (M g)).
Proof. eexists; rewrite product_D1; to_rows; reflexivity. Defined.
Definition D2_rows a b f g : value (D2 (pair_function a b) (M f) (M g)).
Proof. eexists; rewrite product_D2; to_rows; reflexivity. Defined.
Definition discrete_euler_lagrange_rows a b f g x :
  value (groupoids.discrete_euler_lagrange (pair_function a b) (M f) (M g) (M x)).
Proof.
by eexists; rewrite /groupoids.discrete_euler_lagrange product_D1 product_D2; to_rows; reflexivity.
Defined.

Definition lie_poisson_bracket_plus_number a b c d mu :
  number (groups.lie_poisson_bracket_plus (function a b) (function c d) (M mu)).
Proof. rewrite /groups.lie_poisson_bracket_plus; by_differential. Defined.

(** The number that the form of Kirillov and Kostant has on \f$\mathrm{ad}^*_x\mu\f$ and
\f$\mathrm{ad}^*_y\mu\f$. *)
Definition kirillov_kostant_plus_number mu x y :
  {c : Qc | kirillov_kostant_plus (@all_matrices _ _) (M mu) (ad_star (M x) (M mu)) (ad_star (M y) (M mu)) c}.
Proof. by eexists; have := kirillov_kostant_value (M mu) (M x) (M y); to_rows; apply. Defined.

Definition legendre_at_target_number a b g v : number (legendre_at_target (function a b) (M g) (M v)).
Proof.
eexists; rewrite legendre_at_target_of_group; last exact: quadratic_differentiable.
by rewrite /left_differential quadratic_differential; to_rows; reflexivity.
Defined.
Definition legendre_at_source_number a b g v : number (legendre_at_source (function a b) (M g) (M v)).
Proof.
eexists; rewrite legendre_at_source_of_group; last exact: quadratic_differentiable.
by rewrite /right_differential quadratic_differential; to_rows; reflexivity.
Defined.

Definition inertia_operator_rows l x : value (inertia_operator (M l) (M x)).
Proof. rewrite /inertia_operator; by_rows. Defined.
Definition kinetic_energy_number l x : number (kinetic_energy (M l) (M x)).
Proof. rewrite /kinetic_energy /inertia_operator; by_rows. Defined.

Definition cayley_rows a : value (isospectral.cayley (M a)).
Proof. rewrite /isospectral.cayley; by_rows. Defined.
Definition casimir_number a : number (casimir 2 (M a)). Proof. rewrite /casimir /power /=; by_rows. Defined.

Definition momentum_before_rows f l : value (momentum_before (M f) (M l)).
Proof. rewrite /momentum_before; by_rows. Defined.
Definition momentum_after_rows f l : value (momentum_after (M f) (M l)).
Proof. rewrite /momentum_after; by_rows. Defined.
Definition orthogonality_rows g : value (orthogonality (M g)).
Proof. rewrite /orthogonality; by_rows. Defined.
Definition body_multiplier_rows g a : value (body_multiplier (M g) (M a)).
Proof. rewrite /body_multiplier; by_rows. Defined.
Definition trace_casimir_number l f : number (trace_casimir (M l) (M f)).
Proof. rewrite /trace_casimir; by_rows. Defined.

End Rows.

(** Vectors of space are columns. *)
Definition vector (x : rows) (i : 'I_3) : Qc := entry x i 0.

Definition hat_rows x : value (rotations.hat (vector x)).
Proof.
exists (tabulate 3 3 (fun i j => nth Qc_zero (nth [::]
  [:: [:: Qc_zero; - entry x 2 0; entry x 1 0]; [:: entry x 2 0; Qc_zero; - entry x 0 0];
      [:: - entry x 1 0; entry x 0 0; Qc_zero]] i) j)).
by apply/matrixP; apply: axes; apply: axes; rewrite !mxE /=.
Defined.

Definition cross_rows x y : value (\col_i rotations.cross (vector x) (vector y) i).
Proof.
exists (tabulate 3 1 (fun i _ => entry x ((i + 1) %% 3)%N 0 * entry y ((i + 2) %% 3)%N 0
  - entry x ((i + 2) %% 3)%N 0 * entry y ((i + 1) %% 3)%N 0)).
by apply/matrixP; apply: axes => j; rewrite !mxE ord1.
Defined.

(** ** Samples and lines

An argument of a definition: an element of the group, a matrix of its algebra or of the dual of the algebra,
any matrix, the positive diagonal matrix of an inertia, or a vector. The group is that of the invertible
matrices or that of the rotations. *)
Local Open Scope string_scope.

Inductive kind := In_group | In_algebra | Any | Inertia | Column.

Definition given : Type := nat * nat * rows.

Definition sample_of (rotations : bool) n (k : kind) (seed : Z) : given :=
  match k with
  | In_group => (n, n, if ~~ rotations then sample_invertible n seed
                       else if n == 3%N then sample_rotation seed else sample_rotation_of n seed)
  | In_algebra => (n, n, if rotations then sample_skew n seed else sample n n seed)
  | Any => (n, n, sample n n seed)
  | Inertia => (n, n, diagonal [seq Qcplus (rational 10 1) x | x <- fractions_drawn seed 9 n])
  | Column => (n, 1%N, sample n 1 seed)
  end.

(** A line for each argument and one for the value: definition, sample, `in1`, `in2` and so on or `out`, rows
and columns, entries. *)
Definition table_line (name case role : string) (t : given) : string :=
  let: (m, n, a) := t in matrix_line (words [:: name; case; role]) m n a.

Definition case_lines (name case : string) (arguments : seq given) (out : given) : seq string :=
  rcons [seq table_line name case (String.append "in" (text_of_integer (Z.of_nat k.+1))) (nth out arguments k)
        | k <- iota 0 (size arguments)] (table_line name case "out" out).

Definition case_name (rotations : bool) (n s : nat) : string :=
  String.append (if rotations then "SO" else "GL")
    (String.append (text_of_integer (Z.of_nat n)) (String.append "." (text_of_integer (Z.of_nat s)))).

Definition lines_of (rotations : bool) n name (kinds : seq kind) (f : seq rows -> given) : seq string :=
  flatten [seq
    let arguments := [seq sample_of rotations n (nth Any kinds k) (Z.of_nat (100 * s + 10 * n + k))
                     | k <- iota 0 (size kinds)] in
    case_lines name (case_name rotations n s) arguments (f [seq t.2 | t <- arguments]) | s <- [:: 1; 2]%N].

Definition on_invertible name kinds (f : nat -> seq rows -> given) : seq string :=
  flatten [seq lines_of false n name kinds (f n) | n <- [:: 2; 3; 4]%N].

Definition on_groups name kinds f :=
  (on_invertible name kinds f ++ lines_of true 3 name kinds (f 3%N))%SEQ.

Definition on_rotations name kinds (f : nat -> seq rows -> given) : seq string :=
  flatten [seq lines_of true n name kinds (f n) | n <- [:: 2; 3; 4]%N].

Definition in_space name kinds (f : seq rows -> given) : seq string := lines_of true 3 name kinds f.

Definition matrix_given n (X : 'M[Qc]_n) (v : value X) : given := (n, n, rows_of v).
Definition number_given (x : Qc) : given := (1%N, 1%N, [:: [:: x]]).

Local Notation "l @ k" := (nth [::] l k%N) (at level 10).

(** What a definition gives for the first one, two, three or four matrices of a sample. *)
Local Notation given_1 f := (fun n l => matrix_given (f n (l @ 0))).
Local Notation given_2 f := (fun n l => matrix_given (f n (l @ 0) (l @ 1))).
Local Notation given_3 f := (fun n l => matrix_given (f n (l @ 0) (l @ 1) (l @ 2))).
Local Notation given_4 f := (fun n l => matrix_given (f n (l @ 0) (l @ 1) (l @ 2) (l @ 3))).
Local Notation number_2 f := (fun n l => number_given (number_of (f n (l @ 0) (l @ 1)))).
Local Notation number_4 f := (fun n l => number_given (number_of (f n (l @ 0) (l @ 1) (l @ 2) (l @ 3)))).

(** ** The file of values *)

Definition actions : seq (seq string) :=
  [:: on_groups "Ad" [:: In_group; In_algebra] (given_2 Ad_rows);
      on_groups "Ad_star" [:: In_group; In_algebra] (given_2 Ad_star_rows);
      on_groups "bracket" [:: In_algebra; In_algebra] (given_2 bracket_rows);
      on_groups "ad_star" [:: In_algebra; In_algebra] (given_2 ad_star_rows);
      on_groups "pairing" [:: In_algebra; In_algebra] (number_2 pairing_number);
      on_groups "L_star" [:: In_group; Any] (given_2 L_star_rows);
      on_groups "R_star" [:: In_group; Any] (given_2 R_star_rows);
      on_rotations "skew_part" [:: Any] (given_1 skew_part_rows)].

Definition motions : seq (seq string) :=
  [:: on_groups "relative_motion_right" [:: In_group; In_group] (given_2 relative_motion_right_rows);
      on_groups "relative_motion_left" [:: In_group; In_group] (given_2 relative_motion_left_rows);
      on_groups "reconstruct_right" [:: In_group; In_group] (given_2 reconstruct_right_rows);
      on_groups "reconstruct_left" [:: In_group; In_group] (given_2 reconstruct_left_rows);
      on_groups "lie_poisson_update_right" [:: In_group; In_algebra] (given_2 lie_poisson_update_right_rows);
      on_groups "lie_poisson_update_left" [:: In_group; In_algebra] (given_2 lie_poisson_update_left_rows)].

(** The matrices \f$a\f$ and \f$b\f$ of the function come first. *)
Definition differentials : seq (seq string) :=
  [:: on_groups "right_differential" [:: Any; Any; In_group] (given_3 right_differential_rows);
      on_groups "left_differential" [:: Any; Any; In_group] (given_3 left_differential_rows);
      on_groups "momentum_before_right" [:: Any; Any; In_group] (given_3 momentum_before_right_rows);
      on_groups "momentum_before_left" [:: Any; Any; In_group] (given_3 momentum_before_left_rows);
      on_groups "euler_poincare_right" [:: Any; Any; In_group; In_group] (given_4 euler_poincare_right_rows);
      on_groups "euler_poincare_left" [:: Any; Any; In_group; In_group] (given_4 euler_poincare_left_rows);
      on_groups "initial_momentum_left" [:: Any; Any; In_group] (given_3 initial_momentum_left_rows);
      on_groups "final_momentum_left" [:: In_group; In_algebra] (given_2 final_momentum_left_rows);
      on_groups "D1" [:: Any; Any; In_group; In_group] (given_4 D1_rows);
      on_groups "D2" [:: Any; Any; In_group; In_group] (given_4 D2_rows);
      on_groups "discrete_euler_lagrange" [:: Any; Any; In_group; In_group; In_group]
        (fun n l => matrix_given (discrete_euler_lagrange_rows n (l @ 0) (l @ 1) (l @ 2) (l @ 3) (l @ 4)));
      on_groups "legendre_at_target" [:: Any; Any; In_group; In_algebra]
        (number_4 legendre_at_target_number);
      on_groups "legendre_at_source" [:: Any; Any; In_group; In_algebra]
        (number_4 legendre_at_source_number)].

Definition brackets_and_forms : seq (seq string) :=
  [:: on_invertible "lie_poisson_bracket_plus" [:: Any; Any; Any; Any; In_algebra]
        (fun n l => number_given
          (number_of (lie_poisson_bracket_plus_number n (l @ 0) (l @ 1) (l @ 2) (l @ 3) (l @ 4))));
      on_groups "kirillov_kostant_plus" [:: In_algebra; In_algebra; In_algebra]
        (fun n l => number_given (sval (kirillov_kostant_plus_number n (l @ 0) (l @ 1) (l @ 2))))].

Definition bodies : seq (seq string) :=
  [:: on_rotations "inertia_operator" [:: Inertia; In_algebra] (given_2 inertia_operator_rows);
      on_rotations "kinetic_energy" [:: Inertia; In_algebra] (number_2 kinetic_energy_number);
      on_rotations "casimir" [:: In_algebra] (fun n l => number_given (number_of (casimir_number n (l @ 0))));
      on_rotations "cayley" [:: In_algebra] (given_1 cayley_rows);
      on_rotations "momentum_before" [:: In_group; Inertia] (given_2 momentum_before_rows);
      on_rotations "momentum_after" [:: In_group; Inertia] (given_2 momentum_after_rows);
      on_rotations "orthogonality" [:: Any] (given_1 orthogonality_rows);
      on_rotations "body_multiplier" [:: In_group; Any] (given_2 body_multiplier_rows);
      on_rotations "trace_casimir" [:: Inertia; In_group] (number_2 trace_casimir_number);
      in_space "hat" [:: Column] (fun l => matrix_given (hat_rows (l @ 0)));
      in_space "cross" [:: Column; Column] (fun l => (3%N, 1%N, rows_of (cross_rows (l @ 0) (l @ 1))))].

(** The rows without the proofs that they are the rows, so that nothing but fractions is computed. *)
Definition all_values : seq (seq string) := Eval lazy beta iota delta [
    actions motions differentials brackets_and_forms bodies matrix_given number_given rows_of number_of
    proj1_sig value_opp value_sub D1_rows D2_rows casimir_number cayley_rows cross_rows
    discrete_euler_lagrange_rows euler_poincare_left_rows euler_poincare_right_rows hat_rows
    inertia_operator_rows kinetic_energy_number kirillov_kostant_plus_number left_differential_rows
    left_translation_rows legendre_at_source_number legendre_at_target_number
    lie_poisson_bracket_plus_number lie_poisson_update_left_rows lie_poisson_update_right_rows
    momentum_before_left_rows momentum_before_right_rows reconstruct_left_rows reconstruct_right_rows
    relative_motion_left_rows relative_motion_right_rows right_differential_rows right_translation_rows
    skew_part_rows momentum_before_rows
    momentum_after_rows orthogonality_rows body_multiplier_rows
    trace_casimir_number initial_momentum_left_rows final_momentum_left_rows
    Ad_rows Ad_star_rows bracket_rows ad_star_rows L_star_rows R_star_rows pairing_number] in
  (actions ++ motions ++ differentials ++ brackets_and_forms ++ bodies)%SEQ.

(** Three definitions in a file: a text of thousands of letters takes long to print. *)
Definition part k : string := lines (flatten (take 3 (drop (3 * k)%N all_values))).

Redirect "values_00" Eval vm_compute in part 0.
Redirect "values_01" Eval vm_compute in part 1.
Redirect "values_02" Eval vm_compute in part 2.
Redirect "values_03" Eval vm_compute in part 3.
Redirect "values_04" Eval vm_compute in part 4.
Redirect "values_05" Eval vm_compute in part 5.
Redirect "values_06" Eval vm_compute in part 6.
Redirect "values_07" Eval vm_compute in part 7.
Redirect "values_08" Eval vm_compute in part 8.
Redirect "values_09" Eval vm_compute in part 9.
Redirect "values_10" Eval vm_compute in part 10.
Redirect "values_11" Eval vm_compute in part 11.
Redirect "values_12" Eval vm_compute in part 12.
Redirect "values_13" Eval vm_compute in part 13.
