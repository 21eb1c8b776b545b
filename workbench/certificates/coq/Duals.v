(** Reciprocals and lengths of dual quantities (to be read together with Kin.v where their words occur). *)
From Coq Require Import QArith.
From Kin Require Import Kin.
Open Scope Q_scope. Open Scope kin_scope.

(** 1/x, where y is that of the real part of x; ‖u‖, where n is that of the real part of u and y = 1/n. *)
Definition dual_over {K : diff_ring} (x : dual_scalar K) (y : scalar K) : dual_scalar K :=
  embed y - eps • embed (y • y • (dual_part x : scalar K)).
Definition dual_length {K : diff_ring} (u : dual_vector K) (n y : scalar K) : dual_scalar K :=
  embed n + eps • embed (y • ((real_part u : vector K) · (dual_part u : vector K))).
