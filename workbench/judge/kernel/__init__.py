"""What asks the engines and turns their answers into a verdict: every `proved` rests on all of it."""
