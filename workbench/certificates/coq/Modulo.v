(** Proof machinery: equations under premises. A premise is an equation that is known to hold; it becomes rewriting
    rules (Divide.v), or the derivatives of a symbol's components, or a symbol's value in terms of other symbols. *)
From Coq Require Import QArith List Bool Setoid Morphisms Ring BinPos Arith Lia.
From Coq.micromega Require Import EnvRing Env.
From Kin Require Import Kin Poly Divide Terms Certify.
Set Implicit Arguments.
Import ListNotations.

Inductive premise :=
| Rule d k (a b : tm d k)              (* a ≡ b: its greatest monomials are rewritten *)
| Rate d k (i : nat) (t : tm d k)      (* D x ≡ t, where x is symbol i *)
| Value d k (i : nat) (t : tm d k)     (* x ≡ t *)
| Complete (rounds : nat).             (* nothing new: rules that follow from the rules so far *)
Definition holds {K : diff_ring} (e : env K) (p : premise) : Prop :=
  match p with
  | Rule a b => equal (den e a) (den e b)
  | @Rate d k i t => equal (D (e d k i)) (den e t)
  | @Value d k i t => equal (e d k i) (den e t)
  | Complete _ => True
  end.

(** What is known so far: the number of indeterminates, the derivatives of some of them, and rules. *)
Record state := { width : positive; rates : M.t pol; known : rules }.
Definition derivative (s : state) (i : positive) : pol :=
  match M.find i (rates s) with Some p => p | None => var (i + width s) end.
Definition rem_ops (s : state) : ops := {| car := pol; num q := Pc (Qred q); add := padd;
  mul := let r := reduce (known s) in fun a b => r (pmul a b); opp := popp;
  dt := let r := reduce (known s) in fun p => r (deriv (derivative s) 1 p) |}.
Definition recast {A B : ops} (f : A -> B) (e : env A) : env B := fun d k i =>
  (if d return val (rng A d) k -> val (rng B d) k then each (fun a => Dual (f (re a)) (f (du a))) else each f) (e d k i).
Definition moved (s t : state) : env (rem_ops s) -> env (rem_ops t) := @recast (rem_ops s) (rem_ops t) (fun p => p).
Arguments moved : clear implicits.

Fixpoint as_var (p : pol) : option positive :=
  match p with
  | PX (Pc c) 1 (Pc z) => if qeqb c 1 && qeqb z 0 then Some 1%positive else None
  | Pinj j q => option_map (Pos.add j) (as_var q)
  | _ => None
  end.
Definition set_rates (c : list (pol * pol)) (r : M.t pol) : M.t pol :=
  fold_right (fun c r => match as_var (fst c) with Some i => M.add i (snd c) r | None => r end) r c.
Definition subtract (c : pol * pol) : pol := padd (fst c) (popp (snd c)).
Definition pairs {O : ops} {d k} (a b : val (rng O d) k) : list (O * O) := combine (comps O d k a) (comps O d k b).
Definition vanishes (s : state) (c : pol * pol) : bool := is_zero (reduce (known s) (subtract c)).

Section Modulo.
Variable shapes : list shape.
Definition start : state := {| width := Pos.of_nat (total shapes); rates := M.empty _; known := M.empty _ |}.
Definition env0 : env (rem_ops start) :=
  @recast (pol_ops (table shapes)) (rem_ops start) (fun p => p) (envP shapes 0 1 shapes).
Definition step (p : premise) {s : state} (E : env (rem_ops s)) : {s : state & env (rem_ops s)} :=
  match p with
  | Rule a b =>
      let t := {| width := width s; rates := rates s;
                  known := fold_left (@learn) (List.map subtract (pairs (den E a) (den E b))) (known s) |} in
      existT _ t (moved s t E)
  | @Rate d k i t =>
      let t := {| width := width s; known := known s;
                  rates := set_rates (@pairs (rem_ops s) d k (moved start s env0 d k i) (den E t)) (rates s) |} in
      existT _ t (moved s t E)
  | @Value d k i t => existT _ s (@upd (rem_ops s) E d k i (den E t))
  | Complete n =>
      let t := {| width := width s; rates := rates s; known := complete n (known s) |} in existT _ t (moved s t E)
  end.
