(** Proof machinery: reciprocals. A pair (p, k) stands for p·yᵏ where y·d = 1; two such are equal if they are so over a
    common denominator. What computes soundly in K still does so with y; done again, there are several reciprocals. *)
From Coq Require Import QArith List Bool Setoid Morphisms Ring Arith Lia.
From Kin Require Import Kin Poly Terms Certify.
Set Implicit Arguments.

Lemma env_upd A B R (e : env A) (f : env B) d k i a x : env_related R e f -> related R d k a x ->
  env_related R (upd e d k i a) (upd f d k i x).
Proof.
  intros E F d' k' j. unfold upd. destruct (Bool.bool_dec d d') as [p|]; [|apply E].
  destruct (kind_dec k k') as [q|]; [|apply E]. destruct (Nat.eqb i j); [|apply E]. destruct p, q. exact F.
Qed.

(** A way to compute that proves equations of K: operations that respect K's, and a test of equality. *)
Record computes (K : diff_ring) (O : ops) (R : O -> K -> Prop) (eqb : O -> O -> bool) : Prop := {
  s_hom : hom O K R;
  s_ext : forall p x y, R p x -> same x y -> R p y;
  s_eqb : forall p q x y, R p x -> R q y -> eqb p q = true -> same x y }.
Definition equal_by {O : ops} (eqb : O -> O -> bool) d k (a b : val (rng O d) k) : bool :=
  forallb (fun c => eqb (fst c) (snd c)) (combine (comps O d k a) (comps O d k b)).
Lemma equal_by_ok K O R eqb : computes K O R eqb -> forall d k (p q : val (rng O d) k) (x y : val (rng K d) k),
  @related O K R d k p x -> @related O K R d k q y -> equal_by eqb d k p q = true -> equal x y.
Proof.
  intros [_ _ S] d k. unfold related, equal, equal_by, comps, drel. destruct d, k; cbn; unfold all3, dual_same; cbn;
    intros; repeat match goal with H : _ /\ _ |- _ => destruct H | H : _ && _ = true |- _ => apply andb_true_iff in H end; repeat split;
    match goal with |- same ?x ?y => match goal with
      A : R ?p x, B : R ?q y, E : eqb ?p ?q = true |- _ => exact (S p q x y A B E) end end.
Qed.

Section Fractions.
Variable O : ops.
Variable eqb : O -> O -> bool.
Variable d : O.
Fixpoint times_d (n : nat) (p : O) : O := match n with 0%nat => p | S m => mul (times_d m p) d end.
Definition frac := (O * nat)%type.
Definition frac_ops : ops := {| car := frac;
  num q := (num q, 0%nat);
  add a b := let m := Nat.max (snd a) (snd b) in (add (times_d (m - snd a) (fst a)) (times_d (m - snd b) (fst b)), m);
  mul a b := (mul (fst a) (fst b), (snd a + snd b)%nat);
  opp a := (opp (fst a), snd a);
  dt a := match snd a with
    | 0%nat => (dt (fst a), 0%nat)
    | S m => (add (mul (dt (fst a)) d) (mul (mul (num (- (Z.of_nat (S m) # 1))) (fst a)) (dt d)), S (S m)) end |}.
Definition frac_eqb (a b : frac_ops) : bool :=
  let m := Nat.max (snd a) (snd b) in eqb (times_d (m - snd a) (fst a)) (times_d (m - snd b) (fst b)).

Variable K : diff_ring.
Variable R : O -> K -> Prop.
Hypothesis S : computes K O R eqb.
Variables v y : K.
Hypothesis d_ok : R d v.
Hypothesis y_ok : same (mul v y) (num 1).
Existing Instances same_Equivalence add_Proper mul_Proper opp_Proper dt_Proper num_Proper sub_Proper.
Add Ring K_ring : (laws K) (setoid (same_equiv K) (reqe K)).
Notation "a == b" := (@same K a b) (at level 70).
Fixpoint pow (x : K) (n : nat) : K := match n with 0%nat => num 1 | Datatypes.S m => mul (pow x m) x end.
Definition stands_frac (a : frac_ops) (x : K) : Prop := exists p, R (fst a) p /\ x == mul p (pow y (snd a)).

Lemma pow_add x m n : pow x (m + n) == mul (pow x m) (pow x n).
Proof. induction m; cbn; [ring | rewrite IHm; ring]. Qed.
Lemma pow_cancel n : mul (pow v n) (pow y n) == num 1.
Proof.
  induction n; cbn; [ring|].
  transitivity (mul (mul (pow v n) (pow y n)) (mul v y)); [ring | rewrite IHn, y_ok; ring].
Qed.
Lemma times_ok n p x : R p x -> exists z, R (times_d n p) z /\ z == mul x (pow v n).
Proof.
  intros H. induction n as [|n [z [Z E]]]; cbn.
  - exists x. split; [assumption | ring].
  - exists (mul z v). split; [now apply (h_mul (s_hom S)) | rewrite E; ring].
Qed.
Lemma common m k p x : (k <= m)%nat -> R p x -> exists z, R (times_d (m - k) p) z /\ mul x (pow y k) == mul z (pow y m).
Proof.
  intros L H. destruct (times_ok (m - k) H) as [z [Z E]]. exists z. split; [assumption|].
  replace (pow y m) with (pow y ((m - k) + k)) by (f_equal; lia). rewrite pow_add, E.
  transitivity (mul (mul x (pow y k)) (mul (pow v (m - k)) (pow y (m - k)))); [rewrite pow_cancel; ring | ring].
Qed.
Lemma y_dt : dt y == opp (mul (mul y y) (dt v)).
Proof.
  assert (E : add (mul (dt v) y) (mul v (dt y)) == num 0) by (rewrite <- dt_mul, y_ok; apply dt_num).
  transitivity (add (mul y (add (mul (dt v) y) (mul v (dt y)))) (opp (mul (mul y y) (dt v)))).
  - transitivity (mul (mul v y) (dt y)); [rewrite y_ok; ring | ring].
  - rewrite E. ring.
Qed.
Lemma num_S n : @num K (Z.of_nat (Datatypes.S n) # 1) == add (num (Z.of_nat n # 1)) (num 1).
Proof. rewrite <- num_add. apply num_ext. unfold Qeq, Qplus. cbn -[Z.of_nat]. lia. Qed.
Lemma pow_dt n : dt (pow y (Datatypes.S n)) == opp (mul (num (Z.of_nat (Datatypes.S n) # 1)) (mul (pow y (Datatypes.S (Datatypes.S n))) (dt v))).
Proof.
  induction n as [|n IH].
  - cbn [pow]. rewrite !dt_mul, y_dt, dt_num. change (Z.of_nat 1 # 1)%Q with 1%Q. ring.
  - cbn [pow] in *. rewrite dt_mul, IH, y_dt, (num_S (Datatypes.S n)). ring.
Qed.
Theorem frac_sound : computes K frac_ops stands_frac frac_eqb.
Proof.
  pose proof (s_hom S) as H. unfold stands_frac. split; [split; cbn -[pow]| |].
  - intros q. exists (num q). split; [apply (h_num H) | cbn; ring].
  - intros [p k] [q l] x z [a [A E]] [b [B F]]; cbn -[pow] in *.
    destruct (@common (Nat.max k l) k p a ltac:(lia) A) as [a' [A' E']].
    destruct (@common (Nat.max k l) l q b ltac:(lia) B) as [b' [B' F']].
    exists (add a' b'). split; [now apply (h_add H)|]. rewrite E, F, E', F'. ring.
  - intros [p k] [q l] x z [a [A E]] [b [B F]]; cbn -[pow] in *.
    exists (mul a b). split; [now apply (h_mul H)|]. rewrite E, F, pow_add. ring.
  - intros [p k] x [a [A E]]; cbn -[pow] in *. exists (opp a). split; [now apply (h_opp H)|]. rewrite E. ring.
  - intros [p [|k]] x [a [A E]]; cbn [fst snd] in *.
    + exists (dt a). split; [now apply (h_dt H)|]. rewrite E. cbn [pow]. rewrite dt_mul, dt_num. ring.
    + exists (add (mul (dt a) v) (mul (mul (num (- (Z.of_nat (Datatypes.S k) # 1))) a) (dt v))). split.
      * apply (h_add H); [apply (h_mul H); [now apply (h_dt H) | assumption]|].
        apply (h_mul H); [apply (h_mul H); [apply (h_num H) | assumption] | now apply (h_dt H)].
      * rewrite E, dt_mul, pow_dt, num_opp. cbn [pow].
        transitivity (add (mul (mul (dt a) (mul (pow y k) y)) (mul v y))
          (mul a (opp (mul (num (Z.of_nat (Datatypes.S k) # 1)) (mul (mul (mul (pow y k) y) y) (dt v))))));
          [rewrite y_ok; ring | ring].
  - intros [p k] x z [a [A E]] F. exists a. split; [assumption | now rewrite <- F].
  - intros [p k] [q l] x z [a [A E]] [b [B F]] T; unfold frac_eqb in T; cbn -[pow] in *.
    destruct (@common (Nat.max k l) k p a ltac:(lia) A) as [a' [A' E']].
    destruct (@common (Nat.max k l) l q b ltac:(lia) B) as [b' [B' F']].
    rewrite E, F, E', F'. now rewrite (s_eqb S _ _ _ _ A' B' T).
Qed.

(** The values of all symbols, and of y itself. *)
Definition lift (E : env O) : env frac_ops := fun e k i =>
  match e return val (rng O e) k -> val (rng frac_ops e) k with
  | false => each (fun p => (p, 0%nat) : frac_ops)
  | true => each (fun p => @Dual frac_ops (re p, 0%nat) (du p, 0%nat))
  end (E e k i).
Lemma lift_ok E e : env_related R E e -> env_related stands_frac (lift E) e.
Proof.
  assert (L : forall p x, R p x -> stands_frac (p, 0%nat) x) by (intros p x H; exists x; split; [exact H | cbn; ring]).
  intros H b k i. specialize (H b k i). unfold related, lift in *.
  destruct b, k; cbn in *; unfold all3, dual_same in *; cbn in *; intuition.
Qed.
Definition with_y (E : env O) i : env frac_ops := @upd frac_ops (lift E) false Scalar i ((num 1, 1%nat) : frac_ops).
Lemma with_y_ok E e i : env_related R E e -> env_related stands_frac (with_y E i) (upd e false Scalar i (y : val (rng K false) Scalar)).
Proof.
  intros H. apply env_upd; [now apply lift_ok|]. exists (num 1). split; [apply (h_num (s_hom S)) | cbn; ring].
Qed.
End Fractions.
