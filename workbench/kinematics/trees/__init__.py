"""Trees of bodies: plan, memory and compiled steps of the evaluation of all frames to any order."""
