"""Test of many candidates at random points modulo a prime, and comparison of two candidates."""
