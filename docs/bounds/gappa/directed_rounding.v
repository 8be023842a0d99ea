(* SPDX-License-Identifier: LGPL-3.0-or-later *)
(* docs/bounds/gappa/directed_rounding.v: the errors of binary64 rounded up, down or toward zero, as theorems for the terms that
   `gappa -Bcoq` prints. Gappa 1.4.1 uses these bounds in its proofs, but its Coq library has them for rounding to nearest only:
   a term then names a theorem UNKNOWN_float_... that does not exist. tests/predicates/generated/coq_proofs.py puts the theorems
   below in its place. Everything here is proved from Flocq's definition of rounding; coqc checks it. *)
Require Import Reals ZArith Bool Lia Lra.
From Flocq Require Import Core Relative.
Require Import Gappa.Gappa_library Gappa.Gappa_dyadic Gappa.Gappa_common.

Lemma float2_bpow : forall e, float2R (Float2 1 e) = bpow radix2 e.
Proof. intros e. unfold float2R, Defs.F2R. simpl. ring. Qed.

Lemma float2_minus_bpow : forall e, float2R (Float2 (-1) e) = Ropp (bpow radix2 e).
Proof. intros e. unfold float2R, Defs.F2R. simpl. ring. Qed.

Lemma float2_zero : float2R (Float2 0 0) = 0%R.
Proof. unfold float2R, Defs.F2R. simpl. ring. Qed.

(* Whether zi holds the errors: those below zero go down to -2^e if `down`, those above zero up to 2^e if `up`. *)
Definition holds_errors (down up : bool) (e : Z) (zi : FF) : bool :=
  (Fle2 (lower zi) (if down then Float2 (-1) e else Float2 0 0) &&
   Fle2 (if up then Float2 1 e else Float2 0 0) (upper zi))%bool.

Lemma holds_errors_correct :
  forall (down up : bool) (e : Z) (zi : FF) (r : R), holds_errors down up e zi = true ->
  (Rabs r <= bpow radix2 e)%R -> (down = false -> 0 <= r)%R -> (up = false -> r <= 0)%R -> BND r zi.
Proof.
intros down up e zi r Hb E D U.
apply andb_prop in Hb. destruct Hb as (H1, H2).
apply Fle2_correct in H1, H2. apply Rabs_le_inv in E.
destruct down, up; cbv beta iota in H1, H2;
  try rewrite float2_minus_bpow in H1; try rewrite float2_zero in H1;
  try rewrite float2_bpow in H2; try rewrite float2_zero in H2;
  try specialize (D (eq_refl _)); try specialize (U (eq_refl _)); split; lra.
Qed.

Definition is_normal (p : positive) (d : Z) (xi : FF) : bool :=
  Fle2 (Float2 1 (d + Zpos p - 1)) (lower xi).

Lemma relative_error :
  forall (rnd : R -> Z) (V : Valid_rnd rnd) (p : positive) (d : Z) (x : R) (xi : FF),
  ABS x xi -> is_normal p d xi = true ->
  x <> 0%R /\ exists e, (Rabs e <= bpow radix2 (1 - Zpos p))%R /\
                        round radix2 (FLT_exp d (Zpos p)) rnd x = (x * (1 + e))%R.
Proof.
intros rnd V p d x xi (_, (Hx, _)) H.
apply Fle2_correct in H. rewrite float2_bpow in H.
assert (Hn : (bpow radix2 (d + Zpos p - 1) <= Rabs x)%R) by (apply Rle_trans with (2 := Hx); exact H).
split.
- intros O. rewrite O, Rabs_R0 in Hn. generalize (bpow_gt_0 radix2 (d + Zpos p - 1)). lra.
- destruct (relative_error_FLT_ex radix2 d (Zpos p) (eq_refl _) rnd x Hn) as (e, (He, Hr)).
  exists e. split; [| exact Hr].
  replace (1 - Zpos p)%Z with (- Zpos p + 1)%Z by ring. apply Rlt_le. exact He.
Qed.

Definition float_relative_directed_helper (down up : bool) (p : positive) (d : Z) (xi zi : FF) : bool :=
  (is_normal p d xi && holds_errors down up (1 - Zpos p) zi)%bool.

Theorem float_relative_up :
  forall (p : positive) (d : Z) (x : R) (xi zi : FF), ABS x xi ->
  float_relative_directed_helper true true p d xi zi = true -> REL (round radix2 (FLT_exp d (Zpos p)) rndUP x) x zi.
Proof.
intros p d x xi zi Hx Hb. apply andb_prop in Hb. destruct Hb as (H1, H2).
destruct (relative_error rndUP _ p d x xi Hx H1) as (_, (e, (He, Hr))).
exists e. split; [| exact Hr].
apply (holds_errors_correct true true _ zi e H2 He); discriminate.
Qed.

Theorem float_relative_dn :
  forall (p : positive) (d : Z) (x : R) (xi zi : FF), ABS x xi ->
  float_relative_directed_helper true true p d xi zi = true -> REL (round radix2 (FLT_exp d (Zpos p)) rndDN x) x zi.
Proof.
intros p d x xi zi Hx Hb. apply andb_prop in Hb. destruct Hb as (H1, H2).
destruct (relative_error rndDN _ p d x xi Hx H1) as (_, (e, (He, Hr))).
exists e. split; [| exact Hr].
apply (holds_errors_correct true true _ zi e H2 He); discriminate.
Qed.

(* Toward zero the magnitude never grows: the relative error is not positive. *)
Lemma abs_round_toward_zero :
  forall (p : positive) (d : Z) (x : R), (Rabs (round radix2 (FLT_exp d (Zpos p)) rndZR x) <= Rabs x)%R.
Proof.
intros p d x.
assert (P : Prec_gt_0 (Zpos p)) by (exact (eq_refl _)).
rewrite <- (round_ZR_abs radix2 (FLT_exp d (Zpos p)) x).
rewrite round_ZR_DN by apply Rabs_pos.
apply (round_DN_pt radix2 (FLT_exp d (Zpos p)) (Rabs x)).
Qed.

Theorem float_relative_zr :
  forall (p : positive) (d : Z) (x : R) (xi zi : FF), ABS x xi ->
  float_relative_directed_helper true false p d xi zi = true -> REL (round radix2 (FLT_exp d (Zpos p)) rndZR x) x zi.
Proof.
intros p d x xi zi Hx Hb. apply andb_prop in Hb. destruct Hb as (H1, H2).
destruct (relative_error rndZR _ p d x xi Hx H1) as (O, (e, (He, Hr))).
exists e. split; [| exact Hr].
apply (holds_errors_correct true false _ zi e H2 He); [discriminate | intros _].
generalize (abs_round_toward_zero p d x). rewrite Hr, Rabs_mult. intros H.
assert (G : (0 < Rabs x)%R) by (apply Rabs_pos_lt; exact O).
assert (A : (Rabs (1 + e) <= 1)%R).
{ apply Rmult_le_reg_l with (1 := G). rewrite Rmult_1_r. exact H. }
apply Rabs_le_inv in A. lra.
Qed.

(* Some k with |f| <= 2^k; is_below checks it. *)
Definition power_above (f : float2) : Z :=
  match f with
  | Float2 (Zpos m) e | Float2 (Zneg m) e => (e + Z.log2_up (Zpos m))%Z
  | Float2 Z0 e => e
  end.
Definition power_around (xi : FF) : Z := Z.max (power_above (lower xi)) (power_above (upper xi)).
Definition is_below (p : positive) (d : Z) (xi : FF) : bool :=
  let k := power_around xi in
  (Zle_bool (FLT_exp d (Zpos p) k) k && (Fle2 (Float2 (-1) k) (lower xi) && Fle2 (upper xi) (Float2 1 k)))%bool.

(* "Wide": |x| = 2^k is allowed, since it is a number of the format and not rounded. *)
Lemma absolute_error :
  forall (rnd : R -> Z) (V : Valid_rnd rnd) (p : positive) (d : Z) (x : R) (xi : FF),
  BND x xi -> is_below p d xi = true ->
  (Rabs (round radix2 (FLT_exp d (Zpos p)) rnd x - x) <= bpow radix2 (FLT_exp d (Zpos p) (power_around xi)))%R.
Proof.
intros rnd V p d x xi Hx Hb.
unfold is_below in Hb. set (k := power_around xi) in *.
apply andb_prop in Hb. destruct Hb as (H0, Hb). apply andb_prop in Hb. destruct Hb as (H1, H2).
apply Zle_bool_imp_le in H0. apply Fle2_correct in H1, H2. rewrite float2_minus_bpow in H1. rewrite float2_bpow in H2.
assert (Hk : (Rabs x <= bpow radix2 k)%R) by (apply Rabs_le; destruct Hx; lra).
assert (P : Prec_gt_0 (Zpos p)) by (exact (eq_refl _)).
destruct Hk as [Hk | Hk].
- apply Rle_trans with (1 := error_le_ulp radix2 (FLT_exp d (Zpos p)) rnd x).
  destruct (Req_dec x 0) as [O | O].
  + rewrite O, ulp_FLT_0 by exact P. apply bpow_le. unfold FLT_exp. apply Z.le_max_r.
  + rewrite ulp_neq_0 by exact O. apply bpow_le. unfold cexp.
    exact (FLT_exp_monotone d (Zpos p) _ _ (mag_le_bpow radix2 x k O Hk)).
- assert (G : generic_format radix2 (FLT_exp d (Zpos p)) (Rabs x)).
  { rewrite Hk. apply generic_format_bpow'. apply FLT_exp_valid; exact P. exact H0. }
  apply generic_format_abs_inv in G.
  rewrite round_generic by (try exact V; exact G).
  rewrite Rminus_diag_eq by reflexivity. rewrite Rabs_R0. apply bpow_ge_0.
Qed.

Definition float_absolute_wide_directed_helper (down up : bool) (p : positive) (d : Z) (xi zi : FF) : bool :=
  (is_below p d xi && holds_errors down up (FLT_exp d (Zpos p) (power_around xi)) zi)%bool.

Theorem float_absolute_wide_up :
  forall (p : positive) (d : Z) (x : R) (xi zi : FF), BND x xi ->
  float_absolute_wide_directed_helper false true p d xi zi = true ->
  BND (round radix2 (FLT_exp d (Zpos p)) rndUP x - x)%R zi.
Proof.
intros p d x xi zi Hx Hb. apply andb_prop in Hb. destruct Hb as (H1, H2).
assert (P : Prec_gt_0 (Zpos p)) by (exact (eq_refl _)).
apply (holds_errors_correct _ _ _ _ _ H2 (absolute_error rndUP _ p d x xi Hx H1)); [intros _ | discriminate].
generalize (proj1 (proj2 (round_UP_pt radix2 (FLT_exp d (Zpos p)) x))). lra.
Qed.

Theorem float_absolute_wide_dn :
  forall (p : positive) (d : Z) (x : R) (xi zi : FF), BND x xi ->
  float_absolute_wide_directed_helper true false p d xi zi = true ->
  BND (round radix2 (FLT_exp d (Zpos p)) rndDN x - x)%R zi.
Proof.
intros p d x xi zi Hx Hb. apply andb_prop in Hb. destruct Hb as (H1, H2).
assert (P : Prec_gt_0 (Zpos p)) by (exact (eq_refl _)).
apply (holds_errors_correct _ _ _ _ _ H2 (absolute_error rndDN _ p d x xi Hx H1)); [discriminate | intros _].
generalize (proj1 (proj2 (round_DN_pt radix2 (FLT_exp d (Zpos p)) x))). lra.
Qed.

Theorem float_absolute_wide_zr :
  forall (p : positive) (d : Z) (x : R) (xi zi : FF), BND x xi ->
  float_absolute_wide_directed_helper true true p d xi zi = true ->
  BND (round radix2 (FLT_exp d (Zpos p)) rndZR x - x)%R zi.
Proof.
intros p d x xi zi Hx Hb. apply andb_prop in Hb. destruct Hb as (H1, H2).
apply (holds_errors_correct _ _ _ _ _ H2 (absolute_error rndZR _ p d x xi Hx H1)); discriminate.
Qed.
