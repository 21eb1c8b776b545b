"""Results on claims: the verdict on each form, evidence, proposals and motions."""
