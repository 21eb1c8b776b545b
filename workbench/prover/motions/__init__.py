"""Statements on Drake's motions: numbers that can veto a proof and show the size of an error. Nothing here
proves.
"""