Fixpoint run (ps : list premise) {s : state} (E : env (rem_ops s)) : {s : state & env (rem_ops s)} :=
  match ps with [] => existT _ s E | p :: r => let (s', E') := step p E in run r E' end.
Definition follows (ps : list premise) d k (a b : tm d k) : bool :=
  let (s, E) := run ps env0 in forallb (vanishes s) (pairs (den E a) (den E b)).

Variable K : diff_ring.
Existing Instances same_Equivalence add_Proper mul_Proper opp_Proper dt_Proper num_Proper sub_Proper.
Add Ring K_ring : (laws K) (setoid (same_equiv K) (reqe K)).
Notation "a == b" := (@same K a b) (at level 70).
Variable slots : list (slot K).
Hypothesis shapes_ok : List.map (@projT1 _ _) slots = shapes.
Hypothesis some : (0 < total shapes)%nat.
Notation l := (jets shapes slots).
Notation e := (envK 0 slots).
Notation value := (value K l).

Definition sound (s : state) : Prop := width s = Pos.of_nat (total shapes) /\
  (forall i p, M.find i (rates s) = Some p -> value p == dt (l i)) /\ rules_ok K l (known s).
Definition suits {s : state} (E : env (rem_ops s)) : Prop := @env_related (rem_ops s) K (stands K l) E e.

Lemma derivative_ok s i : sound s -> value (derivative s i) == dt (l i).
Proof.
  intros (W & R & _). unfold derivative. destruct (M.find i (rates s)) eqn:F; [now apply R|].
  rewrite W. exact (@table_ok shapes K slots some i).
Qed.
Lemma rem_hom s : sound s -> hom (rem_ops s) K (stands K l).
Proof.
  intros S. pose proof (fun i => @derivative_ok s i S) as T. destruct S as (_ & _ & R).
  unfold stands. split; cbn; intros.
  - change (value (Pc (Qred q)) == num q). apply num_ext, Qred_correct.
  - etransitivity; [apply value_add|]. now apply add_ext.
  - etransitivity; [apply (reduce_ok R)|]. etransitivity; [apply value_mul|]. now apply mul_ext.
  - etransitivity; [apply value_opp|]. now apply opp_ext.
  - etransitivity; [apply (reduce_ok R)|]. etransitivity; [apply value_dt, T|]. now apply dt_ext.
Qed.
Lemma recast_ok (A B : ops) (f : A -> B) (R : A -> K -> Prop) (S : B -> K -> Prop) E :
  (forall a x, R a x -> S (f a) x) -> @env_related A K R E e -> @env_related B K S (recast f E) e.
Proof.
  intros F H d k i. specialize (H d k i). unfold related, recast in *. destruct d.
  - change (@every (dual A) (dual K) (dual_same R) k (E true k i) (e true k i)) in H.
    change (@every (dual B) (dual K) (dual_same S) k (each (fun a => Dual (f (re a)) (f (du a))) (E true k i)) (e true k i)).
    destruct k; cbn in *; unfold all3, dual_same in *; cbn in *; intuition.
  - change (@every A K R k (E false k i) (e false k i)) in H.
    change (@every B K S k (each f (E false k i)) (e false k i)).
    destruct k; cbn in *; unfold all3 in *; cbn in *; intuition.
Qed.
Lemma moved_ok s t (E : env (rem_ops s)) : suits E -> suits (moved s t E).
Proof. apply recast_ok. auto. Qed.
Lemma start_ok : sound start.
Proof. split; [reflexivity|]. split; [|apply no_rules_ok]. intros i p. cbn. rewrite M.gempty. discriminate. Qed.
Lemma env0_ok : suits env0.
Proof.
  refine (@recast_ok (pol_ops (table shapes)) (rem_ops start) (fun p => p) _ _ _ (fun a x H => H) _).
  rewrite <- shapes_ok at 4. apply env_ok with (before := []);
    [exact some | reflexivity | reflexivity | cbn; now rewrite shapes_ok].
Qed.

