(** Proof machinery: the few steps by which the certificates are proved, and what an inverse is. *)
From Coq Require Import QArith List Setoid Morphisms.
From Kin Require Import Kin Poly Terms Certify Modulo Symbols Forms Facts Fraction Context.
Set Implicit Arguments.
Import ListNotations.
Open Scope Q_scope. Open Scope kin_scope.

(** [certify context lhs rhs]: both sides are what their deep copies say, and those are equal by computation. *)
Ltac certify c lhs rhs := refine (@by_computing _ c _ _ lhs rhs _); vm_cast_no_check (@eq_refl bool true).
Ltac certify_by free context lhs rhs := refine (@by_either _ free context _ _ lhs rhs eq_refl _); vm_cast_no_check (@eq_refl bool true).
(** A conjunction, or an equation of matrices, in parts. *)
Ltac apart := cbv beta delta [matrix_equal upto] iota; repeat apply conj.

Section Premises.
Variable K : diff_ring.
Variable e : env K.
Lemma single p : holds e p -> Forall (holds e) [p].
Proof. intros H. repeat constructor. exact H. Qed.
Lemma joined p q : Forall (holds e) p -> Forall (holds e) q -> Forall (holds e) (p ++ q).
Proof. intros H G. apply Forall_app. now split. Qed.
Lemma alike d k (x : val (rng K d) k) : equal x x.
Proof. reflexivity. Qed.
Lemma as_given d k (x y : val (rng K d) k) : equal x y -> equal x y.
Proof. exact (fun H => H). Qed.
Lemma turned d k (x y : val (rng K d) k) : equal y x -> equal x y.
Proof. intros H. now symmetry. Qed.
Lemma carried k (x y z : val (rng K false) k) : equal (plus x y) z -> equal x (minus z y).
Proof.
  pose proof (hom_same K) as S.
  intros H. transitivity (minus (plus x y) y); [|exact (@r_minus _ _ _ S k _ _ _ _ H (alike false k y))]. clear H z.
  destruct k;
    match goal with |- @equal _ _ ?k _ _ =>
      certify (@premised K [(false, k); (false, k)] [as_slot false k x; as_slot false k y] eq_refl eq_refl [] (Forall_nil _))
        (Var false k 0) (Minus (Plus (Var false k 0) (Var false k 1)) (Var false k 1)) end.
Qed.
Lemma still_real (u : dual_vector K) : constant (K := K) (d := true) (k := Vector) u -> equal (D (real_part u : vector K)) zero.
Proof. unfold constant. cbn. unfold all3, dual_same. cbn. tauto. Qed.
Lemma still_dual (u : dual_vector K) : constant (K := K) (d := true) (k := Vector) u -> equal (D (dual_part u : vector K)) zero.
Proof. unfold constant. cbn. unfold all3, dual_same. cbn. tauto. Qed.
Lemma still_moment (u : dual_vector K) : constant (K := K) (d := true) (k := Vector) u -> equal (D (moment u)) zero.
Proof.
  intros H. unfold moment.
  under [@Rate false Vector 0 (Zer false Vector); @Rate false Vector 1 (Zer false Vector)] [(false, Vector); (false, Vector)]
    [as_slot false Vector (real_part u : vector K); as_slot false Vector (dual_part u : vector K)]
    (DD (Cross (Var false Vector 0) (Var false Vector 1))) (Zer false Vector).
  - exact (still_real H).
  - exact (still_dual H).
Qed.
End Premises.
Arguments single {K e p}. Arguments joined {K e p q}. Arguments alike {K d k} x. Arguments as_given {K d k x y}.
Arguments turned {K d k x y}. Arguments carried {K k x y z}. Arguments still_real {K u}. Arguments still_moment {K u}.

Section Inverse.
Variable K : diff_ring.
Variables A B : tensor K.
Hypothesis H : inverse A B.
Let cx := @premised K [(false, Tensor); (false, Tensor)] [as_slot false Tensor A; as_slot false Tensor B] eq_refl eq_refl [] (Forall_nil _).
Notation a := (Var false Tensor 0). Notation b := (Var false Tensor 1).
Let same_hom := hom_same K.
Lemma inverse_det : reciprocal (det A) (det B).
Proof.
  unfold reciprocal. transitivity (det (prod A B)); [certify cx (Scale (Det a) (Det b)) (Det (Prod a b))|].
  transitivity (det (ident : tensor K)); [exact (r_det same_hom (proj1 H))|]. certify cx (Det (Idt false)) (Num false (1 # 1)).
Qed.
Lemma inverse_adj : equal B (scale (det B) (adj A)).
Proof.
  pose (cy := with_reciprocal cx 2 (Det a) inverse_det).
  pose (p := Scale (Var false Scalar 2) (Adj a)).
  transitivity (den (c_val cy) (Prod p (Prod a b))); [certify cy (Var false Tensor 1) (Prod p (Prod a b))|].
  transitivity (den (c_val cy) (Prod p (Idt false))); [|certify cy (Prod p (Idt false)) p].
  exact (r_prod same_hom (alike (k := Tensor) (d := false) (den (c_val cy) p)) (proj1 H)).
Qed.
End Inverse.
