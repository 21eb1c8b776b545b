"""The result on a claim: the verdict on each of its forms, evidence, proposals and motions."""
