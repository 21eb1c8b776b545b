"""Statements on Drake's motions: numerical evidence that can veto a proof and show the size of an error. It
proves nothing."""
