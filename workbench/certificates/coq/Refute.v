(** A counterexample as a theorem: not for all smooth motions. The motion is a polynomial in time, evaluated at t = 0. *)
From Coq Require Import QArith Reals Qreals List Lra Bool.
From Kin Require Import Kin Poly Terms Certify Smooth.
Set Implicit Arguments.
Import ListNotations.

(** Rational derivatives at t = 0. *)
Fixpoint qleibniz (n : nat) (f g : nat -> Q) : Q :=
  match n with O => qmul (f 0%nat) (g 0%nat)
  | S n => qadd (qleibniz n (fun k => f (S k)) g) (qleibniz n f (fun k => g (S k))) end.
(** The same derivatives, the first ones computed once. *)
Definition table_of (f : nat -> Q) : nat -> Q :=
  let known := List.map f [0; 1; 2; 3; 4; 5; 6; 7]%nat in
  fun n => match nth_error known n with Some q => q | None => f n end.
Lemma table_of_ok f n : table_of f n = f n.
Proof. do 8 (destruct n as [|n]; [reflexivity|]). unfold table_of. cbn. now destruct n. Qed.
Definition qjets : ops := {| car := nat -> Q; num q := fun n => match n with O => q | _ => 0 # 1 end;
  add f g := table_of (fun n => qadd (f n) (g n)); mul f g := table_of (fun n => qleibniz n f g); opp f := fun n => Qopp (f n); dt f := fun n => f (S n) |}.
Definition at0 (f : qjets) (g : smooth_ops) : Prop := forall n, F g n 0%R = Q2R (f n).
Lemma at0_hom : hom qjets smooth_ops at0.
Proof.
  assert (A : forall p q, Q2R (qadd p q) = (Q2R p + Q2R q)%R) by (intros; rewrite <- Q2R_plus; apply Qeq_eqR, qadd_ok).
  assert (M : forall p q, Q2R (qmul p q) = (Q2R p * Q2R q)%R) by (intros; rewrite <- Q2R_mult; apply Qeq_eqR, qmul_ok).
  unfold at0. split; cbn -[table_of]; intros; rewrite ?table_of_ok.
  - destruct n; [reflexivity | unfold Q2R; cbn; lra].
  - now rewrite A, H, H0.
  - revert a b x y H H0. induction n as [|n IH]; intros a b [x Sx] [y Sy] H H0; cbn in *.
    + now rewrite M, H, H0.
    + rewrite A. f_equal.
      * exact (IH (fun k => a (S k)) b {| F := fun n => x (S n); smooth_ok := fun n => Sx (S n) |} {| F := y; smooth_ok := Sy |} (fun n => H (S n)) H0).
      * exact (IH a (fun k => b (S k)) {| F := x; smooth_ok := Sx |} {| F := fun n => y (S n); smooth_ok := fun n => Sy (S n) |} H (fun n => H0 (S n))).
  - now rewrite Q2R_opp, H.
  - apply H.
Qed.
Definition tt_smooth : smooth.
  refine {| F := fun n t => match n with O => t | S O => 1 | _ => 0 end%R |}.
  intros [|[|n]] t; [apply derivable_pt_lim_id | apply derivable_pt_lim_const | apply derivable_pt_lim_const].
