(** More smooth functions: 1/f where f is never 0, so that premises which divide can be met by motions. *)
From Coq Require Import QArith Reals Qreals List Lra.
From Kin Require Import Kin Poly Terms Certify Modulo Symbols Forms Facts Fraction Context Steps Smooth Time Refute.
Set Implicit Arguments.
Import ListNotations.
Open Scope Q_scope. Open Scope kin_scope.

(** Its derivatives, as words in those of f and in 1/f itself, which are differentiated again and again. *)
Section Reciprocal.
Variable f : smooth.
Hypothesis never : forall t, F f 0 t <> 0%R.
Inductive word := Of (n : nat) | Over | Less (a : word) | More (a b : word) | Times (a b : word).
Fixpoint said (w : word) (t : R) : R := match w with
  | Of n => F f n t | Over => / F f 0 t | Less a => - said a t | More a b => said a t + said b t | Times a b => said a t * said b t end.
Fixpoint rate (w : word) : word := match w with
  | Of n => Of (S n) | Over => Less (Times (Of 1) (Times Over Over)) | Less a => Less (rate a)
  | More a b => More (rate a) (rate b) | Times a b => More (Times (rate a) b) (Times a (rate b)) end.
Lemma rate_ok w t : derivable_pt_lim (said w) t (said (rate w) t).
Proof.
  induction w as [n| |a A|a A b B|a A b B]; cbn.
  - apply smooth_ok.
  - pose proof (derivable_pt_lim_div (fct_cte 1) (F f 0) t 0 _ (derivable_pt_lim_const 1 t) (smooth_ok f 0 t) (never t)) as H.
    replace (- (F f 1 t * (/ F f 0 t * / F f 0 t)))%R with ((0 * F f 0 t - F f 1 t * fct_cte 1 t) / Rsqr (F f 0 t))%R
      by (unfold fct_cte, Rsqr; field; apply never).
    intros eps E. destruct (H eps E) as [delta G]. exists delta. intros h N S. specialize (G h N S).
    unfold div_fct, fct_cte in *. now replace (/ F f 0 (t + h) - / F f 0 t)%R with (1 / F f 0 (t + h) - 1 / F f 0 t)%R by (unfold Rdiv; ring).
  - exact (derivable_pt_lim_opp _ _ _ A).
  - exact (derivable_pt_lim_plus _ _ _ _ _ A B).
  - exact (derivable_pt_lim_mult _ _ _ _ _ A B).
Qed.
Definition recip : smooth := {| F n := said (Nat.iter n rate Over); smooth_ok n := rate_ok (Nat.iter n rate Over) |}.
End Reciprocal.

(** p + q t + r t² where it is never 0; [quadratic_over] is one over it there. *)
Definition quadratic (p q r : Q) : scalar smooth_functions := number p + number q • time + number r • (time • time).
Definition positive (p q r : Q) : bool := negb (Qle_bool (4 * p * r) (q * q)).
Lemma never_zero p q r : positive p q r = true -> forall t, F (quadratic p q r : smooth) 0 t <> 0%R.
Proof.
  unfold positive. intros H t E. apply Bool.negb_true_iff, Bool.not_true_iff_false in H. apply H, Qle_bool_iff, Rle_Qle.
  rewrite !Q2R_mult. change (Q2R 4) with (4 * / 1)%R. cbn in E.
  assert (S : (0 <= (2 * Q2R r * t + Q2R q) * (2 * Q2R r * t + Q2R q))%R) by apply Rle_0_sqr.
  replace ((2 * Q2R r * t + Q2R q) * (2 * Q2R r * t + Q2R q))%R
    with (4 * Q2R r * (Q2R p + Q2R q * t + Q2R r * (t * t)) + (Q2R q * Q2R q - 4 * Q2R p * Q2R r))%R in S by ring.
  rewrite E in S. lra.
Qed.
Definition quadratic_over (p q r : Q) : scalar smooth_functions :=
  match Bool.bool_dec (positive p q r) true with left H => recip (quadratic p q r) (@never_zero p q r H) | right _ => const 0 end.
