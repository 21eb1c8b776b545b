(** Inequations at one instant: what differs just where something else does. *)
From Coq Require Import QArith Reals Qreals Lra.
From Kin Require Import Kin Smooth Time Moment.
Open Scope Q_scope. Open Scope kin_scope.
Notation K := smooth_functions.

Section Unequal.
Variable t : instant.
Let at_t (f : scalar K) : R := F (f : smooth) 0 t.
Lemma at_scaled (q : Q) (f : scalar K) : at_t (number q • f) = (Q2R q * at_t f)%R.
Proof. reflexivity. Qed.
Lemma at_minus (f g : scalar K) : at_t (f - g) = (at_t f - at_t g)%R.
Proof. unfold at_t. cbn. lra. Qed.
Lemma nonzero (q : Q) : ~ (q == 0)%Q -> Q2R q <> 0%R.
Proof. intros N E. apply N, eqR_Qeq. rewrite E. unfold Q2R; cbn; lra. Qed.

(** a ≠ b just where c ≠ d, if the differences are proportional. *)
Lemma unequal_scaled (q : Q) (a b c d : scalar K) : ~ (q == 0)%Q -> a - b ≡ number q • (c - d) ->
  ~ equal_at t a b <-> ~ equal_at t c d.
Proof.
  intros N E. specialize (E 0%nat t). change (at_t (a - b) = at_t (number q • (c - d))) in E.
  rewrite at_scaled, !at_minus in E. apply nonzero in N.
  change (~ at_t a = at_t b <-> ~ at_t c = at_t d). split; intros H G; apply H.
  - rewrite G in E. lra.
  - rewrite G, Rminus_diag_eq in E by reflexivity. symmetry in E. apply Rmult_integral in E. lra.
Qed.
(** a ≠ b just where the vectors u ≠ v, if the difference is proportional to the square of theirs. *)
Lemma unequal_square (q : Q) (a b : scalar K) (u v : vector K) : ~ (q == 0)%Q -> a - b ≡ number q • square (u - v) ->
  ~ equal_at t a b <-> ~ equal_at t u v.
Proof.
  intros N E. specialize (E 0%nat t). change (at_t (a - b) = at_t (number q • square (u - v))) in E.
  rewrite at_scaled, at_minus in E. apply nonzero in N. destruct u as [u1 u2 u3], v as [v1 v2 v3].
  assert (S : at_t (square ((V u1 u2 u3 : vector K) - (V v1 v2 v3 : vector K))) = ((at_t u1 - at_t v1) * (at_t u1 - at_t v1) +
    (at_t u2 - at_t v2) * (at_t u2 - at_t v2) + (at_t u3 - at_t v3) * (at_t u3 - at_t v3))%R) by (unfold at_t; cbn; ring).
  rewrite S in E. change (~ at_t a = at_t b <-> ~ (at_t u1 = at_t v1 /\ at_t u2 = at_t v2 /\ at_t u3 = at_t v3)).
  split; intros H G; apply H.
  - destruct G as (G1 & G2 & G3). rewrite G1, G2, G3 in E. assert (Z : (at_t a - at_t b = 0)%R) by (rewrite E; ring). lra.
  - rewrite G in E. replace (at_t b - at_t b)%R with 0%R in E by ring. symmetry in E. apply Rmult_integral in E.
    destruct E as [E|E]; [contradiction|].
    pose proof (Rle_0_sqr (at_t u1 - at_t v1)) as A. pose proof (Rle_0_sqr (at_t u2 - at_t v2)) as B.
    pose proof (Rle_0_sqr (at_t u3 - at_t v3)) as C. unfold Rsqr in *.
    repeat split; apply Rminus_diag_uniq; apply Rsqr_0_uniq; unfold Rsqr; lra.
Qed.
End Unequal.
