"""The test of thousands of candidates at random points modulo a prime, and of what two candidates say."""
