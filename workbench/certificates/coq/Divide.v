(** Proof machinery: division with remainder. A rule says that a monomial equals a polynomial; [reduce] rewrites by
    a list of rules until no rule applies (or the fuel ends), and never changes a value at which the rules hold. *)
From Coq Require Import QArith List Bool Setoid Morphisms Ring Ring_theory BinPos FMapPositive Lia.
From Coq.micromega Require Import EnvRing Env.
From Kin Require Import Kin Poly.
Set Implicit Arguments.
Import ListNotations.
Module M := PositiveMap.

(** A monomial: variables with their exponents, the greatest variable first. *)
Definition mon := list (positive * positive).
Definition push (v e : positive) (m : mon) : mon :=
  match m with (w, f) :: r => if Pos.eqb v w then (v, (e + f)%positive) :: r else (v, e) :: m | [] => [(v, e)] end.
Fixpoint quotient (m n : mon) {struct m} : option mon :=
  match n, m with
  | [], _ => Some m
  | _, [] => None
  | (v, e) :: n', (w, f) :: m' =>
      if Pos.eqb v w then
        match Pos.compare e f with
        | Eq => quotient m' n'
        | Lt => option_map (cons (v, (f - e)%positive)) (quotient m' n')
        | Gt => None
        end
      else option_map (cons (w, f)) (quotient m' n)
  end.
Definition power (v : positive) (e : positive) : pol := shift v (mkXi c0 c1 e).
Fixpoint of_mon (m : mon) : pol := match m with [] => Pc c1 | (v, e) :: r => pmul (of_mon r) (power v e) end.

(** Rules, found by the greatest variable of their monomial. *)
Definition rule := (mon * pol)%type.
Definition rules := M.t (list rule).
Definition at_ (rs : rules) (v : positive) : list rule := match M.find v rs with Some l => l | None => [] end.
Definition insert (r : rule) (rs : rules) : rules :=
  match fst r with [] => rs | (v, _) :: _ => M.add v (r :: at_ rs v) rs end.
Fixpoint first (m : mon) (l : list rule) : option (mon * pol) :=
  match l with [] => None | (n, p) :: r => match quotient m n with Some q => Some (q, p) | None => first m r end end.

Definition is_zero (p : pol) : bool := match p with Pc c => Qeq_bool c 0 | _ => false end.
(** The greatest variable that a rule begins with: beyond it there is nothing to do. *)
Definition deepest (rs : rules) : positive := M.fold (fun v _ b => Pos.max v b) rs 1%positive.
Section Reduce.
Variable rs : rules.
Variable last : positive.
(** One pass over p, whose variables begin with k, under the monomial m: what no rule touches, and the rest rewritten. *)
Fixpoint pass (k : positive) (m : mon) (p : pol) : pol * pol :=
  if Pos.ltb last k then (p, Pc c0) else
  match p with
  | Pc _ => (p, Pc c0)
  | Pinj j q => let (a, x) := pass (j + k) m q in (mkPinj j a, x)
  | PX q i r =>
      let (b, y) := pass (Pos.succ k) m r in
      match first (push k i m) (at_ rs k) with
      | Some (n, t) => (mkPinj 1 b, padd y (pmul (pmul (of_mon n) t) (shift k q)))
      | None => let (a, x) := pass k (push k i m) q in (mkPX c0 qeqb a i b, padd x y)
      end
  end.
Fixpoint iterate (fuel : nat) (p : pol) : pol :=
  match fuel with
  | O => p
  | S n => let (a, x) := pass 1 [] p in if is_zero x then a else padd a (iterate n x)
  end.
Definition reduce_to (p : pol) : pol := match rs with M.Leaf _ => p | _ => iterate 1000 p end.
End Reduce.
Definition reduce (rs : rules) : pol -> pol := reduce_to rs (deepest rs).

(** From a polynomial that vanishes, the rule for its greatest monomial: by degree, then by the last variables. *)
Definition degree (m : mon) : positive := fold_right (fun c d => (snd c + d)%positive) 1%positive m.
Fixpoint revlex (m n : mon) {struct m} : bool :=
  match m, n with
  | (v, e) :: m', (w, f) :: n' =>
      match Pos.compare v w, Pos.compare e f with
      | Lt, _ => true | Gt, _ => false
      | Eq, Lt => true | Eq, Gt => false | Eq, Eq => revlex m' n'
      end
  | [], _ => true | _, [] => false
  end.
Definition greater (m n : mon) : bool :=
  match Pos.compare (degree m) (degree n) with Gt => true | Lt => false | Eq => revlex m n end.
Fixpoint lead (k : positive) (m : mon) (p : pol) : option (mon * Q) :=
  match p with
  | Pc c => if Qeq_bool c 0 then None else Some (m, c)
  | Pinj j q => lead (j + k) m q
  | PX q i r =>
      match lead k (push k i m) q, lead (Pos.succ k) m r with
      | Some (a, c), Some (b, d) => Some (if greater a b then (a, c) else (b, d))
      | Some a, None => Some a
      | None, b => b
      end
  end.
Definition learn (rs : rules) (h : pol) : rules :=
  let h := reduce rs h in
  match lead 1 [] h with
  | Some (m, c) => insert (m, padd (of_mon m) (pmul (Pc (- Qred (/ c))%Q) h)) rs
  | None => rs
  end.

(** What two rules imply by overlapping, for as many rounds as asked (Buchberger's algorithm, if they are enough). *)
Fixpoint lcm (m : mon) : mon -> mon := fix under n :=
  match m, n with
  | [], _ => n
  | _, [] => m
  | (v, e) :: m', (w, f) :: n' =>
      match Pos.compare v w with Eq => (v, Pos.max e f) :: lcm m' n' | Gt => (v, e) :: lcm m' n | Lt => (w, f) :: under n' end
  end.
Definition overlap (r s : rule) : pol :=
  let m := lcm (fst r) (fst s) in
  match quotient m (fst r), quotient m (fst s) with
  | Some a, Some b => padd (pmul (of_mon a) (snd r)) (popp (pmul (of_mon b) (snd s)))
  | _, _ => Pc c0
  end.
Definition listed (rs : rules) : list rule := flat_map snd (M.elements rs).
Definition overlaps (rs : rules) : list pol :=
  let all := listed rs in flat_map (fun r => List.map (overlap r) all) all.
Fixpoint complete (rounds : nat) (rs : rules) : rules :=
  match rounds with O => rs | S n => complete n (fold_left learn (overlaps rs) rs) end.

Section Sound.
Variable K : diff_ring.
Variable l : Env K.
Existing Instances same_Equivalence add_Proper mul_Proper opp_Proper dt_Proper num_Proper sub_Proper.
Add Ring K_ring : (laws K) (setoid (same_equiv K) (reqe K)).
Notation "a == b" := (@same K a b) (at level 70).
Notation value := (value K l).
Notation from k := (fun x => l (Pos.pred (x + k))).
Notation value_from k p := (Poly.value K (from k) p).
Notation "a ^ n" := (pow_pos (@mul K) a n).

Fixpoint vmon (m : mon) : K := match m with [] => num 1 | (v, e) :: r => mul (vmon r) (l v ^ e) end.
Lemma pow_add (x : K) i j : x ^ (i + j) == mul (x ^ i) (x ^ j).
Proof. etransitivity; [apply (EnvRing.pow_pos_add (same_equiv K) (reqe K) (art K)) | ring]. Qed.
Lemma vmon_push v e m : vmon (push v e m) == mul (vmon m) (l v ^ e).
Proof.
  destruct m as [|[w f] r]; cbn [push vmon]; [reflexivity|].
  destruct (Pos.eqb_spec v w) as [->|]; cbn [vmon]; [rewrite pow_add; ring | reflexivity].
Qed.
Lemma quotient_ok m : forall n q, quotient m n = Some q -> vmon m == mul (vmon q) (vmon n).
Proof.
  induction m as [|[w f] m IH]; intros [|[v e] n] q; cbn [quotient]; intros E; try discriminate;
    try (injection E as <-; cbn [vmon]; ring).
  destruct (Pos.eqb_spec v w) as [->|].
  - destruct (Pos.compare_spec e f) as [->|L|]; try discriminate.
    + cbn [vmon]. rewrite (IH _ _ E). ring.
    + destruct (quotient m n) as [r|] eqn:F; try discriminate. injection E as <-. cbn [vmon]. rewrite (IH _ _ F).
      replace (l w ^ f) with (l w ^ ((f - e) + e)) by (f_equal; lia). rewrite pow_add. ring.
  - destruct (quotient m _) as [r|] eqn:F; try discriminate. injection E as <-. cbn [vmon]. rewrite (IH _ _ F).
    cbn [vmon]. ring.
Qed.
Lemma value_power v e : value (power v e) == l v ^ e.
Proof. unfold power. rewrite value_shift. apply value_Xi. Qed.
Lemma value_of_mon m : value (of_mon m) == vmon m.
Proof. induction m as [|[v e] r IH]; cbn [of_mon vmon]; [reflexivity|]. now rewrite value_mul, value_power, IH. Qed.

Definition rule_ok (r : rule) : Prop := vmon (fst r) == value (snd r).
Definition rules_ok (rs : rules) : Prop := forall v, Forall rule_ok (at_ rs v).
Lemma first_ok m rs n p : Forall rule_ok rs -> first m rs = Some (n, p) -> vmon m == mul (vmon n) (value p).
Proof.
  induction 1 as [|[o t] rs H _ IH]; cbn [first]; [discriminate|].
  destruct (quotient m o) as [q|] eqn:E; [|exact IH]. intros F. injection F as <- <-.
  rewrite (quotient_ok _ _ E). unfold rule_ok in H. cbn in H. now rewrite H.
Qed.

Lemma value_ext (e f : Env K) p : (forall x, e x = f x) -> Poly.value K e p == Poly.value K f p.
Proof. intros. unfold Poly.value. rewrite (env_morph _ _ _ p e f); auto. reflexivity. Qed.
Lemma from_inj j k p : Poly.value K (jump j (from k)) p == value_from (j + k)%positive p.
Proof. apply value_ext. intros x. unfold jump. f_equal. lia. Qed.
Lemma value_mkPinj j k p : value_from k (mkPinj j p) == value_from (j + k)%positive p.
Proof. unfold Poly.value. etransitivity; [apply (mkPinj_ok _ _ (same_equiv K)) | apply from_inj]. Qed.
Lemma value_Pinj j k p : value_from k (Pinj j p) == value_from (j + k)%positive p.
Proof. apply from_inj. Qed.
Lemma value_PX k p i q : value_from k (PX p i q) == add (mul (value_from k p) (l k ^ i)) (value_from (Pos.succ k) q).
Proof.
  unfold Poly.value at 1; cbn [Pphi]. unfold hd, nth. replace (Pos.pred (1 + k)) with k by lia.
  apply add_ext; [reflexivity|]. apply value_ext. intros. unfold tail, jump. f_equal. lia.
Qed.
Lemma value_mkPX k p i q : value_from k (mkPX c0 qeqb p i q) == value_from k (PX p i q).
Proof.
  unfold Poly.value. etransitivity; [apply (mkPX_ok (same_equiv K) (reqe K) (art K) (morph K))|]. reflexivity.
Qed.

Variable rs : rules.
Hypothesis holds : rules_ok rs.
Lemma pass_ok last p : forall k m, let (a, x) := pass rs last k m p in
  mul (vmon m) (value_from k p) == add (mul (vmon m) (value_from k a)) (value x).
Proof.
  induction p as [c|j q IH|q IHq i r IHr]; intros k m; cbn [pass];
    (destruct (Pos.ltb last k); [change (value (Pc c0)) with (@num K 0); ring|]).
  - change (value (Pc c0)) with (@num K 0). ring.
  - specialize (IH (j + k)%positive m). destruct (pass rs last (j + k) m q) as [a x].
    rewrite value_Pinj, value_mkPinj. exact IH.
  - specialize (IHr (Pos.succ k) m). destruct (pass rs last (Pos.succ k) m r) as [b y].
    destruct (first (push k i m) (at_ rs k)) as [[n t]|] eqn:E.
    + rewrite value_mkPinj, value_PX, value_add, !value_mul, value_of_mon, value_shift.
      rewrite <- (first_ok _ (holds k) E), vmon_push.
      replace (1 + k)%positive with (Pos.succ k) by lia.
      transitivity (add (mul (mul (vmon m) (value_from k q)) (l k ^ i)) (mul (vmon m) (value_from (Pos.succ k) r))); [ring|].
      rewrite IHr. ring.
    + specialize (IHq k (push k i m)). destruct (pass rs last k (push k i m) q) as [a x].
      rewrite vmon_push in IHq. rewrite value_mkPX, !value_PX, value_add.
      transitivity (add (mul (mul (vmon m) (l k ^ i)) (value_from k q)) (mul (vmon m) (value_from (Pos.succ k) r))); [ring|].
      rewrite IHq, IHr. ring.
Qed.
Lemma value_from_1 p : value_from 1 p == value p.
Proof. apply value_ext. intros. f_equal. lia. Qed.
Lemma iterate_ok last n : forall p, value (iterate rs last n p) == value p.
Proof.
  induction n as [|n IH]; intros p; cbn [iterate]; [reflexivity|].
  pose proof (pass_ok last p 1 []) as P. destruct (pass rs last 1 [] p) as [a x]. cbn [vmon] in P. rewrite !value_from_1 in P.
  transitivity (add (value a) (value x)); [|transitivity (mul (num 1) (value p)); [rewrite P; ring | ring]].
  destruct (is_zero x) eqn:Z.
  - destruct x as [c| |]; try discriminate. apply Qeq_bool_eq in Z. change (value (Pc c)) with (@num K c). rewrite Z. ring.
  - now rewrite value_add, IH.
Qed.
Lemma reduce_ok p : value (reduce rs p) == value p.
Proof. unfold reduce, reduce_to. pose proof (iterate_ok (deepest rs) 1000 p). now destruct rs. Qed.

Lemma insert_ok r : rule_ok r -> rules_ok (insert r rs).
Proof.
  intros R v. unfold insert. destruct r as [[|[w e] m] p]; cbn [fst]; [apply holds|].
  unfold at_ at 1. destruct (Pos.eq_dec v w) as [->|N].
  - rewrite M.gss. constructor; [exact R | apply holds].
  - rewrite M.gso by exact N. apply holds.
Qed.
Lemma learn_ok h : value h == num 0 -> rules_ok (learn rs h).
Proof.
  intros Z. unfold learn. destruct (lead 1 [] (reduce rs h)) as [[m c]|]; [|exact holds].
  apply insert_ok. unfold rule_ok. cbn [fst snd]. rewrite value_add, value_of_mon, value_mul, reduce_ok, Z. ring.
Qed.
End Sound.
Section Complete.
Variable K : diff_ring.
Variable l : Env K.
Existing Instances same_Equivalence add_Proper mul_Proper opp_Proper num_Proper.
Add Ring K_ring : (laws K) (setoid (same_equiv K) (reqe K)).
Notation vanishing := (fun h => same (value K l h) (num 0)).
Lemma learn_all_ok hs : forall rs, rules_ok K l rs -> Forall vanishing hs -> rules_ok K l (fold_left learn hs rs).
Proof.
  induction hs as [|h hs IH]; cbn [fold_left]; intros rs R F; [exact R|].
  apply Forall_cons_iff in F as [Z F]. apply IH; [now apply learn_ok | exact F].
Qed.
Lemma overlap_ok r s : rule_ok K l r -> rule_ok K l s -> vanishing (overlap r s).
Proof.
  unfold rule_ok, overlap. destruct r as [m p], s as [n q]. cbn [fst snd]. intros P Q.
  destruct (quotient (lcm m n) m) as [a|] eqn:A; [|reflexivity]. destruct (quotient (lcm m n) n) as [b|] eqn:B; [|reflexivity].
  apply (quotient_ok K l) in A, B. rewrite value_add, value_opp, !value_mul, !value_of_mon, <- P, <- Q, <- A, <- B. ring.
Qed.
Lemma listed_ok rs : rules_ok K l rs -> Forall (rule_ok K l) (listed rs).
Proof.
  intros H. apply Forall_forall. intros r I. apply in_flat_map in I as ((v & rules_) & E & I).
  specialize (H v). unfold at_ in H. rewrite (M.elements_complete _ _ _ E) in H. rewrite Forall_forall in H. now apply H.
Qed.
Lemma complete_ok rounds : forall rs, rules_ok K l rs -> rules_ok K l (complete rounds rs).
Proof.
  induction rounds as [|n IH]; cbn [complete]; intros rs H; [exact H|]. apply IH, learn_all_ok; [exact H|].
  pose proof (listed_ok H) as L. rewrite Forall_forall in L. apply Forall_forall. intros h I.
  apply in_flat_map in I as (r & R & I). apply in_map_iff in I as (s & <- & S). apply overlap_ok; auto.
Qed.
End Complete.
Lemma no_rules_ok (K : diff_ring) l : @rules_ok K l (M.empty _).
Proof. intros v. unfold at_. rewrite M.gempty. constructor. Qed.
