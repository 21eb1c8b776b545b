"""Goals with quantifiers as one theorem: what they say, and the rules of a proof, joined."""
