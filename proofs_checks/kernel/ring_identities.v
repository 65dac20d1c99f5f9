(** * Identities of commutative rings

A decision procedure for identities that hold in every commutative ring: both sides are written as
polynomials in their atoms with integer coefficients, and compared. The library of Coq has the polynomials
and their correctness; the tactic `ring_identity` reads an equation of mathcomp and hands it over. *)

From Coq Require Import ZArith Ring_theory Ring_polynom InitialRing.
From mathcomp Require Import all_ssreflect all_algebra.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

Section Ring.

Variable R : comRingType.

Definition ring_sum (x y : R) : R := x + y.
Definition ring_difference (x y : R) : R := x - y.
Definition ring_product (x y : R) : R := x * y.
Definition ring_opposite (x : R) : R := - x.

Lemma commutative_ring : ring_theory 0 1 ring_sum ring_product ring_difference ring_opposite eq.
Proof.
split; [exact: add0r | exact: addrC | exact: addrA | exact: mul1r | exact: mulrC | exact: mulrA
       | exact: mulrDl | by [] | exact: subrr].
Qed.

(** The value of a polynomial at a list of elements of the ring. *)
Definition polynomial_value (atoms : list R) (e : PExpr Z) : R :=
  PEeval 0 1 ring_sum ring_product ring_difference ring_opposite (gen_phiZ 0 1 ring_sum ring_product
    ring_opposite) id_phi_N
    (pow_N 1 ring_product) atoms e.

Definition same_polynomial (e f : PExpr Z) : bool :=
  Peq Zeq_bool (norm_subst Z0 (Zpos xH) Z.add Z.mul Z.sub Z.opp Zeq_bool Z.quotrem 0 nil e)
    (norm_subst Z0 (Zpos xH) Z.add Z.mul Z.sub Z.opp Zeq_bool Z.quotrem 0 nil f).

Lemma same_value (atoms : list R) (e f : PExpr Z) :
  same_polynomial e f = true -> polynomial_value atoms e = polynomial_value atoms f.
Proof.
have ext := Eq_ext ring_sum ring_product ring_opposite.
exact: (ring_correct (Eqsth R) ext (Rth_ARth (Eqsth R) ext commutative_ring)
  (gen_phiZ_morph (Eqsth R) ext commutative_ring) (pow_N_th 1 ring_product (Eqsth R))
  (Ztriv_div_th (Eqsth R) _) 0 atoms nil e f I).
Qed.

End Ring.

(** The place of an atom in a list, which grows where the atom is new; atoms are compared up to conversion. *)
Ltac place_of R t atoms :=
  let rec go l k :=
    match l with
    | nil => constr:(@None positive)
    | cons ?a ?l' =>
        match constr:(Set) with
        | _ => let same := match goal with _ => unify a t end in constr:(@Some positive k)
        | _ => go l' constr:(Pos.succ k)
        end
    end in
  go atoms constr:(xH).

(** \f$e\f$ joined with itself \f$n\f$ times. *)
Ltac repeated F unit e n :=
  match n with
  | 0%N => unit
  | 1%N => e
  | S ?m => let f := repeated F unit e m in constr:(F e f)
  end.

Ltac read R t atoms :=
  let two F x y :=
    match read R x atoms with
    | (?e, ?atoms') => match read R y atoms' with (?f, ?atoms'') => constr:((F e f, atoms'')) end
    end in
  match t with
  | @GRing.add _ ?x ?y => two (@PEadd Z) x y
  | @GRing.mul _ ?x ?y => two (@PEmul Z) x y
  | @GRing.opp _ ?x => match read R x atoms with (?e, ?atoms') => constr:((@PEopp Z e, atoms')) end
  | GRing.zero _ => constr:((@PEO Z, atoms))
  | GRing.one _ => constr:((@PEI Z, atoms))
  | @GRing.natmul _ ?x ?n =>
      match read R x atoms with
      | (?e, ?atoms') => let f := repeated (@PEadd Z) (@PEO Z) e n in constr:((f, atoms'))
      end
  | @GRing.exp _ ?x ?n =>
      match read R x atoms with
      | (?e, ?atoms') => let f := repeated (@PEmul Z) (@PEI Z) e n in constr:((f, atoms'))
      end
  | _ =>
      match place_of R t atoms with
      | Some ?k => let k' := eval compute in k in constr:((@PEX Z k', atoms))
      | None =>
          let k := eval compute in (Pos.of_succ_nat (List.length atoms)) in
          let atoms' := eval cbv [List.app] in (List.app atoms (cons (t : GRing.ComRing.sort R) nil)) in
          constr:((@PEX Z k, atoms'))
      end
  end.

Ltac ring_identity :=
  match goal with
  | |- @eq ?T ?a ?b =>
      let R := constr:([comRingType of T]) in
      match read R a (@nil (GRing.ComRing.sort R)) with
      | (?e, ?atoms) =>
          match read R b atoms with
          | (?f, ?atoms') => exact (@same_value R atoms' e f (@erefl bool true <: same_polynomial e f = true))
          end
      end
  end.