Lemma over_quadratic (x : scalar smooth_functions) p q r : positive p q r = true -> x ≡ quadratic p q r -> reciprocal x (quadratic_over p q r).
Proof.
  intros H E. unfold quadratic_over. destruct (Bool.bool_dec _ _) as [P|N]; [|contradiction].
  apply by_values. intros t. specialize (E 0%nat t). change (F (x : smooth) 0 t * / F (quadratic p q r : smooth) 0 t = Q2R 1)%R.
  rewrite E. rewrite Rinv_r by now apply never_zero. unfold Q2R; cbn; lra.
Qed.

(** A counterexample (Refute.v) where some symbols are such reciprocals; of these only the values at t = 0 are known. *)
Definition quotients := list (nat * tm false Scalar * scalar smooth_functions).
Fixpoint with_them (rs : quotients) (e : env smooth_ops) : env smooth_ops :=
  match rs with [] => e | (i, _, y) :: rest => with_them rest (@upd smooth_ops e false Scalar i y) end.
Fixpoint are_such (rs : quotients) (e : env smooth_ops) : Prop :=
  match rs with [] => True | (i, x, y) :: rest => @reciprocal smooth_functions (den e x) y /\ are_such rest (@upd smooth_ops e false Scalar i y) end.
Section Jets.
Variable known : nat.
Notation jets := (jets known).
Notation related := (@env_related jets smooth_ops (at0 (known := known))).
Definition inverted (x : jets) : jets := match x with q :: _ => if Qeq_bool q 0 then [] else [Qred (/ q)] | [] => [] end.
Lemma inverted_ok (x : jets) (f g : smooth) : at0 x f -> @reciprocal smooth_functions f g -> at0 (inverted x) g.
Proof.
  intros A E [|n] q; destruct x as [|p x]; cbn; try discriminate; destruct (Qeq_bool p 0) eqn:Z; try discriminate; [|now destruct n].
  intros H. injection H as <-. specialize (A 0%nat p eq_refl). specialize (E 0%nat 0%R).
  change (F f 0 0%R * F g 0 0%R = Q2R 1)%R in E. apply Qeq_bool_neq in Z. rewrite A in E.
  rewrite (Qeq_eqR _ _ (Qred_correct (/ p))), Q2R_inv by exact Z.
  assert (N : Q2R p <> 0%R) by (intros W; apply Z, eqR_Qeq; rewrite W; unfold Q2R; cbn; lra).
  apply (Rmult_eq_reg_l (Q2R p)); [|exact N]. rewrite Rinv_r by exact N. rewrite E. unfold Q2R; cbn; lra.
Qed.
Fixpoint learn_them (rs : quotients) (E : env jets) : env jets :=
  match rs with [] => E | (i, x, _) :: rest => learn_them rest (@upd jets E false Scalar i (inverted (den E x))) end.
Lemma learn_them_ok rs : forall (E : env jets) (e : env smooth_ops), related E e -> are_such rs e -> related (learn_them rs E) (with_them rs e).
Proof.
  induction rs as [|[[i x] y] rs IH]; intros E e H A; [exact H|]. destruct A as [R A]. cbn. apply IH; [|exact A].
  apply env_upd; [exact H|]. exact (inverted_ok (@den_related _ _ _ (@at0_hom known) false Scalar x _ _ H) R).
Qed.
Theorem refuted_over (e : env smooth_ops) ps rs d k (a b : tm d k) : e false Scalar 0%nat = cosine -> e false Scalar 1%nat = sine ->
  e false Scalar 2%nat = time -> Forall (@holds smooth_functions e) ps -> are_such rs e ->
  (let E := learn_them rs (learn ps (begun known)) in @differs known d k (den E a) (den E b)) = true ->
  ~ @equal smooth_functions d k (den (O := smooth_ops) (with_them rs e) a) (den (O := smooth_ops) (with_them rs e) b).
Proof.
  intros C S T P A. pose proof (learn_them_ok rs (learn_ok (@begun_ok known e C S T) P) A) as E.
  apply (@differs_ok known); [exact (@den_related _ _ _ (@at0_hom known) d k a _ _ E) | exact (@den_related _ _ _ (@at0_hom known) d k b _ _ E)].
Qed.
End Jets.