Definition both_stand (c : pol * pol) (x : K * K) := stands K l (fst c) (fst x) /\ stands K l (snd c) (snd x).
Lemma pairs_ok s d k (p q : val (rng (rem_ops s) d) k) (x y : val (rng K d) k) :
  @related (rem_ops s) K (stands K l) d k p x -> @related (rem_ops s) K (stands K l) d k q y ->
  Forall2 both_stand (@pairs (rem_ops s) d k p q) (@pairs K d k x y).
Proof.
  unfold related, pairs, both_stand. destruct d, k; cbn; unfold all3, dual_same; cbn; intros; repeat constructor; cbn; tauto.
Qed.
Lemma pairs_equal d k (x y : val (rng K d) k) : equal x y -> Forall (fun c => fst c == snd c) (@pairs K d k x y).
Proof. unfold pairs. destruct d, k; cbn; unfold all3, dual_same; cbn; intros; repeat constructor; cbn; tauto. Qed.
Lemma equal_pairs d k (x y : val (rng K d) k) : Forall (fun c => fst c == snd c) (@pairs K d k x y) -> equal x y.
Proof.
  unfold pairs. destruct d, k; cbn; unfold all3, dual_same; cbn; intros H;
    repeat match goal with H : Forall _ (_ :: _) |- _ => apply Forall_cons_iff in H; destruct H end; cbn in *; tauto.
Qed.
Lemma value_subtract p q : value (subtract (p, q)) == add (value p) (opp (value q)).
Proof. unfold subtract, fst, snd. now rewrite value_add, value_opp. Qed.
Lemma zeros (c : list (pol * pol)) x : Forall2 both_stand c x -> Forall (fun c => fst c == snd c) x ->
  Forall (fun h => value h == num 0) (List.map subtract c).
Proof.
  induction 1 as [|[p q] [x y] c cs [P Q] _ IH]; cbn [List.map]; intros F; [constructor|].
  apply Forall_cons_iff in F as [E F]. constructor; [|auto]. unfold stands in *. cbn [fst snd] in *.
  rewrite value_subtract, P, Q, E. ring.
Qed.
Lemma as_var_ok p : forall i f, as_var p = Some i -> Poly.value K f p == f i.
Proof.
  induction p as [c|j q IH|q _ i r _]; intros n f; cbn [as_var]; [discriminate| |].
  - destruct (as_var q) as [m|]; [|discriminate]. intros E. injection E as <-.
    change (Poly.value K f (Pinj j q)) with (Poly.value K (jump j f) q).
    rewrite (IH m _ eq_refl). unfold jump. replace (j + m)%positive with (m + j)%positive by lia. reflexivity.
  - destruct q as [c| |]; try discriminate. destruct i; try discriminate. destruct r as [z| |]; try discriminate.
    destruct (qeqb c 1) eqn:C; [|discriminate]. destruct (qeqb z 0) eqn:Z; [|discriminate]. intros E. injection E as <-.
    apply Qeq_bool_eq in C, Z. unfold Poly.value. cbn. rewrite C, Z. unfold hd, nth.
    change (num c1) with (@num K 1). change (num c0) with (@num K 0). ring.
Qed.
Lemma set_rates_ok (c : list (pol * pol)) (x : list (K * K)) r : Forall2 both_stand c x ->
  Forall (fun c => dt (fst c) == snd c) x -> (forall i p, M.find i r = Some p -> value p == dt (l i)) ->
  forall i p, M.find i (set_rates c r) = Some p -> value p == dt (l i).
Proof.
  intros S. revert r. induction S as [|[p q] [x y] c cs [P Q] _ IH]; cbn [set_rates fold_right]; intros r F R; [exact R|].
  apply Forall_cons_iff in F as [E F]. intros i t. cbn [fst snd] in *. specialize (IH r F R).
  destruct (as_var p) as [j|] eqn:A; [|apply IH]. destruct (Pos.eq_dec i j) as [->|N].
  - rewrite M.gss. intros X. injection X as <-. unfold stands in *. rewrite Q, <- E. apply dt_ext.
    rewrite <- P. exact (as_var_ok p l A).
  - rewrite M.gso by exact N. apply IH.
Qed.
Lemma pairs_rate d k (x y : val (rng K d) k) : equal (D x) y -> Forall (fun c => dt (fst c) == snd c) (@pairs K d k x y).
Proof. unfold pairs. destruct d, k; cbn; unfold all3, dual_same; cbn; intros; repeat constructor; cbn; tauto. Qed.
Lemma related_equal s d k (p : val (rng (rem_ops s) d) k) (x y : val (rng K d) k) : equal x y ->
  @related (rem_ops s) K (stands K l) d k p y -> @related (rem_ops s) K (stands K l) d k p x.
