(** Proof machinery: what a proof computes with. A context gives each symbol its value in K and what stands for that
    value in some way to compute; it begins with polynomials modulo premises (Modulo.v) and grows by reciprocals, by
    definitions, and by symbols of which a premise says what they are. *)
From Coq Require Import QArith List Bool Setoid Morphisms Ring BinPos.
From Kin Require Import Kin Poly Divide Terms Certify Modulo Fraction.
Set Implicit Arguments.
Import ListNotations.

Record context (K : diff_ring) := { c_ops : ops; c_R : c_ops -> K -> Prop; c_eqb : c_ops -> c_ops -> bool;
  c_sound : computes K c_ops c_R c_eqb; c_env : env c_ops; c_val : env K; c_rel : env_related c_R c_env c_val }.

Section Contexts.
Variable K : diff_ring.
Section Premises.
Variable shapes : list shape.
Variable slots : list (slot K).
Hypothesis shapes_ok : List.map (@projT1 _ _) slots = shapes.
Hypothesis some : Nat.ltb 0 (total shapes) = true.
Variable ps : list premise.
Hypothesis premises_ok : Forall (holds (envK 0 slots)) ps.
Let some_ok := proj1 (PeanoNat.Nat.ltb_lt _ _) some.
Lemma run_related : sound shapes slots (projT1 (run shapes ps (env0 shapes))) /\
  suits shapes slots (projT2 (run shapes ps (env0 shapes))).
Proof.
  pose proof (run_ok shapes_ok some_ok (start_ok shapes slots) (env0_ok slots shapes_ok some_ok) premises_ok) as H.
  now destruct (run shapes ps (env0 shapes)).
Qed.
Lemma rem_computes s : sound shapes slots s ->
  computes K (rem_ops s) (stands K (jets shapes slots)) (fun p q => vanishes s (p, q)).
Proof.
  pose proof (same_equiv K) as QE. intros S. split; [exact (rem_hom some_ok S) | intros p x y H E; exact (@Equivalence_Transitive _ _ QE _ _ _ H E) |].
  intros p q x y P Q V. exact (vanishes_ok p q x y S P Q V).
Qed.
Definition premised : context K := {| c_sound := rem_computes (proj1 run_related); c_rel := proj2 run_related |}.
End Premises.
Definition defined (c : context K) d k i (t : tm d k) : context K := {| c_sound := c_sound c;
  c_rel := @env_upd _ _ _ _ _ d k i _ _ (c_rel c) (den_related (s_hom (c_sound c)) t (c_rel c)) |}.

Lemma related_ext O R eqb (S : computes K O R eqb) d k (p : val (rng O d) k) (x y : val (rng K d) k) :
  related R d k p x -> equal y x -> related R d k p y.
Proof.
  pose proof (same_equiv K) as Q. pose proof (s_ext S) as X.
  unfold related, equal, drel. destruct d, k; cbn; unfold all3, dual_same; cbn;
    intros; repeat match goal with H : _ /\ _ |- _ => destruct H end; repeat split;
    match goal with |- R ?p ?y => match goal with A : R p ?x, B : same y ?x |- _ =>
      exact (X p x y A (@Equivalence_Symmetric _ _ Q y x B)) end end.
Qed.
Definition given (c : context K) d k i (x : val (rng K d) k) (t : tm d k) (H : equal x (den (c_val c) t)) : context K :=
  {| c_sound := c_sound c;
     c_rel := @env_upd _ _ _ _ _ d k i _ _ (c_rel c) (@related_ext _ _ _ (c_sound c) d k _ _ _ (den_related (s_hom (c_sound c)) t (c_rel c)) H) |}.

Definition with_reciprocal (c : context K) i (t : tm false Scalar) (y : K) (H : @reciprocal K (den (c_val c) t) y) : context K :=
  let d_ok := den_related (s_hom (c_sound c)) t (c_rel c) : c_R c (den (c_env c) t) (den (c_val c) t) in
  {| c_sound := frac_sound (den (c_env c) t) (c_sound c) (den (c_val c) t) y d_ok H; c_rel := with_y_ok (den (c_env c) t) (c_sound c) y i (c_rel c) |}.

Theorem by_computing (c : context K) d k (a b : tm d k) :
  equal_by (c_eqb c) d k (den (c_env c) a) (den (c_env c) b) = true -> equal (den (c_val c) a) (den (c_val c) b).
Proof. apply (equal_by_ok (c_sound c)); apply (den_related (s_hom (c_sound c))), (c_rel c). Qed.
(** What holds whatever the symbols are is not computed with what they are. *)
Theorem by_either (free c : context K) d k (a b : tm d k) : c_val free = c_val c ->
  (if equal_by (c_eqb free) d k (den (c_env free) a) (den (c_env free) b) then true
   else equal_by (c_eqb c) d k (den (c_env c) a) (den (c_env c) b)) = true -> equal (den (c_val c) a) (den (c_val c) b).
Proof.
  intros E. destruct (equal_by (c_eqb free) d k _ _) eqn:F; [intros _ | apply by_computing].
  exact (eq_ind _ (fun e => equal (den e a) (den e b)) (by_computing free a b F) _ E).
Qed.
End Contexts.
Arguments with_reciprocal {K} c i t {y} H. Arguments given {K} c d k i {x} t H. Arguments defined {K} c d k i t.
