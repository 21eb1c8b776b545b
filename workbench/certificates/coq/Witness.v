(** Real motions for which premises hold: time, its cosine and sine, and what is made of them. *)
From Coq Require Import QArith Reals Lra List.
From Kin Require Import Kin Poly Divide Terms Certify Modulo Symbols Facts Smooth Refute.
Set Implicit Arguments.
Import ListNotations.

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
Definition time : scalar smooth_functions := tt_smooth.

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

(** A rotation whose angular velocity is not constant: about the third axis and the first one, both by the angle t. *)
Definition tumbling : tensor smooth_functions := rodrigues cosine sine (axis 2) ∘ rodrigues cosine sine (axis 0).
(** Its copy, where cos t, sin t are the scalars 0 and 1, and t is the scalar 2; the tensor is symbol 3. *)
Definition rodrigues_tm d (c s : tm d Scalar) (u : tm d Vector) : tm d Tensor :=
  Plus (Plus (Idt d) (Scale s (Skew u))) (Scale (Minus (Num d 1) c) (Prod (Skew u) (Skew u))).
Definition tumbling_tm : tm false Tensor := let c := Var false Scalar 0 in let s := Var false Scalar 1 in
  Prod (rodrigues_tm c s (Axis false 2)) (rodrigues_tm c s (Axis false 0)).
Definition tumbling_at : list premise := [Rate 2 (Num false 1)] ++ turn_at (Var false Scalar 2) 0 1 ++ [Value 3 tumbling_tm].
Definition tumbling_shapes : list shape := [(false, Scalar); (false, Scalar); (false, Scalar); (false, Tensor)].
Definition tumbling_slots : list (slot smooth_functions) := [as_slot false Scalar cosine; as_slot false Scalar sine;
  as_slot false Scalar time; as_slot false Tensor tumbling].
Lemma tumbling_at_ok more : Forall (holds (envK 0 (tumbling_slots ++ more))) tumbling_at.
Proof.
  apply Forall_cons; [exact time_rate|]. apply Forall_app. split; [apply turn_at_ok; exact time_turn|].
  apply Forall_cons; [|apply Forall_nil]. cbn [holds]. reflexivity.
Qed.
#[global] Hint Extern 1 (Forall _ tumbling_at) => apply (tumbling_at_ok []) : facts.
Lemma tumbling_rotation : rotation tumbling.
Proof.
  split.
  - under tumbling_at tumbling_shapes tumbling_slots (let R := Var false Tensor 3 in Prod R (Transpose R)) (Idt false).
  - under tumbling_at tumbling_shapes tumbling_slots (Det (Var false Tensor 3)) (Num false 1).
Qed.
