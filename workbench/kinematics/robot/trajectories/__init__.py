"""Paths of a robot: formulas, splines, samples and trajectories of planners, and their scaling in time."""
