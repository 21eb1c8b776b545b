(** A counterexample as a theorem: not for all smooth motions. The motions are made of time, its cosine and its sine;
    what differs are the values at t = 0. *)
From Coq Require Import QArith Reals Qreals List Lra Bool Lia.
From Kin Require Import Kin Poly Terms Certify Modulo Smooth Time.
Set Implicit Arguments.
Import ListNotations.

(** Rational derivatives at t = 0: as many as are known. *)
Definition jet := list Q.
Fixpoint together (f : Q -> Q -> Q) (a b : jet) : jet :=
  match a, b with x :: a, y :: b => f x y :: together f a b | _, _ => [] end.
Fixpoint product (n : nat) (a b : jet) : jet :=
  match n, a, b with S n, x :: a', y :: b' => qmul x y :: together qadd (product n a' b) (product n a b') | _, _, _ => [] end.
Definition first (n : nat) (f : nat -> Q) : jet := List.map f (seq 0 n).
Section Jets.
Variable known : nat.  (* how many derivatives of a constant are known *)
Definition jets : ops := {| car := jet; num q := q :: repeat (0 # 1) known; add := together qadd; mul a b := product (Nat.min (length a) (length b)) a b;
  opp := List.map Qopp; dt f := tl f |}.
Definition at0 (f : jets) (g : smooth_ops) : Prop := forall n q, nth_error f n = Some q -> F g n 0%R = Q2R q.
Lemma nth_together op a : forall b n q, nth_error (together op a b) n = Some q ->
  exists x y, nth_error a n = Some x /\ nth_error b n = Some y /\ q = op x y.
Proof.
  induction a as [|x a IH]; intros [|y b] [|n] q; cbn; try discriminate.
  - intros E. injection E as <-. now exists x, y.
  - apply IH.
Qed.
Let A p q : Q2R (qadd p q) = (Q2R p + Q2R q)%R.
Proof. rewrite <- Q2R_plus. apply Qeq_eqR, qadd_ok. Qed.
Lemma product_ok m : forall a b (x y : nat -> R -> R), (forall n q, nth_error a n = Some q -> x n 0%R = Q2R q) ->
  (forall n q, nth_error b n = Some q -> y n 0%R = Q2R q) ->
  forall n q, nth_error (product m a b) n = Some q -> leibniz n x y 0%R = Q2R q.
Proof.
  induction m as [|m IH]; intros [|p a] [|r b] x y X Y [|n] q; try discriminate.
  - cbn. intros E. injection E as <-. rewrite (X 0%nat p eq_refl), (Y 0%nat r eq_refl), <- Q2R_mult.
    apply Qeq_eqR. symmetry. apply qmul_ok.
  - intros E. cbn [product nth_error] in E. apply nth_together in E as (u & v & U & W & ->). rewrite A. cbn [leibniz]. f_equal.
    + exact (IH _ _ _ _ (fun n => X (S n)) Y n u U).
    + exact (IH _ _ _ _ X (fun n => Y (S n)) n v W).
Qed.
Lemma at0_hom : hom jets smooth_ops at0.
Proof.
  unfold at0. split; cbn; intros.
  - destruct n; [injection H as <-; reflexivity|]. cbn in H. apply nth_error_In, repeat_spec in H as ->. unfold Q2R; cbn; lra.
  - apply nth_together in H1 as (u & v & U & W & ->). now rewrite A, (H n u U), (H0 n v W).
  - exact (@product_ok _ a b _ _ H H0 n q H1).
  - rewrite nth_error_map in H0. destruct (nth_error a n) as [u|] eqn:E; [|discriminate]. injection H0 as <-.
    now rewrite Q2R_opp, (H n u E).
  - apply H. destruct a; [now destruct n | exact H0].
Qed.
Lemma first_ok f (g : smooth) : (forall n, F g n 0%R = Q2R (f n)) -> at0 (first known f) g.
Proof.
  intros E n q H. unfold first in H. rewrite nth_error_map in H. destruct (nth_error (seq 0 known) n) as [m|] eqn:S; [|discriminate].
  injection H as <-. rewrite E. do 2 f_equal. pose proof (proj1 (nth_error_Some (seq 0 known) n) ltac:(congruence)) as L.
  rewrite seq_length in L. apply (nth_error_nth _ _ 0%nat) in S. rewrite seq_nth in S by exact L. exact S.
Qed.

(** Time, its cosine and its sine. *)
Fixpoint qturned (n : nat) (a b : Q) : Q * Q := match n with O => (a, b) | S m => qturned m b (Qopp a) end.
Definition time_jet : jets := first known (fun n => match n with S O => 1 # 1 | _ => 0 # 1 end).
Definition wave_jet (a b : Q) : jets := first known (fun n => fst (qturned n a b)).
Lemma time_at0 : at0 time_jet time.
Proof. apply first_ok. intros [|[|n]]; cbn; unfold Q2R; cbn; lra. Qed.
Lemma wave_at0 a b : at0 (wave_jet a b) (wave (Q2R a) (Q2R b)).
Proof.
  apply first_ok. intros n. cbn. rewrite cos_0, sin_0, Rmult_1_r, Rmult_0_r, Rplus_0_r. revert a b.
  induction n as [|n IH]; intros a b; cbn [turned qturned]; [reflexivity|]. rewrite <- Q2R_opp. apply IH.
Qed.

(** What is known of the symbols: the scalars 0, 1, 2 are cos t, sin t and t; the others are what premises say they are. *)
Definition unknown : env jets := fun d k _ =>
  match d return val (rng jets d) k with false => fill [] | true => fill (@Dual jets [] []) end.
Lemma unknown_ok (e : env smooth_ops) : @env_related jets smooth_ops at0 unknown e.
Proof.
  assert (N : forall x, at0 [] x) by (intros x [|n] q; discriminate).
  intros d k i. unfold related. destruct d, k; cbn; unfold all3, dual_same; cbn; auto 12.
Qed.
Definition begun : env jets := @upd jets (@upd jets (@upd jets unknown false Scalar 2 time_jet)
  false Scalar 1 (wave_jet 0 1)) false Scalar 0 (wave_jet 1 0).
Fixpoint learn (ps : list premise) (E : env jets) : env jets :=
  match ps with [] => E | @Value d k i t :: r => learn r (@upd jets E d k i (den E t)) | _ :: r => learn r E end.
Lemma known_ok (E : env jets) (e : env smooth_ops) d k i x : @env_related jets smooth_ops at0 E e ->
  @related jets smooth_ops at0 d k x (e d k i) -> @env_related jets smooth_ops at0 (@upd jets E d k i x) e.
Proof.
  intros H F d' k' j. unfold upd. destruct (Bool.bool_dec d d') as [p|]; [|apply H].
  destruct (kind_dec k k') as [q|]; [|apply H]. destruct (Nat.eqb_spec i j) as [<-|]; [|apply H]. destruct p, q. exact F.
Qed.
Lemma begun_ok (e : env smooth_ops) : e false Scalar 0%nat = cosine -> e false Scalar 1%nat = sine ->
  e false Scalar 2%nat = time -> @env_related jets smooth_ops at0 begun e.
Proof.
  intros C S T. assert (W : forall a b (x y : R), Q2R a = x -> Q2R b = y -> at0 (wave_jet a b) (wave x y)) by (intros a b x y <- <-; apply wave_at0).
  repeat apply known_ok; [apply unknown_ok | rewrite T; exact time_at0 | rewrite S; apply W | rewrite C; apply W]; unfold Q2R; cbn; lra.
Qed.
Lemma jet_ext d k (p : val (rng jets d) k) (x y : val (rng smooth_ops d) k) :
  @related jets smooth_ops at0 d k p x -> @equal smooth_functions d k y x -> @related jets smooth_ops at0 d k p y.
Proof.
  assert (X : forall (f : jets) (x y : smooth), at0 f x -> same_fun y x -> at0 f y).
  { intros f u v A' S n q N. rewrite S. exact (A' n q N). }
  unfold related, equal, drel. destruct d, k; cbn; unfold all3, dual_same; cbn; intros;
    repeat match goal with H : _ /\ _ |- _ => destruct H end; repeat split; eapply X; eassumption.
Qed.
Lemma learn_ok (e : env smooth_ops) ps : forall E, @env_related jets smooth_ops at0 E e ->
  Forall (@holds smooth_functions e) ps -> @env_related jets smooth_ops at0 (learn ps E) e.
Proof.
  induction ps as [|p ps IH]; cbn [learn]; intros E H G; [exact H|].
  apply Forall_cons_iff in G as [P G]. destruct p as [d k a b|d k i t|d k i t|n]; auto.
  apply IH; [|exact G]. apply known_ok; [exact H|].
  exact (jet_ext d k _ _ _ (@den_related _ _ _ at0_hom d k t _ _ H) P).
Qed.
Definition apart (a b : jets) : bool := match a, b with x :: _, y :: _ => negb (Qeq_bool x y) | _, _ => false end.
Definition differs d k (a b : val (rng jets d) k) : bool :=
  existsb (fun c => apart (fst c) (snd c)) (combine (comps jets d k a) (comps jets d k b)).
Lemma differs_ok d k (a b : val (rng jets d) k) (x y : val (rng smooth_ops d) k) :
  related at0 d k a x -> related at0 d k b y -> differs d k a b = true -> ~ @equal smooth_functions d k x y.
Proof.
  assert (N : forall (a b : jets) (x y : smooth), at0 a x -> at0 b y -> apart a b = true -> ~ same_fun x y).
  { intros [|p u] [|q v] f g A' B; try discriminate. cbn. intros D E. apply negb_true_iff, Qeq_bool_neq in D.
    apply D, eqR_Qeq. rewrite <- (A' 0%nat p eq_refl), <- (B 0%nat q eq_refl). apply E. }
  unfold related, differs, comps, equal, drel. destruct d, k; cbn; unfold all3, dual_same; cbn; intros X Y D E;
    rewrite ?orb_true_iff, ?orb_false_r in D;
    repeat match goal with H : _ /\ _ |- _ => destruct H | H : _ || _ = true |- _ => apply orb_true_iff in H | H : _ \/ _ |- _ => destruct H
      | H : false = true |- _ => discriminate H end;
    match goal with D : apart ?a ?b = true, A : at0 ?a ?f, B : at0 ?b ?g |- _ =>
      exact (N a b f g A B D ltac:(assumption)) end.
Qed.
Theorem refuted (e : env smooth_ops) ps d k (a b : tm d k) : e false Scalar 0%nat = cosine -> e false Scalar 1%nat = sine ->
  e false Scalar 2%nat = time -> Forall (@holds smooth_functions e) ps ->
  differs d k (den (learn ps begun) a) (den (learn ps begun) b) = true ->
  ~ @equal smooth_functions d k (den (O := smooth_ops) e a) (den (O := smooth_ops) e b).
Proof.
  intros C S T P. pose proof (learn_ok (begun_ok e C S T) P) as E.
  apply differs_ok; [exact (@den_related _ _ _ at0_hom d k a _ _ E) | exact (@den_related _ _ _ at0_hom d k b _ _ E)].
Qed.
End Jets.