Proof.
  unfold related, stands. destruct d, k; cbn; unfold all3, dual_same; cbn; intros H G; repeat split;
    (etransitivity; [apply G | symmetry; apply H]).
Qed.

Lemma upd_ok s (E : env (rem_ops s)) d k i v : suits E -> @related (rem_ops s) K (stands K l) d k v (e d k i) ->
  suits (@upd (rem_ops s) E d k i v).
Proof.
  intros U R d' k' j. unfold upd.
  destruct (Bool.bool_dec d d') as [q|]; [|apply U]. destruct (kind_dec k k') as [r|]; [|apply U].
  destruct (Nat.eqb_spec i j) as [<-|]; [|apply U]. destruct q, r. exact R.
Qed.
Lemma step_ok p s (E : env (rem_ops s)) : sound s -> suits E -> holds e p -> let (t, F) := step p E in sound t /\ suits F.
Proof.
  intros S U H. pose proof (rem_hom S) as HH. destruct p as [d k a b|d k i t|d k i t|n]; cbn [step holds] in *.
  - split; [|now apply moved_ok]. destruct S as (W & R & N). split; [exact W|]. split; [exact R|].
    apply learn_all_ok; [exact N|]. eapply zeros.
    + apply pairs_ok; apply (den_related HH); exact U.
    + now apply pairs_equal.
  - split; [|now apply moved_ok]. destruct S as (W & R & N). split; [exact W|]. split; [|exact N].
    intros j p. apply (@set_rates_ok _ (@pairs K d k (e d k i) (den e t))); [|now apply pairs_rate|exact R].
    apply pairs_ok; [apply (moved_ok s env0_ok) | apply (den_related HH); exact U].
  - split; [exact S|]. apply upd_ok; [exact U|]. apply (@related_equal s d k (den E t) _ _ H). apply (den_related HH). exact U.
  - split; [|now apply moved_ok]. destruct S as (W & R & N). split; [exact W|]. split; [exact R|]. now apply complete_ok.
Qed.
Lemma run_ok ps : forall s (E : env (rem_ops s)), sound s -> suits E -> Forall (holds e) ps ->
  let (t, F) := run ps E in sound t /\ suits F.
Proof.
  induction ps as [|p ps IH]; cbn [run]; intros s E S U H; [auto|].
  apply Forall_cons_iff in H as [P H]. pose proof (@step_ok p s E S U P) as N. destruct (step p E) as [t F].
  now apply IH.
Qed.
Lemma vanishes_ok s p q x y : sound s -> stands K l p x -> stands K l q y -> vanishes s (p, q) = true -> x == y.
Proof.
  intros (_ & _ & R) P Q Z. unfold vanishes, stands in *.
  assert (V : value (subtract (p, q)) == num 0).
  { rewrite <- (reduce_ok R). destruct (reduce (known s) (subtract (p, q))) as [n| |]; try discriminate.
    exact (num_ext K (Qeq_bool_eq _ _ Z)). }
  rewrite value_subtract, P, Q in V.
  transitivity (add (add x (opp y)) y); [ring | rewrite V; ring].
Qed.
Theorem modulo ps d k (a b : tm d k) : Forall (holds e) ps -> follows ps a b = true -> equal (den e a) (den e b).
Proof.
  intros H. unfold follows. pose proof (@run_ok ps start env0 start_ok env0_ok H) as N.
  destruct (run ps env0) as [s E]. destruct N as [S U]. intros C. apply equal_pairs.
  pose proof (@pairs_ok s d k _ _ _ _ (den_related (rem_hom S) a U) (den_related (rem_hom S) b U)) as P.
  rewrite forallb_forall, <- Forall_forall in C. revert C.
  induction P as [|[p q] [x y] c cs [P Q] _ IH]; intros C; [constructor|].
  apply Forall_cons_iff in C as [Z C]. constructor; [exact (vanishes_ok p q x y S P Q Z) | auto].
Qed.
End Modulo.
