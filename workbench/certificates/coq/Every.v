(** Goals about every n, and what holds at all times. *)
From Coq Require Import QArith Reals Arith Lia.
From Kin Require Import Kin Smooth Time Moment Orders.
Open Scope Q_scope. Open Scope kin_scope.

Lemma from_least (k : nat) (P : nat -> Prop) : (forall m, P (k + m)%nat) -> forall n, (k <= n)%nat -> P n.
Proof. intros H n L. replace n with (k + (n - k))%nat by lia. apply H. Qed.
Lemma by_induction (k : nat) (P : nat -> Prop) : P k -> (forall m, P (k + m)%nat -> P (S (k + m))) ->
  forall n, (k <= n)%nat -> P n.
Proof. intros B H. apply from_lowest; [exact B|]. intros n L. now replace n with (k + (n - k))%nat by lia; apply H. Qed.
(** What holds at all times may be differentiated. *)
Lemma throughout d k (x y : val (rng smooth_functions d) k) : (forall now, equal_at now x y) -> equal x y.
Proof.
  intros H. assert (V : forall f g : smooth, (forall t, alike_at t f g) -> @same smooth_functions f g).
  { intros f g E. apply by_values. exact E. }
  destruct d, k; cbn; unfold all3, dual_same; cbn; repeat split; apply V; intros t; specialize (H t);
    unfold equal_at, equal_in in H; cbn in H; unfold all3, dual_same in H; cbn in H; tauto.
Qed.
Arguments throughout {d k x y}.
(** An index is at least so much; a sum of a number of addends is what is added. *)
Ltac from_here := lia.
Ltac added := first [exact (same_at _ _)
  | apply always; unfold sum_from; cbn [total Nat.add Nat.sub Nat.pred]; rewrite ?zero_plus; reflexivity].
