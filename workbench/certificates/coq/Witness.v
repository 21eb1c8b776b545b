(** Real motions for which premises hold: what is made of time, its cosine and its sine. *)
From Coq Require Import QArith List.
From Kin Require Import Kin Poly Divide Terms Certify Modulo Symbols Facts Smooth Time.
Set Implicit Arguments.
Import ListNotations.
Open Scope Q_scope. Open Scope kin_scope.

(** The scalars 0, 1, 2 are cos t, sin t and t, as in Refute.v. *)
Definition time_slots : list (slot smooth_functions) :=
  [as_slot false Scalar cosine; as_slot false Scalar sine; as_slot false Scalar time].
Definition time_at : list premise := Rate 2 (Num false 1) :: turn_at (Var false Scalar 2) 0 1.
Lemma time_at_ok more : Forall (holds (envK 0 (time_slots ++ more))) time_at.
Proof. apply Forall_cons; [exact time_rate | apply turn_at_ok; exact time_turn]. Qed.
(** A smooth motion, as the value of a variable. *)
Definition made d k (t : tm d k) : val (rng smooth_functions d) k := den (envK 0 time_slots) t.
