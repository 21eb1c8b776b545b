(** Some smooth functions: time, its cosine and its sine. *)
From Coq Require Import QArith Reals Lra Qreals.
From Kin Require Import Kin Symbols Smooth.
Open Scope Q_scope. Open Scope kin_scope.

(** a cos t + b sin t with all its derivatives. *)
Fixpoint turned (n : nat) (a b : R) : R * R := match n with O => (a, b) | S m => turned m b (- a)%R end.
Definition wave (a b : R) : smooth.
Proof.
  refine {| F := fun n t => (fst (turned n a b) * cos t + snd (turned n a b) * sin t)%R |}.
  intros n t.
  assert (N : forall n a b, turned (S n) a b = (snd (turned n a b), - fst (turned n a b))%R).
  { clear. induction n as [|n IH]; intros a b; [reflexivity|]. exact (IH b (- a)%R). }
  rewrite N. cbn [fst snd]. set (x := fst (turned n a b)). set (y := snd (turned n a b)).
  replace (y * cos t + - x * sin t)%R with (x * - sin t + y * cos t)%R by ring.
  apply (derivable_pt_lim_plus (fun t => x * cos t)%R (fun t => y * sin t)%R).
  - apply (derivable_pt_lim_scal cos). apply derivable_pt_lim_cos.
  - apply (derivable_pt_lim_scal sin). apply derivable_pt_lim_sin.
Defined.
Definition cosine : scalar smooth_functions := wave 1 0.
Definition sine : scalar smooth_functions := wave 0 1.
Definition time : scalar smooth_functions.
Proof.
  refine {| F := fun n t => match n with O => t | S O => 1 | _ => 0 end%R |}.
  intros [|[|n]] t; [apply derivable_pt_lim_id | apply derivable_pt_lim_const | apply derivable_pt_lim_const].
Defined.

(** Smooth functions with equal values are equal with all their derivatives. *)
Lemma by_values (f g : smooth) : (forall t, F f 0 t = F g 0 t) -> same_fun f g.
Proof.
  intros E n. induction n as [|n IH]; [exact E|]. intros t.
  apply (uniqueness_limite (F f n) t); [apply smooth_ok|].
  intros eps P. destruct (smooth_ok g n t eps P) as [delta H]. exists delta. intros h N A. rewrite !IH. now apply H.
Qed.
Lemma time_rate : D time ≡ (num 1 : scalar smooth_functions).
Proof. apply by_values. intros t. cbn. unfold Q2R; cbn. lra. Qed.
Lemma time_turn : turn (K := smooth_functions) time cosine sine.
Proof.
  repeat split; apply by_values; intros t; cbn; unfold Q2R; cbn; try lra.
  pose proof (sin2_cos2 t) as P. unfold Rsqr in P. lra.
Qed.