Defined.
Definition tt_q : qjets := fun n => match n with S O => 1 # 1 | _ => 0 # 1 end.
(** c₀ + t (c₁ + t/2 (c₂ + …)): the motion with these derivatives at t = 0. *)
Fixpoint motion {O : ops} (time : O) (k : positive) (cs : list Q) : O :=
  match cs with [] => num 0 | c :: r => add (num c) (mul (mul (num (1 # k)) time) (motion time (Pos.succ k) r)) end.
Lemma motion_at0 cs : forall k, at0 (motion tt_q k cs) (motion (O:=smooth_ops) tt_smooth k cs).
Proof.
  induction cs; intros k; cbn [motion]; [apply (h_num at0_hom)|].
  apply (h_add at0_hom); [apply (h_num at0_hom) | apply (h_mul at0_hom); [apply (h_mul at0_hom) | apply IHcs]].
  - apply (h_num at0_hom).
  - intros [|[|n]]; cbn; unfold Q2R; cbn; lra.
Qed.

(** A symbol that moves so that its components have these derivatives at t = 0, real parts before dual parts. *)
Definition moving {O : ops} (time : O) (cs : list (list Q)) d k : val (rng O d) k :=
  let m i := motion time 1 (nth i cs []) in
  let v i := V (m i) (m (i + 1)%nat) (m (i + 2)%nat) in
  let real n := match k return nat -> val O k with Scalar => m | Vector => v
    | Tensor => fun i => V (v i) (v (i + 3)%nat) (v (i + 6)%nat) end n in
  match d return val (rng O d) k with
  | false => real 0%nat
  | true => both (@Dual O) (real 0%nat) (real match k with Scalar => 1 | Vector => 3 | Tensor => 9 end)%nat
  end.
Lemma moving_at0 cs d k : @related qjets smooth_ops at0 d k (moving tt_q cs d k) (moving (O := smooth_ops) tt_smooth cs d k).
Proof. unfold related. destruct d, k; cbn; unfold all3, dual_same; cbn; repeat split; apply motion_at0. Qed.
Fixpoint motions {O : ops} (time : O) (i : nat) (ms : list (bool * kind * list (list Q))) : env O :=
  match ms with [] => fun d k _ => zero
  | (d, k, cs) :: r => @upd O (motions time (S i) r) d k i (moving time cs d k) end.
Lemma motions_at0 ms : forall i, @env_related qjets smooth_ops at0 (motions tt_q i ms) (motions (O := smooth_ops) tt_smooth i ms).
Proof.
  induction ms as [|[[d k] cs] r IH]; intros i; cbn [motions].
  - intros d k j. apply (r_zero (hom_rng d at0_hom)).
  - intros d' k' j. unfold upd. destruct (Bool.bool_dec d d') as [p|]; [|apply IH].
    destruct (kind_dec k k') as [q|]; [|apply IH]. destruct (Nat.eqb i j); [|apply IH]. destruct p, q. apply moving_at0.
Qed.
Definition differs d k (a b : val (rng qjets d) k) : bool :=
  existsb (fun c => negb (Qeq_bool (fst c 0%nat) (snd c 0%nat))) (combine (comps qjets d k a) (comps qjets d k b)).
Lemma differs_ok d k (a b : val (rng qjets d) k) (x y : val (rng smooth_ops d) k) :
  related at0 d k a x -> related at0 d k b y -> differs d k a b = true -> ~ @equal smooth_functions d k x y.
Proof.
  assert (N : forall (a b : qjets) (x y : smooth), at0 a x -> at0 b y -> negb (Qeq_bool (a 0%nat) (b 0%nat)) = true -> ~ same_fun x y).
  { intros p q f g A B D E. apply negb_true_iff, Qeq_bool_neq in D. apply D, eqR_Qeq. rewrite <- (A 0%nat), <- (B 0%nat). apply E. }
  unfold related, differs, comps, equal, drel. destruct d, k; cbn; unfold all3, dual_same; cbn; intros A B D E;
    rewrite ?orb_true_iff, ?orb_false_r in D;
    repeat match goal with H : _ /\ _ |- _ => destruct H | H : _ || _ = true |- _ => apply orb_true_iff in H | H : _ \/ _ |- _ => destruct H
      | H : false = true |- _ => discriminate H end;
    match goal with D : negb (Qeq_bool (?a 0%nat) (?b 0%nat)) = true, A : at0 ?a ?f, B : at0 ?b ?g |- _ =>
      exact (N a b f g A B D ltac:(assumption)) end.
Qed.
Theorem refuted ms d k (a b : tm d k) :
  differs d k (den (motions tt_q 0 ms) a) (den (motions tt_q 0 ms) b) = true ->
  ~ @equal smooth_functions d k (den (motions (O := smooth_ops) tt_smooth 0 ms) a) (den (motions (O := smooth_ops) tt_smooth 0 ms) b).
Proof.
  pose proof (motions_at0 ms 0) as E.
  apply differs_ok; [exact (@den_related _ _ _ at0_hom d k a _ _ E) | exact (@den_related _ _ _ at0_hom d k b _ _ E)].
Qed.
(** Such a motion, as a value for the variable of a statement. *)
Notation motion_of cs d k := (@moving smooth_ops tt_smooth cs d k).
